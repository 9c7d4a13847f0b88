#pragma once

#include "core/geometry/elliptic_arc.h"
#include "core/geometry/spline.h"
#include "core/pattern/dxf_entities.h"

#include <vector>

namespace arris::pattern {

/// The ellipse of an ELLIPSE, in its own coordinates, as a part of the unit circle and a map that the major axis may be
/// without length under. Parameters within 1e-6 of once round are once round (files have six decimals), and so are
/// equal ones.
[[nodiscard]] geometry::EllipticArc readEllipse(const Entity& entity);

/// The curve of a SPLINE, in its own coordinates, at least one piece: by its control points and knots where these make
/// one, else through its fit points. Closed and periodic splines are drawn as their knots and control points say, which
/// is one of two conventions: the last point is the first again, or the first `degree` points are repeated at the end.
/// A closed one written with as many knots as control points and one more has each of them once; its repeated ones are
/// added. `SplineFlawed` where there is no curve to be had.
[[nodiscard]] base::Expected<std::vector<geometry::Bezier>> readSpline(const Entity& entity);

} // namespace arris::pattern
