#pragma once

#include <algorithm>
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

/// Every drawing of the corpus, sorted by name: decided by looking at the drawings, not by what the program said.
inline const std::vector<CorpusVerdict> kCorpusVerdicts = {
#include "tests/core/job/corpus_verdicts.inc"
};

} // namespace arris::test
