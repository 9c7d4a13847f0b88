#pragma once

#include "core/pattern/dxf_gate.h"
#include "core/pattern/pattern.h"

#include <vector>

namespace arris::pattern {

/// What of a drawing is read, and what is told about the rest.
struct Selection {
  std::vector<Entity> entities;               ///< to read, in the order of the file
  EntityCounts counts;                        ///< all in model space, by kind
  std::map<std::string, EntityCounts> layers; ///< the same by layer
  base::Problems problems;                    ///< one per kind and reason, with the first line and the count
};

/// Passes over what cannot be part of a contour (texts, dimensions, construction lines, layers that are off, …) with a
/// note, and names what could be part of one but is not read yet as an error: nothing is dropped silently but the paper
/// space's own viewports. `scale` is mm per drawing unit.
[[nodiscard]] Selection selectEntities(const Inventory& inventory, double scale);

} // namespace arris::pattern
