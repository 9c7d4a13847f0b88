#pragma once

#include "core/base/problem.h"
#include "core/pattern/dxf_entities.h"
#include "core/recipe/recipe.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace arris::pattern {

/// A coordinate or radius above this is absurd for a pane of glass, mm (10 km). Below it a double resolves 2 nm.
inline constexpr double kMostCoordinate = 1e7;

/// A block: entities that an INSERT draws.
struct Block {
  std::string_view name;
  std::int64_t line = 0; ///< of the word BLOCK in the file, from 1
  std::int64_t flags = 0;
  std::array<double, 2> base{0, 0}; ///< the point that comes to lie where it is inserted
  std::vector<Entity> entities;
  std::optional<base::Problem> problem; ///< the first thing that is wrong in it; it matters to those who insert it
};

/// What a well-formed DXF text holds: the entities of its ENTITIES section in order, and what else decides about them.
/// The views point into the text, which for a binary file is `converted`.
struct Inventory {
  std::unique_ptr<const std::string> converted;
  std::vector<Entity> entities;
  std::map<std::string, Block> blocks;     ///< by name in capital letters
  std::optional<std::int64_t> insUnits;    ///< $INSUNITS
  std::optional<std::int64_t> measurement; ///< $MEASUREMENT
  std::set<std::string> offLayers;         ///< names in capital letters
  std::set<std::string> frozenLayers;
};

/// The gate in front of dxflib, which reports no errors: walks over every group of the text and refuses the first thing
/// that is wrong, with its line. What comes through is complete (groups in pairs, sections and polylines closed, end of
/// file reached), and every number of an entity that can be part of a contour is finite and sane. `units` is what the
/// user says over what the file says; it decides which coordinates are absurd. Blocks are judged alike, but what is
/// wrong within one is kept with it. A binary file is turned into text first: lines are then those of this text, two
/// for each group. Cancelled once a stop is requested.
[[nodiscard]] base::Expected<Inventory> inspectDxf(std::string_view text, std::optional<recipe::Units> units,
                                                   const std::stop_token& stop = {});

/// The name of a layer as it is compared: without regard to case.
[[nodiscard]] std::string layerKey(std::string_view name);

} // namespace arris::pattern
