#include "core/pattern/fit_run.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/fit_distance.h"
#include "core/pattern/fit_single.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace arris::pattern {
namespace {

using geometry::Arc;
using geometry::Biarc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Station;
using geometry::Vector;

/// A run from corner to corner that a line passes within this share of the tolerance is one.
constexpr double kStraightShare = 0.25;

/// Two arcs turn by no more than this together, rad.
constexpr double kMostTurnOfSpan = 2.5;

/// The direction where two arcs end is taken from this share of their length to either side.
constexpr double kTangentShare = 1.0 / 16;

/// Of a straight part this share stays between the arcs at its ends, at least.
constexpr double kLeastLeftOfStraight = 0.1;

/// A closed run turns by once round to within this, rad.
constexpr double kOnceRound = 1e-6;

Vector rotatedBy(const Vector& v, double angle) {
  return Eigen::Rotation2Dd(angle) * v;
}

/// The circle through three points: its curvature and its direction in the first and in the middle one.
struct ThreePoints {
  Vector atFirst;
  Vector atMiddle;
  double curvature = 0;

  ThreePoints(const Point& a, const Point& b, const Point& c) {
    const Vector before = b - a;
    const Vector after = c - b;
    const double turn = geometry::turn(before, after);
    curvature = 2 * std::sin(turn) / (c - a).norm();
    const double half = turn / 2 + (std::asin(std::clamp(curvature * before.norm() / 2, -1.0, 1.0)) -
                                    std::asin(std::clamp(curvature * after.norm() / 2, -1.0, 1.0))) /
                                       2; // of the first arc: both halves are the turn, and keep all digits
    atFirst = rotatedBy(before.normalized(), -half);
    atMiddle = rotatedBy(before.normalized(), half);
  }
};

class RunFitter {
public:
  RunFitter(ChordRun run, double tolerance, std::stop_token stop)
      : m_run(std::move(run)), m_tolerance(tolerance), m_stop(std::move(stop)) {}

  FittedRun fit() {
    m_shape = shapeOf(m_run, {});
    if (!(m_run.closed ? asCircle() : asSingle())) {
      asSeveral();
    }
    return std::move(m_result);
  }

private:
  [[nodiscard]] std::size_t last() const {
    return m_run.vertices.size() - 1;
  }

  [[nodiscard]] std::span<const Point> vertices(std::size_t from, std::size_t to) const {
    return {m_run.vertices.data() + from, to - from + 1};
  }

  /// The middles of the chords, moved outwards by half of what the curve bulges there.
  [[nodiscard]] std::vector<Point> centredMiddles(std::size_t from, std::size_t to) const {
    std::vector<Point> middles;
    middles.reserve(to - from);
    for (std::size_t i = from; i < to; ++i) {
      const Point& a = m_run.vertices[i];
      const Point& b = m_run.vertices[i + 1];
      middles.emplace_back((a + b) / 2 - m_shape.sagitta[i] / 2 * geometry::leftOf((b - a).normalized()));
    }
    return middles;
  }

  /// What the chords between two vertices turn by, rad.
  [[nodiscard]] double turnBetween(std::size_t from, std::size_t to) const {
    return m_shape.heading[to - 1] - m_shape.heading[from];
  }

  bool take(const Biarc& fitted, std::size_t from, std::size_t to, double enough) {
    const double distance = distanceFromChords(fitted, vertices(from, to), enough);
    if (distance > enough) {
      return false;
    }
    append(fitted, distance);
    return true;
  }

  void append(const Biarc& fitted, double distance) {
    m_result.curves.push_back(fitted.first);
    if (fitted.second) {
      m_result.curves.push_back(*fitted.second);
    }
    m_result.deviation = std::max(m_result.deviation, distance);
  }

  bool asCircle() {
    const std::vector<Point>& p = m_run.vertices;
    const double turn = turnBetween(0, last()) + geometry::turn(p[last()] - p[last() - 1], p[1] - p[0]);
    if (std::abs(std::abs(turn) - 2 * base::kPi) > kOnceRound) {
      return false;
    }
    return take({circleThrough(centredMiddles(0, last()), turn > 0), std::nullopt}, 0, last(), m_tolerance);
  }

  /// From corner to corner by one line or arc.
  bool asSingle() {
    const Point& from = m_run.vertices.front();
    const Point& to = m_run.vertices.back();
    if (m_run.startTangent || m_run.endTangent || from == to) {
      return false;
    }
    if (take({Line{from, to}, std::nullopt}, 0, last(), kStraightShare * m_tolerance)) {
      return true;
    }
    const std::optional<Arc> arc = arcThrough(from, to, centredMiddles(0, last()));
    return arc && take({*arc, std::nullopt}, 0, last(), m_tolerance);
  }

  void asSeveral() {
    if (m_run.closed) {
      startWhereItBendsMost();
    }
    m_straights = findStraights(m_run, m_tolerance);
    if (m_run.closed && !m_straights.empty()) {
      const std::size_t shift = m_straights.front().first;
      rotate(shift);
      for (Straight& straight : m_straights) {
        straight.first -= shift;
        straight.last -= shift;
      }
    }
    m_shape = shapeOf(m_run, m_straights);
    if (m_straights.empty()) {
      fitSection(0, startStation(), last(), endStation());
    } else {
      fitStraightsAndBetween();
    }
  }

  void startWhereItBendsMost() {
    const auto bend = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto most = std::max_element(m_shape.curvature.begin(), std::prev(m_shape.curvature.end()), bend);
    rotate(static_cast<std::size_t>(most - m_shape.curvature.begin()));
  }

  void rotate(std::size_t vertex) {
    m_run = startingAt(m_run, vertex);
    m_rotated = (m_rotated + vertex) % last();
  }

  // Straights and sections

  void fitStraightsAndBetween() {
    const std::size_t count = m_straights.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
      roundBetween(m_straights[i], m_straights[i + 1], m_straights[i + 1].first);
    }
    if (m_run.closed) {
      roundBetween(m_straights[count - 1], m_straights[0], last());
    } else if (m_straights.front().first > 0) {
      fitSection(0, startStation(), m_straights.front().first, stationAtStart(m_straights.front()));
    }
    for (std::size_t i = 0; i < count; ++i) {
      appendStraight(m_straights[i]);
      if (i + 1 < count || m_run.closed) {
        const Straight& next = m_straights[(i + 1) % count];
        fitBetween(m_straights[i], next, i + 1 < count ? next.first : last());
      }
    }
    if (!m_run.closed && m_straights.back().last < last()) {
      fitSection(m_straights.back().last, stationAtEnd(m_straights.back()), last(), endStation());
    }
  }

  static Vector directionOf(const Straight& straight) {
    return (straight.to - straight.from).normalized();
  }

  static Station stationAtStart(const Straight& straight) {
    return {straight.from, directionOf(straight)};
  }

  static Station stationAtEnd(const Straight& straight) {
    return {straight.to, directionOf(straight)};
  }

  /// Moves the ends of two straight parts so that one arc can join them, if one can.
  void roundBetween(Straight& a, Straight& b, std::size_t end) {
    const Vector before = directionOf(a);
    const Vector after = directionOf(b);
    if (a.last == end) {
      cutCorner(a, b);
      return;
    }
    const double turn = geometry::turn(before, m_run.vertices[a.last + 1] - m_run.vertices[a.last]) +
                        turnBetween(a.last, end) + geometry::turn(m_run.vertices[end] - m_run.vertices[end - 1], after);
    const std::optional<Fillet> fillet = filletThrough(a.to, before, b.from, after, turn, centredMiddles(a.last, end));
    if (!fillet || !(fillet->radius * turn > 0)) {
      return;
    }
    const Point from = fillet->center - fillet->radius * geometry::leftOf(before);
    const Point to = fillet->center - fillet->radius * geometry::leftOf(after);
    if (!hasRoom(a, a.from, from) || !hasRoom(b, to, b.to)) {
      return;
    }
    const Arc arc{from, before, 1 / fillet->radius, std::abs(turn * fillet->radius)};
    const double distance = distanceFromChords(Line{a.from, from}, arc, Line{to, b.to}, vertices(a.last, end));
    if (distance <= m_tolerance) {
      a.to = from;
      b.from = to;
      a.rounded = distance;
    }
  }

  static bool hasRoom(const Straight& straight, const Point& from, const Point& to) {
    const Vector whole = straight.to - straight.from;
    return (to - from).dot(whole) > kLeastLeftOfStraight * whole.squaredNorm();
  }

  /// Two straight parts that meet in a vertex: an arc that turns by θ from x before it to x after it passes it at xθ/4.
  void cutCorner(Straight& a, Straight& b) const {
    const Vector before = directionOf(a);
    const Vector after = directionOf(b);
    const double turn = std::abs(geometry::turn(before, after));
    const Point corner = m_run.vertices[a.last];
    const double room = std::min((a.to - a.from).norm(), (b.to - b.from).norm()) / 3;
    const double cut = std::min(2 * m_tolerance / turn, room);
    a.to = corner - cut * before;
    b.from = corner + cut * after;
    a.rounded = cut * turn / 4;
  }

  void fitBetween(const Straight& a, const Straight& b, std::size_t end) {
    const Station from = stationAtEnd(a);
    const Station to = stationAtStart(b);
    if (a.rounded) {
      append(geometry::biarcBetween(from, to), *a.rounded);
    } else {
      fitSection(a.last, from, end, to);
    }
  }

  void appendStraight(const Straight& straight) {
    const Line line{straight.from, straight.to};
    m_result.curves.emplace_back(line);
    for (const Point& p : vertices(straight.first, straight.last)) {
      const double along = directionOf(straight).dot(p - straight.from);
      if (along > 0 && along < (straight.to - straight.from).norm()) {
        m_result.deviation = std::max(m_result.deviation, std::abs(leftDistance(line, p)));
      }
    }
  }

  // A section without straight parts, from station to station

  [[nodiscard]] Station startStation() const {
    if (m_run.closed) {
      const std::size_t beside = std::max<std::size_t>(1, nearestVertex(m_shape.way[last()] / 64));
      return {m_shape.centred[0],
              ThreePoints(m_shape.centred[last() - beside], m_shape.centred[0], m_shape.centred[beside]).atMiddle};
    }
    return {m_run.vertices.front(), m_run.startTangent.value_or(Vector::Zero())};
  }

  [[nodiscard]] Station endStation() const {
    return m_run.closed ? startStation() : Station{m_run.vertices.back(), m_run.endTangent.value_or(Vector::Zero())};
  }

  /// The vertex before or at this length along the chords.
  [[nodiscard]] std::size_t nearestVertex(double way) const {
    const auto after = std::upper_bound(m_shape.way.begin(), m_shape.way.end(), way);
    return static_cast<std::size_t>(after - m_shape.way.begin()) - 1;
  }

  /// Each time by the two arcs that reach farthest.
  void fitSection(std::size_t from, Station start, std::size_t to, const Station& end) {
    m_shape.centred[from] = start.point;
    m_shape.centred[to] = end.point;
    m_section = {from, to, end, reachIn(from, to)};
    for (std::size_t here = from; here < to && !m_stop.stop_requested();) {
      const std::size_t next = farthestFrom(here, start);
      const Span span = spanBetween(here, start, next);
      append(span.arcs, span.distance);
      if (span.distance > m_tolerance) {
        m_result.failed.push_back((here + m_rotated) % last());
      }
      start = span.end;
      here = next;
    }
  }

  /// Half of what chords and curve are apart cannot be avoided; half the tolerance is for having few arcs.
  [[nodiscard]] double reachIn(std::size_t from, std::size_t to) const {
    double most = 0;
    for (std::size_t i = from; i < to; ++i) {
      most = std::max(most, std::abs(m_shape.sagitta[i]));
    }
    return std::min(m_tolerance, (most + m_tolerance) / 2);
  }

  /// Two arcs from vertex to vertex, and how far the chords between are from them.
  struct Span {
    Biarc arcs;
    Station end;
    double distance = 0;
  };

  /// A direction that is not given is free.
  [[nodiscard]] Span spanBetween(std::size_t from, Station start, std::size_t to) const {
    Station end = to == m_section.to ? m_section.end : Station{m_shape.centred[to], Vector::Zero()};
    if (end.tangent.isZero()) {
      end.tangent = to == m_section.to ? tangentAtCorner(to, from, -1) : tangentAtKnot(to, from);
    }
    if (start.tangent.isZero()) {
      start.tangent = tangentAtCorner(from, to, 1);
    }
    Span span{geometry::biarcBetween(start, end), end, 0};
    span.distance = distanceFromChords(span.arcs, vertices(from, to), m_section.reach);
    return span;
  }

  [[nodiscard]] bool reaches(std::size_t from, const Station& start, std::size_t to) const {
    return std::abs(turnBetween(from, to)) <= kMostTurnOfSpan &&
           spanBetween(from, start, to).distance <= m_section.reach;
  }

  /// The whole way if two arcs do; else doubles the step while they do, then halves it. Beside corners and lines a few
  /// chords may be harder to follow than many: one failure does not end the doubling.
  [[nodiscard]] std::size_t farthestFrom(std::size_t from, const Station& start) const {
    if (reaches(from, start, m_section.to)) {
      return m_section.to;
    }
    std::size_t good = from + 1;
    std::size_t step = 2;
    for (int failures = 0; failures < 2 && from + step < m_section.to; step *= 2) {
      if (reaches(from, start, from + step)) {
        good = from + step;
        failures = 0;
      } else {
        ++failures;
      }
    }
    for (step = good - from; step > 0; step /= 2) {
      if (good + step < m_section.to && reaches(from, start, good + step)) {
        good += step;
      }
    }
    return good;
  }

  /// The direction at a vertex that two arcs from another end in: of the circle through it and points a little before
  /// and after it, so far away that the rounding of the drawing does not show in the direction.
  [[nodiscard]] Vector tangentAtKnot(std::size_t knot, std::size_t from) const {
    const double reach = (m_shape.way[knot] - m_shape.way[from]) * kTangentShare;
    const std::size_t a = std::clamp(nearestVertex(m_shape.way[knot] - reach), m_section.from, knot - 1);
    const std::size_t b = std::clamp(nearestVertex(m_shape.way[knot] + reach), knot + 1, m_section.to);
    const std::vector<Point>& p = m_shape.centred;
    return ThreePoints(p[a], p[knot], p[b]).atMiddle;
  }

  /// `step` is 1 at the start of a section and −1 at its end; the tangent is in the direction of travel.
  [[nodiscard]] Vector tangentAtCorner(std::size_t corner, std::size_t other, int step) const {
    const std::vector<Point>& p = m_shape.centred;
    const std::size_t chords = step > 0 ? other - corner : corner - other;
    const std::size_t away = std::max<std::size_t>(1, chords / 8);
    const auto at = [&](std::size_t k) { return p[step > 0 ? corner + k : corner - k]; };
    if (chords < 2) {
      return step * (p[other] - p[corner]).normalized();
    }
    return step * ThreePoints(p[corner], at(away), at(2 * away)).atFirst;
  }

  struct Section {
    std::size_t from = 0;
    std::size_t to = 0;
    Station end;
    double reach = 0; ///< how far two arcs may be from the chords, mm
  };

  ChordRun m_run;
  std::size_t m_rotated = 0; ///< number that its first vertex had when it came
  double m_tolerance;
  std::stop_token m_stop;
  Section m_section; ///< that is being fitted
  ChordShape m_shape;
  std::vector<Straight> m_straights;
  FittedRun m_result;
};

} // namespace

FittedRun fitRun(const ChordRun& run, double tolerance, const std::stop_token& stop) {
  return RunFitter(run, tolerance, stop).fit();
}

} // namespace arris::pattern
