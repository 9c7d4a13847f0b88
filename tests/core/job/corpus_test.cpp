#include "tests/support/corpus.h"
#include "tests/support/limited_process.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace arris::job {
namespace {

using base::Code;
using test::CorpusVerdict;
using test::Verdict;

/// What a person needs to find the place of an error: a line, a place, or none because it is about the whole.
void expectUseful(const base::Problem& problem) {
  const bool aboutTheWhole = problem.code == Code::NoContour || problem.code == Code::DxfEmpty ||
                             problem.code == Code::DxfBinary || problem.code == Code::DxfNotDxf ||
                             problem.code == Code::UnitsUnknown || problem.code == Code::NothingToGrind;
  if (base::severityOf(problem) == base::Severity::Error && !aboutTheWhole && !problem.line && !problem.where) {
    throw std::runtime_error(fmt::format("no place: {}", base::describe(problem)));
  }
  if (base::describe(problem).find('{') != std::string::npos) {
    throw std::runtime_error(fmt::format("no value: {}", base::describe(problem)));
  }
}

bool isAccepted(const base::Problem& problem, std::string_view reasons) {
  const std::string between = fmt::format("|{}|", reasons);
  return base::severityOf(problem) == base::Severity::Error &&
         between.find(fmt::format("|{}|", base::info(problem.code).name)) != std::string::npos;
}

/// "planned" or "refused" with the first error; "agreed: " before it where the verdict says so too.
std::string outcomeOf(const std::filesystem::path& file, const CorpusVerdict& verdict) {
  const pattern::Pattern pattern = pattern::readDxf(test::contentOf(file), {});
  const Job job = test::plannedAs(verdict, pattern);
  std::for_each(job.problems.begin(), job.problems.end(), expectUseful);
  std::for_each(pattern.repairs.begin(), pattern.repairs.end(), expectUseful);
  if (job.canBeGround()) {
    return fmt::format("{}planned, {} contours, {} corners, {:.1f} s",
                       verdict.verdict == Verdict::Planned ? "agreed: " : "", job.contours.size(),
                       job.toolpath.corners.size(), job.duration);
  }
  const auto isReason = [&](const base::Problem& p) { return isAccepted(p, verdict.reasons); };
  const auto isError = [](const base::Problem& p) { return base::severityOf(p) == base::Severity::Error; };
  const auto reason = std::find_if(job.problems.begin(), job.problems.end(), isReason);
  const bool agreed = verdict.verdict == Verdict::Refused && reason != job.problems.end();
  const auto told = agreed ? reason : std::find_if(job.problems.begin(), job.problems.end(), isError);
  return fmt::format("{}refused, {}", agreed ? "agreed: " : "", base::describeWithPlace(*told, "on the table"));
}

// Drawings by people and CAD systems. Each is read and planned in a process of its own: none crashes, hangs or eats the
// memory, and each ends as a person who looked at it expects.
TEST(Corpus, EveryDrawingEndsAsAPersonWhoLooksAtItExpects) {
  const auto folder = test::corpusFolder();
  if (!folder) {
    GTEST_SKIP() << "ARRIS_PATTERN_CORPUS names no folder of drawings";
  }
  const std::vector<std::filesystem::path> files = test::drawingsIn(*folder);
  EXPECT_EQ(files.size(), test::countOfVerdicts());
  int planned = 0;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.filename().string();
    const auto verdict = test::verdictOn(name);
    if (!verdict) {
      ADD_FAILURE() << name << " has no verdict";
      continue;
    }
    constexpr unsigned kSeconds = 60; // in a Debug build under sanitizers, on a busy machine
    constexpr unsigned kMegabytes = 1024;
    const test::Outcome outcome =
        test::inLimitedProcess(kSeconds, kMegabytes, [&] { return outcomeOf(file, *verdict); });
    EXPECT_TRUE(outcome.ended) << name << ": " << outcome.failure;
    EXPECT_TRUE(outcome.text.starts_with("agreed: ")) << name << ": " << outcome.text << "\n  but: " << verdict->remark;
    planned += outcome.text.starts_with("agreed: planned") ? 1 : 0;
    std::cout << name << ": " << outcome.text << '\n';
  }
  std::cout << files.size() << " drawings, " << planned << " planned\n";
}

} // namespace
} // namespace arris::job
