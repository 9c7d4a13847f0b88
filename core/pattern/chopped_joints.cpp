#include "core/pattern/chopped_joints.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using geometry::Curve;
using geometry::Line;

/// Who draws a curve in chords that turn by more than this draws a polygon, rad: 18 chords make a circle.
constexpr double kMostChordTurn = 2 * base::kPi / 18;

/// A joint that turns by less than this is rounded within the tolerance whatever its neighbours do, rad.
constexpr double kLeastCornerTurn = 0.1;

/// A joint of more than this many times the curvature that either neighbour can stand for is a corner between them.
constexpr double kStandsOut = 1.5;

/// A tolerance that nobody may choose is not worth telling, mm.
constexpr double kMostTolerance = 1;

/// The joint at the start of a curve.
struct Joint {
  double turn = 0;      ///< rad, positive to the left
  double before = 0;    ///< length of the curve before, mm; 0: an arc
  double after = 0;     ///< of the curve after
  double curvature = 0; ///< of the circle through the three points, 1/mm
  double most = 0;      ///< curvature if the longer chord were straight: the most that the joint can stand for
};

double chordLength(const Curve& curve) {
  return std::holds_alternative<Line>(curve) ? geometry::parameterLength(curve) : 0;
}

Joint jointBetween(const Curve& before, const Curve& after) {
  Joint joint;
  joint.turn = geometry::turn(geometry::endTangent(before), geometry::startTangent(after));
  joint.before = chordLength(before);
  joint.after = chordLength(after);
  if (joint.before > 0 && joint.after > 0) {
    joint.curvature = 2 * joint.turn / (joint.before + joint.after);
    joint.most = 2 * joint.turn / std::min(joint.before, joint.after);
  } else if (joint.before > 0 || joint.after > 0) {
    joint.most = std::get<geometry::Arc>(joint.before > 0 ? after : before).curvature;
    joint.curvature = 2 * joint.turn / std::max(joint.before, joint.after);
  }
  return joint;
}

/// How far the curve that the joint stands for is from the shorter chord, mm: the longer may lie on a line that the
/// curve touches. A chord next to an arc bends towards that.
double sagittaOf(const Joint& joint) {
  const double shorter = std::min(joint.before, joint.after);
  return std::abs(joint.turn) * (shorter > 0 ? shorter / 8 : std::max(joint.before, joint.after) / 4);
}

bool standsOut(const Joint& joint, const Joint& previous, const Joint& next) {
  const auto sameWay = [&](const Joint& other) {
    const bool isCurve = std::abs(other.turn) <= kMostChordTurn && other.most * joint.turn > 0;
    return isCurve ? std::abs(other.most) : 0;
  };
  return std::abs(joint.turn) > kLeastCornerTurn &&
         std::abs(joint.curvature) > kStandsOut * std::max(sameWay(previous), sameWay(next));
}

/// What keeps a joint from being smooth.
enum class Verdict { Smooth, Corner, TooCoarse };

Verdict judge(const Joint& joint, const Joint& previous, const Joint& next, double tolerance) {
  const bool betweenArcs = joint.before == 0 && joint.after == 0;
  if (betweenArcs || std::abs(joint.turn) > kMostChordTurn || standsOut(joint, previous, next)) {
    return Verdict::Corner;
  }
  if (sagittaOf(joint) <= tolerance) {
    return Verdict::Smooth;
  }
  return std::abs(joint.turn) > base::kSmoothTurn ? Verdict::TooCoarse : Verdict::Corner;
}

// One note for each run of at least two joints: a single one is no curve.
base::Problems notesOf(const std::vector<Curve>& chain, const std::vector<Joint>& joints,
                       const std::vector<Verdict>& verdicts, double tolerance) {
  const std::size_t n = joints.size();
  const auto isCoarse = [&](std::size_t i) { return verdicts[i % n] == Verdict::TooCoarse; };
  std::size_t start = 0;
  while (start < n && isCoarse(start)) {
    ++start;
  }
  base::Problems notes;
  for (std::size_t i = start == n ? 0 : start; i < (start == n ? n : start + n);) {
    std::size_t end = i;
    double needed = 0;
    for (; end < i + n && end < start + n && isCoarse(end); ++end) {
      needed = std::max(needed, sagittaOf(joints[end % n]));
    }
    if (end >= i + 2 && needed <= kMostTolerance) {
      const double named = std::ceil(needed * 1e4) / 1e4; // in tenths of a micrometre, upwards
      notes.push_back(
          Problem(Code::ChordsTooCoarse,
                  {{"count", static_cast<std::int64_t>(end - i)}, {"needed_mm", named}, {"tolerance_mm", tolerance}})
              .at(geometry::startPoint(chain[i % n])));
    }
    i = std::max(end, i + 1);
  }
  return notes;
}

} // namespace

ChoppedJoints findChoppedJoints(const std::vector<Curve>& closedChain, double tolerance) {
  const std::size_t n = closedChain.size();
  std::vector<Joint> joints;
  joints.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    joints.push_back(jointBetween(closedChain[(i + n - 1) % n], closedChain[i]));
  }
  std::vector<Verdict> verdicts;
  verdicts.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    verdicts.push_back(judge(joints[i], joints[(i + n - 1) % n], joints[(i + 1) % n], tolerance));
  }
  ChoppedJoints result;
  result.notes = notesOf(closedChain, joints, verdicts, tolerance);
  std::transform(verdicts.begin(), verdicts.end(), std::back_inserter(result.smooth),
                 [](Verdict verdict) { return verdict == Verdict::Smooth; });
  return result;
}

} // namespace arris::pattern
