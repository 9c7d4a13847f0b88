#include "core/toolpath/blocked.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

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

/// Places on a path between its ends, ascending.
class Marks {
public:
  explicit Marks(double end) : m_end(end) {}

  void add(const Track::Meetings& meetings) {
    for (std::size_t i = 0; i < meetings.count; ++i) {
      const double s = meetings.s[i];
      if (s > -m_end && s < m_end) {
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
    m_marks[m_count] = m_end;
  }

  /// The ends of the stretches between the marks, the end of the path last.
  [[nodiscard]] const double* begin() const {
    return m_marks.data();
  }

  [[nodiscard]] const double* end() const {
    return m_marks.data() + m_count + 1;
  }

private:
  double m_end;
  std::array<double, 9> m_marks; ///< four curves with two meetings each, and the end
  std::size_t m_count = 0;
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

// The border of what is nearer than the radius: two lines or circles beside the edge, two circles about its ends.
Marks marksOf(const Track& path, const Curve& edge, double radius) {
  Marks marks(path.end());
  if (const auto* line = std::get_if<Line>(&edge)) {
    const Vector normal = geometry::leftOf((line->to - line->from).normalized());
    marks.add(path.meetLine(line->from + radius * normal, normal));
    marks.add(path.meetLine(line->from - radius * normal, normal));
  } else {
    const auto& arc = std::get<Arc>(edge);
    marks.add(path.meetCircle(arc.center(), arc.radius() + radius));
    marks.add(path.meetCircle(arc.center(), std::abs(arc.radius() - radius)));
  }
  marks.add(path.meetCircle(geometry::startPoint(edge), radius));
  marks.add(path.meetCircle(geometry::endPoint(edge), radius));
  marks.sort();
  return marks;
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
  double from = -m_path.end();
  bool taken = false;
  for (const double to : marksOf(m_path, edge, m_radius)) {
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
