#include "core/job/job.h"
#include "core/pattern/pattern.h"
#include "tests/support/limited_process.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace arris::job {
namespace {

using base::Code;
using pattern::Pattern;

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "refused" or "skipped" (what it holds is not read yet), and why.
std::string refusalOf(const base::Problems& problems) {
  const auto first = std::find_if(problems.begin(), problems.end(),
                                  [](const auto& p) { return base::severityOf(p) == base::Severity::Error; });
  const bool notYet = std::any_of(problems.begin(), problems.end(), [](const auto& p) {
    return p.code == Code::EntityNotSupported;
  });
  return fmt::format("{}: {}", notYet ? "skipped" : "refused", base::describeWithPlace(*first, "on the table"));
}

/// With the wheel of the recipe and with a small one, on a machine that has room for every drawing.
std::string outcomeOf(const Pattern& pattern) {
  recipe::Machine machine;
  machine.travel = {20000, 20000, 120};
  Job job;
  for (const double radius : {75.0, 5.0}) {
    recipe::Recipe recipe;
    recipe.wheelRadius = radius;
    job = planJob(pattern, recipe, machine);
    if (job.canBeGround()) {
      return fmt::format("planned: R {}, {} corners, {:.3f} s", radius, job.toolpath.corners.size(), job.duration);
    }
  }
  return refusalOf(job.problems);
}

/// What a person needs to find the place of an error: a line, a place, or none because it is about the whole.
void expectUseful(const base::Problem& problem) {
  const bool aboutTheWhole = problem.code == Code::NoContour || problem.code == Code::DxfEmpty ||
                             problem.code == Code::DxfBinary || problem.code == Code::DxfNotDxf ||
                             problem.code == Code::UnitsUnknown;
  if (base::severityOf(problem) == base::Severity::Error && !aboutTheWhole && !problem.line && !problem.where) {
    throw std::runtime_error("no place");
  }
  if (base::describe(problem).find('{') != std::string::npos) {
    throw std::runtime_error("no value");
  }
}

// Drawings by people and CAD systems. Each is read and planned in a process of its own: none crashes, hangs or eats the
// memory, and what is refused is refused in words, with a line or a place.
TEST(Corpus, EveryDrawingIsPlannedOrRefusedInWords) {
  const char* folder = std::getenv("ARRIS_PATTERN_CORPUS"); // NOLINT(concurrency-mt-unsafe)
  if (!folder) {
    GTEST_SKIP() << "ARRIS_PATTERN_CORPUS names no folder of drawings";
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".dxf") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty()) << folder;

  std::map<std::string, int> counts;
  for (const std::filesystem::path& file : files) {
    constexpr unsigned kSeconds = 60; // in a Debug build under sanitizers, on a busy machine
    constexpr unsigned kMegabytes = 1024;
    const test::Outcome outcome = test::inLimitedProcess(kSeconds, kMegabytes, [&file]() {
      const Pattern pattern = pattern::readDxf(contentOf(file), {});
      std::for_each(pattern.problems.begin(), pattern.problems.end(), expectUseful);
      std::for_each(pattern.repairs.begin(), pattern.repairs.end(), expectUseful);
      return outcomeOf(pattern);
    });
    EXPECT_TRUE(outcome.ended) << file << ": " << outcome.failure;
    std::cout << file.filename().string() << ": " << outcome.text << '\n';
    ++counts[outcome.text.substr(0, outcome.text.find(':'))];
  }
  std::cout << files.size() << " drawings: " << counts["planned"] << " planned, " << counts["refused"] << " refused, "
            << counts["skipped"] << " skipped (several contours, concave corners, or entities not read yet)\n";
}

} // namespace
} // namespace arris::job
