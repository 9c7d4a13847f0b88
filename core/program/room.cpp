#include "core/base/tolerances.h"
#include "core/program/manoeuvres.h"
#include "core/program/way.h"

#include <algorithm>
#include <cmath>

namespace arris::program {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using motion::Move;

/// The room is told to within this much, mm.
constexpr double kRoomStep = 0.01;

/// Moved towards the middle of its curvature, an arc keeps at least this share of its radius.
constexpr double kLeastRadiusLeft = 0.5;

bool isHollowFor(const Curve& curve, double shift) {
  const auto* arc = std::get_if<Arc>(&curve);
  return arc && 1 - arc->curvature * shift < kLeastRadiusLeft;
}

Line normalAt(const Point& point, const geometry::Vector& tangent, double shift) {
  return {point, point + shift * geometry::leftOf(tangent)};
}

} // namespace

Room::Room(const job::Job& job) : m_job(job), m_glass(toolpath::glassOf(job.contours, job.recipe.direction)) {}

double Room::beside(int segment, double most) const {
  if (most <= 0 || has(segment, most)) {
    return std::max(most, 0.0);
  }
  double room = 0;
  for (double above = most; above - room > kRoomStep;) {
    const double middle = (room + above) / 2;
    (has(segment, middle) ? room : above) = middle;
  }
  return room;
}

// What the wheel's centre sweeps on its way outwards is bordered by the way, the way moved outwards, and the normals at
// its ends. The way is free. An island of glass inside would come to light on one of the rows, which lie within a
// radius of each other.
bool Room::has(int segment, double beside) const {
  if (beside <= 0) {
    return true;
  }
  const motion::Segment& way = m_job.track[static_cast<std::size_t>(segment)];
  if (!motion::isAlongContour(way.move)) {
    return false;
  }
  const std::vector<WayPiece> pieces = piecesOf(motion::curveOf(way));
  const double shift = m_glass.side() * beside;
  const Curve& first = pieces.front().curve;
  const Curve& last = pieces.back().curve;
  if (!isFree(normalAt(geometry::startPoint(first), geometry::startTangent(first), shift)) ||
      !isFree(normalAt(geometry::endPoint(last), geometry::endTangent(last), shift))) {
    return false;
  }
  const int rows = static_cast<int>(std::ceil(beside / m_job.recipe.wheelRadius));
  return std::all_of(pieces.begin(), pieces.end(), [&](const WayPiece& piece) {
    bool isClear = !isHollowFor(piece.curve, shift);
    for (int row = 1; isClear && row <= rows; ++row) {
      isClear = isFree(geometry::offset(piece.curve, shift * row / rows));
    }
    return isClear;
  });
}

bool Room::isFree(const Curve& lineOrArc) const {
  // Half of the accuracy is left for what the job's own way may lack, and for arcs beside a transition.
  const double least = m_job.recipe.wheelRadius - base::kContourAccuracy / 2;
  bool isClear = isInTravel(lineOrArc, m_job.machine);
  if (isClear) {
    m_glass.tree().forNear(geometry::flatBounds(lineOrArc), least, [&](std::size_t edge) {
      isClear = geometry::distance(lineOrArc, m_glass.edges()[edge], least) >= least;
      return isClear;
    });
  }
  return isClear;
}

} // namespace arris::program
