#pragma once

#include "core/job/job.h"

#include <cstdint>
#include <string>

namespace arris::test {

struct GlassOptions {
  bool splines = false;         ///< some sides of the outline are cubic SPLINE entities
  bool acceptUnreached = false; ///< in the recipe
};

/// Any pane, as a drawing: an outline of lines and arcs both ways (bulging and hollow), concave and sharp corners,
/// rounded ones, notches and tabs; none to three cut-outs (circles, slots, rectangles sharp and rounded, free shapes),
/// at times with an island of glass. Nothing crosses. In two of three panes the wheel has room for the single feature;
/// nowhere is it certain that it reaches everything. Wheel radius 5 to 100 mm. The same seed gives the same pane.
struct RandomGlass {
  std::string dxf;
  recipe::Recipe recipe;
  recipe::Machine machine; ///< with travel for every transition
};

[[nodiscard]] RandomGlass randomGlass(std::uint64_t seed, const GlassOptions& options = {});

/// Read from the drawing and planned.
[[nodiscard]] job::Job planned(const RandomGlass& glass);

} // namespace arris::test
