#pragma once

#include "core/geometry/biarc.h"

#include <optional>
#include <vector>

namespace arris::pattern {

/// Chords of a smooth curve, one after the other, mm: at least two.
struct ChordRun {
  std::vector<geometry::Point> vertices;        ///< of a closed run the first stands at the end again
  std::optional<geometry::Vector> startTangent; ///< unit, where the run leaves an arc; free at a corner
  std::optional<geometry::Vector> endTangent;
  bool closed = false; ///< smooth where it closes too
};

/// What is known of a run before it is fitted. Curvatures and sagittas are positive where the run turns left.
struct ChordShape {
  std::vector<double> way;              ///< by vertex: length along the chords up to it, mm
  std::vector<double> heading;          ///< by chord: direction, rad, without jumps along the run; 0 for the first
  std::vector<double> curvature;        ///< by vertex, of the circle through it and its neighbours, 1/mm
  std::vector<double> sagitta;          ///< by chord, of the curve that it stands for, mm
  std::vector<geometry::Point> centred; ///< by vertex: half-way between it and the middles of its chords, mm
};

/// Chords from vertex to vertex that lie on one line, which is no part of a curve.
struct Straight {
  std::size_t first = 0; ///< vertex
  std::size_t last = 0;
  geometry::Point from; ///< where the line starts and ends for now
  geometry::Point to;
  std::optional<double> rounded; ///< one arc follows that is this far from the chords, mm
};

/// `straights` bend the run no more; in their order along the run.
[[nodiscard]] ChordShape shapeOf(const ChordRun& run, const std::vector<Straight>& straights);

/// The straight parts of a run, in their order: much longer than chords of the curves beside them could be within
/// `tolerance`. Each passes its vertices within a twentieth of that. Cost grows as n log n.
[[nodiscard]] std::vector<Straight> findStraights(const ChordRun& run, double tolerance);

/// The same closed run from another of its vertices on.
[[nodiscard]] ChordRun startingAt(const ChordRun& closedRun, std::size_t vertex);

} // namespace arris::pattern
