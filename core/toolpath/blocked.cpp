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
using geometry::Meetings;
using geometry::Point;
using geometry::Track;
using geometry::Vector;

/// Nearer than the radius by less than this is rounding, mm.
constexpr double kRounding = 1e-7;

/// λ inside a path, ascending.
class Marks {
public:
  explicit Marks(double length) : m_length(length) {}

  void add(const Meetings& meetings) {
    for (std::size_t i = 0; i < meetings.count; ++i) {
      const double lambda = meetings.lambda[i];
      if (lambda > 0 && lambda < m_length) {
        m_marks[m_count++] = lambda;
      }
    }
  }

  void sort() {
    std::sort(m_marks.begin(), m_marks.begin() + static_cast<std::ptrdiff_t>(m_count));
    m_marks[m_count] = m_length;
  }

  /// Ends of the stretches between the marks, the end of the path last.
  [[nodiscard]] const double* begin() const {
    return m_marks.data();
  }

  [[nodiscard]] const double* end() const {
    return m_marks.data() + m_count + 1;
  }

private:
  double m_length;
  std::array<double, 9> m_marks{}; ///< four curves with two meetings each, and the end
  std::size_t m_count = 0;
};

double squaredDistance(const Line& line, const Point& point) {
  const Vector way = line.to - line.from;
  const Vector from = point - line.from;
  const double along = std::clamp(from.dot(way), 0.0, way.squaredNorm());
  return (from - along / way.squaredNorm() * way).squaredNorm();
}

// The border of what is nearer than the radius: two lines or circles beside the edge, two circles about its ends.
Marks marksOf(const Track& path, const Curve& edge, double radius) {
  Marks marks(path.length);
  if (const auto* line = std::get_if<Line>(&edge)) {
    const Vector normal = geometry::leftOf((line->to - line->from).normalized());
    marks.add(geometry::meetLine(path, line->from + radius * normal, normal));
    marks.add(geometry::meetLine(path, line->from - radius * normal, normal));
  } else {
    const auto& arc = std::get<Arc>(edge);
    marks.add(geometry::meetCircle(path, arc.center(), arc.radius() + radius));
    marks.add(geometry::meetCircle(path, arc.center(), std::abs(arc.radius() - radius)));
  }
  marks.add(geometry::meetCircle(path, geometry::startPoint(edge), radius));
  marks.add(geometry::meetCircle(path, geometry::endPoint(edge), radius));
  marks.sort();
  return marks;
}

} // namespace

void FreeStretches::begin(const Curve& path) {
  m_path = Track(path);
  m_free.assign(1, {0, m_path.length});
}

void FreeStretches::block(const Curve& edge) {
  const auto* line = std::get_if<Line>(&edge);
  const double least2 = squared(m_radius - kRounding);
  const auto isNear = [&](double lambda) {
    const Point point = m_path.at(lambda);
    return (line ? squaredDistance(*line, point) : squared(geometry::nearest(edge, point).distance)) < least2;
  };
  double from = 0;
  for (const double to : marksOf(m_path, edge, m_radius)) {
    if (to > from && isNear((from + to) / 2)) {
      take(from, to);
    }
    from = to;
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
