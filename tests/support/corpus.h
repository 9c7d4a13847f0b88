#pragma once

#include "core/job/job.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arris::test {

enum class Verdict { Planned, Refused };

/// What a person who looks at a drawing expects: a plan with a wheel that fits, or a refusal for one of some reasons.
struct CorpusVerdict {
  std::string_view file;
  Verdict verdict = Verdict::Refused;
  double wheelRadius = 0;   ///< mm, where it is planned
  std::string_view reasons; ///< codes of errors, any of which a person would accept, between bars
  std::string_view remark;  ///< what is to be seen in the drawing
};

/// The verdict on a drawing: decided by looking at it, not by what the program said.
[[nodiscard]] std::optional<CorpusVerdict> verdictOn(std::string_view file);
[[nodiscard]] std::size_t countOfVerdicts();

/// The folder that ARRIS_PATTERN_CORPUS names, if it names one.
[[nodiscard]] std::optional<std::filesystem::path> corpusFolder();

/// Its drawings, sorted by name.
[[nodiscard]] std::vector<std::filesystem::path> drawingsIn(const std::filesystem::path& folder);

[[nodiscard]] std::string contentOf(const std::filesystem::path& file);

/// A job with the wheel that the verdict names, or one of the smallest to be had, on a machine with room for every
/// drawing. Small wheels come with short leads and little depth.
[[nodiscard]] job::Job plannedAs(const CorpusVerdict& verdict, const pattern::Pattern& pattern);

} // namespace arris::test
