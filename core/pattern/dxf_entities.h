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
  Ellipse,
  Spline,
  Insert, ///< draws a block
  NeverPartOfContour,
  NotRead, ///< could be part of a contour, but Arris does not read it yet
};

/// The kind behind an entity's type name; a name that is not known is `NotRead`.
[[nodiscard]] EntityKind kindOf(std::string_view type);

// Flags of a POLYLINE (group 70).
inline constexpr std::int64_t kSplineFit = 4;
inline constexpr std::int64_t kInSpace = 8; ///< its vertices have the coordinates of the world

/// One entity of the drawing or of a block; a polyline with its vertices is one.
struct Entity {
  EntityKind kind = EntityKind::NotRead;
  std::string_view type;
  std::string_view layer = "0";
  std::int64_t line = 0; ///< of the type's name in the file, from 1
  std::string_view body; ///< its groups, vertices included
  std::int64_t flags = 0;
  std::int64_t vertices = 0; ///< of a polyline; of a spline all its points
  std::array<double, 3> extrusion{0, 0, 1};
  /// Z of the ends of a line, lowest and highest of what has more points; 0 and Z of an ellipse's major axis
  std::array<double, 2> heights{0, 0};
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
  [[nodiscard]] std::optional<base::Problem> noteSplineGroup(int code);
  [[nodiscard]] std::optional<base::Problem> finishSpline() const;
  void noteHeight(int code, double height);

  Entity m_entity;
  double m_mostCoordinate;
  std::uint64_t m_seen = 0; ///< bit per group code below 64
  std::optional<std::int64_t> m_announcedVertices;

  /// Groups that a spline may have many of, and how many of them it announces.
  struct SplineCounts {
    std::int64_t knots = 0;
    std::int64_t weights = 0;
    std::array<std::int64_t, 2> controls{}; ///< X and Y
    std::array<std::int64_t, 2> fits{};
    std::optional<std::int64_t> announcedKnots;
    std::optional<std::int64_t> announcedControls;
    std::optional<std::int64_t> announcedFits;
  };

  SplineCounts m_spline;
  std::int64_t m_ordinates = 0; ///< groups 20 of a lightweight polyline, one after each 10
};

} // namespace arris::pattern
