#pragma once

#include "core/base/problem.h"
#include "core/pattern/group_cursor.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace arris::pattern {

enum class EntityKind {
  Line,
  Arc,
  Circle,
  LwPolyline,
  Polyline,
  Vertex,      ///< part of the polyline before it
  SequenceEnd, ///< end of a polyline's vertices or an insert's attributes
  NeverPartOfContour,
  NotRead, ///< could be part of a contour, but Arris does not read it yet
};

/// The kind behind an entity's type name; a name that is not known is `NotRead`.
[[nodiscard]] EntityKind kindOf(std::string_view type);

/// One entity of the ENTITIES section; a polyline with its vertices is one.
struct Entity {
  EntityKind kind = EntityKind::NotRead;
  std::string_view type;
  std::string_view layer = "0";
  std::int64_t line = 0; ///< of the type's name in the file, from 1
  std::string_view body; ///< its groups, vertices included
  std::int64_t flags = 0;
  std::int64_t vertices = 0;
  std::array<double, 3> extrusion{0, 0, 1};
  std::array<double, 2> heights{0, 0}; ///< Z of the ends of a line, lowest and highest of a POLYLINE's vertices
  bool paperSpace = false;
  bool invisible = false;
};

/// Takes the groups of one entity after the other and judges them.
class EntityCheck {
public:
  /// The entity whose type name is `group`; its groups follow. Coordinates above `mostCoordinate` (drawing units) are
  /// absurd.
  EntityCheck(const Group& group, double mostCoordinate);

  /// What is wrong with this group, if anything.
  [[nodiscard]] std::optional<base::Problem> take(const Group& group);

  /// What the entity lacks, if anything, now that it is complete.
  [[nodiscard]] std::optional<base::Problem> finish() const;

  [[nodiscard]] const Entity& entity() const {
    return m_entity;
  }

private:
  [[nodiscard]] std::optional<base::Problem> takeReal(const Group& group);
  [[nodiscard]] std::optional<base::Problem> takeInteger(const Group& group);
  [[nodiscard]] std::optional<base::Problem> noteSeen(const Group& group);
  [[nodiscard]] std::optional<base::Problem> noteVertex(int code);

  Entity m_entity;
  double m_mostCoordinate;
  std::uint64_t m_seen = 0; ///< bit per group code below 64
  std::optional<std::int64_t> m_announcedVertices;
  std::int64_t m_ordinates = 0; ///< groups 20 of a lightweight polyline, one after each 10
};

} // namespace arris::pattern
