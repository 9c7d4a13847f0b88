#include "core/geometry/elliptic_arc.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace arris::geometry {

bool keepsCircles(const Eigen::Matrix2d& linear) {
  constexpr double kSame = 1e-12;
  const double size = linear.col(0).squaredNorm();
  return std::abs(linear.col(1).squaredNorm() - size) <= 2 * kSame * size &&
         std::abs(linear.col(0).dot(linear.col(1))) <= kSame * size;
}

Station stationAt(const EllipticArc& ellipticArc, double lambda) {
  const Evaluation at = evaluate(ellipticArc.arc, lambda);
  return {ellipticArc.map * at.point, (ellipticArc.map.linear() * at.first).normalized()};
}

std::optional<Arc> asCircular(const EllipticArc& ellipticArc) {
  const Eigen::Matrix2d linear = ellipticArc.map.linear();
  if (!keepsCircles(linear)) {
    return std::nullopt;
  }
  const Arc& arc = ellipticArc.arc;
  const double scale = linear.col(0).norm();
  const double curvature = linear.determinant() < 0 ? -arc.curvature / scale : arc.curvature / scale;
  return Arc{ellipticArc.map * arc.start, (linear * arc.tangent).normalized(), curvature, scale * arc.length};
}

bool follow(const EllipticArc& ellipticArc, ArcFitter& fitter) {
  constexpr int kPlaces = 16;
  constexpr double kRounding = 1e-9;
  const double length = ellipticArc.arc.length;
  const double sweep = std::abs(ellipticArc.arc.sweep());
  const int quarters = std::max(1, static_cast<int>(std::ceil(2 * sweep / base::kPi - kRounding)));
  const bool whole = sweep > 2 * base::kPi - kRounding;
  const Station first = stationAt(ellipticArc, 0);
  Station start = first;
  for (int quarter = 0; quarter < quarters; ++quarter) {
    const auto trace = [&](double u) { return stationAt(ellipticArc, length * (quarter + u) / quarters); };
    const Station end = whole && quarter + 1 == quarters ? first : trace(1);
    if (!fitter.follow(trace, start, end, kPlaces)) {
      return false;
    }
    start = end;
  }
  return true;
}

} // namespace arris::geometry
