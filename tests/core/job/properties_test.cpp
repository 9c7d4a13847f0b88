// What holds for every pane, over seeded random convex panes of lines and arcs.

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/job/job.h"
#include "tests/support/random_panes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace arris::job {
namespace {

using base::squared;
using toolpath::PathSegment;
using toolpath::Role;

constexpr int kPanes = 60;

/// The accuracy of a second difference over 1 ms in double precision, mm/s².
constexpr double kSecondDifference = 1e-6;

class RandomPanes : public testing::TestWithParam<int> {
protected:
  void SetUp() override {
    std::uint64_t seed = 1000 * static_cast<std::uint64_t>(GetParam());
    m_job = test::randomJob(seed);
    SCOPED_TRACE(fmt::format("seed {}", seed - 1));
  }

  [[nodiscard]] const Job& theJob() const {
    return m_job;
  }

private:
  Job m_job;
};

double distanceToContours(const Job& job, const geometry::Point& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const pattern::Contour& contour : job.contours) {
    for (const geometry::Curve& curve : contour.curves) {
      least = std::min(least, geometry::nearest(curve, point).distance);
    }
  }
  return least;
}

TEST_P(RandomPanes, ThePathIsG1FromLeadInToLeadOut) {
  for (const toolpath::Chain& chain : theJob().toolpath.chains) {
    EXPECT_EQ(chain.segments.front().role, Role::LeadIn);
    EXPECT_EQ(chain.segments.back().role, Role::LeadOut);
    for (std::size_t i = 1; i < chain.segments.size(); ++i) {
      const geometry::Curve& before = chain.segments[i - 1].shape;
      const geometry::Curve& after = chain.segments[i].shape;
      EXPECT_LT((geometry::endPoint(before) - geometry::startPoint(after)).norm(), 1e-10) << "segment " << i;
      EXPECT_LT((geometry::endTangent(before) - geometry::startTangent(after)).norm(), 1e-10) << "segment " << i;
    }
  }
}

TEST_P(RandomPanes, NoPointOfThePathComesNearerToTheContourThanTheWheel) {
  const double least = theJob().recipe.wheelRadius - base::kContourAccuracy;
  for (const toolpath::Chain& chain : theJob().toolpath.chains) {
    for (const PathSegment& piece : chain.segments) {
      const double length = geometry::parameterLength(piece.shape);
      const int steps = 20 + static_cast<int>(length);
      for (int i = 0; i <= steps; ++i) {
        ASSERT_GE(distanceToContours(theJob(), geometry::pointAt(piece.shape, length * i / steps)), least);
      }
    }
  }
}

TEST_P(RandomPanes, TheWheelGoesDownAndComesUpClearOfTheBlank) {
  const recipe::Recipe& recipe = theJob().recipe;
  for (const toolpath::Chain& chain : theJob().toolpath.chains) {
    const double clear = recipe.wheelRadius + recipe.depth + 1;
    EXPECT_GE(distanceToContours(theJob(), geometry::startPoint(chain.segments.front().shape)), clear - 1e-9);
    EXPECT_GE(distanceToContours(theJob(), geometry::endPoint(chain.segments.back().shape)), clear - 1e-9);
  }
}

TEST_P(RandomPanes, ATransitionKeepsTheWheelOffItsCornerAndReachesTheWidestDistance) {
  for (const toolpath::Chain& chain : theJob().toolpath.chains) {
    for (const PathSegment& piece : chain.segments) {
      if (piece.corner == 0) {
        continue;
      }
      const toolpath::Corner& corner = theJob().toolpath.corners[static_cast<std::size_t>(piece.corner - 1)];
      const double length = geometry::parameterLength(piece.shape);
      double widest = 0;
      for (int i = 0; i <= 100; ++i) {
        const double distance = (geometry::pointAt(piece.shape, length * i / 100) - corner.s).norm();
        EXPECT_GE(distance, theJob().recipe.wheelRadius - 1e-9);
        widest = std::max(widest, distance);
      }
      EXPECT_NEAR(widest, corner.widest, 1e-9 * corner.widest);
    }
  }
}

TEST_P(RandomPanes, EveryPointOfTheContourIsTouched) {
  const double reach = theJob().recipe.wheelRadius + base::kContourAccuracy;
  std::vector<geometry::Curve> edges;
  for (const PathSegment& piece : theJob().toolpath.chains.front().segments) {
    if (piece.role != Role::Transition) {
      edges.push_back(piece.shape);
    }
  }
  for (const geometry::Curve& curve : theJob().contours.front().curves) {
    const double length = geometry::parameterLength(curve);
    for (int i = 0; i <= 20; ++i) {
      const geometry::Point point = geometry::pointAt(curve, length * i / 20);
      const bool touched = std::any_of(edges.begin(), edges.end(), [&](const geometry::Curve& edge) {
        return geometry::nearest(edge, point).distance <= reach;
      });
      EXPECT_TRUE(touched);
    }
  }
}

/// Keeps the last positions and compares their second difference with the limits.
class LimitWatch {
public:
  explicit LimitWatch(const Job& job) : m_limits(job.limits), m_period(job.machine.period) {
    m_last.fill(Eigen::Vector3d::Zero());
  }

  void add(const motion::SetPoint& point) {
    m_last = {m_last[1], m_last[2], point.position};
    ++m_count;
    for (int axis = 0; axis < 3; ++axis) {
      worstSpeed = std::max(worstSpeed, std::abs(point.velocity[axis]) / m_limits.speed[axis]);
      worstAcceleration =
          std::max(worstAcceleration, std::abs(point.axisAcceleration[axis]) / m_limits.acceleration[axis]);
      if (m_count >= 3) {
        const double second = (m_last[0][axis] - 2 * m_last[1][axis] + m_last[2][axis]) / squared(m_period);
        worstExcess = std::max(worstExcess, std::abs(second) - m_limits.acceleration[axis]);
      }
    }
  }

  void expectKept() const {
    EXPECT_LE(worstSpeed, 1 + 1e-9);
    EXPECT_LE(worstAcceleration, 1 + 1e-9);
    EXPECT_LE(worstExcess, kSecondDifference);
  }

  double worstSpeed = 0, worstAcceleration = 0; ///< as a share of the limit
  double worstExcess = -std::numeric_limits<double>::infinity();

private:
  motion::AxisLimits m_limits;
  double m_period;
  int m_count = 0;
  std::array<Eigen::Vector3d, 3> m_last;
};

TEST_P(RandomPanes, NoAxisExceedsItsLimitsAtAnyConstantOverride) {
  for (const double factor : {0.1, 0.37, 0.8, 1.0, 1.2, 1.5}) {
    SCOPED_TRACE(fmt::format("override {}", factor));
    motion::Interpolator interpolator(theJob().track, theJob().intervals, theJob().limits);
    interpolator.setOverride(factor);
    LimitWatch watch(theJob());
    const double most = 20 * theJob().duration / factor;
    std::size_t tick = 0;
    for (; !interpolator.atEnd(); ++tick) {
      const double time = static_cast<double>(tick) * theJob().machine.period;
      ASSERT_LT(time, most) << "it does not come to its end";
      watch.add(interpolator.advanceTo(time));
    }
    watch.expectKept();
  }
}

TEST_P(RandomPanes, TheOverrideMayChangeAtAnyMoment) {
  std::mt19937 engine(static_cast<unsigned>(GetParam()));
  motion::Interpolator interpolator(theJob().track, theJob().intervals, theJob().limits);
  LimitWatch watch(theJob());
  const std::array<double, 6> factors{0, 0.1, 0.5, 1, 1.3, 1.5};
  double factor = 1;
  double next = 0;
  for (std::size_t tick = 0; !interpolator.atEnd(); ++tick) {
    const double time = static_cast<double>(tick) * theJob().machine.period;
    ASSERT_LT(time, 100 * theJob().duration + 100) << "it does not come to its end";
    if (time >= next) {
      factor = factors[engine() % factors.size()];
      interpolator.setOverride(factor);
      next = time + 1e-4 * static_cast<double>(engine() % 30000);
    }
    watch.add(interpolator.advanceTo(time));
  }
  watch.expectKept();
}

TEST_P(RandomPanes, ABrakeOrderedAtAnyMomentComesToRestOnThePathWithinTheLimits) {
  std::mt19937 engine(static_cast<unsigned>(GetParam()));
  for (int stop = 0; stop < 20; ++stop) {
    const double at = theJob().duration * static_cast<double>(engine()) / 0x1p32;
    motion::Interpolator interpolator(theJob().track, theJob().intervals, theJob().limits);
    LimitWatch watch(theJob());
    watch.add(interpolator.advanceTo(at - 0.001));
    watch.add(interpolator.advanceTo(at));
    interpolator.setOverride(0);
    double speed = interpolator.advanceTo(at).speed;
    double time = at;
    const double most = at + 100;
    while (speed > 0) {
      time += theJob().machine.period;
      ASSERT_LT(time, most) << "it does not come to rest";
      const motion::SetPoint point = interpolator.advanceTo(time);
      EXPECT_LE(point.speed, speed * (1 + 1e-9)) << "it speeds up in a hold";
      speed = point.speed;
      watch.add(point);
    }
    watch.expectKept();
  }
}

TEST_P(RandomPanes, TheRowsOfTheProfileAreConsistentWithEachOther) {
  const double period = theJob().machine.period;
  Sampler sampler(theJob());
  const std::size_t rows = sampler.count();
  Sample last = sampler.next();
  std::size_t count = 1;
  EXPECT_EQ(last.setPoint.time, 0);
  EXPECT_EQ(last.setPoint.position, theJob().machine.park);
  for (; !sampler.done(); ++count) {
    const Sample row = sampler.next();
    const double dt = row.setPoint.time - last.setPoint.time;
    ASSERT_GT(dt, 0);
    ASSERT_LE(dt, period * (1 + 1e-6));
    const double greatest = theJob().limits.acceleration.maxCoeff();
    const Eigen::Vector3d moved = row.setPoint.position - last.setPoint.position;
    const Eigen::Vector3d mean = (row.setPoint.velocity + last.setPoint.velocity) / 2;
    ASSERT_LT((moved - dt * mean).cwiseAbs().maxCoeff(), 0.5 * greatest * dt * dt + 1e-11);
    const Eigen::Vector3d gained = row.setPoint.velocity - last.setPoint.velocity;
    ASSERT_LT(gained.cwiseAbs().maxCoeff(), greatest * dt * (1 + 1e-4) + 1e-9);
    ASSERT_GE(row.path, last.path);
    ASSERT_NEAR(row.path - last.path, dt * (row.speed + last.speed) / 2, greatest * dt * dt + 1e-9);
    ASSERT_NEAR(row.speed, row.setPoint.velocity.norm(), 1e-12);
    ASSERT_LE(row.speed, std::max(theJob().recipe.feedPerSecond(), 300.0) * (1 + 1e-9));
    last = row;
  }
  EXPECT_EQ(count, rows);
  EXPECT_EQ(last.setPoint.time, theJob().duration);
  EXPECT_LT((last.setPoint.position - theJob().machine.park).norm(), 1e-9);
  EXPECT_LT(last.speed, 1e-6);
}

TEST_P(RandomPanes, TheTimesOfThePhasesAddUp) {
  double sum = 0;
  for (const double time : theJob().byPhase) {
    EXPECT_GE(time, 0);
    sum += time;
  }
  EXPECT_NEAR(sum, theJob().duration, 1e-9 * theJob().duration);
  EXPECT_LT(theJob().working, theJob().duration);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPanes, testing::Range(0, kPanes));

} // namespace
} // namespace arris::job
