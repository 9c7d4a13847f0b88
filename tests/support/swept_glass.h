#pragma once

#include "core/job/job.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace arris::test {

// The promises about the wheel at grinding height, checked without the program's own geometry: the curves are read
// field by field, distances are computed here, areas are Clipper's on a grid of 10 nm.

/// A place where a promise is broken.
struct Breach {
  std::string what;
  geometry::Point where; ///< on the table, mm
  double amount = 0;     ///< distance between wheel and glass there, mm: negative in the glass, positive off it
};

/// Rooms of the free space, cut off from the outside, that the wheel could grind in but that no path enters: a breach,
/// or accepted by the operator.
enum class Unentered { Breach, Accepted };

/// Distance of a point from the edge of the glass, mm, exact to rounding; negative in the glass (nearer than 0.1 mm to
/// the edge the sign is not certain).
[[nodiscard]] double distanceFromGlass(const std::vector<pattern::Contour>& contours, const geometry::Point& point);

/// Largest distance of points along the curves of `a` (each 1.5 mm) from `b`, mm; blends too.
[[nodiscard]] double farthestApart(const std::vector<geometry::Curve>& a, const std::vector<geometry::Curve>& b);

/// Where a point of any path piece, leads and transitions included, comes nearer to the glass than R − 1 µm. Clipper
/// finds every place within R − 0.75 µm (the glass widened by that, and the path in it), the exact distance judges.
[[nodiscard]] std::vector<Breach> gouges(const job::Job& job);

/// Points of the contours (each 1.5 mm, joints and 0.05 mm beside them) that a wheel of radius R touches from some free
/// place and that are farther from the path than R + 1 µm.
[[nodiscard]] std::vector<Breach> untouched(const job::Job& job, Unentered unentered = Unentered::Breach);

/// Where a piece that should grind (roles Contour and Roll) is farther from the glass than R + 1 µm; on a concave
/// corner's fillet arc 0.5 µm more.
[[nodiscard]] std::vector<Breach> idling(const job::Job& job);

/// All three; the failure lists the first breaches of each.
[[nodiscard]] testing::AssertionResult grindsAllAndOnlyTheEdge(const job::Job& job,
                                                               Unentered unentered = Unentered::Breach);

} // namespace arris::test
