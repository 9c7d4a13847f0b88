#include "core/toolpath/toolpath.h"

#include "core/base/numbers.h"
#include "core/toolpath/chain.h"

namespace arris::toolpath {
namespace {

using base::Code;
using base::Problem;
using base::Problems;

/// A transition that takes longer than this is worth a warning, s.
constexpr double kSlowCorner = 60;

void append(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

Problems warnings(const Corner& corner, const recipe::Recipe& recipe) {
  Problems problems;
  if (corner.treatment != Treatment::Transition) {
    return problems;
  }
  if (!corner.relief) {
    problems.push_back(Problem(Code::NoRelief, {{"corner", std::int64_t{corner.id}},
                                                {"lift_mm", corner.widest - recipe.wheelRadius},
                                                {"depth_mm", corner.tipDepth}})
                           .at(corner.s)
                           .ofContour(corner.contour)
                           .ofCorner(corner.id));
  }
  if (corner.blendTime > kSlowCorner) {
    problems.push_back(Problem(Code::SlowCorner, {{"corner", std::int64_t{corner.id}}, {"time_s", corner.blendTime}})
                           .at(corner.s)
                           .ofContour(corner.contour)
                           .ofCorner(corner.id));
  }
  return problems;
}

} // namespace

Toolpath makeToolpath(const std::vector<pattern::Contour>& placed, const recipe::Recipe& recipe, Leads leads) {
  Toolpath result;
  std::vector<CompensatedContour> compensated;
  compensated.reserve(placed.size());
  for (const pattern::Contour& contour : placed) {
    compensated.push_back(compensate(contour, recipe, result.problems));
  }
  if (!base::hasErrors(result.problems)) { // offsets that meet at a corner would be found again here
    append(result.problems, checkClearance(compensated, recipe));
  }
  for (const CompensatedContour& contour : compensated) {
    if (contour.edges.empty()) {
      continue;
    }
    const StartPoint start = chooseStart(contour, recipe);
    const double overlap = leads == Leads::With ? overlapOn(contour, recipe, result.problems) : 0;
    Chain chain = traceContour(contour, start, overlap, result.corners);
    if (leads == Leads::With && !base::hasErrors(result.problems)) {
      addLeads(chain, recipe);
      append(result.problems, checkLeads(chain, contour, start, compensated, recipe));
    }
    result.chains.push_back(std::move(chain));
  }
  for (const Corner& corner : result.corners) {
    append(result.problems, warnings(corner, recipe));
  }
  return result;
}

} // namespace arris::toolpath
