#pragma once

#include "core/geometry/curve.h"
#include "core/pattern/dxf_gate.h"
#include "core/pattern/pattern.h"

#include <span>
#include <vector>

namespace arris::pattern {

/// Where the entities of the drawing, or of one copy of a block, stand.
struct Placement {
  Eigen::AffineCompact2d toMillimetres; ///< from the entities' coordinates
  std::string_view layer;               ///< of what is on layer 0 in the block; empty for the drawing itself
  std::int64_t line = 0;                ///< of the drawing's INSERT; 0 for the drawing itself
};

struct PlacedEntity {
  const Entity* entity = nullptr; ///< of the inventory
  std::uint32_t placement = 0;    ///< its number
};

/// What of a drawing is read, and what is told about the rest.
struct Selection {
  std::vector<PlacedEntity> entities;         ///< to read, in the order of the file, blocks where they are inserted
  std::vector<Placement> placements;          ///< the first is the drawing itself
  EntityCounts counts;                        ///< all in model space, INSERTs and what they draw too, by kind
  std::map<std::string, EntityCounts> layers; ///< the same by layer
  base::Problems problems;                    ///< one per kind and reason, with the first line and the count
};

/// Passes over what cannot be part of a contour (texts, dimensions, construction lines, layers that are off, …) with a
/// note, and names what could be part of one but is not read yet as an error: nothing is dropped silently but the paper
/// space's own viewports. INSERTs are followed into their blocks, where entities on layer 0 count as on the layer of
/// the INSERT; an INSERT on a frozen layer draws nothing. `onlyLayers`: where not empty, the layers that are read, in
/// any case. `scale` is mm per drawing unit, for blocks too, whatever unit they have of their own.
[[nodiscard]] Selection selectEntities(const Inventory& inventory, std::span<const std::string> onlyLayers,
                                       double scale);

} // namespace arris::pattern
