#pragma once

#include "core/base/monitor.h"
#include "core/base/problem.h"
#include "core/geometry/curve.h"
#include "core/pattern/pieces.h"
#include "core/recipe/recipe.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace arris::pattern {

enum class ContourKind { Outline, CutOut };

/// A closed chain of lines and arcs, each starting where the one before ends (to rounding), the last ending where the
/// first starts. mm. Outlines run counter-clockwise, cut-outs clockwise: the glass lies to the left of both. The
/// finished contour, fitted: joints are tangential within `kTangentTurn` or turn by more than `kSmoothTurn`.
struct Contour {
  int id = 0; ///< from 1, by the place of the bounding box (least X, then least Y): independent of the file's order
  ContourKind kind = ContourKind::Outline;
  std::vector<geometry::Curve> curves;
  double fitDeviation = 0; ///< largest distance between this and the drawing, mm
  int parent = 0;          ///< id of the innermost contour that this one lies in; 0: none
};

/// Where the unit of the drawing was taken from.
enum class UnitsFrom { Option, InsUnits, Measurement, Assumed };

/// Entities on a layer by kind: {"LINE": 3}.
using EntityCounts = std::map<std::string, int>;

/// What the import found. With errors among the problems, `contours` holds what could be made of the drawing (for the
/// preview) and cannot be machined.
struct Pattern {
  recipe::Units units = recipe::Units::Millimetre;
  UnitsFrom unitsFrom = UnitsFrom::Assumed;
  EntityCounts entities;                      ///< in model space, read or passed over
  std::map<std::string, EntityCounts> layers; ///< the same by layer
  std::vector<Contour> contours;
  std::vector<geometry::Curve> loose; ///< pieces that belong to no closed contour, mm
  base::Problems repairs;             ///< notes about what was repaired; each with its place and `size_mm`
  base::Problems problems;            ///< errors, warnings and other notes, with line or place
};

struct ImportOptions {
  std::optional<recipe::Units> units;
  double gap = 0.05;               ///< mm, ends nearer than this are joined
  double smooth = 0.01;            ///< mm, chords of curves are fitted within this; 0: not at all
  std::vector<std::string> layers; ///< only what is on these; everything where empty

  bool operator==(const ImportOptions&) const = default;
};

[[nodiscard]] ImportOptions importOptions(const recipe::Recipe& recipe);

/// Reads a DXF drawing from memory. Never throws, whatever the text; cost grows as n log n.
[[nodiscard]] Pattern readDxf(std::string_view text, const ImportOptions& options, const base::Monitor& monitor = {});

/// Closed contours from pieces in any order and direction: the steps behind the reader. mm; `gap` and `smooth` as in
/// the options.
[[nodiscard]] Pattern joinPieces(Pieces pieces, double gap, double smooth, const base::Monitor& monitor = {});

[[nodiscard]] std::string_view name(recipe::Units units);
[[nodiscard]] double millimetresPer(recipe::Units units);

} // namespace arris::pattern
