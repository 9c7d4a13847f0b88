#include "core/pattern/smooth_joints.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/geometry/biarc.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::pattern {
namespace {

using base::squared;
using geometry::Arc;
using geometry::Curve;
using geometry::Evaluation;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

/// An arc of a larger radius than this is not worth having, mm.
constexpr double kMostRadius = 1e6;

/// Of an arc at most this much is cut off, rad: it is all but a parabola over so short a way, as `chooseCuts` takes it.
constexpr double kMostSweepCut = 0.03;

/// What is left of a curve between two cuts is cut off too where it is shorter than this and than both cuts together,
/// mm: two rounded ends so near to each other would not keep the direction of a line.
constexpr double kLeastLeft = 0.1;

/// Cutting off what is left moves each cut by up to half of `kLeastLeft`; the deviation keeps room for that, mm. (An
/// arc that turns by θ from cuts of length t passes the joint at tθ/4.)
constexpr double kDeviation = base::kSmoothDeviation - kLeastLeft / 2 * base::kSmoothTurn / 4;

double curvatureOf(const Curve& curve) {
  const auto* arc = std::get_if<Arc>(&curve);
  return arc ? arc->curvature : 0;
}

/// How much may be cut off at one end, mm.
double roomOf(const Curve& curve) {
  const double half = geometry::parameterLength(curve) / 2;
  const double curvature = std::abs(curvatureOf(curve));
  return curvature * half <= kMostSweepCut ? half : kMostSweepCut / curvature;
}

/// A curve may be turned by this much without anybody noticing, rad: a tenth of what counts as tangential.
constexpr double kUnnoticed = base::kTangentTurn / 10;

/// How much of the curves before and after a joint is cut off, mm. 0 and 0 leave the joint as it is; where one is 0,
/// the line on that side ends on the cut of the other.
struct Cuts {
  double before = 0;
  double after = 0;
};

// Over a short way the curves are parabolas y = κ₁x²/2 and y = θx + κ₂x²/2 about the joint. The parabola of curvature k
// that touches both does so at −t₁ and t₂ with a = k − κ₁, b = k − κ₂ (a, b > 0 for a turn θ > 0):
//   a t₁² = b t₂²,  a t₁ + b t₂ = θ,  so  t₁ = θ/(a + √(ab)),  t₂ = θ/(b + √(ab)),
// and it passes the joint at a t₁²/2 = θ²/(2(√a + √b)²). The longest arc has the least a and b: with e the lesser and
// e + d the greater of the two (d = |κ₁ − κ₂|), each condition gives a least e in closed form.
Cuts chooseCuts(double turn, double before, double after, double roomBefore, double roomAfter) {
  const double side = turn > 0 ? 1 : -1;
  const double theta = std::abs(turn);
  const double d = std::abs(before - after);
  const bool beforeIsNearer = side * before >= side * after;
  const double nearest = beforeIsNearer ? side * before : side * after; // curvature to be exceeded
  const double nearRoom = beforeIsNearer ? roomBefore : roomAfter;
  const double farRoom = beforeIsNearer ? roomAfter : roomBefore;

  const double nearLimit = theta / nearRoom; // θ/(e + √(e(e+d))) ≤ room
  double e = squared(nearLimit) / (d + 2 * nearLimit);
  const double farLimit = theta / farRoom; // θ/(e + d + √(e(e+d))) ≤ room
  if (farLimit > d) {
    e = std::max(e, squared(farLimit - d) / (2 * farLimit - d));
  }
  const double roots = theta / std::sqrt(2 * kDeviation); // √e + √(e+d) at least
  if (squared(roots) > d) {
    e = std::max(e, squared((squared(roots) - d) / (2 * roots)));
  }
  if (std::abs(nearest + e) < 1 / kMostRadius) {
    e = 1 / kMostRadius - nearest;
  }
  const double root = std::sqrt(e * (e + d));
  const double nearCut = std::min(theta / (e + root), nearRoom);
  const double farCut = std::min(theta / (e + d + root), farRoom);
  return beforeIsNearer ? Cuts{nearCut, farCut} : Cuts{farCut, nearCut};
}

// Where a line turns a little away from an arc, the arc has the line's direction θ/κ further on and lies θ²/(2κ) beside
// it: mostly nothing at all. Then the line ends there, which is better than an arc of atoms' length.
double shiftAlongArc(double turn, double curvature, double lineLength) {
  const bool turnsAway = turn * curvature < 0;
  const double beside = squared(turn) / (2 * std::abs(curvature));
  return turnsAway && beside < kUnnoticed * lineLength ? std::abs(turn / curvature) : 0;
}

/// Point and direction of travel where a curve is cut, seen from the joint: small numbers keep their digits.
using CutEnd = geometry::Station;

CutEnd alongFromJoint(const Vector& tangent, double curvature, double way) {
  if (curvature == 0) {
    return {way * tangent, tangent};
  }
  const Evaluation e = geometry::evaluate(Arc{Point::Zero(), tangent, curvature, std::abs(way)}, way);
  return {e.point, e.first};
}

CutEnd beforeJoint(const Curve& curve, double cut) {
  const CutEnd back = alongFromJoint(-geometry::endTangent(curve), -curvatureOf(curve), cut);
  return {back.point, -back.tangent};
}

CutEnd afterJoint(const Curve& curve, double cut) {
  return alongFromJoint(geometry::startTangent(curve), curvatureOf(curve), cut);
}

Curve shifted(const Curve& curve, const Point& by) {
  return geometry::transformed(curve, Eigen::Isometry2d(Eigen::Translation2d(by)));
}

class Smoother {
public:
  explicit Smoother(std::vector<Curve>& chain) : m_chain(chain), m_cuts(chain.size()) {}

  double smooth() {
    for (std::size_t i = 0; i < m_chain.size(); ++i) {
      m_cuts[i] = cutsBefore(i);
    }
    for (std::size_t i = 0; i < m_chain.size(); ++i) {
      cutOffRest(i);
    }
    std::vector<Curve> smoothed;
    smoothed.reserve(m_chain.size());
    for (std::size_t i = 0; i < m_chain.size(); ++i) {
      appendBridge(i, smoothed);
      appendRest(i, smoothed);
    }
    m_chain = std::move(smoothed);
    return m_deviation;
  }

private:
  [[nodiscard]] std::size_t next(std::size_t i) const {
    return i + 1 < m_chain.size() ? i + 1 : 0;
  }

  [[nodiscard]] std::size_t previous(std::size_t i) const {
    return i > 0 ? i - 1 : m_chain.size() - 1;
  }

  [[nodiscard]] Cuts cutsBefore(std::size_t i) const {
    const Curve& before = m_chain[previous(i)];
    const Curve& after = m_chain[i];
    const double turn = geometry::turn(geometry::endTangent(before), geometry::startTangent(after));
    if (std::abs(turn) <= base::kTangentTurn || std::abs(turn) >= base::kSmoothTurn) {
      return {};
    }
    const double k1 = curvatureOf(before);
    const double k2 = curvatureOf(after);
    if (k1 == 0 && k2 != 0) {
      if (const double shift = shiftAlongArc(turn, k2, geometry::parameterLength(before)); shift > 0) {
        return {0, shift};
      }
    }
    if (k2 == 0 && k1 != 0) {
      if (const double shift = shiftAlongArc(turn, k1, geometry::parameterLength(after)); shift > 0) {
        return {shift, 0};
      }
    }
    return chooseCuts(turn, k1, k2, roomOf(before), roomOf(after));
  }

  void cutOffRest(std::size_t i) {
    double& atStart = m_cuts[i].after;
    double& atEnd = m_cuts[next(i)].before;
    const double left = geometry::parameterLength(m_chain[i]) - atStart - atEnd;
    if (left < kLeastLeft && left < atStart + atEnd && isBridged(i) && isBridged(next(i))) {
      atStart += left / 2;
      atEnd = geometry::parameterLength(m_chain[i]) - atStart;
    }
  }

  [[nodiscard]] bool isBridged(std::size_t i) const {
    return m_cuts[i].before > 0 && m_cuts[i].after > 0;
  }

  void appendBridge(std::size_t i, std::vector<Curve>& out) {
    if (!isBridged(i)) {
      return;
    }
    const Point joint = geometry::startPoint(m_chain[i]);
    double nearest = std::numeric_limits<double>::infinity();
    const auto append = [&](const Curve& curve) {
      nearest = std::min(nearest, geometry::nearest(curve, Point::Zero()).distance);
      out.push_back(shifted(curve, joint));
    };
    const geometry::Biarc bridge = geometry::biarcBetween(beforeJoint(m_chain[previous(i)], m_cuts[i].before),
                                                          afterJoint(m_chain[i], m_cuts[i].after));
    append(bridge.first);
    if (bridge.second) {
      append(*bridge.second);
    }
    m_deviation = std::max(m_deviation, nearest);
  }

  // What is left of a curve is half of it at least, or nothing but rounding.
  void appendRest(std::size_t i, std::vector<Curve>& out) const {
    const Curve& curve = m_chain[i];
    const double length = geometry::parameterLength(curve);
    const double from = m_cuts[i].after;
    const double to = length - m_cuts[next(i)].before;
    if (to - from < base::kZeroLength / 4) {
      return;
    }
    if (std::holds_alternative<Line>(curve)) {
      out.emplace_back(Line{restStart(i), restEnd(i)});
    } else {
      out.push_back(from == 0 && to == length ? curve : geometry::part(curve, from, to));
    }
  }

  [[nodiscard]] Point restStart(std::size_t i) const {
    const Point joint = geometry::startPoint(m_chain[i]);
    return m_cuts[i].after > 0 ? Point(joint + afterJoint(m_chain[i], m_cuts[i].after).point)
                               : Point(joint + beforeJoint(m_chain[previous(i)], m_cuts[i].before).point);
  }

  [[nodiscard]] Point restEnd(std::size_t i) const {
    const Cuts& cuts = m_cuts[next(i)];
    const Point joint = geometry::startPoint(m_chain[next(i)]);
    return cuts.before > 0 ? Point(joint + beforeJoint(m_chain[i], cuts.before).point)
                           : Point(joint + afterJoint(m_chain[next(i)], cuts.after).point);
  }

  std::vector<Curve>& m_chain;
  std::vector<Cuts> m_cuts; ///< at the start of each curve
  double m_deviation = 0;
};

} // namespace

double smoothJoints(std::vector<Curve>& closedChain) {
  return closedChain.size() > 1 ? Smoother(closedChain).smooth() : 0;
}

} // namespace arris::pattern
