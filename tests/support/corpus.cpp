#include "tests/support/corpus.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace arris::test {
namespace {

const std::vector<CorpusVerdict>& verdicts() {
  static const std::vector<CorpusVerdict> kVerdicts = {
#include "tests/support/corpus_verdicts.inc"
  };
  return kVerdicts;
}

} // namespace

std::optional<CorpusVerdict> verdictOn(std::string_view file) {
  const auto found =
      std::find_if(verdicts().begin(), verdicts().end(), [file](const CorpusVerdict& v) { return v.file == file; });
  return found != verdicts().end() ? std::optional(*found) : std::nullopt;
}

std::size_t countOfVerdicts() {
  return verdicts().size();
}

std::optional<std::filesystem::path> corpusFolder() {
  const char* folder = std::getenv("ARRIS_PATTERN_CORPUS"); // NOLINT(concurrency-mt-unsafe)
  return folder ? std::optional<std::filesystem::path>(folder) : std::nullopt;
}

std::vector<std::filesystem::path> drawingsIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".dxf") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

job::Job plannedAs(const CorpusVerdict& verdict, const pattern::Pattern& pattern) {
  constexpr double kSmallWheel = 10;
  recipe::Machine machine;
  machine.travel = {20000, 20000, 120};
  recipe::Recipe recipe;
  recipe.wheelRadius = verdict.wheelRadius > 0 ? verdict.wheelRadius : 0.5;
  if (recipe.wheelRadius <= kSmallWheel) {
    recipe.lead = 1.5;
    recipe.overlap = 1;
    recipe.depth = 0.05;
  }
  return job::planJob(pattern, recipe, machine);
}

} // namespace arris::test
