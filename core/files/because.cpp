#include "core/files/because.h"

#include "core/base/numbers.h"

#include <cmath>

namespace arris::files {
namespace {

using toolpath::Reason;

struct Wording {
  std::string_view code;
  std::string_view text;
};

Wording wordingOf(Reason reason) {
  switch (reason) {
  case Reason::SharpWithRelief:
    return {"sharp-with-relief",
            "On a transition the wheel clears the tip of the blank: at {angle_deg}° (1 − sin(β/2))² is "
            "{relief_reached}, not less than 2 d_n/R = {relief_needed}."};
  case Reason::SharpWithoutRelief:
    return {"sharp-without-relief",
            "On a transition the wheel does not clear the tip of the blank: at {angle_deg}° (1 − sin(β/2))² is "
            "{relief_reached}, less than 2 d_n/R = {relief_needed}. Below {limit_deg}° the corner is fragile and has "
            "a transition all the same."};
  case Reason::BluntWithoutRelief:
    return {"blunt-without-relief",
            "A transition would not clear the tip of the blank: at {angle_deg}° (1 − sin(β/2))² is {relief_reached}, "
            "less than 2 d_n/R = {relief_needed}. From {limit_deg}° on a corner is not fragile, and the wheel rolls "
            "round it."};
  case Reason::TransitionBlocked:
    return {"transition-blocked",
            "On a transition the wheel would touch other glass, so it rolls round the corner of {angle_deg}°."};
  case Reason::ConcaveShallow:
    return {"concave-shallow",
            "The corner is concave ({angle_deg}°). The kink of the wheel path is so small that an arc can take its "
            "place and leaves no more than {kink_mm} mm of glass in addition."};
  case Reason::ConcaveDeep:
    return {"concave-deep",
            "The corner is concave ({angle_deg}°). The wheel stops in it, where it touches both edges; an "
            "arc that leaves no more than {kink_mm} mm of glass in addition would be smaller than "
            "{least_mm} mm."};
  }
  return {};
}

} // namespace

Because because(const toolpath::Corner& corner, const recipe::Recipe& recipe) {
  base::Problem figures;
  figures.values = {{"angle_deg", base::degrees(corner.angle)},
                    {"limit_deg", base::degrees(toolpath::kBluntAngle)},
                    {"wheel_radius_mm", recipe.wheelRadius},
                    {"depth_mm", recipe.depth},
                    {"relief_reached", base::squared(1 - std::sin(corner.angle / 2))}, // Eq. (12) in closed form
                    {"relief_needed", 2 * recipe.depth / recipe.wheelRadius}};
  if (corner.kind == toolpath::CornerKind::Concave) {
    figures.values = {{"angle_deg", base::degrees(corner.angle)},
                      {"kink_mm", toolpath::kKinkDeviation},
                      {"least_mm", toolpath::kLeastKinkRadius}};
  }
  const Wording wording = wordingOf(corner.reason);
  return {wording.code, base::fillIn(wording.text, figures), figures.values};
}

} // namespace arris::files
