#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/job/program_track.h"
#include "core/program/manoeuvres.h"
#include "tests/support/dice.h"
#include "tests/support/panes.h"
#include "tests/support/programs.h"
#include "tests/support/swept_glass.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace arris::program {
namespace {

using Eigen::Vector3d;
using motion::Move;
using motion::Segment;

const Segment& trackAt(const job::Job& job, int segment) {
  return job.track.at(static_cast<std::size_t>(segment));
}

/// The program to resume a job from a place with the wheel where it then may stand.
struct Resumed {
  JobPlace place;
  double overlap = 0;
  Vector3d at;
  Program program;
};

/// Calls `check(job, resumed)` for random places of the whole track, on the contours or anywhere.
template <class Check> void forAnyResumption(int jobs, int places, Check check) {
  test::Dice dice(3);
  int count = 0;
  for (const job::Job& job : test::jobsOfAllKinds(jobs)) {
    for (int i = 0; i < places; ++i) {
      Resumed resumed;
      const auto segment = static_cast<int>(dice.between(0, static_cast<double>(job.track.size())));
      resumed.place = {segment, dice.between(0, 1) * motion::parameterLength(trackAt(job, segment))};
      resumed.overlap = dice.chance(0.2) ? 0 : dice.between(0, 40);
      resumed.at = test::wheelAt(job, resumed.place);
      resumed.at.z() += dice.chance(0.5) ? 0 : dice.between(0, 1) * (job.machine.travel.z() - resumed.at.z());
      resumed.program = resumeProgram(job, resumed.place, resumed.overlap, resumed.at);
      SCOPED_TRACE(fmt::format("job {} from segment {} at {:.17g}, overlap {:.17g}", count / places, segment,
                               resumed.place.lambda, resumed.overlap));
      check(job, resumed);
      ++count;
    }
  }
}

/// Index of the first segment that is the job's own; the size of the program where there is none.
std::size_t firstOwn(const Program& program) {
  const auto own = std::find_if(program.places.begin(), program.places.end(),
                                [](const JobStretch& stretch) { return stretch.from.segment >= 0; });
  return static_cast<std::size_t>(own - program.places.begin());
}

/// Its lead-in where that is not the job's own.
const Segment* newLead(const Program& program) {
  const std::size_t own = firstOwn(program);
  return own > 0 && own < program.track.size() && program.track[own - 1].move == Move::LeadIn ? &program.track[own - 1]
                                                                                              : nullptr;
}

bool isGrinding(const Segment& segment) {
  return segment.move == Move::Contour || segment.move == Move::Transition || segment.move == Move::Roll;
}

TEST(AResumedJob, IsOneMotionFromWhereTheWheelIsToThePark) {
  forAnyResumption(20, 10, [](const job::Job& job, const Resumed& resumed) {
    EXPECT_EQ(resumed.program.kind, Kind::Job);
    ASSERT_TRUE(test::isOneMotion(resumed.program, resumed.at));
    const Segment& last = resumed.program.track.back();
    EXPECT_LT((motion::evaluate(last, motion::parameterLength(last)).point - job.machine.park).norm(), 1e-6);
  });
}

TEST(AResumedJob, KeepsTheLimitsOfTheAxes) {
  forAnyResumption(6, 3, [](const job::Job& /*job*/, const Resumed& resumed) {
    EXPECT_TRUE(test::keepsTheLimits(resumed.program));
  });
}

TEST(AResumedJob, IsTheJobItselfFromThePlaceOrSomewhatBefore) {
  forAnyResumption(20, 10, [](const job::Job& job, const Resumed& resumed) {
    const Program& program = resumed.program;
    const std::size_t own = firstOwn(program);
    int next = own < program.track.size() ? program.places[own].from.segment : static_cast<int>(job.track.size());
    for (std::size_t i = own; i < program.track.size(); ++i, ++next) {
      const JobStretch& stretch = program.places[i];
      const Segment& original = trackAt(job, next);
      ASSERT_EQ(stretch.from.segment, next);
      EXPECT_TRUE(stretch.from.lambda == 0 || i == own);
      const double length = motion::parameterLength(program.track[i]);
      EXPECT_NEAR(placeOn(stretch, length).lambda, motion::parameterLength(original), 1e-9);
      for (const double lambda : {0.0, 0.3 * length, 0.7 * length, length}) {
        const Vector3d expected = test::wheelAt(job, placeOn(stretch, lambda));
        ASSERT_LT((motion::evaluate(program.track[i], lambda).point - expected).norm(), 1e-9);
      }
      EXPECT_EQ(program.track[i].move, original.move);
      EXPECT_EQ(program.track[i].number, original.number);
      EXPECT_EQ(program.track[i].speedCap, original.speedCap);
      EXPECT_EQ(program.track[i].stopAtEnd, original.stopAtEnd);
    }
    if (own < program.track.size()) {
      EXPECT_EQ(next, static_cast<int>(job.track.size()));
    }
  });
}

TEST(AResumedJob, LeavesNothingUngroundBehindThePlace) {
  forAnyResumption(20, 10, [](const job::Job& job, const Resumed& resumed) {
    const std::size_t own = firstOwn(resumed.program);
    int firstLeft = resumed.place.segment; // that still has to be ground from the place on
    while (firstLeft < static_cast<int>(job.track.size()) && !isGrinding(trackAt(job, firstLeft))) {
      ++firstLeft;
    }
    if (firstLeft == static_cast<int>(job.track.size())) {
      EXPECT_EQ(own, resumed.program.track.size()) << "it grinds again though all was done";
      return;
    }
    ASSERT_LT(own, resumed.program.track.size());
    const JobPlace start = resumed.program.places[own].from;
    EXPECT_LE(start.segment, firstLeft);
    EXPECT_EQ(trackAt(job, start.segment).contour == 0 ? trackAt(job, start.segment + 1).contour
                                                       : trackAt(job, start.segment).contour,
              trackAt(job, firstLeft).contour)
        << "it grinds a contour again that was done";
    if (isGrinding(trackAt(job, resumed.place.segment)) && newLead(resumed.program)) {
      double again = motion::arcLength(trackAt(job, resumed.place.segment), resumed.place.lambda) -
                     motion::arcLength(trackAt(job, start.segment), start.lambda);
      for (int i = start.segment; i < resumed.place.segment; ++i) {
        again += motion::arcLength(trackAt(job, i), motion::parameterLength(trackAt(job, i)));
      }
      EXPECT_GE(again, resumed.overlap - 1e-9);
    }
  });
}

TEST(AResumedJob, NeverBringsTheWheelNearerToTheGlassThanItsRadius) {
  forAnyResumption(10, 6, [](const job::Job& job, const Resumed& resumed) {
    const double clearance = job::heightsOf(job.recipe, job.machine).clearance;
    const double least = job.recipe.wheelRadius - base::kContourAccuracy;
    for (std::size_t i = 0; i < resumed.program.track.size(); ++i) {
      const Segment& segment = resumed.program.track[i];
      const bool straightUp = i == 0 && std::holds_alternative<motion::Vertical>(segment.shape);
      const double length = motion::parameterLength(segment);
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vector3d wheel = motion::evaluate(segment, share * length).point;
        if (!straightUp && wheel.z() < clearance - 1e-9) {
          ASSERT_GE(test::distanceFromGlass(job.contours, wheel.head<2>()), least) << "segment " << i;
        }
      }
    }
  });
}

/// The curves of the glass that meet the one nearest to a point tangentially or at a corner of up to 60°, which the
/// wheel rolls round: what a lead-in to there may touch.
std::set<std::pair<std::size_t, std::size_t>> sameEdge(const job::Job& job, const geometry::Point& point) {
  std::pair<std::size_t, std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < job.contours.size(); ++c) {
    for (std::size_t i = 0; i < job.contours[c].curves.size(); ++i) {
      const double distance = geometry::nearest(job.contours[c].curves[i], point).distance;
      if (distance < least) {
        least = distance;
        best = {c, i};
      }
    }
  }
  const std::vector<geometry::Curve>& ring = job.contours[best.first].curves;
  const std::size_t n = ring.size();
  const auto isBlunt = [&](std::size_t before) {
    const double turn =
        geometry::turn(geometry::endTangent(ring[before % n]), geometry::startTangent(ring[(before + 1) % n]));
    return std::abs(turn) <= base::radians(60) + 1e-9;
  };
  std::set<std::pair<std::size_t, std::size_t>> result{best};
  for (std::size_t i = best.second; isBlunt(i) && result.insert({best.first, (i + 1) % n}).second; ++i) {
  }
  for (std::size_t i = best.second + n; isBlunt(i - 1) && result.insert({best.first, (i - 1) % n}).second; --i) {
    i = i == 1 ? i + n : i;
  }
  return result;
}

TEST(AResumedJob, IsEnteredClearOfTheBlankAndOfAllGlassButTheEdgeEntered) {
  int leads = 0;
  int onContours = 0;
  forAnyResumption(20, 10, [&](const job::Job& job, const Resumed& resumed) {
    onContours += isGrinding(trackAt(job, resumed.place.segment)) ? 1 : 0;
    const Segment* lead = newLead(resumed.program);
    if (!lead) {
      return;
    }
    ++leads;
    const double clear = job.recipe.wheelRadius + job.recipe.depth;
    const Vector3d down = motion::evaluate(*lead, 0).point;
    EXPECT_GE(test::distanceFromGlass(job.contours, down.head<2>()), clear + 1 - 2e-6);
    const geometry::Curve curve = motion::curveOf(*lead);
    const auto own = sameEdge(job, geometry::endPoint(curve));
    for (const double lambda : test::placesAlong(*lead)) {
      const geometry::Point wheel = geometry::pointAt(curve, lambda);
      for (std::size_t c = 0; c < job.contours.size(); ++c) {
        for (std::size_t i = 0; i < job.contours[c].curves.size(); ++i) {
          const double least = own.contains({c, i}) ? job.recipe.wheelRadius - base::kContourAccuracy : clear;
          ASSERT_GE(geometry::nearest(job.contours[c].curves[i], wheel).distance, least - 2e-6);
        }
      }
    }
  });
  EXPECT_GT(leads, onContours / 2);
}

/// The lower side of the triangle is one long line on both sides of the start.
class ResumedOnATriangle : public testing::Test {
protected:
  void SetUp() override {
    m_job = job::planJob(test::triangle600(), {}, {});
    ASSERT_TRUE(m_job.canBeGround());
  }

  [[nodiscard]] int firstOf(Move move) const {
    const auto found = std::find_if(m_job.track.begin(), m_job.track.end(),
                                    [move](const Segment& segment) { return segment.move == move; });
    return static_cast<int>(found - m_job.track.begin());
  }

  job::Job m_job;
};

TEST_F(ResumedOnATriangle, JoinsTheWayByTheOverlapBeforeThePlace) {
  const JobPlace place{firstOf(Move::Contour), 250};
  const Vector3d at = test::wheelAt(m_job, place, 5);
  const Program program = resumeProgram(m_job, place, 12, at);
  const std::size_t own = firstOwn(program);
  ASSERT_LT(own, program.track.size());
  EXPECT_EQ(program.places[own].from.segment, place.segment);
  EXPECT_NEAR(program.places[own].from.lambda, 238, 1e-9);
  // Up, across, down, lead-in; each where the job has the same.
  ASSERT_EQ(own, 4U);
  EXPECT_NEAR(motion::evaluate(program.track[1], 0).point.z(), 77, 1e-9);
  EXPECT_EQ(program.track[2].move, Move::Plunge);
  EXPECT_NEAR(motion::evaluate(program.track[3], 0).point.z(), 46, 1e-9);
  EXPECT_NEAR(motion::parameterLength(program.track[3]), 20 * base::kPi / 2, 1e-9);
}

TEST_F(ResumedOnATriangle, JoinsOnTheEdgeBeforeATransitionFromInsideIt) {
  const int transition = firstOf(Move::Transition);
  const JobPlace place{transition, 100};
  const Program program = resumeProgram(m_job, place, 0, test::wheelAt(m_job, place));
  const std::size_t own = firstOwn(program);
  ASSERT_LT(own, program.track.size());
  ASSERT_TRUE(newLead(program));
  EXPECT_EQ(program.places[own].from.segment, transition - 1);
  const double left = motion::parameterLength(trackAt(m_job, transition - 1)) - program.places[own].from.lambda;
  EXPECT_GT(left, 0);
  EXPECT_LT(left, 10) << "clear of the edge behind the corner within a few millimetres";
}

TEST_F(ResumedOnATriangle, BeginsWithTheApproachWhereTheLeadInWasBrokenOff) {
  const int lead = firstOf(Move::LeadIn);
  const JobPlace place{lead, 3};
  const Program program = resumeProgram(m_job, place, 10, test::wheelAt(m_job, place));
  const std::size_t own = firstOwn(program);
  ASSERT_LT(own, program.track.size());
  EXPECT_EQ(program.places[own].from, (JobPlace{lead - 1, 0}));
  EXPECT_EQ(program.track[own].move, Move::Plunge);
}

TEST_F(ResumedOnATriangle, OnlyGoesToTheParkBehindTheContour) {
  const int out = firstOf(Move::LeadOut);
  for (const JobPlace& place : {JobPlace{out, 3}, JobPlace{out + 1, 1}, JobPlace{out + 2, 5}}) {
    const Program program = resumeProgram(m_job, place, 10, test::wheelAt(m_job, place));
    EXPECT_EQ(firstOwn(program), program.track.size());
    EXPECT_TRUE(test::isOneMotion(program, test::wheelAt(m_job, place)));
  }
}

TEST_F(ResumedOnATriangle, StaysAtTheHeightWhereItIsAboveClearance) {
  const JobPlace place{firstOf(Move::Contour), 250};
  Vector3d at = test::wheelAt(m_job, place);
  at.z() = 110;
  const Program program = resumeProgram(m_job, place, 12, at);
  EXPECT_EQ(program.track.front().z, 110);
  EXPECT_TRUE(std::holds_alternative<geometry::Line>(program.track.front().shape));
}

} // namespace
} // namespace arris::program
