#include "tests/support/random_panes.h"

#include "core/base/numbers.h"
#include "tests/support/dice.h"
#include "tests/support/panes.h"

#include <algorithm>
#include <cmath>

namespace arris::test {
namespace {

using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

std::vector<Point> convexCorners(Dice& dice) {
  const int count = static_cast<int>(dice.between(3, 41));
  std::vector<double> steps;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    steps.push_back(dice.between(0.3, 1));
    sum += steps.back();
  }
  const double a = dice.between(60, 200);
  const double b = dice.between(60, 200);
  const double turned = dice.between(0, 2 * kPi);
  double angle = dice.between(0, 2 * kPi);
  std::vector<Point> corners;
  for (const double step : steps) {
    const Point onEllipse(a * std::cos(angle), b * std::sin(angle));
    corners.emplace_back(Eigen::Rotation2Dd(turned) * onEllipse);
    angle += 2 * kPi * step / sum;
  }
  return corners;
}

/// A corner cut back by a fillet; radius 0: it stays sharp.
struct Fillet {
  double radius = 0;
  double cut = 0;
};

std::vector<Curve> edgesOf(const std::vector<Point>& corners, double hollows, Dice& dice) {
  const std::size_t n = corners.size();
  const auto way = [&](std::size_t i) -> Vector { return corners[(i + 1) % n] - corners[i % n]; };
  const auto turnAt = [&](std::size_t i) { return geometry::turn(way(i + n - 1), way(i)); };
  std::vector<Fillet> fillets(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (dice.chance(0.25)) {
      const double cut = dice.between(0.02, 0.4) * std::min(way(i + n - 1).norm(), way(i).norm());
      fillets[i] = {cut / std::tan(turnAt(i) / 2), cut};
    }
  }
  std::vector<Curve> edges;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Vector direction = way(i).normalized();
    const Point from = corners[i] + fillets[i].cut * direction;
    const Point to = corners[next] - fillets[next].cut * direction;
    const bool plain = fillets[i].radius == 0 && fillets[next].radius == 0;
    if (plain && dice.chance(0.3)) { // bulging by less than the corners turn
      edges.emplace_back(geometry::arcBetween(from, to, dice.between(0.1, 0.9) * std::min(turnAt(i), turnAt(next))));
    } else if (plain && dice.chance(hollows)) { // hollow; the corners get sharper
      edges.emplace_back(geometry::arcBetween(from, to, -dice.between(0.02, 0.7)));
    } else {
      edges.emplace_back(Line{from, to});
    }
    if (fillets[next].radius > 0) {
      const double turn = turnAt(next);
      edges.emplace_back(Arc{to, direction, 1 / fillets[next].radius, fillets[next].radius * turn});
    }
  }
  return edges;
}

recipe::Recipe randomRecipe(Dice& dice) {
  recipe::Recipe recipe;
  recipe.wheelRadius = dice.logBetween(5, 150);
  recipe.depth = dice.chance(0.1) ? 0 : dice.logBetween(0.01, 1);
  recipe.feed = dice.logBetween(600, 60000);
  recipe.accelX = dice.logBetween(5, 500);
  recipe.accelY = dice.logBetween(5, 500);
  recipe.cornerSpeed = dice.chance(0.7) ? 100 : dice.between(10, 100);
  recipe.direction = dice.chance(0.5) ? recipe::Direction::Clockwise : recipe::Direction::CounterClockwise;
  recipe.lead = dice.between(2.5, 40);
  recipe.overlap = dice.between(0, 60);
  recipe.rotate = dice.chance(0.5) ? 0 : dice.between(-180, 180);
  return recipe;
}

} // namespace

RandomPane randomPane(std::uint64_t seed) {
  Dice dice(seed);
  RandomPane result;
  const std::vector<Point> corners = convexCorners(dice);
  result.pattern = paneOf(edgesOf(corners, seed % 4 == 0 ? 0.4 : 0, dice));
  result.recipe = randomRecipe(dice);
  result.recipe.place = Point(600, 600);
  result.machine.travel = {4000, 4000, 120};
  return result;
}

job::Job randomJob(std::uint64_t& seed) {
  for (;;) {
    const RandomPane pane = randomPane(seed++);
    job::Job job = job::planJob(pane.pattern, pane.recipe, pane.machine);
    if (job.canBeGround()) {
      return job;
    }
  }
}

} // namespace arris::test
