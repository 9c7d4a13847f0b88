#include "tests/core/control/linuxcnc/hal_session.h"

#include "tests/support/scratch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace arris::test {
namespace {

const std::string kHalFolder = ARRIS_SOURCE_DIR "/packaging/hal/";

std::string textOf(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The same session with another stream of the sampler, of the same signals.
std::string withRecorder(std::string text) {
  const std::string load = "sampler depth=8000 cfg=fffffbb";
  const std::size_t at = text.find(load);
  EXPECT_NE(at, std::string::npos);
  text.replace(at, load.size(), "sampler depth=8000,60000 cfg=fffffbb,fffffbb");
  const std::size_t start = text.rfind("start\n");
  std::string recorder;
  const char* const recorded[] = {"x-measured", "y-measured", "z-measured", "number", "time", "chain-ok", "x-enabled"};
  for (int i = 0; i < 7; ++i) {
    recorder += std::string("net ") + recorded[i] + " => sampler.1.pin." + std::to_string(i) + "\n";
  }
  return text.insert(start, recorder + "addf sampler.1 servo\n");
}

int startScript(const std::string& arguments) {
  return std::system((kHalFolder + "start.sh " + arguments).c_str());
}

} // namespace

HalSession::HalSession(const std::string& name) {
  const Scratch scratch;
  const std::string file = (scratch / "session.hal").string();
  std::ofstream(file) << withRecorder(textOf(kHalFolder + "arris-" + name + ".hal"));
  m_runs = startScript("start " + file) == 0;
}

HalSession::~HalSession() {
  if (m_runs) {
    startScript("stop");
  }
}

std::string halcmd(const std::string& arguments) {
  const Scratch scratch;
  const std::string file = (scratch / "said").string();
  EXPECT_EQ(std::system(("halcmd " + arguments + " >" + file + " </dev/null").c_str()), 0);
  return textOf(file);
}

} // namespace arris::test
