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

/// An arc between two knots turns by no more than this, rad: two arcs in its place have nearly its shape.
constexpr double kMostArcTurn = base::kPi / 2;

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
  RunFitter(ChordRun run, double tolerance) : m_run(std::move(run)), m_tolerance(tolerance) {}

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

  [[nodiscard]] double turnFrom(std::size_t from, std::size_t to) const {
    double turn = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      turn += geometry::turn(m_run.vertices[i] - m_run.vertices[i - 1], m_run.vertices[i + 1] - m_run.vertices[i]);
    }
    return turn;
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
    const double turn = turnFrom(0, last()) + geometry::turn(p[last()] - p[last() - 1], p[1] - p[0]);
    if (std::abs(std::abs(turn) - 2 * base::kPi) > kOnceRound) {
      return false;
    }
    return take({circleThrough(centredMiddles(0, last()), turn > 0), std::nullopt}, 0, last(), m_tolerance);
  }

  /// From corner to corner by one line or arc.
  bool asSingle() {
    if (m_run.startTangent || m_run.endTangent) {
      return false;
    }
    const Point& from = m_run.vertices.front();
    const Point& to = m_run.vertices.back();
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
      m_run = startingAt(m_run, m_straights.front().first);
      const std::size_t shift = m_straights.front().first;
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
    m_run = startingAt(m_run, static_cast<std::size_t>(most - m_shape.curvature.begin()));
    m_shape = shapeOf(m_run, {});
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
                        turnFrom(a.last, end) + geometry::turn(m_run.vertices[end] - m_run.vertices[end - 1], after);
    const std::optional<Fillet> fillet = filletThrough(a.to, before, b.from, after, turn, centredMiddles(a.last, end));
    if (!fillet || !(fillet->radius * turn > 0)) {
      return;
    }
    const Point from = fillet->center - fillet->radius * geometry::leftOf(before);
    const Point to = fillet->center - fillet->radius * geometry::leftOf(after);
    if (!hasRoom(a, a.from, from) || !hasRoom(b, to, b.to)) {
      return;
    }
    const Biarc arc{Arc{from, before, 1 / fillet->radius, std::abs(turn * fillet->radius)}, std::nullopt};
    if (distanceFromChords(arc, vertices(a.last, end), m_tolerance) <= m_tolerance) {
      a.to = from;
      b.from = to;
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
  }

  void fitBetween(const Straight& a, const Straight& b, std::size_t end) {
    const Station from = stationAtEnd(a);
    const Station to = stationAtStart(b);
    if (a.last == end) { // its arc passes the vertex
      append(geometry::biarcBetween(from, to),
             (geometry::nearest(geometry::biarcBetween(from, to).first, m_run.vertices[end])).distance);
      return;
    }
    fitSection(a.last, from, end, to);
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

  void fitSection(std::size_t from, Station start, std::size_t to, Station end) {
    m_shape.centred[from] = start.point;
    m_shape.centred[to] = end.point;
    const std::vector<std::size_t> knots = knotsBetween(from, to);
    if (start.tangent.isZero()) {
      start.tangent = tangentAtCorner(from, knots[1], 1);
    }
    if (end.tangent.isZero()) {
      end.tangent = tangentAtCorner(to, knots[knots.size() - 2], -1);
    }
    const Biarc whole = geometry::biarcBetween(start, end);
    if (knots.size() < 4 && take(whole, from, to, m_tolerance)) {
      return;
    }
    Station here = start;
    for (std::size_t k = 1; k < knots.size(); ++k) {
      const bool isLast = k + 1 == knots.size();
      const Station next = isLast ? end : stationAt(knots[k], knots[k - 1], knots[k + 1]);
      fitSpan(knots[k - 1], here, knots[k], next);
      here = next;
    }
  }

  /// By two arcs, or those of both halves where that does not do.
  void fitSpan(std::size_t from, const Station& start, std::size_t to, const Station& end) {
    const Biarc arcs = geometry::biarcBetween(start, end);
    if (take(arcs, from, to, m_tolerance)) {
      return;
    }
    if (to - from < 2) {
      append(arcs, distanceFromChords(arcs, vertices(from, to), HUGE_VAL));
      return;
    }
    const std::size_t middle = (from + to) / 2;
    const Station station = stationAt(middle, from, to);
    fitSpan(from, start, middle, station);
    fitSpan(middle, station, to, end);
  }

  /// A knot and the direction there: of the circle through it and points a quarter of the way to the knots beside it.
  [[nodiscard]] Station stationAt(std::size_t knot, std::size_t before, std::size_t after) const {
    const double reach = std::min(m_shape.way[knot] - m_shape.way[before], m_shape.way[after] - m_shape.way[knot]) / 4;
    const std::size_t a = std::min(nearestVertex(m_shape.way[knot] - reach), knot - 1);
    const std::size_t b = std::max(nearestVertex(m_shape.way[knot] + reach), knot + 1);
    const std::vector<Point>& p = m_shape.centred;
    return {p[knot], ThreePoints(p[a], p[knot], p[b]).atMiddle};
  }

  /// `step` is 1 at the start of a section and −1 at its end; the tangent is in the direction of travel.
  [[nodiscard]] Vector tangentAtCorner(std::size_t corner, std::size_t knot, int step) const {
    const std::vector<Point>& p = m_shape.centred;
    const std::size_t away = step > 0 ? knot - corner : corner - knot;
    const Point& end = p[knot];
    if (away < 2) {
      return step * (end - p[corner]).normalized();
    }
    const std::size_t between = step > 0 ? corner + away / 2 : corner - away / 2;
    return step * ThreePoints(p[corner], p[between], end).atFirst;
  }

  // Knots: as few as arcs through the points between them allow

  [[nodiscard]] std::vector<std::size_t> knotsBetween(std::size_t from, std::size_t to) const {
    double most = 0;
    for (std::size_t i = from; i < to; ++i) {
      most = std::max(most, std::abs(m_shape.sagitta[i]));
    }
    const double reach = std::max(m_tolerance - most / 2, m_tolerance / 4) / 2; // the rest is for the directions
    std::vector<std::size_t> knots{from};
    while (knots.back() < to) {
      knots.push_back(farthestByArc(knots.back(), to, reach));
    }
    return knots;
  }

  /// Doubles the step while an arc passes all points, then halves it.
  [[nodiscard]] std::size_t farthestByArc(std::size_t from, std::size_t to, double reach) const {
    std::size_t good = from + 1;
    std::size_t step = 1;
    while (good + step <= to && isByArc(from, good + step, reach)) {
      good += step;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (good + step <= to && isByArc(from, good + step, reach)) {
        good += step;
      }
    }
    return good;
  }

  [[nodiscard]] bool isByArc(std::size_t from, std::size_t to, double reach) const {
    const std::vector<Point>& p = m_shape.centred;
    const ThreePoints circle(p[from], p[nearestBetween(from, to)], p[to]);
    if (std::abs(circle.curvature) * (m_shape.way[to] - m_shape.way[from]) > kMostArcTurn) {
      return false;
    }
    const Curve arc = circle.curvature == 0
                          ? Curve(Line{p[from], p[to]})
                          : Curve(Arc{p[from], circle.atFirst, circle.curvature, 1 / std::abs(circle.curvature)});
    for (std::size_t i = from + 1; i < to; ++i) {
      if (std::abs(leftDistance(arc, p[i])) > reach) {
        return false;
      }
    }
    return true;
  }

  /// The vertex nearest to half-way, but neither end.
  [[nodiscard]] std::size_t nearestBetween(std::size_t from, std::size_t to) const {
    return std::clamp(nearestVertex((m_shape.way[from] + m_shape.way[to]) / 2), from + 1, to - 1);
  }

  ChordRun m_run;
  double m_tolerance;
  ChordShape m_shape;
  std::vector<Straight> m_straights;
  FittedRun m_result;
};

} // namespace

FittedRun fitRun(const ChordRun& run, double tolerance) {
  return RunFitter(run, tolerance).fit();
}

} // namespace arris::pattern
