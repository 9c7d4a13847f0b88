#include "tests/structure/rules.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace arris::test {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

std::vector<fs::path> sourcesIn(const std::string& folder) {
  std::vector<fs::path> sources;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(ARRIS_SOURCE_DIR) / folder)) {
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") {
      sources.push_back(entry.path());
    }
  }
  return sources;
}

const std::vector<std::string>& flow() {
  static const std::vector<std::string> kFlow = flowOf(contentOf(fs::path(ARRIS_SOURCE_DIR) / "core/CMakeLists.txt"));
  return kFlow;
}

TEST(Sources, KeepTheRulesOfTheHouse) {
  for (const char* folder : {"core", "ui", "app"}) {
    for (const fs::path& source : sourcesIn(folder)) {
      const std::string path = source.lexically_relative(ARRIS_SOURCE_DIR).generic_string();
      EXPECT_THAT(brokenRules(path, contentOf(source), flow()), testing::IsEmpty());
    }
  }
}

TEST(Sources, OfCoreStandInTheFoldersOfTheFlow) {
  ASSERT_THAT(flow(), testing::SizeIs(testing::Ge(8)));
  for (const fs::path& source : sourcesIn("core")) {
    const fs::path path = source.lexically_relative(fs::path(ARRIS_SOURCE_DIR) / "core");
    EXPECT_THAT(flow(), testing::Contains(path.begin()->string())) << path;
  }
}

TEST(Sources, SeeDxflibInOneFileOnly) {
  std::vector<fs::path> seeing;
  for (const fs::path& source : sourcesIn("core")) {
    if (contentOf(source).find("#include <dxflib") != std::string::npos) {
      seeing.push_back(source);
    }
  }
  EXPECT_THAT(seeing, testing::SizeIs(testing::Le(1)));
}

} // namespace
} // namespace arris::test
