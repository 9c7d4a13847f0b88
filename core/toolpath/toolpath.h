#pragma once

#include "core/base/numbers.h"
#include "core/pattern/pattern.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace arris::toolpath {

enum class CornerKind { Sharp, Blunt, Concave };
enum class Treatment { Transition, Roll, Arc, Stop };

/// What limits the transition speed.
enum class LimitedBy { Angle, AxisX, AxisY, CornerSpeed };

/// Corners from this angle on are not fragile: without relief the wheel rolls round them, rad.
inline constexpr double kBluntAngle = base::radians(120);

/// Why a corner is treated as it is.
enum class Reason {
  SharpWithRelief,    ///< relief is attainable: transition
  SharpWithoutRelief, ///< below 120° and no relief: transition all the same, with a warning
  BluntWithoutRelief, ///< relief not attainable and 120° or more: roll
  TransitionBlocked,  ///< other glass is in the way of the transition: roll, with a warning
  ConcaveShallow,     ///< the kink of the path is rounded within `kKinkDeviation`: arc
  ConcaveDeep,        ///< such an arc would be smaller than `kLeastKinkRadius`: stop
};

/// The arc that takes the place of a kink in the path leaves at most this much more glass, mm.
inline constexpr double kKinkDeviation = 0.5e-3;

/// Where that arc would be smaller than this, mm, the wheel stops instead.
inline constexpr double kLeastKinkRadius = 0.05;

/// A joint of the contour that is not smooth, with the figures of the method. Lengths mm, times s, angles rad.
struct Corner {
  int id = 0; ///< from 1 in the order of machining over the whole program
  int contour = 0;
  CornerKind kind = CornerKind::Sharp;
  Treatment treatment = Treatment::Transition;
  Reason reason = Reason::SharpWithRelief;
  geometry::Point s;          ///< the corner of the glass
  double angle = 0;           ///< β, interior angle of the glass, above π where it is concave
  geometry::Point a;          ///< tangent point before: where the transition, roll or arc starts; where the wheel stops
  geometry::Point c;          ///< tangent point after
  geometry::Point q;          ///< where the tangents meet (transition only)
  double leg = 0;             ///< ℓ = R cot(β/2)
  double transitionSpeed = 0; ///< v_trans, mm/s, after every clamp (transition only)
  LimitedBy limitedBy = LimitedBy::Angle;
  double blendAcceleration = 0; ///< a, mm/s², Eq. (14)
  double blendTime = 0;         ///< t_m, s, Eq. (2)
  double widest = 0;            ///< L(t_m/2), mm (transition only; R on a roll)
  double tipDepth = 0;          ///< d, mm, Eq. (6)
  bool relief = false;          ///< Eq. (12) in closed form
  bool reliefEq13 = false;      ///< what the printed Eq. (13) says
  double fillet = 0;            ///< glass that stays before a concave corner, mm
  double unground = 0;          ///< of the edges at a concave corner, the longer of both, mm
};

enum class Role { LeadIn, Contour, Transition, Roll, LeadOut };

/// One primitive of the wheel path at grinding height.
struct PathSegment {
  geometry::Curve shape;
  Role role = Role::Contour;
  int corner = 0;         ///< id of the corner that this transition, roll or arc belongs to; 0: none
  double speedCap = 0;    ///< mm/s of λ; 0: none but the feed (v_trans on a transition)
  bool stopAtEnd = false; ///< the path has a kink there
  int stopCorner = 0;     ///< id of the concave corner that the kink at the end belongs to; 0: none
};

/// The wheel's way along a contour, lead-in to lead-out, G1 but where it stops. A contour with bays that the wheel can
/// only enter from above has several; where contours lie too near to each other for the wheel to pass between them, one
/// way goes along several contours, and `contour` is the one where it starts.
struct Chain {
  int contour = 0;
  std::vector<PathSegment> segments;
};

struct Toolpath {
  std::vector<Chain> chains;    ///< in the order of machining
  std::vector<Corner> corners;  ///< index = id − 1
  std::vector<double> unground; ///< by contour in their given order: length that the wheel does not touch, mm
  base::Problems problems;
};

/// What a corner of angle `beta` (rad) asks for under a recipe, before any clamp by the axes: every figure of the
/// method that does not depend on the directions of the edges. Source: method table, Eq. (2), (6), (7), (12)–(16).
struct CornerFigures {
  double leg = 0, transitionSpeed = 0, acceleration = 0, time = 0, widest = 0, tipDepth = 0;
  double accelerationVector = 0; ///< magnitude of the acceleration of the wheel, mm/s²
  double eq15 = 0;               ///< L_d = L_a of the paper's Eq. (15), mm
  bool relief = false, reliefEq13 = false;
};

[[nodiscard]] CornerFigures cornerFigures(double beta, const recipe::Recipe& recipe);

enum class Leads { With, Without };

/// The wheel path along placed contours: compensation, corners, transitions, start, leads, order. Errors among the
/// problems mean that it cannot be machined; the chains then hold what could be made of it. Leads::Without is for
/// tests: each chain then starts and ends at rest at the start point, without overlap. A stop ends it early.
[[nodiscard]] Toolpath makeToolpath(const std::vector<pattern::Contour>& placed, const recipe::Recipe& recipe,
                                    Leads leads = Leads::With, const geometry::Point& park = {0, 0},
                                    const std::stop_token& stop = {});

} // namespace arris::toolpath
