#include "tests/support/random_glass.h"

#include "core/base/numbers.h"
#include "tests/support/dice.h"
#include "tests/support/dxf_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace arris::test {
namespace {

using base::kPi;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

/// A side of a ring: a curve, or the controls of a cubic spline.
using Side = std::variant<Curve, geometry::Spline>;
using Ring = std::vector<Side>;

/// What a ring is to keep to, mm.
struct Limits {
  double inner = 0, outer = 0; ///< distances of its corners from its middle
  double leastHollow = 0;      ///< radius of arcs that are hollow for the wheel
  double leastMouth = 0;       ///< half the width of notches
  double leastEdge = 0;        ///< distance of neighbouring corners, about
  bool wheelInside = false;    ///< a cut-out
  double splines = 0;          ///< share of its sides
};

// A ring is a star about its middle: each side keeps to the sector between its corners, and so no two cross.

bool isInSector(const Point& from, const Point& to, const Point& p) {
  const double margin = 0.03 * p.norm();
  return geometry::cross(from.normalized(), p) > margin && geometry::cross(p, to.normalized()) > margin;
}

/// Whether rays from the middle meet the curve once.
bool isStar(const Curve& curve) {
  constexpr int kSamples = 24;
  for (int i = 0; i <= kSamples; ++i) {
    const auto here = geometry::evaluate(curve, geometry::parameterLength(curve) * i / kSamples);
    if (geometry::cross(here.point.normalized(), here.first) < 0.03) {
      return false;
    }
  }
  return true;
}

/// An arc, hollow or bulging as seen from the middle, flattened until it is a star; a line where none is.
Side arcSide(const Point& from, const Point& to, const Limits& limits, Dice& dice) {
  const double chord = (to - from).norm();
  const double side = dice.chance(0.5) ? 1 : -1;
  const bool hollow = (side < 0) != limits.wheelInside;
  double radius = std::max(chord * dice.logBetween(0.52, 4), hollow ? limits.leastHollow : 0.0);
  for (int i = 0; i < 5; ++i, radius *= 2) {
    const Curve arc = geometry::arcBetween(from, to, side * 2 * std::asin(chord / (2 * radius)));
    if (isStar(arc)) {
      return arc;
    }
  }
  return Line{from, to};
}

/// A cubic whose controls keep to the sector, in order.
std::optional<Side> splineSide(const Point& from, const Point& to, Dice& dice) {
  const double half = 0.25 * (to - from).norm();
  const auto shifted = [&](double share) -> Point {
    const Point onChord = from + share * (to - from);
    return onChord + dice.between(-half, half) * onChord.normalized();
  };
  const std::vector<Point> controls{from, shifted(1.0 / 3), shifted(2.0 / 3), to};
  for (std::size_t i = 1; i < controls.size(); ++i) {
    if (geometry::cross(controls[i - 1].normalized(), controls[i]) < 0.03 * controls[i].norm()) {
      return std::nullopt;
    }
  }
  return bezier(controls);
}

/// The corners of a notch into the glass or a tab on it, in the middle of a line.
std::vector<Point> notchCorners(const Point& from, const Point& to, double half, double depth, double foot) {
  const Vector along = (to - from).normalized();
  const Point middle = (from + to) / 2;
  const Vector inwards = geometry::leftOf(along);
  return {middle - half * along, middle - foot * along + depth * inwards, middle + foot * along + depth * inwards,
          middle + half * along};
}

/// With a rectangular, round, V-shaped or narrowing foot; none where it would leave the sector.
std::optional<std::vector<Side>> notch(const Point& from, const Point& to, const Limits& limits, Dice& dice) {
  const double chord = (to - from).norm();
  const double least = std::max(limits.leastMouth, 0.04 * chord);
  if (least > 0.35 * chord) {
    return std::nullopt;
  }
  const double half = dice.between(least, 0.35 * chord);
  const double depth = (dice.chance(0.6) ? 1 : -1) * dice.between(0.5, 2) * half;
  const double form = dice.between(0, 1);
  const double foot = form < 0.2 ? 0 : form < 0.4 ? 0.7 * half : half;
  const std::vector<Point> corners = notchCorners(from, to, half, depth, foot);
  std::vector<Curve> sides{Line{from, corners[0]}, Line{corners[0], corners[1]}};
  if (form > 0.7) {
    sides.emplace_back(geometry::arcBetween(corners[1], corners[2], depth > 0 ? -kPi : kPi));
  } else if (foot > 0) {
    sides.emplace_back(Line{corners[1], corners[2]});
  }
  sides.emplace_back(Line{corners[2], corners[3]});
  sides.emplace_back(Line{corners[3], to});
  for (std::size_t i = 1; i + 1 < sides.size(); ++i) {
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Point p = geometry::pointAt(sides[i], share * geometry::parameterLength(sides[i]));
      if (!isInSector(from, to, p) || p.norm() < 0.3 * from.norm()) {
        return std::nullopt;
      }
    }
  }
  return std::vector<Side>(sides.begin(), sides.end());
}

std::vector<Point> starCorners(const Limits& limits, Dice& dice) {
  const double round = 2 * kPi * (limits.inner + limits.outer) / 2;
  const int most = std::clamp(static_cast<int>(round / std::max(limits.leastEdge, 1.0)), 3, 14);
  const int count = static_cast<int>(dice.between(3, most + 1));
  const double turned = dice.between(0, 2 * kPi);
  std::vector<Point> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = turned + 2 * kPi * (i + dice.between(-0.2, 0.2)) / count;
    corners.emplace_back(dice.between(limits.inner, limits.outer) * Point(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

/// Rounds corners between lines.
Ring rounded(const Ring& ring, const Limits& limits, Dice& dice) {
  Ring result;
  std::vector<Line> lines;
  const auto lineAt = [&](std::size_t i) -> Line* {
    auto* curve = std::get_if<Curve>(&result[i % result.size()]);
    return curve ? std::get_if<Line>(curve) : nullptr;
  };
  result = ring;
  for (std::size_t i = 0; i < result.size(); ++i) {
    Line* before = lineAt(i);
    Line* after = lineAt(i + 1);
    if (!before || !after || !dice.chance(0.25)) {
      continue;
    }
    const Vector in = before->to - before->from;
    const Vector out = after->to - after->from;
    const double turn = geometry::turn(in, out);
    const double cut = dice.between(0.05, 0.4) * std::min(in.norm(), out.norm());
    const double radius = cut / std::tan(std::abs(turn) / 2);
    const bool hollow = (turn < 0) != limits.wheelInside;
    if (std::abs(turn) < 0.1 || (hollow && radius < limits.leastHollow)) {
      continue;
    }
    before->to -= cut * in.normalized();
    after->from += cut * out.normalized();
    const geometry::Arc arc{before->to, in.normalized(), (turn > 0 ? 1 : -1) / radius, radius * std::abs(turn)};
    result.insert(result.begin() + static_cast<std::ptrdiff_t>(i) + 1, Curve{arc});
    ++i;
  }
  return result;
}

Ring starRing(const Limits& limits, Dice& dice) {
  const std::vector<Point> corners = starCorners(limits, dice);
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& from = corners[i];
    const Point& to = corners[(i + 1) % corners.size()];
    const double form = dice.between(0, 1);
    std::optional<std::vector<Side>> sides;
    if (dice.chance(limits.splines)) {
      if (const std::optional<Side> spline = splineSide(from, to, dice)) {
        sides = {*spline};
      }
    } else if (form < 0.25 && !limits.wheelInside) {
      sides = notch(from, to, limits, dice);
    } else if (form < 0.55) {
      sides = {arcSide(from, to, limits, dice)};
    }
    if (!sides) {
      sides = {Curve{Line{from, to}}};
    }
    ring.insert(ring.end(), sides->begin(), sides->end());
  }
  return rounded(ring, limits, dice);
}

/// Whether the arcs that bulge beyond the corners stay in the disc too.
bool isWithin(const Ring& ring, double disc) {
  return std::all_of(ring.begin(), ring.end(), [disc](const Side& side) {
    const auto& curve = std::get<Curve>(side);
    for (int i = 0; i <= 24; ++i) {
      if (geometry::pointAt(curve, geometry::parameterLength(curve) * i / 24).norm() > disc) {
        return false;
      }
    }
    return true;
  });
}

Ring circle(double radius) {
  return {Curve{geometry::arcAbout({0, 0}, radius, -kPi / 2, 2 * kPi)}};
}

/// A star without splines in the disc of radius `limits.outer`; a circle where none is found.
Ring starWithin(const Limits& limits, Dice& dice) {
  for (int tries = 0; tries < 10; ++tries) {
    Ring ring = starRing(limits, dice);
    if (isWithin(ring, 1.02 * limits.outer)) {
      return ring;
    }
  }
  return circle(limits.outer);
}

/// A rectangle of these half sides with rounded corners; radius 0: sharp.
Ring roundedRectangle(double a, double b, double radius) {
  const std::vector<Point> signs{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto centre = [&](std::size_t k) -> Point {
      return signs[k % 4].cwiseProduct(Point(a - radius, b - radius));
    };
    const double start = kPi / 2 * (static_cast<double>(i) - 1); // of the quarter about this centre
    const Vector from = radius * Vector(std::cos(start), std::sin(start));
    const Vector to = geometry::leftOf(from);
    if (radius > 0) {
      ring.emplace_back(Curve{geometry::arcBetween(centre(i) + from, centre(i) + to, kPi / 2)});
    }
    if ((centre(i + 1) - centre(i)).norm() > 1e-6) {
      ring.emplace_back(Curve{Line{centre(i) + to, centre(i + 1) + to}});
    }
  }
  return ring;
}

/// A cut-out within a disc of this radius about the origin.
Ring cutOut(double disc, const Limits& limits, Dice& dice) {
  const double form = dice.between(0, 1);
  if (form < 0.3) {
    return circle(std::max(limits.leastHollow, dice.between(0.3, 0.95) * disc));
  }
  if (form < 0.8) {
    const double least = std::max(limits.leastMouth, 0.15 * disc);
    const double b = dice.between(least, std::max(least, 0.65 * disc));
    const double most = std::sqrt(std::max(b * b, disc * disc - b * b));
    const double a = dice.between(b, most);
    const double radius = form < 0.45  ? b
                          : form < 0.6 ? 0
                                       : std::max(std::min(limits.leastHollow, b), dice.between(0.1, 0.9) * b);
    return roundedRectangle(a, b, radius);
  }
  Limits free = limits;
  free.inner = 0.65 * disc;
  free.outer = 0.97 * disc;
  return starWithin(free, dice);
}

Side moved(const Side& side, const Eigen::Isometry2d& motion) {
  if (const auto* curve = std::get_if<Curve>(&side)) {
    return geometry::transformed(*curve, motion);
  }
  geometry::Spline spline = std::get<geometry::Spline>(side);
  for (Point& control : spline.points) {
    control = motion * control;
  }
  return spline;
}

Ring moved(const Ring& ring, const Point& to, double turned) {
  Eigen::Isometry2d motion = Eigen::Isometry2d::Identity();
  motion.translate(to).rotate(turned);
  Ring result;
  std::transform(ring.begin(), ring.end(), std::back_inserter(result), [&](const Side& s) { return moved(s, motion); });
  return result;
}

/// Least distance of the ring from the origin; of splines of their controls' lines.
double clearDisc(const Ring& ring) {
  double least = std::numeric_limits<double>::infinity();
  for (const Side& side : ring) {
    if (const auto* curve = std::get_if<Curve>(&side)) {
      least = std::min(least, geometry::nearest(*curve, {0, 0}).distance);
      continue;
    }
    const std::vector<Point>& controls = std::get<geometry::Spline>(side).points;
    for (std::size_t i = 1; i < controls.size(); ++i) {
      least = std::min(least, geometry::nearest(Line{controls[i - 1], controls[i]}, {0, 0}).distance);
    }
    least = std::min(least, geometry::nearest(Line{controls.front(), controls.back()}, {0, 0}).distance);
  }
  return least;
}

struct Disc {
  Point middle;
  double radius = 0;
};

/// Discs in the disc about the origin, apart from each other.
std::vector<Disc> disjointDiscs(double within, double least, Dice& dice) {
  const int wanted = static_cast<int>(dice.between(0, 4));
  const double apart = 0.05 * within;
  std::vector<Disc> discs;
  for (int tries = 0; tries < 20 && static_cast<int>(discs.size()) < wanted; ++tries) {
    const double most = within / std::max(1.0, 0.75 * wanted);
    if (least > most) {
      break;
    }
    const double radius = dice.between(std::max(least, 0.1 * within), most);
    const double far = std::max(0.0, within - radius) * std::sqrt(dice.between(0, 1));
    const double angle = dice.between(0, 2 * kPi);
    const Disc disc{far * Point(std::cos(angle), std::sin(angle)), radius};
    const bool free = std::none_of(discs.begin(), discs.end(), [&](const Disc& other) {
      return (other.middle - disc.middle).norm() < other.radius + disc.radius + apart;
    });
    if (free) {
      discs.push_back(disc);
    }
  }
  return discs;
}

/// Every second ring as one polyline where it has lines and arcs alone.
void write(DxfText& dxf, const Ring& ring, bool polyline) {
  std::vector<Curve> curves;
  for (const Side& side : ring) {
    if (const auto* curve = std::get_if<Curve>(&side)) {
      curves.push_back(*curve);
    } else {
      dxf.add(std::get<geometry::Spline>(side));
    }
  }
  if (polyline && curves.size() == ring.size() && curves.size() > 1) {
    dxf.addPolyline(curves);
  } else {
    dxf.add(curves);
  }
}

recipe::Recipe glassRecipe(Dice& dice) {
  recipe::Recipe recipe;
  recipe.wheelRadius = dice.logBetween(5, 100);
  recipe.depth = dice.chance(0.1) ? 0 : dice.logBetween(0.01, 0.5);
  recipe.feed = dice.logBetween(1000, 20000);
  recipe.accelX = dice.logBetween(10, 500);
  recipe.accelY = dice.logBetween(10, 500);
  recipe.direction = dice.chance(0.5) ? recipe::Direction::Clockwise : recipe::Direction::CounterClockwise;
  recipe.lead = dice.between(3, 25);
  recipe.overlap = dice.between(0, 30);
  recipe.rotate = dice.chance(0.5) ? 0 : dice.between(-180, 180);
  recipe.place = Point(1500, 1500);
  return recipe;
}

/// The limits of an outline; with `room` the wheel fits into each feature by itself.
Limits outlineLimits(double wheel, bool room, double splines, Dice& dice) {
  Limits limits;
  limits.outer = std::clamp(wheel * dice.between(4, 12), 120.0, 900.0);
  limits.inner = dice.between(0.5, 0.9) * limits.outer;
  limits.splines = splines;
  limits.leastEdge = (room ? 3 : 1) * wheel;
  limits.leastHollow = room ? 1.2 * wheel : 0;
  limits.leastMouth = room ? 1.3 * wheel : 0;
  return limits;
}

} // namespace

RandomGlass randomGlass(std::uint64_t seed, const GlassOptions& options) {
  Dice dice(seed);
  RandomGlass result;
  result.recipe = glassRecipe(dice);
  result.recipe.acceptUnreached = options.acceptUnreached;
  result.machine.travel = {6000, 6000, 120};
  const double wheel = result.recipe.wheelRadius;
  const bool room = dice.chance(0.67);
  Limits limits = outlineLimits(wheel, room, options.splines ? 0.4 : 0, dice);
  const Ring outline = starRing(limits, dice);
  const Point origin(dice.between(-500, 500), dice.between(-500, 500));
  DxfText dxf;
  dxf.insUnits(4);
  write(dxf, moved(outline, origin, 0), dice.chance(0.5));

  limits.wheelInside = true;
  limits.splines = 0;
  const double leastDisc = room ? 2 * wheel + 20 : 10;
  for (const Disc& disc : disjointDiscs(0.93 * clearDisc(outline), leastDisc, dice)) {
    const bool island = disc.radius > 2 * limits.leastHollow + 40 && dice.chance(0.3);
    const Ring hole = island ? circle(0.95 * disc.radius) : cutOut(disc.radius, limits, dice);
    write(dxf, moved(hole, origin + disc.middle, dice.between(0, 2 * kPi)), dice.chance(0.5));
    if (island) {
      const double most = 0.9 * disc.radius - 2 * limits.leastHollow;
      const Limits within{0.6 * most, most, limits.leastHollow, limits.leastMouth, most, false, 0};
      write(dxf, moved(starWithin(within, dice), origin + disc.middle, 0), dice.chance(0.5));
    }
  }
  result.dxf = dxf.text();
  return result;
}

job::Job planned(const RandomGlass& glass) {
  const pattern::Pattern pattern = pattern::readDxf(glass.dxf, pattern::importOptions(glass.recipe));
  return job::planJob(pattern, glass.recipe, glass.machine);
}

} // namespace arris::test
