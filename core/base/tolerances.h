#pragma once

namespace arris::base {

// Every tolerance of the program that more than one file needs, each for one purpose. There is no shared epsilon.

/// The wheel centre may come this much nearer to the finished contour than the wheel radius, and may leave this much
/// untouched, mm. The accuracy promised to the user.
inline constexpr double kContourAccuracy = 1e-3;

/// A piece shorter than this has no direction worth keeping, mm. DXF files carry six decimals at best.
inline constexpr double kZeroLength = 1e-6;

/// A joint that turns by less than this is tangential as it stands, rad: at 60 m/min the jump in velocity, seen over
/// 1 ms, stays below 1e-5 mm/s².
inline constexpr double kTangentTurn = 1e-11;

/// A joint that turns by less than this is a drawing's rounding and not a corner, rad (0.2°); it is replaced by a
/// tangential arc as far as `kSmoothDeviation` allows.
inline constexpr double kSmoothTurn = 3.5e-3;

/// The fitted contour may differ by this much from the drawing where such a joint is smoothed, mm.
inline constexpr double kSmoothDeviation = 0.5e-3;

/// Lengths and places within this count as equal where the drawing's order must not decide, mm.
inline constexpr double kSamePlace = 1e-3;

} // namespace arris::base
