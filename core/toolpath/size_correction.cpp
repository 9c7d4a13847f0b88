#include "core/toolpath/size_correction.h"

#include "core/base/numbers.h"
#include "core/geometry/meetings.h"
#include "core/pattern/contour.h"
#include "core/toolpath/offset.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace arris::toolpath {
namespace {

using base::Code;
using base::kPi;
using base::Problem;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Track;
using geometry::Vector;

/// Edges are prolonged as what they are, line or circle, where they meet within this many times the way that straight
/// edges would need; else straight ahead.
constexpr double kMostProlonged = 4;

/// How far an edge is prolonged beyond its end, and the other backwards beyond its start, mm.
struct Prolonged {
  double before = 0;
  double after = 0;
};

/// The circle or line that a curve runs along from its end on, or backwards from its start.
Curve onwards(const Curve& curve, double length) {
  const geometry::Evaluation end = geometry::evaluate(curve, geometry::parameterLength(curve));
  const auto* arc = std::get_if<Arc>(&curve);
  if (arc) {
    return Arc{end.point, end.first, arc->curvature, std::min(length, 2 * kPi * arc->radius())};
  }
  return Line{end.point, end.point + length * end.first};
}

// The nearest point in which both meet ahead.
std::optional<Prolonged> meetAhead(const Curve& before, const Curve& after, double most) {
  const Curve first = onwards(before, most);
  const Curve second = onwards(geometry::reversed(after), most);
  const Track track(first);
  const Track::Meetings meetings = track.meetWhole(second);
  std::optional<Prolonged> best;
  for (std::size_t i = 0; i < meetings.count; ++i) {
    const double s = meetings.s[i];
    const double lambda = track.lambda(s);
    if (std::abs(s) > track.end() || lambda <= 0 || (best && lambda > best->before)) {
      continue;
    }
    const geometry::Nearest there = geometry::nearest(second, track.at(s));
    if (there.distance < 1e-6) {
      best = Prolonged{lambda, there.lambda};
    }
  }
  return best;
}

Curve longer(const Curve& curve, double atStart, double atEnd) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    const Vector direction = geometry::startTangent(curve);
    return Line{line->from - atStart * direction, line->to + atEnd * direction};
  }
  const auto& arc = std::get<Arc>(curve);
  const geometry::Evaluation start = geometry::evaluate(arc, -atStart);
  return Arc{start.point, start.first, arc.curvature, arc.length + atStart + atEnd};
}

/// Makes the corrected contour of one loop.
class Corrector {
public:
  Corrector(const Offset& offset, const Loop& loop) : m_offset(offset), m_loop(loop) {}

  /// The curves, or the place where a corner cannot be made sharp.
  tl::expected<std::vector<Curve>, Point> curves() {
    for (const Span& span : m_loop) {
      const Piece& piece = m_offset.pieces[span.piece];
      if (!piece.isRoll) {
        m_edges.push_back({geometry::part(piece.path, span.from, span.to)});
      } else if (span.from > 0 || span.to < piece.length) {
        return tl::unexpected(geometry::pointAt(piece.path, span.from));
      }
    }
    if (m_edges.empty()) {
      return tl::unexpected(geometry::startPoint(m_offset.pieces[m_loop.front().piece].path));
    }
    sharpenCorners();
    return assembled();
  }

private:
  struct Edge {
    Curve curve;
    double atStart = 0, atEnd = 0;                  ///< to be prolonged by
    std::optional<Point> straightTo = std::nullopt; ///< corner that both edges reach straight ahead
  };

  void sharpenCorners() {
    std::size_t edges = 0; // gone by
    for (const Span& span : m_loop) {
      const Piece& piece = m_offset.pieces[span.piece];
      if (!piece.isRoll) {
        ++edges;
        continue;
      }
      Edge& before = m_edges[(edges + m_edges.size() - 1) % m_edges.size()];
      Edge& after = m_edges[edges % m_edges.size()];
      const double leg = m_offset.radius * std::tan(std::min(piece.length / m_offset.radius, 3.1) / 2);
      if (const auto meeting = meetAhead(before.curve, after.curve, kMostProlonged * leg)) {
        before.atEnd = meeting->before;
        after.atStart = meeting->after;
      } else {
        const geometry::Evaluation end = geometry::evaluate(before.curve, geometry::parameterLength(before.curve));
        before.straightTo = end.point + leg * end.first;
      }
    }
  }

  [[nodiscard]] std::vector<Curve> assembled() const {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
      const Edge& edge = m_edges[i];
      curves.push_back(longer(edge.curve, edge.atStart, edge.atEnd));
      if (edge.straightTo) {
        curves.emplace_back(Line{geometry::endPoint(edge.curve), *edge.straightTo});
        curves.emplace_back(Line{*edge.straightTo, geometry::startPoint(m_edges[(i + 1) % m_edges.size()].curve)});
      }
    }
    return curves;
  }

  const Offset& m_offset;
  const Loop& m_loop;
  std::vector<Edge> m_edges;
};

Problem tooLarge(double correction, const Point& place, int contour) {
  return Problem(Code::SizeCorrectionTooLarge, {{"correction_mm", correction}}).at(place).ofContour(contour);
}

} // namespace

std::vector<pattern::Contour> sizeCorrected(const std::vector<pattern::Contour>& contours, double correction,
                                            base::Problems& problems) {
  if (correction == 0 || contours.empty()) {
    return contours;
  }
  // As stored the glass lies on the left.
  const Glass glass(contours, Glass::Order::AsStored, correction > 0 ? -1 : 1);
  const Offset offset = offsetOf(glass, std::abs(correction));
  std::vector<pattern::Contour> result = contours;
  std::vector<int> loopsOf(contours.size(), 0);
  std::map<int, std::size_t> index;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    index[contours[i].id] = i;
  }
  base::Problems faults;
  for (const Loop& loop : offset.loops) {
    const int id = glass.ringOf(offset.pieces[loop.front().piece].edge).contour;
    auto curves = Corrector(offset, loop).curves();
    if (!curves) {
      faults.push_back(tooLarge(correction, curves.error(), id));
    } else if (++loopsOf[index[id]] == 1) {
      result[index[id]].curves = *std::move(curves);
    }
  }
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (loopsOf[i] != 1 && faults.empty()) {
      faults.push_back(tooLarge(correction, geometry::startPoint(contours[i].curves.front()), contours[i].id));
    }
  }
  if (faults.empty()) {
    faults = pattern::checkContours(result);
  }
  problems.insert(problems.end(), faults.begin(), faults.end());
  return faults.empty() ? result : contours;
}

} // namespace arris::toolpath
