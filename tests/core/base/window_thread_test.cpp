#include "core/base/window_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace arris::base {
namespace {

TEST(WindowThread, TellsWhatHeldItUpAndEachOnce) {
  const WindowThread window;
  takesLong("reading");
  takesLong("planning");
  takesLong("reading");
  EXPECT_THAT(WindowThread::takeOffenders(), testing::ElementsAre("planning", "reading"));
  EXPECT_TRUE(WindowThread::takeOffenders().empty());
}

TEST(WindowThread, LetsOtherThreadsTakeTheirTime) {
  const WindowThread window;
  std::thread([] { takesLong("reading"); }).join();
  EXPECT_TRUE(WindowThread::takeOffenders().empty());
}

TEST(WindowThread, IsNoneWithoutAWindow) {
  takesLong("reading");
  {
    const WindowThread window;
    const WindowThread another;
  }
  takesLong("reading");
  EXPECT_TRUE(WindowThread::takeOffenders().empty());
}

} // namespace
} // namespace arris::base
