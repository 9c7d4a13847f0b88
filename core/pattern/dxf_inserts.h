#pragma once

#include "core/base/caps.h"
#include "core/geometry/curve.h"
#include "core/pattern/dxf_gate.h"

#include <map>

namespace arris::pattern {

/// Blocks may insert blocks this deep.
inline constexpr int kMostNesting = 32;

/// All INSERTs of a drawing together may draw this much: entities, and the vertices and points of what has such.
inline constexpr std::int64_t kMostInserted = 1'000'000 / base::kCapDivisor;

/// What an INSERT says. Lengths in drawing units.
struct Insert {
  std::string_view block;
  geometry::Point at{0, 0};
  geometry::Vector scale{1, 1};
  double rotation = 0; ///< rad
  std::int64_t columns = 1;
  std::int64_t rows = 1;
  geometry::Vector spacing{0, 0}; ///< of columns and rows; turned with the block, not scaled
  bool mirrored = false;          ///< seen from below: X runs the other way
};

/// `entity` is an INSERT that has passed the gate.
[[nodiscard]] Insert readInsert(const Entity& entity);

/// From the coordinates of the block to those in which the INSERT stands, for one copy of its array (from 0).
[[nodiscard]] Eigen::AffineCompact2d placed(const Insert& insert, const Block& block, std::int64_t column,
                                            std::int64_t row);

/// How much the blocks of a drawing hold; each is counted once.
class BlockSizes {
public:
  explicit BlockSizes(const Inventory& inventory) : m_inventory(inventory) {}

  /// What all copies of one INSERT draw, counted as `kMostInserted` is. `BlockInsertsItself` where a block holds
  /// itself, or blocks are nested deeper than `kMostNesting`, on the line of the INSERT that does so.
  [[nodiscard]] base::Expected<double> drawnBy(const Entity& entity);

private:
  [[nodiscard]] base::Expected<double> sizeOf(const Block& block, const Entity& insert);
  [[nodiscard]] base::Expected<double> counted(const Block& block);

  const Inventory& m_inventory;
  std::map<const Block*, base::Expected<double>> m_sizes;
  std::vector<const Block*> m_open; ///< the blocks that are being counted, the innermost last
};

/// The block of that name; null where the file has none.
[[nodiscard]] const Block* findBlock(const Inventory& inventory, std::string_view name);

} // namespace arris::pattern
