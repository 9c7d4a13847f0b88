#include "core/pattern/dxf_inserts.h"

#include "core/base/numbers.h"

#include <algorithm>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using base::Unexpected;

void takeReal(Insert& insert, int code, double number) {
  switch (code) {
  case 10:
    insert.at.x() = number;
    break;
  case 20:
    insert.at.y() = number;
    break;
  case 41:
    insert.scale.x() = number;
    break;
  case 42:
    insert.scale.y() = number;
    break;
  case 44:
    insert.spacing.x() = number;
    break;
  case 45:
    insert.spacing.y() = number;
    break;
  case 50:
    insert.rotation = base::radians(number);
    break;
  default:
    break;
  }
}

} // namespace

// Numbers of copies below one are written for none of an array.
Insert readInsert(const Entity& entity) {
  Insert insert;
  insert.mirrored = entity.extrusion[2] < 0;
  Group group;
  for (GroupCursor cursor(entity.body); cursor.next(group) && group.code != 0;) {
    if (group.code == 2) {
      insert.block = group.value;
    } else if (group.code == 70) {
      insert.columns = std::max<std::int64_t>(1, wholeNumber(group.value).value_or(1));
    } else if (group.code == 71) {
      insert.rows = std::max<std::int64_t>(1, wholeNumber(group.value).value_or(1));
    } else if (group.code >= 10 && group.code < 60) {
      takeReal(insert, group.code, finiteNumber(group.value).value_or(0));
    }
  }
  return insert;
}

Eigen::AffineCompact2d placed(const Insert& insert, const Block& block, std::int64_t column, std::int64_t row) {
  Eigen::AffineCompact2d map = Eigen::AffineCompact2d::Identity();
  if (insert.mirrored) {
    map.scale(geometry::Vector(-1, 1));
  }
  map.translate(insert.at);
  map.rotate(Eigen::Rotation2Dd(insert.rotation));
  map.translate(geometry::Vector(static_cast<double>(column) * insert.spacing.x(),
                                 static_cast<double>(row) * insert.spacing.y()));
  map.scale(insert.scale);
  map.translate(geometry::Vector(-block.base[0], -block.base[1]));
  return map;
}

const Block* findBlock(const Inventory& inventory, std::string_view name) {
  const auto found = inventory.blocks.find(layerKey(name));
  return found != inventory.blocks.end() ? &found->second : nullptr;
}

base::Expected<double> BlockSizes::drawnBy(const Entity& entity) {
  const Insert insert = readInsert(entity);
  const Block* block = findBlock(m_inventory, insert.block);
  if (!block) {
    return 0.0;
  }
  base::Expected<double> size = sizeOf(*block, entity);
  if (!size) {
    return size;
  }
  return static_cast<double>(insert.columns) * static_cast<double>(insert.rows) * (1 + *size);
}

base::Expected<double> BlockSizes::sizeOf(const Block& block, const Entity& insert) {
  if (const auto known = m_sizes.find(&block); known != m_sizes.end()) {
    return known->second;
  }
  const bool insideItself = std::find(m_open.begin(), m_open.end(), &block) != m_open.end();
  if (insideItself || m_open.size() == kMostNesting) {
    return Unexpected(
        Problem(Code::BlockInsertsItself, {{"block", quoted(block.name)}, {"most", std::int64_t{kMostNesting}}})
            .onLine(insert.line));
  }
  m_open.push_back(&block);
  base::Expected<double> size = counted(block);
  m_open.pop_back();
  return m_sizes.emplace(&block, std::move(size)).first->second;
}

base::Expected<double> BlockSizes::counted(const Block& block) {
  double size = 0;
  for (const Entity& entity : block.entities) {
    size += static_cast<double>(1 + entity.vertices);
    if (entity.kind == EntityKind::Insert) {
      base::Expected<double> drawn = drawnBy(entity);
      if (!drawn) {
        return drawn;
      }
      size += *drawn;
    }
  }
  return size;
}

} // namespace arris::pattern
