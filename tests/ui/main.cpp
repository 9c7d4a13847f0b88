#include "core/base/window_thread.h"
#include "tests/ui/support/locales.h"
#include "ui/run_window.h"

#include <QApplication>

#include <gtest/gtest.h>

namespace {

/// A test fails where something that can take long ran on the thread of a window.
class WindowThreadStaysFree : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo& /*test*/) override {
    for (const std::string& what : arris::base::WindowThread::takeOffenders()) {
      ADD_FAILURE() << what << " ran on the window's thread";
    }
  }
};

} // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QLocale::setDefault(arris::test::kEnglish);
  arris::ui::prepareApplication(application);
  ::testing::InitGoogleTest(&argc, argv);
  ::testing::UnitTest::GetInstance()->listeners().Append(new WindowThreadStaysFree); // which takes it over
  return RUN_ALL_TESTS();
}
