#include "tests/support/corpus.h"
#include "tests/support/promises.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace arris {
namespace {

namespace fs = std::filesystem;

/// The drawings that the fuzzer starts from, and those with which it found something.
std::vector<fs::path> fuzzDrawings() {
  std::vector<fs::path> files;
  for (const char* folder : {"corpus", "findings"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(ARRIS_FUZZ_DIR) / folder)) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Fuzz, EveryFindingAndEveryDrawingItBeganWithKeepsWhatIsPromised) {
  ASSERT_GT(fuzzDrawings().size(), 40U);
  for (const fs::path& file : fuzzDrawings()) {
    SCOPED_TRACE(file.filename());
    const std::string text = test::contentOf(file);
    const recipe::Recipe recipe = test::recipeFor(text);
    const pattern::Pattern pattern = pattern::readDxf(text, pattern::importOptions(recipe));
    EXPECT_EQ(test::brokenPromise(pattern).value_or(""), "");
    EXPECT_EQ(test::brokenPromise(job::planJob(pattern, recipe, test::largeMachine())).value_or(""), "");
  }
}

} // namespace
} // namespace arris
