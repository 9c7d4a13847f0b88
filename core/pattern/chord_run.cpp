#include "core/pattern/chord_run.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace arris::pattern {
namespace {

using base::squared;
using geometry::Point;
using geometry::Vector;

/// A shorter line would not keep its direction, mm.
constexpr double kLeastStraight = 0.2;

/// The vertices of a straight part lie on it within this share of the tolerance.
constexpr double kOnStraight = 0.05;

/// Of a straight part of several chords this share of its length is left out at either end when its line is drawn: the
/// first chords of a curve beside it may be taken for a part of it.
constexpr double kUncertainShare = 0.1;

double distanceFrom(const Point& a, const Vector& direction, const Point& p) {
  return geometry::cross(direction, p - a);
}

class StraightFinder {
public:
  StraightFinder(const ChordRun& run, double tolerance)
      : m_run(run), m_points(run.vertices), m_last(run.vertices.size() - 1), m_tolerance(tolerance) {}

  std::vector<Straight> find() {
    std::vector<Straight> straights;
    for (std::size_t i = 0; i < m_last;) {
      const std::size_t j = farthestOnLine(i);
      if (isNoChord(i, j)) {
        straights.push_back(straightOf(i, j));
      }
      i = j;
    }
    return straights;
  }

private:
  [[nodiscard]] bool isOnLine(std::size_t i, std::size_t j) const {
    const Vector way = m_points[j] - m_points[i];
    const double length = way.norm();
    if (length == 0) {
      return false;
    }
    const Vector direction = way / length;
    double reached = 0;
    for (std::size_t k = i + 1; k <= j; ++k) {
      const double along = direction.dot(m_points[k] - m_points[i]);
      if (along <= reached || std::abs(distanceFrom(m_points[i], direction, m_points[k])) > kOnStraight * m_tolerance) {
        return false;
      }
      reached = along;
    }
    return true;
  }

  /// Doubles the step while the chords lie on a line, then halves it.
  [[nodiscard]] std::size_t farthestOnLine(std::size_t i) const {
    std::size_t good = i + 1;
    std::size_t step = 1;
    while (good + step <= m_last && isOnLine(i, good + step)) {
      good += step;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (good + step <= m_last && isOnLine(i, good + step)) {
        good += step;
      }
    }
    return good;
  }

  /// Whether a curve that goes on as the run does there would leave the line by more than the tolerance. Looks at two
  /// distances: the nearest vertex may be off by the rounding of the drawing.
  [[nodiscard]] bool bendsAway(std::size_t from, std::size_t corner, int step) const {
    const Vector line = m_points[corner] - m_points[from];
    const double length = line.norm();
    std::size_t k = corner;
    for (const double least : {length / 32, length / 4}) {
      double away = (m_points[k] - m_points[corner]).norm();
      while ((k == corner || away < least) && hasNext(k, step)) {
        k = next(k, step);
        away = (m_points[k] - m_points[corner]).norm();
      }
      if (away > 0 && std::abs(geometry::turn(line, m_points[k] - m_points[corner])) * squared(length) >
                          4 * m_tolerance * (length + away)) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool hasNext(std::size_t k, int step) const {
    return m_run.closed || (step > 0 ? k < m_last : k > 0);
  }

  [[nodiscard]] std::size_t next(std::size_t k, int step) const { // of a closed run the last vertex is the first
    if (step > 0) {
      return k >= m_last ? 1 : k + 1;
    }
    return k == 0 ? m_last - 1 : k - 1;
  }

  [[nodiscard]] bool isNoChord(std::size_t i, std::size_t j) const {
    return (m_points[j] - m_points[i]).norm() >= kLeastStraight && (bendsAway(i, j, 1) || bendsAway(j, i, -1));
  }

  [[nodiscard]] Straight straightOf(std::size_t i, std::size_t j) const {
    std::size_t a = i;
    std::size_t b = j;
    const double uncertain = kUncertainShare * (m_points[j] - m_points[i]).norm();
    const bool startsAtCorner = i == 0 && !m_run.closed;
    const bool endsAtCorner = j == m_last && !m_run.closed;
    while (!startsAtCorner && a + 1 < j && (m_points[a + 1] - m_points[i]).norm() <= uncertain) {
      ++a;
    }
    while (!endsAtCorner && b > a + 1 && (m_points[b - 1] - m_points[j]).norm() <= uncertain) {
      --b;
    }
    const Vector direction = (m_points[b] - m_points[a]).normalized();
    const auto foot = [&](const Point& p) { return Point(m_points[a] + direction.dot(p - m_points[a]) * direction); };
    return {i, j, a == i ? m_points[i] : foot(m_points[i]), b == j ? m_points[j] : foot(m_points[j]), {}};
  }

  const ChordRun& m_run;
  const std::vector<Point>& m_points;
  std::size_t m_last;
  double m_tolerance;
};

/// By chord: whether it belongs to a straight part.
std::vector<bool> straightChords(std::size_t chords, const std::vector<Straight>& straights) {
  std::vector<bool> result(chords, false);
  for (const Straight& straight : straights) {
    std::fill(result.begin() + static_cast<std::ptrdiff_t>(straight.first),
              result.begin() + static_cast<std::ptrdiff_t>(straight.last), true);
  }
  return result;
}

/// Next to a straight chord the turn is that of half a chord of the curve.
double curvatureAt(const Vector& before, const Vector& after, bool beforeIsStraight, bool afterIsStraight) {
  const double turn = geometry::turn(before, after);
  if (beforeIsStraight && afterIsStraight) {
    return 0;
  }
  if (beforeIsStraight || afterIsStraight) {
    return 2 * turn / (beforeIsStraight ? after : before).norm();
  }
  return 2 * turn / (before.norm() + after.norm());
}

} // namespace

ChordShape shapeOf(const ChordRun& run, const std::vector<Straight>& straights) {
  const std::vector<Point>& p = run.vertices;
  const std::size_t chords = p.size() - 1;
  const std::vector<bool> straight = straightChords(chords, straights);
  ChordShape shape;
  shape.way.assign(p.size(), 0);
  for (std::size_t i = 0; i < chords; ++i) {
    shape.way[i + 1] = shape.way[i] + (p[i + 1] - p[i]).norm();
  }
  shape.heading.assign(chords, 0);
  for (std::size_t i = 1; i < chords; ++i) {
    shape.heading[i] = shape.heading[i - 1] + geometry::turn(p[i] - p[i - 1], p[i + 1] - p[i]);
  }
  shape.curvature.assign(p.size(), 0);
  for (std::size_t i = 1; i < chords; ++i) {
    shape.curvature[i] = curvatureAt(p[i] - p[i - 1], p[i + 1] - p[i], straight[i - 1], straight[i]);
  }
  shape.curvature.front() = run.closed
                                ? curvatureAt(p[chords] - p[chords - 1], p[1] - p[0], straight[chords - 1], straight[0])
                                : shape.curvature[1];
  shape.curvature.back() = run.closed ? shape.curvature.front() : shape.curvature[chords - 1];
  shape.sagitta.assign(chords, 0);
  for (std::size_t i = 0; i < chords; ++i) {
    const double curvature = (shape.curvature[i] + shape.curvature[i + 1]) / 2;
    shape.sagitta[i] = straight[i] ? 0 : curvature * (p[i + 1] - p[i]).squaredNorm() / 8;
  }
  shape.centred = p;
  for (std::size_t i = run.closed ? 0 : 1; i < chords; ++i) {
    const std::size_t before = i == 0 ? chords - 1 : i - 1;
    const Vector along = (p[i] - p[before]).normalized() + (p[i + 1] - p[i]).normalized();
    shape.centred[i] += (shape.sagitta[before] + shape.sagitta[i]) / 4 * geometry::leftOf(along.normalized());
  }
  if (run.closed) {
    shape.centred.back() = shape.centred.front();
  }
  return shape;
}

std::vector<Straight> findStraights(const ChordRun& run, double tolerance) {
  return StraightFinder(run, tolerance).find();
}

ChordRun startingAt(const ChordRun& closedRun, std::size_t vertex) {
  ChordRun result = closedRun;
  result.vertices.pop_back();
  std::rotate(result.vertices.begin(), result.vertices.begin() + static_cast<std::ptrdiff_t>(vertex),
              result.vertices.end());
  result.vertices.push_back(result.vertices.front());
  return result;
}

} // namespace arris::pattern
