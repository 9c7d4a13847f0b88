#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/program/manoeuvres.h"
#include "tests/support/dice.h"
#include "tests/support/panes.h"
#include "tests/support/programs.h"
#include "tests/support/swept_glass.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::program {
namespace {

using Eigen::Vector3d;
using motion::Move;

constexpr double kPlace = 2e-3; ///< mm, how exactly the place on the job's way is known

/// A place on the way round a contour, leads included.
JobPlace anyPlace(const job::Job& job, test::Dice& dice) {
  for (;;) {
    const auto segment = static_cast<std::size_t>(dice.between(0, static_cast<double>(job.track.size())));
    if (job.track[segment].contour > 0) {
      return {static_cast<int>(segment), dice.between(0, 1) * motion::parameterLength(job.track[segment])};
    }
  }
}

/// True length of the way from its beginning to a place.
double wayTo(const job::Job& job, const JobPlace& place) {
  double sum = 0;
  for (int i = 0; i < place.segment; ++i) {
    const motion::Segment& segment = job.track[static_cast<std::size_t>(i)];
    sum += motion::arcLength(segment, motion::parameterLength(segment));
  }
  return sum + motion::arcLength(job.track[static_cast<std::size_t>(place.segment)], place.lambda);
}

bool isAtAJoint(const job::Job& job, const JobPlace& place) {
  return place.lambda == 0 ||
         place.lambda == motion::parameterLength(job.track[static_cast<std::size_t>(place.segment)]);
}

/// A step from a place with the wheel beside it by as much as has room, at most 5 mm.
struct AnyStep {
  JobPlace place;
  double distance = 0, beside = 0;
  Vector3d at;
  std::optional<Step> step;
};

/// Calls `check(job, step)` for steps back and forth from random places.
template <class Check> void forAnyStep(int jobs, int steps, Check check) {
  test::Dice dice(7);
  int count = 0;
  for (const job::Job& job : test::jobsOfAllKinds(jobs)) {
    const Room room(job);
    for (int i = 0; i < steps; ++i) {
      AnyStep any;
      any.place = anyPlace(job, dice);
      any.distance = (dice.chance(0.5) ? 1 : -1) * dice.logBetween(0.05, 300);
      any.beside = dice.chance(0.5) ? 0 : room.beside(any.place.segment, 5);
      any.at = test::wheelAt(job, any.place, any.beside);
      any.step = stepProgram(job, any.place, any.distance, any.beside, any.at);
      SCOPED_TRACE(fmt::format("job {}: {:.17g} mm from segment {} at {:.17g}, {:.17g} beside", count / steps,
                               any.distance, any.place.segment, any.place.lambda, any.beside));
      ++count;
      ASSERT_TRUE(any.step);
      check(job, any);
    }
  }
}

TEST(AStep, IsOneMotionFromWhereTheWheelIsToRestAtItsPlace) {
  forAnyStep(20, 10, [](const job::Job& job, const AnyStep& any) {
    const Program& program = any.step->program;
    EXPECT_EQ(program.kind, Kind::Step);
    ASSERT_TRUE(test::isOneMotion(program, any.at));
    const motion::Segment& last = program.track.back();
    const Vector3d end = motion::evaluate(last, motion::parameterLength(last)).point;
    EXPECT_LT((end - test::wheelAt(job, any.step->end, any.beside)).norm(), kPlace);
    for (const motion::Segment& segment : program.track) {
      EXPECT_LE(segment.feed, std::min(kStepFeed, job.recipe.feedPerSecond()));
      EXPECT_GT(segment.contour, 0);
    }
  });
}

TEST(AStep, KnowsItsPlaceOnTheJobsWayAllAlong) {
  forAnyStep(20, 10, [](const job::Job& job, const AnyStep& any) {
    const Program& program = any.step->program;
    for (std::size_t i = 0; i < program.track.size(); ++i) {
      for (const double lambda : test::placesAlong(program.track[i])) {
        const JobPlace place = placeOn(program.places[i], lambda);
        const Vector3d there = test::wheelAt(job, place, any.beside);
        ASSERT_LT((motion::evaluate(program.track[i], lambda).point - there).norm(), kPlace) << "segment " << i;
      }
    }
  });
}

TEST(AStep, NeverBringsTheWheelNearerToTheGlassThanItsRadius) {
  forAnyStep(20, 10, [](const job::Job& job, const AnyStep& any) {
    const double least = job.recipe.wheelRadius - base::kContourAccuracy;
    for (const motion::Segment& segment : any.step->program.track) {
      for (const double lambda : test::placesAlong(segment)) {
        const Vector3d wheel = motion::evaluate(segment, lambda).point;
        ASSERT_GE(test::distanceFromGlass(job.contours, wheel.head<2>()), least);
      }
    }
  });
}

TEST(AStep, GoesAsFarAsAskedUnlessTheWayStopsBefore) {
  int full = 0;
  int all = 0;
  forAnyStep(20, 10, [&](const job::Job& job, const AnyStep& any) {
    const double gone = wayTo(job, any.step->end) - wayTo(job, any.place);
    EXPECT_GT(gone * any.distance, 0);
    EXPECT_LT(std::abs(gone), std::abs(any.distance) + kPlace);
    const bool isFull = std::abs(gone - any.distance) < kPlace;
    EXPECT_TRUE(isFull || isAtAJoint(job, any.step->end)) << "it went " << gone;
    full += isFull ? 1 : 0;
    ++all;
  });
  EXPECT_GT(full, all / 2);
}

TEST(AStep, BackAndTheSameStepForthEndWhereTheyBegan) {
  int count = 0;
  forAnyStep(20, 10, [&](const job::Job& job, const AnyStep& any) {
    if (isAtAJoint(job, any.step->end)) { // it may have ended there
      return;
    }
    const motion::Segment& last = any.step->program.track.back();
    const Vector3d there = motion::evaluate(last, motion::parameterLength(last)).point;
    const std::optional<Step> back = stepProgram(job, any.step->end, -any.distance, any.beside, there);
    ASSERT_TRUE(back);
    EXPECT_TRUE(test::isOneMotion(back->program, there));
    EXPECT_LT((test::wheelAt(job, back->end) - test::wheelAt(job, any.place)).norm(), 1e-6);
    ++count;
  });
  EXPECT_GT(count, 100);
}

/// Steps from a place, each from where the one before ended, until there is none.
JobPlace walk(const job::Job& job, JobPlace place, double distance, double beside, Vector3d& at) {
  constexpr int kMost = 100000;
  const double least = job.recipe.wheelRadius - base::kContourAccuracy;
  for (int i = 0; i < kMost; ++i) {
    const std::optional<Step> step = stepProgram(job, place, distance, beside, at);
    if (!step) {
      return place;
    }
    EXPECT_TRUE(test::isOneMotion(step->program, at));
    for (const motion::Segment& segment : step->program.track) {
      const double length = motion::parameterLength(segment);
      for (const double lambda : {0.0, length / 2, length}) {
        at = motion::evaluate(segment, lambda).point;
        EXPECT_GE(test::distanceFromGlass(job.contours, at.head<2>()), least);
      }
    }
    place = step->end;
    EXPECT_LT((at - test::wheelAt(job, place, beside)).norm(), kPlace);
  }
  ADD_FAILURE() << "it comes to no end";
  return place;
}

TEST(AStep, AfterTheOtherLeadsRoundTheContourFromLeadInToLeadOutAndBack) {
  for (const job::Job& job : test::jobsOfAllKinds(10)) {
    const auto leadIn = std::find_if(job.track.begin(), job.track.end(), [](const auto& s) { return s.contour > 0; });
    const auto behind = std::find_if(leadIn, job.track.end(), [](const auto& s) { return s.contour == 0; });
    const JobPlace begin{static_cast<int>(leadIn - job.track.begin()), 0};
    const JobPlace end{static_cast<int>(behind - job.track.begin()) - 1, motion::parameterLength(behind[-1])};
    Vector3d at = test::wheelAt(job, begin);
    const JobPlace reached = walk(job, begin, 23.7, 0, at);
    EXPECT_LT((test::wheelAt(job, reached) - test::wheelAt(job, end)).norm(), 1e-5);
    EXPECT_EQ(reached.segment, end.segment);
    const JobPlace returned = walk(job, reached, -31.4, 0, at);
    EXPECT_LT((test::wheelAt(job, returned) - test::wheelAt(job, begin)).norm(), 1e-5);
    EXPECT_EQ(returned.segment, begin.segment);
  }
}

TEST(AStep, AfterTheOtherKeepsClearOfTheGlassBesideTheWay) {
  int kinksPassed = 0;
  for (const job::Job& job : test::jobsOfAllKinds(10)) {
    const Room room(job);
    for (int i = 0; i < static_cast<int>(job.track.size()); ++i) {
      const bool startsAfresh =
          i == 0 || job.track[static_cast<std::size_t>(i - 1)].stopAtEnd || room.beside(i - 1, 3) < 3;
      if (startsAfresh && room.beside(i, 3) == 3) {
        Vector3d at = test::wheelAt(job, {i, 0}, 3);
        const JobPlace end = walk(job, {i, 0}, 23.7, 3, at);
        for (int passed = i; passed < end.segment; ++passed) {
          kinksPassed += job.track[static_cast<std::size_t>(passed)].stopAtEnd ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(kinksPassed, 5);
}

TEST(AStep, KeepsTheLimitsOfTheAxes) {
  forAnyStep(12, 5,
             [](const job::Job& /*job*/, const AnyStep& any) { EXPECT_TRUE(test::keepsTheLimits(any.step->program)); });
}

/// The L-shape whose concave corner, at (500, 500), turns the wheel by 90° at an exact stop.
class StepsAtAKink : public testing::Test {
protected:
  void SetUp() override {
    m_job = job::planJob(test::polygon({{0, 0}, {800, 0}, {800, 500}, {500, 500}, {500, 800}, {0, 800}}), {}, {});
    ASSERT_TRUE(m_job.canBeGround());
    for (std::size_t i = 0; i < m_job.track.size(); ++i) {
      if (m_job.track[i].stopCorner > 0) {
        m_before = static_cast<int>(i);
      }
    }
    ASSERT_GE(m_before, 0);
  }

  [[nodiscard]] JobPlace kink() const {
    return {m_before, motion::parameterLength(m_job.track[static_cast<std::size_t>(m_before)])};
  }

  job::Job m_job;
  int m_before = -1;
};

TEST_F(StepsAtAKink, EndThereAndTheNextOneGoesOn) {
  const JobPlace start{m_before, kink().lambda - 10};
  const std::optional<Step> first = stepProgram(m_job, start, 50, 0, test::wheelAt(m_job, start));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->end, kink());
  const std::optional<Step> second = stepProgram(m_job, first->end, 50, 0, test::wheelAt(m_job, kink()));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->end, (JobPlace{m_before + 1, 50}));
  EXPECT_TRUE(test::isOneMotion(second->program, test::wheelAt(m_job, kink())));
}

TEST_F(StepsAtAKink, MoveOverToTheOtherEdgeWhereTheWheelIsBesideTheWay) {
  const Vector3d at = test::wheelAt(m_job, kink(), 5);
  const std::optional<Step> step = stepProgram(m_job, kink(), 50, 5, at);
  ASSERT_TRUE(step);
  EXPECT_TRUE(test::isOneMotion(step->program, at));
  ASSERT_EQ(step->program.track.size(), 2U);
  EXPECT_NEAR(motion::parameterLength(step->program.track.front()), 5 * std::sqrt(2), 1e-6);
  EXPECT_TRUE(step->program.track.front().stopAtEnd);
  EXPECT_EQ(placeOn(step->program.places.front(), 3), (JobPlace{m_before + 1, 0}));
  EXPECT_EQ(step->end, (JobPlace{m_before + 1, 50}));
}

TEST(AStep, ChangesTheRadiusOfAnArcByWhatTheWheelIsBesideIt) {
  const job::Job job = job::planJob(test::paneOf({geometry::arcAbout({0, 0}, 200, 0, 2 * base::kPi)}), {}, {});
  ASSERT_TRUE(job.canBeGround());
  const auto contour = std::find_if(job.track.begin(), job.track.end(),
                                    [](const motion::Segment& segment) { return segment.move == Move::Contour; });
  const JobPlace place{static_cast<int>(contour - job.track.begin()), 100};
  const std::optional<Step> step = stepProgram(job, place, 55, 5, test::wheelAt(job, place, 5));
  ASSERT_TRUE(step);
  double length = 0;
  for (const motion::Segment& segment : step->program.track) {
    length += motion::parameterLength(segment);
  }
  EXPECT_NEAR(length, 55 * 280.0 / 275, 1e-9); // R = 75 round 200, and 5 more
  EXPECT_NEAR(step->end.lambda, 155, 1e-9);
}

TEST(AStep, AtClearanceHeightStaysThere) {
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  ASSERT_TRUE(job.canBeGround());
  const auto leadIn = std::find_if(job.track.begin(), job.track.end(),
                                   [](const motion::Segment& segment) { return segment.move == Move::LeadIn; });
  const JobPlace place{static_cast<int>(leadIn - job.track.begin()), 5};
  Vector3d at = test::wheelAt(job, place);
  at.z() = 77;
  const std::optional<Step> step = stepProgram(job, place, 200, 0, at);
  ASSERT_TRUE(step);
  EXPECT_TRUE(test::isOneMotion(step->program, at));
  const motion::Segment& last = step->program.track.back();
  EXPECT_EQ(motion::evaluate(last, motion::parameterLength(last)).point.z(), 77);
}

TEST(AStep, DoesNotLeaveTheContour) {
  const job::Job job = job::planJob(test::triangle600(), {}, {});
  ASSERT_TRUE(job.canBeGround());
  const auto isOnWay = [](const motion::Segment& segment) { return segment.contour > 0; };
  const auto first = static_cast<int>(std::find_if(job.track.begin(), job.track.end(), isOnWay) - job.track.begin());
  const JobPlace begin{first, 0};
  EXPECT_FALSE(stepProgram(job, begin, -10, 0, test::wheelAt(job, begin)));
  EXPECT_FALSE(stepProgram(job, {first - 1, 0}, 10, 0, job.machine.park));
  EXPECT_FALSE(stepProgram(job, {}, 10, 0, job.machine.park));
}

} // namespace
} // namespace arris::program
