#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/panes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arris::job {
namespace {

using base::Code;
using geometry::Point;
using recipe::Machine;
using recipe::Recipe;
using testing::Contains;
using testing::Field;

const std::vector<Point> kRectangle{{100, 200}, {500, 200}, {500, 500}, {100, 500}};

Job plan(const Recipe& recipe = {}, const Machine& machine = {}) {
  return planJob(test::polygon(kRectangle), recipe, machine);
}

geometry::Box boxOf(const Job& job) {
  return geometry::bounds(job.contours.front().curves);
}

void expectAt(const Eigen::VectorXd& actual, const Eigen::VectorXd& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-9) << actual.transpose() << " instead of " << expected.transpose();
}

TEST(Placement, CentresThePaneInTheTravel) {
  const Job job = plan();
  expectAt(boxOf(job).min(), Point(550, 1100));
  expectAt(job.placement.place, Point(550, 1100));
  expectAt(job.placement.patternOrigin, Point(450, 900));
}

TEST(Placement, PutsTheLowerLeftCornerAtThePlace) {
  Recipe recipe;
  recipe.place = Point(300, 400);
  expectAt(boxOf(plan(recipe)).min(), Point(300, 400));
}

TEST(Placement, MirrorsThenRotatesThenShifts) {
  Recipe recipe;
  recipe.place = Point(300, 400);
  recipe.mirror = recipe::Mirror::X;
  recipe.rotate = 90;
  const Job job = plan(recipe);
  expectAt(boxOf(job).min(), Point(300, 400));
  expectAt(boxOf(job).sizes(), Point(300, 400));
  // (100, 200) → mirrored (−100, 200) → turned (−200, −100): the corner of greatest X and Y of the turned box.
  expectAt(job.placement.motion * Point(100, 200), Point(600, 800));
  EXPECT_GT(geometry::signedArea(job.contours.front().curves), 0);
}

TEST(Placement, QuarterTurnsAreExact) {
  Recipe recipe;
  recipe.rotate = -270;
  EXPECT_EQ(plan(recipe).placement.motion.linear()(0, 0), 0);
  EXPECT_EQ(plan(recipe).placement.motion.linear()(1, 0), 1);
}

TEST(Heights, AreThoseOfTheDefaults) {
  const Job job = plan();
  std::vector<std::pair<motion::Move, double>> ends;
  for (const motion::Segment& segment : job.track) {
    if (const auto* vertical = std::get_if<motion::Vertical>(&segment.shape)) {
      ends.emplace_back(segment.move, vertical->to);
    }
  }
  using enum motion::Move;
  const std::vector<std::pair<motion::Move, double>> expected{
      {Approach, 77}, {Plunge, 46}, {Retract, 77}, {Retract, 120}}; // the park position is at the top already
  EXPECT_EQ(ends, expected);
}

TEST(Heights, TheProgramStartsAndEndsAtTheParkPosition) {
  Machine machine;
  machine.park = {50, 60, 100};
  const Job job = plan({}, machine);
  expectAt(motion::evaluate(job.track.front(), 0).point, machine.park);
  const motion::Segment& last = job.track.back();
  expectAt(motion::evaluate(last, motion::parameterLength(last)).point, machine.park);
  expectAt(motion::evaluate(job.track[1], 0).point, Eigen::Vector3d(50, 60, 120));
}

TEST(Heights, AWheelThatWouldTouchTheTableIsRefused) {
  Recipe recipe;
  recipe.support = 9.99; // lower face at 9.99 + 6 − 15
  EXPECT_THAT(plan(recipe).problems, Contains(Field(&base::Problem::code, Code::WheelBelowTable)));
  recipe.support = 10;
  EXPECT_TRUE(plan(recipe).canBeGround());
}

TEST(Park, AWheelParkedInGlassOrTableIsRefused) {
  Machine machine;
  for (const Eigen::Vector3d& park : {Eigen::Vector3d(750, 1250, 67.9), Eigen::Vector3d(100, 100, 15.9)}) {
    machine.park = park; // lower face at 52.9 above the glass of 52, and at 0.9
    EXPECT_THAT(plan({}, machine).problems, Contains(Field(&base::Problem::code, Code::ParkTooLow)));
    machine.park.z() += 0.2;
    EXPECT_TRUE(plan({}, machine).canBeGround());
  }
}

// Along the stretches where the X axis is at its speed the wheel follows the circle evenly: few events, and X at its
// limit all the while.
TEST(Speed, WhereAnAxisIsAtItsSpeedTheWheelFollowsTheCurveEvenly) {
  Machine machine;
  machine.maxSpeed.x() = 3000; // mm/min; the feed is 3600
  const Job job = planJob(test::paneOf({geometry::arcAbout({0, 0}, 250, -base::kPi / 2, 2 * base::kPi)}), {}, machine);
  ASSERT_TRUE(job.canBeGround());
  int turns = 0;
  double atLimit = 0;
  for (std::size_t i = 1; i < job.pieces.size(); ++i) {
    const motion::Piece& piece = job.pieces[i].motion;
    const motion::Piece& before = job.pieces[i - 1].motion;
    turns += std::abs(piece.acceleration - before.acceleration) > 1 ? 1 : 0; // of 20 mm/s²
    const motion::Segment& segment = job.track[static_cast<std::size_t>(piece.segment)];
    const double speedX = motion::setPointAt(piece, segment, piece.time + piece.duration / 2).velocity.cwiseAbs().x();
    EXPECT_LE(speedX, 50 * (1 + 1e-9));
    atLimit += segment.move == motion::Move::Contour && speedX > 50 * (1 - 1e-5) ? piece.duration : 0;
  }
  EXPECT_LT(turns, 50);
  EXPECT_GT(atLimit, 5);
}

TEST(Heights, AClearanceAboveTheTravelIsRefused) {
  Recipe recipe;
  recipe.clearance = 53.1; // 40 + 12 + 53.1 + 15
  EXPECT_THAT(plan(recipe).problems, Contains(Field(&base::Problem::code, Code::HeightOutsideTravel)));
  recipe.clearance = 53;
  EXPECT_TRUE(plan(recipe).canBeGround());
}

TEST(Travel, APathThatLeavesItIsRefusedWithTheCorner) {
  // At the lower left corner of the triangle x = −2ℓu + 1.5ℓu² from S on, with ℓ = 75·cot 30°: at least −2ℓ/3.
  const double reach = 50 * std::sqrt(3.0);
  Recipe recipe;
  recipe.place = Point(reach - 6, 1000);
  const Job job = planJob(test::triangle600(), recipe, {});
  std::vector<int> corners;
  for (const base::Problem& problem : job.problems) {
    EXPECT_EQ(problem.code, Code::OutsideTravel);
    corners.push_back(problem.corner.value_or(0));
  }
  ASSERT_EQ(corners, (std::vector<int>{1}));
  EXPECT_NEAR(std::get<double>(job.problems.front().values[1].value), 6, 1e-9);
  recipe.place = Point(reach + 1e-6, 1000);
  EXPECT_TRUE(planJob(test::triangle600(), recipe, {}).canBeGround());
}

TEST(Travel, AMachineSlowerThanTheFeedIsNoted) {
  Machine slow;
  slow.maxSpeed.x() = 3000;
  const Job job = plan({}, slow);
  EXPECT_TRUE(job.canBeGround());
  EXPECT_THAT(job.problems, Contains(Field(&base::Problem::code, Code::MachineSpeedBinds)));
  for (Sampler sampler(job); !sampler.done();) {
    ASSERT_LE(std::abs(sampler.next().setPoint.velocity.x()), 50 * (1 + 1e-9));
  }
}

TEST(Plan, AnErrorOfThePatternStopsItButPlacesWhatIsThere) {
  pattern::Pattern pattern = test::polygon(kRectangle);
  pattern.problems.push_back(base::Problem(Code::ContoursCross).at({100, 200}));
  const Job job = planJob(pattern, {}, {});
  EXPECT_FALSE(job.canBeGround());
  EXPECT_TRUE(job.pieces.empty());
  EXPECT_EQ(job.contours.size(), 1U);
  expectAt(*job.problems.front().where, Point(550, 1100));
}

TEST(Plan, WithoutAnyContourItIsRefusedAndDoesNotFail) {
  pattern::Pattern nothing;
  nothing.problems.emplace_back(Code::NoContour);
  EXPECT_FALSE(planJob(nothing, {}, {}).canBeGround());
}

TEST(Plan, TheSameInputGivesTheSameBits) {
  const Job one = plan();
  const Job other = plan();
  ASSERT_EQ(one.pieces.size(), other.pieces.size());
  for (std::size_t i = 0; i < one.pieces.size(); ++i) {
    ASSERT_EQ(one.pieces[i].motion.time, other.pieces[i].motion.time);
    ASSERT_EQ(one.pieces[i].motion.lambda, other.pieces[i].motion.lambda);
  }
}

TEST(Phases, OfTheTriangleAreThoseOfThePaper) {
  const Job job = planJob(test::triangle600(), {}, {}, toolpath::Leads::Without);
  std::vector<Phase> phases;
  std::vector<int> corners;
  for (const PlannedPiece& piece : job.pieces) {
    const bool works = job.track[static_cast<std::size_t>(piece.motion.segment)].number > 0;
    if (works && (phases.empty() || phases.back() != piece.phase)) {
      phases.push_back(piece.phase);
      corners.push_back(piece.corner);
    }
  }
  using enum Phase;
  EXPECT_EQ(phases,
            (std::vector<Phase>{Accelerate, Cruise, Decelerate, Transition, Accelerate, Cruise, Decelerate, Transition,
                                Accelerate, Cruise, Decelerate, Transition, Accelerate, Cruise, Decelerate}));
  EXPECT_EQ(corners, (std::vector<int>{0, 0, 1, 1, 1, 0, 2, 2, 2, 0, 3, 3, 3, 0, 0}));
}

TEST(Interpolator, TellsTheSameWhateverThePeriodItIsAskedAt) {
  const Job job = plan();
  motion::Interpolator coarse(job.track, job.intervals, job.limits);
  motion::Interpolator fine(job.track, job.intervals, job.limits);
  for (int i = 0; i < 1000; ++i) {
    const double time = job.duration * i / 1000;
    for (int k = 1; k < 7; ++k) {
      (void)fine.advanceTo(job.duration * (i - 1.0 + k / 7.0) / 1000);
    }
    const motion::SetPoint a = coarse.advanceTo(time);
    const motion::SetPoint b = fine.advanceTo(time);
    ASSERT_EQ(a.position, b.position);
    ASSERT_EQ(a.speed, b.speed);
  }
}

TEST(Interpolator, RunsTheProfileThatWasSampled) {
  const Job job = plan();
  motion::Interpolator interpolator(job.track, job.intervals, job.limits);
  for (Sampler sampler(job); !sampler.done();) {
    const Sample row = sampler.next();
    ASSERT_EQ(interpolator.advanceTo(row.setPoint.time).position, row.setPoint.position);
  }
}

} // namespace
} // namespace arris::job
