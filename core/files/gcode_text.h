#pragma once

#include "core/geometry/curve.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace arris::files {

/// Text of a G-code program under construction. Knows the place that was written last, as it was rounded, so that
/// centres and control points fit the rounded ends and no block without motion is written. Lengths in mm with six
/// decimals, feeds in mm/min. XY moves are in the plane of the last Z.
class GCodeText {
public:
  void line(std::string_view text);

  /// A comment: ASCII, without parentheses inside, of a length that controllers take.
  void comment(std::string_view text);

  void rapidTo(const geometry::Point& point);
  void rapidToHeight(double z);
  void feedToHeight(double z, double feed);
  void lineTo(const geometry::Point& point, double feed);

  /// G2 or G3; G1 where the arc is so flat or so large that a controller could take it for something else.
  void arc(const geometry::Arc& arc, double feed);

  /// G5.1 with the control point from the start.
  void spline(const geometry::Parabola& parabola, double feed);

  [[nodiscard]] std::string take();

private:
  using Micro = std::int64_t; ///< 1e-6 mm

  void word(char letter, Micro value);
  void place(Micro x, Micro y);
  void endBlock(double feed);
  void arcBlock(const geometry::Arc& arc, double feed);

  fmt::memory_buffer m_text;
  std::optional<Micro> m_x; ///< nothing before the first move
  std::optional<Micro> m_y;
  std::optional<Micro> m_z;
};

} // namespace arris::files
