#include "core/pattern/dxf_selection.h"

#include <cmath>
#include <tuple>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;

// Flags of a POLYLINE (group 70).
constexpr std::int64_t kSplineFit = 4;
constexpr std::int64_t kMesh = 16 | 32 | 64;

/// Why an entity is not read.
struct Refusal {
  Code code = Code::EntitiesPassedOver;
  std::string entity;
  std::string reason; ///< of passing over

  bool operator<(const Refusal& other) const {
    return std::tie(code, entity, reason) < std::tie(other.code, other.entity, other.reason);
  }
};

Refusal passedOver(const Entity& entity, std::string reason) {
  return {Code::EntitiesPassedOver, readable(entity.type), std::move(reason)};
}

/// Heights within one entity may differ by this much, mm: what it does to a length is far below the contour's accuracy.
constexpr double kFlat = 1e-3;

/// Why nothing on a layer is read; empty where it is.
std::string whyHidden(std::string_view layer, const Inventory& inventory) {
  const std::string key = layerKey(layer);
  if (key == "DEFPOINTS") {
    return "on layer " + quoted(layer) + ", which is never plotted";
  }
  if (inventory.frozenLayers.contains(key)) {
    return "layer " + quoted(layer) + " is frozen";
  }
  return inventory.offLayers.contains(key) ? "layer " + quoted(layer) + " is off" : std::string();
}

std::optional<Refusal> hiddenness(const Entity& entity, const std::string& layerHidden) {
  if (entity.paperSpace) {
    return passedOver(entity, "in paper space");
  }
  if (entity.kind == EntityKind::NeverPartOfContour) {
    return passedOver(entity, "no part of a contour");
  }
  if (entity.invisible) {
    return passedOver(entity, "invisible");
  }
  return layerHidden.empty() ? std::nullopt : std::optional(passedOver(entity, layerHidden));
}

// A line's coordinates are those of the world whatever its extrusion; the flat entities have their own plane.
std::optional<Refusal> tilt(const Entity& entity, double scale) {
  constexpr double kParallel = 1e-9;
  const auto [x, y, z] = entity.extrusion;
  const bool flat = scale * std::abs(entity.heights[1] - entity.heights[0]) <= kFlat;
  const bool parallel = entity.kind == EntityKind::Line || std::hypot(x, y) <= kParallel * std::abs(z);
  if (!flat || !parallel) {
    return Refusal{Code::EntityNotPlanar, readable(entity.type), {}};
  }
  if (entity.kind != EntityKind::Line && z < 0) {
    return Refusal{Code::EntityNotSupported, readable(entity.type) + " seen from below (extrusion 0, 0, -1)", {}};
  }
  return std::nullopt;
}

std::optional<Refusal> refusal(const Entity& entity, const std::string& layerHidden, double scale) {
  if (std::optional<Refusal> hidden = hiddenness(entity, layerHidden)) {
    return hidden;
  }
  if (entity.kind == EntityKind::NotRead) {
    return Refusal{Code::EntityNotSupported, readable(entity.type), {}};
  }
  if (entity.kind == EntityKind::Polyline && (entity.flags & kMesh) != 0) {
    return Refusal{Code::EntityNotSupported, "POLYLINE as a mesh", {}};
  }
  if (entity.kind == EntityKind::Polyline && (entity.flags & kSplineFit) != 0) {
    return Refusal{Code::EntityNotSupported, "POLYLINE with a spline fitted to it", {}};
  }
  return tilt(entity, scale);
}

struct Occurrences {
  std::int64_t firstLine = 0;
  std::int64_t count = 0;
};

Problem asProblem(const Refusal& refusal, const Occurrences& occurrences) {
  const base::Value entity{"entity", refusal.entity};
  const base::Value count{"count", occurrences.count};
  Problem problem = refusal.reason.empty() ? Problem(refusal.code, {entity, count})
                                           : Problem(refusal.code, {entity, count, {"reason", refusal.reason}});
  return std::move(problem).onLine(occurrences.firstLine);
}

/// What is known of a layer once the first of its entities has come by.
struct LayerRecord {
  std::string hidden;
  std::map<std::string_view, int> counts;
};

void addCounts(Selection& selection, const std::map<std::string_view, LayerRecord>& layers) {
  for (const auto& [name, layer] : layers) {
    for (const auto& [type, count] : layer.counts) {
      selection.counts[readable(type)] += count;
      selection.layers[readable(name)][readable(type)] += count;
    }
  }
}

} // namespace

Selection selectEntities(const Inventory& inventory, double scale) {
  Selection selection;
  std::map<std::string_view, LayerRecord> layers;
  std::map<Refusal, Occurrences> refusals;
  for (const Entity& entity : inventory.entities) {
    if (entity.paperSpace && entity.type == "VIEWPORT") {
      continue;
    }
    const auto [layer, isNew] = layers.try_emplace(entity.layer);
    if (isNew) {
      layer->second.hidden = whyHidden(entity.layer, inventory);
    }
    if (!entity.paperSpace) {
      ++layer->second.counts[entity.type];
    }
    const std::optional<Refusal> why = refusal(entity, layer->second.hidden, scale);
    if (!why) {
      selection.entities.push_back(entity);
      continue;
    }
    Occurrences& occurrences = refusals[*why];
    occurrences.firstLine = occurrences.count == 0 ? entity.line : occurrences.firstLine;
    ++occurrences.count;
  }
  addCounts(selection, layers);
  for (const auto& [why, occurrences] : refusals) {
    selection.problems.push_back(asProblem(why, occurrences));
  }
  return selection;
}

} // namespace arris::pattern
