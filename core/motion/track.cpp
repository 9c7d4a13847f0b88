#include "core/motion/track.h"

#include <cmath>

namespace arris::motion {
double parameterLength(const Segment& segment) {
  if (const auto* vertical = std::get_if<Vertical>(&segment.shape)) {
    return std::abs(vertical->to - vertical->from);
  }
  return geometry::parameterLength(curveOf(segment));
}

geometry::Curve curveOf(const Segment& segment) {
  return std::visit(
      [](const auto& shape) -> geometry::Curve {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Vertical>) {
          return geometry::Line{shape.at, shape.at};
        } else {
          return shape;
        }
      },
      segment.shape);
}

Evaluation evaluate(const Segment& segment, double lambda) {
  return std::visit(
      [&](const auto& shape) -> Evaluation {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Vertical>) {
          const double up = shape.to > shape.from ? 1 : -1;
          return {{shape.at.x(), shape.at.y(), shape.from + up * lambda}, {0, 0, up}, {0, 0, 0}};
        } else {
          const geometry::Evaluation plane = geometry::evaluate(shape, lambda);
          return {{plane.point.x(), plane.point.y(), segment.z},
                  {plane.first.x(), plane.first.y(), 0},
                  {plane.second.x(), plane.second.y(), 0}};
        }
      },
      segment.shape);
}

double arcLength(const Segment& segment, double lambda) {
  const auto* parabola = std::get_if<geometry::Parabola>(&segment.shape);
  return parabola ? geometry::arcLength(*parabola, lambda) : lambda;
}

double arcLength(std::span<const Segment> way) {
  double length = 0;
  for (const Segment& segment : way) {
    length += arcLength(segment, parameterLength(segment));
  }
  return length;
}

} // namespace arris::motion
