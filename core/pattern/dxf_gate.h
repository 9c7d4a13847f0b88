#pragma once

#include "core/base/problem.h"
#include "core/pattern/dxf_entities.h"
#include "core/recipe/recipe.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace arris::pattern {

/// What a well-formed DXF text holds: the entities of its ENTITIES section in order, and what else decides about them.
/// The views point into the text.
struct Inventory {
  std::vector<Entity> entities;
  std::optional<std::int64_t> insUnits;    ///< $INSUNITS
  std::optional<std::int64_t> measurement; ///< $MEASUREMENT
  std::set<std::string> offLayers;         ///< names in capital letters
  std::set<std::string> frozenLayers;
};

/// The gate in front of dxflib, which reports no errors: walks over every group of the text and refuses the first thing
/// that is wrong, with its line. What comes through is complete (groups in pairs, sections and polylines closed, end of
/// file reached), and every number of an entity that can be part of a contour is finite and sane. `units` is what the
/// user says over what the file says; it decides which coordinates are absurd.
[[nodiscard]] base::Expected<Inventory> inspectDxf(std::string_view text, std::optional<recipe::Units> units);

/// The name of a layer as it is compared: without regard to case.
[[nodiscard]] std::string layerKey(std::string_view name);

} // namespace arris::pattern
