#include "core/geometry/box_tree.h"

#include <cmath>

namespace arris::geometry {

FlatBox flatBounds(const Curve& lineOrArc) {
  constexpr double kShallow = 0.5; // rad
  FlatBox box(startPoint(lineOrArc));
  const auto* arc = std::get_if<Arc>(&lineOrArc);
  if (arc && std::abs(arc->sweep()) > kShallow) {
    return FlatBox(bounds(lineOrArc));
  }
  box.extend(FlatBox(endPoint(lineOrArc)));
  if (arc) {
    box.grow(arc->length * std::abs(arc->sweep()) / 8); // an arc rises above its chord by less than this
  }
  return box;
}

} // namespace arris::geometry
