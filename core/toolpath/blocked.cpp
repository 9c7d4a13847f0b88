#include "core/toolpath/blocked.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace arris::toolpath {
namespace {

using base::squared;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Track;
using geometry::Vector;

/// Nearer than the radius by less than this is rounding, mm.
constexpr double kRounding = 1e-7;

/// Places on a path inside a stretch of it, ascending.
class Marks {
public:
  explicit Marks(const Stretch& stretch) : m_stretch(stretch) {}

  void add(const Track::Meetings& meetings) {
    for (std::size_t i = 0; i < meetings.count; ++i) {
      const double s = meetings.s[i];
      if (s > m_stretch.from && s < m_stretch.to) {
        m_marks[m_count++] = s;
      }
    }
  }

  void sort() {
    for (std::size_t i = 1; i < m_count; ++i) { // few
      for (std::size_t k = i; k > 0 && m_marks[k] < m_marks[k - 1]; --k) {
        std::swap(m_marks[k], m_marks[k - 1]);
      }
    }
    m_marks[m_count] = m_stretch.to;
  }

  /// The ends of the parts between the marks, the end of the stretch last.
  [[nodiscard]] const double* begin() const {
    return m_marks.data();
  }

  [[nodiscard]] const double* end() const {
    return m_marks.data() + m_count + 1;
  }

private:
  Stretch m_stretch;
  std::array<double, 9> m_marks; ///< four curves with two meetings each, and the end
  std::size_t m_count = 0;
};

/// A disc that holds a stretch of path.
struct Disc {
  Point middle;
  double radius = 0;
};

double squaredDistance(const Line& line, const Point& point) {
  const Vector way = line.to - line.from;
  const Vector from = point - line.from;
  const double length2 = way.squaredNorm();
  const double along = std::clamp(from.dot(way), 0.0, length2);
  return (from - (along / length2) * way).squaredNorm();
}

double squaredDistance(const Curve& edge, const Point& point) {
  const auto* line = std::get_if<Line>(&edge);
  return line ? squaredDistance(*line, point) : squared(geometry::nearest(edge, point).distance);
}

/// Where x + s·slope lies between two limits; empty (from ≥ to) where it never does.
Stretch between(double x, double slope, double least, double most) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (slope == 0) {
    return x > least && x < most ? Stretch{-kInfinite, kInfinite} : Stretch{0, 0};
  }
  const double a = (least - x) / slope;
  const double b = (most - x) / slope;
  return {std::min(a, b), std::max(a, b)};
}

/// Where a straight track is inside a circle, seen from the track's middle.
Stretch insideCircle(const Vector& middle, const Vector& tangent, double radius) {
  const double along = middle.dot(tangent);
  const double discriminant = squared(along) - middle.squaredNorm() + squared(radius);
  if (discriminant <= 0) {
    return {0, 0};
  }
  const double half = std::sqrt(discriminant);
  return {-along - half, -along + half};
}

// What is nearer to a line than the radius is convex, so a straight track is inside it once or never.
Stretch nearLine(const Track& path, const Line& line, double radius) {
  const Vector way = line.to - line.from;
  const double length = way.norm();
  const Vector direction = way / length;
  const Vector normal = geometry::leftOf(direction);
  const Vector middle = path.middle() - line.from;
  const Stretch beside = between(middle.dot(normal), path.tangent().dot(normal), -radius, radius);
  const Stretch along = between(middle.dot(direction), path.tangent().dot(direction), 0, length);
  Stretch result{0, 0};
  for (const Stretch& part :
       {Stretch{std::max(beside.from, along.from), std::min(beside.to, along.to)},
        insideCircle(middle, path.tangent(), radius), insideCircle(middle - way, path.tangent(), radius)}) {
    if (part.from < part.to) {
      const bool isFirst = result.from == result.to;
      result = isFirst ? part : Stretch{std::min(result.from, part.from), std::max(result.to, part.to)};
    }
  }
  return {std::max(result.from, -path.end()), std::min(result.to, path.end())};
}

// The border of what is nearer than the radius to a line is two lines beside it and two circles about its ends; those
// of them that the path may meet inside the disc.
void markLine(Marks& marks, const Track& path, const Disc& disc, const Line& line, double radius) {
  const Vector way = line.to - line.from;
  const double length = way.norm();
  const Vector direction = way / length;
  const Vector normal = geometry::leftOf(direction);
  const double along = (disc.middle - line.from).dot(direction);
  const double beside = (disc.middle - line.from).dot(normal);
  if (along + disc.radius > 0 && along - disc.radius < length) {
    if (beside + disc.radius > 0) {
      marks.add(path.meetLine(line.from + radius * normal, normal));
    }
    if (beside - disc.radius < 0) {
      marks.add(path.meetLine(line.from - radius * normal, normal));
    }
  }
  if (along - disc.radius < 0) {
    marks.add(path.meetCircle(line.from, radius));
  }
  if (along + disc.radius > length) {
    marks.add(path.meetCircle(line.to, radius));
  }
}

// The same with two circles beside an arc.
void markArc(Marks& marks, const Track& path, const Arc& arc, double radius) {
  marks.add(path.meetBeside(arc, radius));
  marks.add(path.meetBeside(arc, -radius));
  marks.add(path.meetCircle(arc.start, radius));
  marks.add(path.meetCircle(geometry::endPoint(arc), radius));
}

} // namespace

void FreeStretches::begin(const Curve& path) {
  m_path = Track(path);
  m_free.assign(1, {-m_path.end(), m_path.end()});
  measureHull();
}

// |dP/ds| is 1 at most.
void FreeStretches::measureHull() {
  if (m_free.empty()) {
    return;
  }
  const double from = m_free.front().from;
  const double to = m_free.back().to;
  m_middle = m_path.at((from + to) / 2);
  const double curvature = std::abs(m_path.curvature());
  m_reach = (to - from) / 2;
  m_reach = m_reach * curvature > 2 ? 2 / curvature : m_reach;
}

geometry::FlatBox FreeStretches::box() const {
  geometry::FlatBox box(m_path.at(m_free.front().from));
  box.extend(geometry::FlatBox(m_path.at(m_free.back().to)));
  const double curvature = std::abs(m_path.curvature());
  // A part no longer than twice the reach rises above its chord by half its curvature times the reach squared at most.
  const bool isWhole = m_reach * curvature >= 2;
  box.grow(isWhole ? m_reach : squared(m_reach) * curvature / 2);
  return box;
}

void FreeStretches::appendTo(std::vector<Stretch>& stretches) const {
  for (const Stretch& free : m_free) {
    stretches.push_back({m_path.lambda(free.from), m_path.lambda(free.to)});
  }
}

void FreeStretches::block(const Curve& edge) {
  // Mostly the edge is too far away to take anything, or near enough to take all.
  const double away2 = squaredDistance(edge, m_middle);
  if (away2 >= squared(m_radius + m_reach)) {
    return;
  }
  const double least = m_radius - kRounding;
  if (m_reach < least && away2 < squared(least - m_reach)) {
    m_free.clear();
    return;
  }
  const auto* line = std::get_if<Line>(&edge);
  if (line && m_path.curvature() == 0) {
    const auto [from, to] = nearLine(m_path, *line, m_radius);
    if (from < to && squaredDistance(*line, m_path.at((from + to) / 2)) < squared(least)) {
      take(from, to);
      measureHull();
    }
    return;
  }
  double from = m_free.front().from;
  Marks marks({from, m_free.back().to});
  if (line) {
    markLine(marks, m_path, {m_middle, m_reach}, *line, m_radius);
  } else {
    markArc(marks, m_path, std::get<Arc>(edge), m_radius);
  }
  marks.sort();
  bool taken = false;
  for (const double to : marks) {
    if (to > from && squaredDistance(edge, m_path.at((from + to) / 2)) < squared(least)) {
      take(from, to);
      taken = true;
    }
    from = to;
  }
  if (taken) {
    measureHull();
  }
}

void FreeStretches::take(double from, double to) {
  m_left.clear();
  for (const Stretch& free : m_free) {
    if (from > free.from) {
      m_left.push_back({free.from, std::min(free.to, from)});
    }
    if (to < free.to) {
      m_left.push_back({std::max(free.from, to), free.to});
    }
  }
  m_free.swap(m_left);
}

} // namespace arris::toolpath
