#include "core/toolpath/chain.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::toolpath {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Point;
using geometry::Vector;

/// Walks round a compensated contour and notes the wheel path.
class Tracer {
public:
  Tracer(const CompensatedContour& contour, std::vector<Corner>& corners)
      : m_contour(contour), m_corners(corners), m_ids(contour.joints.size(), 0) {
    m_chain.contour = contour.contour;
  }

  void edge(std::size_t index, double from, double to) {
    const Edge& edge = m_contour.edges[index];
    const double length = geometry::parameterLength(edge.contour);
    const double scale = geometry::parameterLength(edge.path) / length;
    if (to - from < base::kZeroLength) {
      return;
    }
    const bool whole = from <= 0 && to >= length;
    m_chain.segments.push_back(
        {whole ? edge.path : geometry::part(edge.path, from * scale, to * scale), Role::Contour, 0, 0});
  }

  void joint(std::size_t index) {
    const Joint& joint = m_contour.joints[index];
    if (!joint.path) {
      return;
    }
    if (m_ids[index] == 0) {
      m_corners.push_back(*joint.corner);
      m_ids[index] = m_corners.back().id = static_cast<int>(m_corners.size());
    }
    const bool rolls = joint.corner->treatment == Treatment::Roll;
    m_chain.segments.push_back(
        {*joint.path, rolls ? Role::Roll : Role::Transition, m_ids[index], rolls ? 0 : joint.corner->transitionSpeed});
  }

  Chain take() {
    return std::move(m_chain);
  }

private:
  const CompensatedContour& m_contour;
  std::vector<Corner>& m_corners;
  std::vector<int> m_ids; ///< of the corner at each joint, once it has one
  Chain m_chain;
};

double contourLength(const CompensatedContour& contour) {
  double sum = 0;
  for (const Edge& edge : contour.edges) {
    sum += geometry::parameterLength(edge.contour);
  }
  return sum;
}

// Where the free space curves towards the wheel with less than twice the lead's radius, half of that radius fits.
double leadRadius(const Curve& path, double side, double lead) {
  const auto* arc = std::get_if<Arc>(&path);
  const bool hollow = arc && arc->curvature * side > 0;
  return hollow ? std::min(lead, arc->radius() / 2) : lead;
}

} // namespace

Chain traceContour(const CompensatedContour& contour, const StartPoint& start, double overlap,
                   std::vector<Corner>& corners) {
  const std::size_t count = contour.edges.size();
  const auto lengthOf = [&](std::size_t index) { return geometry::parameterLength(contour.edges[index].contour); };
  Tracer tracer(contour, corners);
  tracer.edge(start.edge, start.along, lengthOf(start.edge));
  for (std::size_t i = 1; i < count; ++i) {
    tracer.joint((start.edge + i - 1) % count);
    tracer.edge((start.edge + i) % count, 0, lengthOf((start.edge + i) % count));
  }
  tracer.joint((start.edge + count - 1) % count);
  // From here over the start point and on, measured along the contour from the beginning of the start's edge.
  double left = start.along + overlap;
  for (std::size_t i = start.edge; left > 0; i = (i + 1) % count) {
    tracer.edge(i, 0, std::min(left, lengthOf(i)));
    left -= lengthOf(i);
    if (left > base::kZeroLength) {
      tracer.joint(i);
    }
  }
  return tracer.take();
}

double overlapOn(const CompensatedContour& contour, const recipe::Recipe& recipe, base::Problems& problems) {
  const double quarter = contourLength(contour) / 4;
  if (recipe.overlap > quarter) {
    problems.push_back(
        base::Problem(base::Code::OverlapShortened, {{"used_mm", quarter}, {"wanted_mm", recipe.overlap}})
            .ofContour(contour.contour));
  }
  return std::min(recipe.overlap, quarter);
}

void addLeads(Chain& chain, const recipe::Recipe& recipe) {
  const double side = wheelSide(recipe.direction);
  const auto quarter = [&](const Curve& path, const Point& start, const Vector& tangent) {
    const double radius = leadRadius(path, side, recipe.lead);
    return Arc{start, tangent, side / radius, radius * base::kPi / 2};
  };
  const Curve& first = chain.segments.front().shape;
  const Arc backwards = [&] { // the lead-in seen from the glass
    Arc arc = quarter(first, geometry::startPoint(first), -geometry::startTangent(first));
    arc.curvature = -arc.curvature;
    return arc;
  }();
  const Curve& last = chain.segments.back().shape;
  const Arc out = quarter(last, geometry::endPoint(last), geometry::endTangent(last));
  chain.segments.insert(chain.segments.begin(), {geometry::reversed(backwards), Role::LeadIn, 0, 0});
  chain.segments.push_back({out, Role::LeadOut, 0, 0});
}

} // namespace arris::toolpath
