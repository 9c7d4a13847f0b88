#include "core/pattern/dxf_selection.h"

#include "core/pattern/dxf_inserts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;

// Of a POLYLINE's flags.
constexpr std::int64_t kMesh = 16 | 32 | 64;

/// Why an entity is not read.
struct Refusal {
  Code code = Code::EntitiesPassedOver;
  std::string entity;
  std::string reason; ///< of passing over; empty for any other code

  bool operator<(const Refusal& other) const {
    return std::tie(code, entity, reason) < std::tie(other.code, other.entity, other.reason);
  }
};

Refusal passedOver(const Entity& entity, std::string reason) {
  return {Code::EntitiesPassedOver, readable(entity.type), std::move(reason)};
}

/// Heights within one entity may differ by this much, mm: what it does to a length is far below the contour's accuracy.
constexpr double kFlat = 1e-3;

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

/// Whether the coordinates are those of the world whatever the extrusion says.
bool isInTheWorld(const Entity& entity) {
  return entity.kind == EntityKind::Line || entity.kind == EntityKind::Spline ||
         (entity.kind == EntityKind::Polyline && (entity.flags & kInSpace) != 0);
}

std::optional<Refusal> tilt(const Entity& entity, double scale) {
  constexpr double kParallel = 1e-9;
  const auto [x, y, z] = entity.extrusion;
  const bool flat = scale * std::abs(entity.heights[1] - entity.heights[0]) <= kFlat;
  const bool parallel = isInTheWorld(entity) || std::hypot(x, y) <= kParallel * std::abs(z);
  if (!flat || !parallel) {
    return Refusal{Code::EntityNotPlanar, readable(entity.type), {}};
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
  return tilt(entity, scale);
}

struct Occurrences {
  std::int64_t firstLine = 0;
  std::int64_t count = 0;
};

Problem asProblem(const Refusal& refusal, const Occurrences& occurrences) {
  Problem problem(refusal.code, {{"entity", refusal.entity}, {"count", occurrences.count}});
  if (!refusal.reason.empty()) {
    problem.values.push_back({"reason", refusal.reason});
  }
  if (refusal.code == Code::InsertsTooMany) {
    problem.values.push_back({"most", kMostInserted});
  }
  return std::move(problem).onLine(occurrences.firstLine);
}

/// What is known of a layer once the first of its entities has come by.
struct LayerRecord {
  bool frozen = false;
  std::string hidden; ///< why nothing on it is read; empty where it is
  std::map<std::string_view, int> counts;
};

/// One walk over the drawing, and into the blocks that it inserts.
class Selector {
public:
  Selector(const Inventory& inventory, std::span<const std::string> onlyLayers, double scale);

  [[nodiscard]] Selection select();

private:
  void take(const Entity& entity, std::uint32_t placement);
  void follow(const Entity& entity, LayerRecord& layer, std::string_view layerName, std::uint32_t placement);
  void draw(const Insert& insert, const Block& block, std::string_view layer, std::int64_t line, std::uint32_t parent);
  [[nodiscard]] std::optional<Refusal> refusalOfInsert(const Entity& entity, const Insert& insert) const;
  [[nodiscard]] bool hasRoomFor(const Entity& insert);
  [[nodiscard]] LayerRecord& layerOf(std::string_view name);
  [[nodiscard]] std::string whyHidden(std::string_view layer) const;
  void note(const Entity& entity, const Refusal& refusal);
  void addCounts();

  const Inventory& m_inventory;
  std::set<std::string> m_onlyLayers;
  double m_scale;
  Selection m_selection;
  BlockSizes m_sizes;
  double m_inserted = 0;
  std::map<std::string_view, LayerRecord> m_layers;
  std::map<Refusal, Occurrences> m_refusals;
  std::set<const Block*> m_brokenBlocks; ///< those whose problem is told
};

Selector::Selector(const Inventory& inventory, std::span<const std::string> onlyLayers, double scale)
    : m_inventory(inventory), m_scale(scale), m_sizes(inventory) {
  for (const std::string& layer : onlyLayers) {
    m_onlyLayers.insert(layerKey(layer));
  }
  m_selection.placements.push_back({Eigen::AffineCompact2d(Eigen::Scaling(scale, scale)), {}, 0});
}

Selection Selector::select() {
  m_selection.entities.reserve(m_inventory.entities.size());
  for (const Entity& entity : m_inventory.entities) {
    take(entity, 0);
  }
  addCounts();
  for (const auto& [why, occurrences] : m_refusals) {
    m_selection.problems.push_back(asProblem(why, occurrences));
  }
  return std::move(m_selection);
}

void Selector::take(const Entity& entity, std::uint32_t placement) {
  if (entity.paperSpace && entity.type == "VIEWPORT") {
    return;
  }
  const bool inherits = placement != 0 && entity.layer == "0";
  const std::string_view layerName = inherits ? m_selection.placements[placement].layer : entity.layer;
  LayerRecord& layer = layerOf(layerName);
  if (!entity.paperSpace) {
    ++layer.counts[entity.type];
  }
  if (entity.kind == EntityKind::Insert) {
    follow(entity, layer, layerName, placement);
  } else if (const std::optional<Refusal> why = refusal(entity, layer.hidden, m_scale)) {
    note(entity, *why);
  } else {
    m_selection.entities.push_back({&entity, placement});
  }
}

// A layer that is off hides what stands on it, an INSERT draws on other layers too; a frozen one hides the whole
// INSERT.
void Selector::follow(const Entity& entity, LayerRecord& layer, std::string_view layerName, std::uint32_t placement) {
  const std::optional<Refusal> why = refusal(entity, layer.frozen ? layer.hidden : std::string(), m_scale);
  const Insert insert = readInsert(entity);
  const std::optional<Refusal> wrong = why ? why : refusalOfInsert(entity, insert);
  if (wrong) {
    note(entity, *wrong);
    return;
  }
  const Block& block = *findBlock(m_inventory, insert.block);
  if (block.problem) {
    if (m_brokenBlocks.insert(&block).second) {
      m_selection.problems.push_back(*block.problem);
    }
    return;
  }
  if (placement == 0 && !hasRoomFor(entity)) {
    return;
  }
  const std::int64_t line = placement == 0 ? entity.line : m_selection.placements[placement].line;
  draw(insert, block, layerName, line, placement);
}

std::optional<Refusal> Selector::refusalOfInsert(const Entity& entity, const Insert& insert) const {
  constexpr std::int64_t kExternal = 4;
  const Block* block = findBlock(m_inventory, insert.block);
  if (!block) {
    return Refusal{Code::BlockUnknown, quoted(insert.block), {}};
  }
  if ((block->flags & kExternal) != 0 && block->entities.empty()) {
    return Refusal{Code::EntityNotSupported, readable(entity.type) + " of another drawing", {}};
  }
  if (insert.scale.x() == 0 || insert.scale.y() == 0) {
    return Refusal{Code::EntityNotSupported, readable(entity.type) + " with a scale of 0", {}};
  }
  return std::nullopt;
}

bool Selector::hasRoomFor(const Entity& insert) {
  const base::Expected<double> drawn = m_sizes.drawnBy(insert);
  if (!drawn) {
    if (m_brokenBlocks.insert(findBlock(m_inventory, readInsert(insert).block)).second) {
      m_selection.problems.push_back(drawn.error());
    }
    return false;
  }
  if (m_inserted + *drawn > static_cast<double>(kMostInserted)) {
    note(insert, {Code::InsertsTooMany, quoted(readInsert(insert).block), {}});
    return false;
  }
  m_inserted += *drawn;
  return true;
}

void Selector::draw(const Insert& insert, const Block& block, std::string_view layer, std::int64_t line,
                    std::uint32_t parent) {
  for (std::int64_t row = 0; row < insert.rows; ++row) {
    for (std::int64_t column = 0; column < insert.columns; ++column) {
      const auto placement = static_cast<std::uint32_t>(m_selection.placements.size());
      const Eigen::AffineCompact2d map =
          m_selection.placements[parent].toMillimetres * placed(insert, block, column, row);
      m_selection.placements.push_back({map, layer, line});
      for (const Entity& entity : block.entities) {
        take(entity, placement);
      }
    }
  }
}

LayerRecord& Selector::layerOf(std::string_view name) {
  const auto [layer, isNew] = m_layers.try_emplace(name);
  if (isNew) {
    layer->second.frozen = m_inventory.frozenLayers.contains(layerKey(name));
    layer->second.hidden = whyHidden(name);
  }
  return layer->second;
}

std::string Selector::whyHidden(std::string_view layer) const {
  const std::string key = layerKey(layer);
  if (m_inventory.frozenLayers.contains(key)) {
    return "layer " + quoted(layer) + " is frozen";
  }
  if (key == "DEFPOINTS") {
    return "on layer " + quoted(layer) + ", which is never plotted";
  }
  if (m_inventory.offLayers.contains(key)) {
    return "layer " + quoted(layer) + " is off";
  }
  return m_onlyLayers.empty() || m_onlyLayers.contains(key) ? std::string()
                                                            : "layer " + quoted(layer) + " is not chosen";
}

void Selector::note(const Entity& entity, const Refusal& refusal) {
  Occurrences& occurrences = m_refusals[refusal];
  occurrences.firstLine = occurrences.count == 0 ? entity.line : occurrences.firstLine;
  ++occurrences.count;
}

void Selector::addCounts() {
  for (const auto& [name, layer] : m_layers) {
    for (const auto& [type, count] : layer.counts) {
      m_selection.counts[readable(type)] += count;
      m_selection.layers[readable(name)][readable(type)] += count;
    }
  }
}

} // namespace

Selection selectEntities(const Inventory& inventory, std::span<const std::string> onlyLayers, double scale) {
  return Selector(inventory, onlyLayers, scale).select();
}

} // namespace arris::pattern
