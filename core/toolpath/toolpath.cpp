#include "core/toolpath/toolpath.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/toolpath/chain.h"
#include "core/toolpath/unreached.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::toolpath {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using geometry::Point;

/// A transition that takes longer than this is worth a warning, s.
constexpr double kSlowCorner = 60;

/// A tip more pointed than this is a mistake of the drawing, rad: the wheel would swing out by 570 radii.
constexpr double kLeastAngle = base::radians(0.1);

void append(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

Problems checkSpikes(const Glass& glass) {
  Problems problems;
  for (EdgeId edge = 0; edge < glass.edges().size(); ++edge) {
    const double angle = base::kPi - std::abs(glass.turnAfter(edge));
    if (angle < kLeastAngle) {
      problems.push_back(Problem(Code::SpikeInContour, {{"angle_deg", base::degrees(angle)}})
                             .at(geometry::endPoint(glass.edges()[edge]))
                             .ofContour(glass.ringOf(edge).contour));
    }
  }
  return problems;
}

/// Names the corner in the sentence too.
void setCorner(Problem& problem, int id) {
  problem.corner = id;
  problem.values.push_back({"corner", std::int64_t{id}});
}

Problem ofCorner(Code code, const Corner& corner, std::vector<base::Value> values) {
  Problem problem = Problem(code, std::move(values)).at(corner.s).ofContour(corner.contour);
  setCorner(problem, corner.id);
  return problem;
}

Problems warnings(const Corner& corner, const recipe::Recipe& recipe) {
  Problems problems;
  if (corner.kind == CornerKind::Concave && corner.fillet > base::kContourAccuracy) {
    problems.push_back(
        ofCorner(Code::ConcaveFillet, corner, {{"fillet_mm", corner.fillet}, {"unground_mm", corner.unground}}));
  }
  if (corner.treatment != Treatment::Transition) {
    return problems;
  }
  if (!corner.relief) {
    problems.push_back(ofCorner(Code::NoRelief, corner,
                                {{"lift_mm", corner.widest - recipe.wheelRadius}, {"depth_mm", corner.tipDepth}}));
  }
  if (corner.blendTime > kSlowCorner) {
    problems.push_back(ofCorner(Code::SlowCorner, corner, {{"time_s", corner.blendTime}}));
  }
  return problems;
}

/// The loop on which a start that the recipe names lies.
std::size_t loopOfStart(const Glass& glass, const std::vector<WheelLoop>& loops, const Point& wanted) {
  std::size_t best = loops.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double distance = nearestOnLoop(glass, loops[i], wanted).distance;
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

/// Makes chains of loops and puts them in order.
class Builder {
public:
  Builder(const Glass& glass, const recipe::Recipe& recipe, Leads leads, std::stop_token stop)
      : m_glass(glass), m_recipe(recipe), m_leads(leads), m_stop(std::move(stop)) {}

  void addLoops(std::vector<WheelLoop> loops) {
    const std::size_t withStart = m_recipe.start ? loopOfStart(m_glass, loops, *m_recipe.start) : loops.size();
    for (std::size_t i = 0; i < loops.size() && !m_stop.stop_requested(); ++i) {
      addLoop(std::move(loops[i]), i == withStart);
    }
  }

  [[nodiscard]] const std::vector<WheelLoop>& leftOut() const {
    return m_leftOut;
  }

  [[nodiscard]] const std::vector<WheelLoop>& loops() const {
    return m_loops;
  }

  Toolpath inOrder(const std::vector<pattern::Contour>& contours, const Point& park) {
    std::vector<Chain> chains;
    chains.reserve(m_traced.size());
    for (Traced& traced : m_traced) {
      chains.push_back(std::move(traced.chain));
    }
    Toolpath result;
    result.problems = m_leftOutProblems;
    for (const std::size_t i : orderOfChains(chains, contours, park)) {
      addNumbered(std::move(chains[i]), m_traced[i], result);
    }
    return result;
  }

private:
  void addLoop(WheelLoop loop, bool atGivenStart) {
    Traced traced = atGivenStart ? tracedFrom(loop, nearestOnLoop(m_glass, loop, *m_recipe.start).start)
                                 : tracedFromBestStart(loop);
    const bool canBeEntered = !base::hasErrors(traced.problems);
    if (!canBeEntered && m_recipe.acceptUnreached) {
      m_leftOutProblems.push_back(leftOutBecauseOf(traced.problems));
      m_leftOut.push_back(std::move(loop));
      return;
    }
    m_traced.push_back(std::move(traced));
    m_loops.push_back(std::move(loop));
  }

  // Where the leads have no room at the best start they may have it elsewhere.
  [[nodiscard]] Traced tracedFromBestStart(const WheelLoop& loop) const {
    constexpr std::size_t kMostTried = 100;
    constexpr std::size_t kMostSteps = 1'000'000; // traced in all
    const std::vector<StartPoint> starts = startsOn(loop);
    const std::size_t most =
        m_leads == Leads::With ? std::min({kMostTried, starts.size(), 1 + kMostSteps / loop.steps.size()}) : 1;
    Traced first = tracedFrom(loop, starts.front());
    for (std::size_t i = 1; i < most && base::hasErrors(first.problems) && !m_stop.stop_requested(); ++i) {
      Traced other = tracedFrom(loop, starts[i]);
      if (!base::hasErrors(other.problems)) {
        return other;
      }
    }
    return first;
  }

  [[nodiscard]] Traced tracedFrom(const WheelLoop& loop, const StartPoint& start) const {
    const EdgeId first = loop.steps[start.step].edge;
    Problems problems;
    const double overlap =
        m_leads == Leads::With ? overlapOn(loop, m_glass.ringOf(first).contour, m_recipe, problems) : 0;
    Traced traced = traceLoop(m_glass, loop, start, overlap);
    if (m_leads == Leads::With) {
      addLeads(traced.chain, m_recipe);
      append(problems, checkLeads(traced.chain, first, traced.lastEdge, m_glass, m_recipe));
    }
    append(traced.problems, problems);
    return traced;
  }

  static Problem leftOutBecauseOf(const Problems& problems) {
    Problem problem =
        *std::find_if(problems.begin(), problems.end(), [](const Problem& p) { return p.code == Code::NoLead; });
    problem.code = Code::NoLeadAccepted;
    return problem;
  }

  // Numbers within a chain become numbers within the program.
  void addNumbered(Chain chain, const Traced& traced, Toolpath& toolpath) const {
    const int before = static_cast<int>(toolpath.corners.size());
    const auto shift = [before](int& number) { number += number > 0 ? before : 0; };
    for (PathSegment& segment : chain.segments) {
      shift(segment.corner);
      shift(segment.stopCorner);
    }
    for (Problem problem : traced.problems) {
      if (problem.corner) {
        setCorner(problem, *problem.corner + before);
      }
      toolpath.problems.push_back(std::move(problem));
    }
    for (Corner corner : traced.corners) {
      shift(corner.id);
      append(toolpath.problems, warnings(corner, m_recipe));
      toolpath.corners.push_back(corner);
    }
    toolpath.chains.push_back(std::move(chain));
  }

  const Glass& m_glass;
  const recipe::Recipe& m_recipe;
  Leads m_leads;
  std::stop_token m_stop;
  std::vector<WheelLoop> m_loops;
  std::vector<Traced> m_traced;
  std::vector<WheelLoop> m_leftOut; ///< that cannot be entered, where the recipe accepts that they stay unground
  Problems m_leftOutProblems;
};

} // namespace

Toolpath makeToolpath(const std::vector<pattern::Contour>& placed, const recipe::Recipe& recipe, Leads leads,
                      const Point& park, const std::stop_token& stop) {
  const Glass glass = glassOf(placed, recipe.direction);
  if (Problems spikes = checkSpikes(glass); !spikes.empty()) {
    Toolpath result;
    result.problems = std::move(spikes);
    return result;
  }
  const Offset offset = offsetOf(glass, recipe.wheelRadius, stop);
  if (offset.open) { // what of it stays unground would be told wrongly
    Toolpath result;
    result.problems.push_back(
        Problem(Code::NumericalFailure, {{"reason", "the wheel path could not be closed"}}).at(*offset.open));
    return result;
  }
  std::vector<WheelLoop> loops;
  for (const Loop& loop : offset.loops) {
    loops.push_back(makeWheelLoop(glass, offset, loop, recipe, stop));
    if (stop.stop_requested()) {
      return {};
    }
  }
  Builder builder(glass, recipe, leads, stop);
  builder.addLoops(std::move(loops));
  if (stop.stop_requested()) {
    return {};
  }
  Unreached unreached = findUnreached(glass, builder.loops(), builder.leftOut(), recipe);
  Toolpath result = builder.inOrder(placed, park);
  result.unground = std::move(unreached.unground);
  append(result.problems, unreached.problems);
  if (result.chains.empty() && !base::hasErrors(result.problems)) {
    result.problems.push_back(Problem(Code::NothingToGrind, {{"wheel_mm", recipe.wheelRadius}}));
  }
  return result;
}

} // namespace arris::toolpath
