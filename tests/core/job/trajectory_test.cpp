// The planned motion at any time and by place, over seeded random panes.

#include "core/job/trajectory.h"
#include "tests/support/dice.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace arris::job {
namespace {

using geometry::Point;

constexpr int kTrajectories = 20;
constexpr int kTrajectoryPlaces = 100;

class Trajectories : public testing::TestWithParam<int> {
protected:
  void SetUp() override {
    std::uint64_t seed = 7000 + 100 * static_cast<std::uint64_t>(GetParam());
    m_job = test::randomJob(seed);
    m_note = fmt::format("seed {}", seed - 1);
  }

  [[nodiscard]] const Job& theJob() const {
    return m_job;
  }

  [[nodiscard]] const std::string& note() const {
    return m_note;
  }

  // Somewhere on the table, on the pane as often as beside it.
  [[nodiscard]] Point anywhere(test::Dice& dice) const {
    const geometry::Box box = geometry::bounds(m_job.contours.front().curves);
    const geometry::Vector room = box.sizes() / 2;
    return {dice.between(box.min().x() - room.x(), box.max().x() + room.x()),
            dice.between(box.min().y() - room.y(), box.max().y() + room.y())};
  }

private:
  Job m_job;
  std::string m_note;
};

// By chords of the way in the plane, a hundred to each segment of the track.
double leastByChords(const Job& job, const Point& point) {
  constexpr int kChords = 100;
  double least = std::numeric_limits<double>::infinity();
  for (const motion::Segment& segment : job.track) {
    const double length = motion::parameterLength(segment);
    for (int i = 0; i <= kChords; ++i) {
      const Point place = motion::evaluate(segment, length * i / kChords).point.head<2>();
      least = std::min(least, (place - point).norm());
    }
  }
  return least;
}

Point planeAt(const Trajectory& trajectory, double time) {
  return trajectory.at(time).setPoint.position.head<2>();
}

TEST_P(Trajectories, SayAtTheTimeOfARowWhatTheRowSays) {
  SCOPED_TRACE(note());
  const Trajectory trajectory(theJob());
  for (Sampler rows(theJob(), 0.01); !rows.done();) {
    const Sample row = rows.next();
    const Sample at = trajectory.at(row.setPoint.time);
    ASSERT_EQ(at.setPoint.time, row.setPoint.time);
    ASSERT_EQ(at.setPoint.segment, row.setPoint.segment);
    ASSERT_EQ(at.setPoint.position, row.setPoint.position);
    ASSERT_EQ(at.setPoint.velocity, row.setPoint.velocity);
    ASSERT_EQ(at.setPoint.axisAcceleration, row.setPoint.axisAcceleration);
    ASSERT_EQ(at.speed, row.speed);
    ASSERT_EQ(at.path, row.path) << "at " << row.setPoint.time << " s";
    ASSERT_EQ(at.segment, row.segment);
    ASSERT_EQ(at.contour, row.contour);
    ASSERT_EQ(at.corner, row.corner);
    ASSERT_EQ(at.phase, row.phase);
    ASSERT_EQ(at.distance, row.distance);
  }
}

TEST_P(Trajectories, StayAtTheirEndsBeforeTheStartAndAfterTheEnd) {
  const Trajectory trajectory(theJob());
  const double end = theJob().duration;
  EXPECT_EQ(trajectory.at(-5).setPoint.position, theJob().machine.park);
  EXPECT_EQ(trajectory.at(end + 5).setPoint.position, trajectory.at(end).setPoint.position);
  EXPECT_EQ(trajectory.at(end + 5).setPoint.time, end);
}

TEST_P(Trajectories, TellWhenAWayHasBeenTravelled) {
  SCOPED_TRACE(note());
  const Trajectory trajectory(theJob());
  test::Dice dice(static_cast<std::uint64_t>(GetParam()));
  for (int i = 0; i < kTrajectoryPlaces; ++i) {
    const double way = dice.between(0, trajectory.length());
    EXPECT_NEAR(trajectory.at(trajectory.timeAfter(way)).path, way, 1e-6);
  }
  EXPECT_EQ(trajectory.timeAfter(-1), 0);
  EXPECT_NEAR(trajectory.timeAfter(trajectory.length() + 1), theJob().duration, 1e-9);
}

TEST_P(Trajectories, FindThePlaceThatIsNearest) {
  SCOPED_TRACE(note());
  const Trajectory trajectory(theJob());
  test::Dice dice(static_cast<std::uint64_t>(GetParam()));
  for (int i = 0; i < kTrajectoryPlaces; ++i) {
    const Point point = anywhere(dice);
    const Trajectory::Near found = trajectory.nearest(point);
    EXPECT_LE(found.distance, leastByChords(theJob(), point) + 1e-9) << point.transpose();
    EXPECT_NEAR((planeAt(trajectory, found.time) - point).norm(), found.distance, 1e-6) << point.transpose();
  }
}

TEST_P(Trajectories, FindAPlaceOfTheWayItself) {
  SCOPED_TRACE(note());
  const Trajectory trajectory(theJob());
  test::Dice dice(static_cast<std::uint64_t>(GetParam()));
  for (int i = 0; i < kTrajectoryPlaces; ++i) {
    const double time = dice.between(0, theJob().duration);
    const Point place = planeAt(trajectory, time);
    const Trajectory::Near found = trajectory.nearest(place);
    EXPECT_LT(found.distance, 1e-6);
    if (trajectory.at(time).setPoint.velocity.z() == 0) { // else the hand cannot tell
      const Trajectory::Near kept = trajectory.nearest(place, time, 1);
      EXPECT_NEAR(trajectory.at(kept.time).path, trajectory.at(time).path, 1e-3)
          << "a wheel that is dragged nowhere leaves its place";
    }
  }
}

// However far the hand leaves it, and over the places where the way crosses or repeats itself.
TEST_P(Trajectories, DraggedAlongComeNearerThanWhatIsInReach) {
  SCOPED_TRACE(note());
  constexpr double kReach = 20;
  const Trajectory trajectory(theJob());
  test::Dice dice(static_cast<std::uint64_t>(GetParam()));
  double time = theJob().duration / 3;
  for (int i = 0; i < kTrajectoryPlaces; ++i) {
    const Point point = anywhere(dice);
    const Trajectory::Near found = trajectory.nearest(point, time, kReach);
    EXPECT_LE(found.distance, leastByChords(theJob(), point) + kReach + 1e-9);
    time = found.time;
  }
}

TEST_P(Trajectories, FollowAHandThatGoesAlongTheWay) {
  SCOPED_TRACE(note());
  const Trajectory trajectory(theJob());
  double time = 0;
  double way = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double ahead = trajectory.length() * i / 2000;
    const double there = trajectory.timeAfter(ahead);
    time = trajectory.nearest(planeAt(trajectory, there), time, 30).time;
    // down and up in one place the hand cannot tell
    if (std::abs(trajectory.at(there).setPoint.velocity.z()) == 0) {
      EXPECT_GE(trajectory.at(time).path, way - 60) << "it jumped back at " << ahead << " mm";
      way = trajectory.at(time).path;
    }
  }
  EXPECT_GT(way, 0.9 * trajectory.length());
}

TEST_P(Trajectories, TellWhereAnotherPhaseBegins) {
  SCOPED_TRACE(note());
  const Trajectory trajectory(theJob());
  const double end = theJob().duration;
  int changes = 0;
  for (double time = 0, next = trajectory.firstChange(0, end); next < end; ++changes) {
    const Sample before = trajectory.at((time + next) / 2);
    const Sample after = trajectory.at(next);
    EXPECT_TRUE(before.phase != after.phase || before.corner != after.corner) << "at " << next << " s";
    EXPECT_EQ(trajectory.firstChange(end, (time + next) / 2) > next, trajectory.firstChange(next, end) < end);
    EXPECT_EQ(trajectory.firstChange(trajectory.firstChange(next, end), time), next) << "on the way back";
    time = next;
    next = trajectory.firstChange(time, end);
  }
  EXPECT_GT(changes, 5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Trajectories, testing::Range(0, kTrajectories));

// Of two long sides 100 mm apart, a wheel on the one stays there until the hand is at the other.
TEST(Trajectory, StaysOnItsSideUntilTheHandIsAtAnother) {
  recipe::Recipe recipe;
  recipe.wheelRadius = 5;
  recipe.depth = 0;
  recipe.place = Point(200, 200);
  const Job job = planJob(test::polygon({{0, 0}, {600, 0}, {600, 90}, {0, 90}}), recipe, {});
  ASSERT_TRUE(job.canBeGround());
  const Trajectory trajectory(job); // sides at Y 195 and 295
  const double lower = trajectory.nearest({300, 195}).time;
  const auto draggedTo = [&](double y) { return planeAt(trajectory, trajectory.nearest({310, y}, lower, 40).time); };
  EXPECT_NEAR(draggedTo(195).y(), 195, 1e-6);
  EXPECT_NEAR(draggedTo(260).y(), 195, 1e-6); // 65 mm from the one, 35 mm from the other: within reach of as near
  EXPECT_NEAR(draggedTo(260).x(), 310, 1e-6);
  EXPECT_NEAR(draggedTo(290).y(), 295, 1e-6);
}

} // namespace
} // namespace arris::job
