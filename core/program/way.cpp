#include "core/program/way.h"

#include "core/geometry/biarc.h"

#include <cmath>

namespace arris::program {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Parabola;

/// What rounding may put outside the travel, mm; as for the job itself.
constexpr double kOutsideByRounding = 1e-6;

geometry::Station stationAt(const Parabola& parabola, double lambda) {
  const geometry::Evaluation at = geometry::evaluate(parabola, lambda);
  return {at.point, at.first.normalized()};
}

// Over λ the true length bends by no more than |q''|, so that a proportional λ is off by h²|q''|/8 in the middle of a
// stretch h. Stretches that short turn so little that a biarc follows them within nanometres.
std::vector<WayPiece> piecesOfParabola(const Parabola& parabola) {
  const double length = geometry::parameterLength(parabola);
  const double bend = geometry::evaluate(parabola, 0).second.norm();
  const int count = std::max(1, static_cast<int>(std::ceil(length * std::sqrt(bend / (8 * kPlaceAccuracy)))));
  std::vector<WayPiece> pieces;
  pieces.reserve(2 * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double from = length * i / count;
    const double to = length * (i + 1) / count;
    const geometry::Biarc biarc = geometry::biarcBetween(stationAt(parabola, from), stationAt(parabola, to));
    const double first = geometry::arcLength(biarc.first);
    const double second = biarc.second ? geometry::arcLength(*biarc.second) : 0;
    const double joint = biarc.second ? from + (to - from) * first / (first + second) : to;
    pieces.push_back({biarc.first, from, joint});
    if (biarc.second) {
      pieces.push_back({*biarc.second, joint, to});
    }
  }
  return pieces;
}

std::vector<WayPiece> piecesOfArc(const Arc& arc) {
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep()))));
  std::vector<WayPiece> pieces;
  for (int i = 0; i < count; ++i) {
    const double from = arc.length * i / count;
    const double to = arc.length * (i + 1) / count;
    pieces.push_back({geometry::part(arc, from, to), from, to});
  }
  return pieces;
}

} // namespace

std::vector<WayPiece> piecesOf(const Curve& curve) {
  if (const auto* parabola = std::get_if<Parabola>(&curve)) {
    return piecesOfParabola(*parabola);
  }
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    return piecesOfArc(*arc);
  }
  return {{curve, 0, geometry::parameterLength(curve)}};
}

bool isInTravel(const Curve& curve, const recipe::Machine& machine) {
  const geometry::Box box = geometry::bounds(curve);
  return box.min().minCoeff() >= -kOutsideByRounding &&
         (box.max() - machine.travel.head<2>()).maxCoeff() <= kOutsideByRounding;
}

} // namespace arris::program
