#pragma once

#include "core/geometry/curve.h"
#include "core/pattern/dxf_entities.h"

#include <vector>

namespace arris::pattern {

/// Lines and arcs of entities, and what is wrong with entities that are no such.
struct ReadEntities {
  std::vector<geometry::Curve> pieces; ///< mm; one without length stays one (a line or an arc of length 0)
  base::Problems problems;
};

/// Reads entities that have passed the gate with dxflib; independent of every locale. `scale` is mm per drawing unit.
[[nodiscard]] ReadEntities readEntities(const std::vector<Entity>& entities, double scale);

} // namespace arris::pattern
