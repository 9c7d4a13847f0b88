#include "core/base/numbers.h"
#include "core/files/gcode.h"
#include "tests/support/lines_of.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"
#include "tests/support/rs274.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <limits>

namespace arris::files {
namespace {

using geometry::Point;
using job::Job;
using test::CanonicalMotion;
using test::Interpretation;
using testing::HasSubstr;
using Kind = CanonicalMotion::Kind;

/// What the interpreter's four decimals can shift an end and a centre by, mm.
constexpr double kPrinted = 2.1e-4;

constexpr double kPromise = 1e-3; ///< mm

Job triangle(const recipe::Recipe& recipe = {}) {
  return job::planJob(test::triangle600(), recipe, {});
}

// The number after a letter of a block.
double wordOf(const std::string& block, char letter) {
  const std::size_t at = block.find(std::string(" ") + letter);
  EXPECT_NE(at, std::string::npos) << letter << " in " << block;
  return base::parseNumber<double>(block.substr(at + 2, block.find(' ', at + 1) - at - 2)).value();
}

// Of an arc, rad, positive counter-clockwise; as LinuxCNC takes it: never nothing.
double sweepOf(const CanonicalMotion& motion) {
  const Point a = motion.from.head<2>() - motion.center;
  const Point b = motion.to.head<2>() - motion.center;
  const double sweep = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
  if (motion.counterClockwise) {
    return sweep > 0 ? sweep : sweep + 2 * base::kPi;
  }
  return sweep < 0 ? sweep : sweep - 2 * base::kPi;
}

Point placeAt(const CanonicalMotion& motion, double share) {
  const Point from = motion.from.head<2>();
  const Point to = motion.to.head<2>();
  if (motion.kind != Kind::Arc) {
    return from + share * (to - from);
  }
  const Point a = from - motion.center;
  const double radius = a.norm() + share * ((to - motion.center).norm() - a.norm());
  const double angle = std::atan2(a.y(), a.x()) + share * sweepOf(motion);
  return motion.center + radius * Point(std::cos(angle), std::sin(angle));
}

double distanceToChord(const Point& point, const Point& from, const Point& to) {
  const Point way = to - from;
  const double share = way.squaredNorm() > 0 ? std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
  return (from + share * way - point).norm();
}

// A stretch of a motion or of the path as points.
struct Trace {
  std::vector<Point> points;
  geometry::Box box;
};

using Traces = std::vector<Trace>;

// Points so dense that chords between them leave the curve by less than 0.1 µm, in short stretches.
template <typename PlaceAt> void addTraces(Traces& traces, PlaceAt placeAtShare, double radius, double length) {
  constexpr int kChords = 16;
  const int steps =
      std::isinf(radius) ? 1 : std::max(4, static_cast<int>(std::ceil(length / std::sqrt(8e-4 * radius))));
  for (int from = 0; from < steps; from += kChords) {
    Trace trace;
    for (int i = from; i <= std::min(from + kChords, steps); ++i) {
      trace.points.push_back(placeAtShare(double(i) / steps));
      trace.box.extend(trace.points.back());
    }
    traces.push_back(trace);
  }
}

void addTraces(Traces& traces, const CanonicalMotion& motion) {
  const bool isArc = motion.kind == Kind::Arc;
  const double radius =
      isArc ? (motion.from.head<2>() - motion.center).norm() : std::numeric_limits<double>::infinity();
  const double length = isArc ? radius * std::abs(sweepOf(motion)) : 0;
  addTraces(
      traces, [&](double share) { return placeAt(motion, share); }, radius, length);
}

void addTraces(Traces& traces, const geometry::Curve& curve) {
  double radius = std::numeric_limits<double>::infinity();
  if (const auto* arc = std::get_if<geometry::Arc>(&curve)) {
    radius = arc->radius();
  } else if (const auto* parabola = std::get_if<geometry::Parabola>(&curve)) {
    const Point s = parabola->a + parabola->c - 2 * parabola->q; // half the constant second derivative by u
    const double across = geometry::cross(parabola->q - parabola->a, s) / s.norm(); // half of q' at the apex
    radius = 2 * across * across / s.norm();                                        // |q'|²/|q''| there
  }
  const double length = geometry::parameterLength(curve);
  addTraces(
      traces, [&](double share) { return geometry::pointAt(curve, share * length); }, radius, length);
}

double distanceToTrace(const Point& point, const Trace& trace) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < trace.points.size(); ++i) {
    least = std::min(least, distanceToChord(point, trace.points[i - 1], trace.points[i]));
  }
  return least;
}

// The largest distance of the points of one set of traces, and of the middles between them, from the other set.
double farthest(const Traces& from, const Traces& to) {
  double largest = 0;
  std::size_t last = 0; // where the point before was found: the next is near it
  const auto look = [&](const Point& point) {
    double least = distanceToTrace(point, to[last]);
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (to[i].box.squaredExteriorDistance(point) < least * least) {
        const double distance = distanceToTrace(point, to[i]);
        last = distance < least ? i : last;
        least = std::min(least, distance);
      }
    }
    largest = std::max(largest, least);
  };
  for (const Trace& trace : from) {
    const std::size_t stride = 1 + trace.points.size() / 2;
    for (std::size_t i = 0; i < trace.points.size(); i += stride) {
      look(trace.points[i]);
      look((trace.points[i] + trace.points[std::min(i + 1, trace.points.size() - 1)]) / 2);
    }
  }
  return largest;
}

bool isFeedInPlane(const CanonicalMotion& motion) {
  return motion.kind != Kind::Rapid && motion.from.z() == motion.to.z();
}

Traces feedsOf(const Interpretation& canon) {
  Traces result;
  for (const CanonicalMotion& motion : canon.motions) {
    if (isFeedInPlane(motion)) {
      addTraces(result, motion);
    }
  }
  return result;
}

Traces wheelPathOf(const Job& job) {
  Traces result;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    for (const toolpath::PathSegment& segment : chain.segments) {
      addTraces(result, segment.shape);
    }
  }
  return result;
}

void expectAccepted(const Interpretation& canon) {
  EXPECT_EQ(canon.status, 0) << canon.message;
  EXPECT_TRUE(canon.ended) << canon.message;
  EXPECT_FALSE(canon.motions.empty());
}

void expectRebuildsTheWheelPath(const Job& job, TransitionForm form) {
  const Interpretation canon = test::interpret(gcode(job, "pane.dxf", form));
  expectAccepted(canon);
  const Traces feeds = feedsOf(canon);
  const Traces path = wheelPathOf(job);
  EXPECT_LT(farthest(feeds, path), kPromise + kPrinted);
  EXPECT_LT(farthest(path, feeds), kPromise + kPrinted);
}

TEST(GCode, OfTheTriangleReadsAsPromised) {
  const std::string text = gcode(triangle(), "triangle.dxf", TransitionForm::Spline);
  EXPECT_THAT(text, HasSubstr("\nG17 G21 G40 G54 G61 G90 G94\n"));
  EXPECT_THAT(text, HasSubstr("\nS6000 M3\nM8\nG4 P3\nG1 Z46 F1000\n"));
  EXPECT_THAT(text, testing::EndsWith("\nM5\nM9\nM30\n"));
  for (const std::string& line : test::linesOf(text)) {
    const std::string word = line.substr(0, line.find(' '));
    const bool motion = word == "G1" || word == "G2" || word == "G3" || word == "G5.1";
    EXPECT_EQ(motion, line.find(" F") != std::string::npos) << line;
  }
}

TEST(GCode, ATransitionIsAParabolaWithItsSpeedAndTheWayToAndFromItIsSplit) {
  const Job job = triangle();
  const std::vector<std::string> lines = test::linesOf(gcode(job, "triangle.dxf", TransitionForm::Spline));
  Point at(0, 0);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string word = lines[i].substr(0, lines[i].find(' '));
    if (word == "G5.1") {
      const toolpath::Corner& expected = job.toolpath.corners.at(corner);
      const job::CornerResult& result = job.cornerResults.at(corner);
      const Point end(wordOf(lines[i], 'X'), wordOf(lines[i], 'Y'));
      const Point control = at + Point(wordOf(lines[i], 'I'), wordOf(lines[i], 'J'));
      EXPECT_LT((at - expected.a).norm(), 1e-6);
      EXPECT_LT((end - expected.c).norm(), 1e-6);
      EXPECT_LT((control - expected.q).norm(), 2e-6);
      EXPECT_NEAR(wordOf(lines[i], 'F'), 1200, 1e-6); // v_trans of 60°: 20 mm/s
      const std::string& before = lines.at(i - 3);    // to P_d, to A, comment, transition, to P_a
      EXPECT_LT((Point(wordOf(before, 'X'), wordOf(before, 'Y')) - result.decelerationPoint).norm(), 1e-6) << before;
      const std::string& after = lines.at(i + 1);
      EXPECT_LT((Point(wordOf(after, 'X'), wordOf(after, 'Y')) - result.accelerationPoint).norm(), 1e-6) << after;
      EXPECT_EQ(wordOf(before, 'F'), 3600);
      EXPECT_EQ(wordOf(after, 'F'), 3600);
      ++corner;
    }
    if (lines[i].find(" X") != std::string::npos) {
      at = {wordOf(lines[i], 'X'), wordOf(lines[i], 'Y')};
    }
  }
  EXPECT_EQ(corner, 3U);
}

TEST(GCode, LinuxCncAcceptsEveryFormOfTheTriangleAndKeepsTheHeightsAndFeeds) {
  const Job job = triangle();
  for (const TransitionForm form : {TransitionForm::Spline, TransitionForm::Arcs, TransitionForm::Lines}) {
    const Interpretation canon = test::interpret(gcode(job, "triangle.dxf", form));
    expectAccepted(canon);
    EXPECT_EQ(canon.motions.front().to.z(), 120); // first up, wherever the machine is
    for (const CanonicalMotion& motion : canon.motions) {
      if (motion.kind == Kind::Rapid) {
        EXPECT_TRUE(motion.to.z() == 120 || motion.to.z() == 77) << motion.to.z();
      } else if (motion.kind != Kind::Spline) {
        EXPECT_EQ(motion.to.z(), 46);
        EXPECT_TRUE(motion.spindleOn && motion.coolantOn);
        EXPECT_LE(motion.feed, 3600);
      }
    }
    EXPECT_LT((canon.motions.back().to - Eigen::Vector3d(0, 0, 120)).norm(), 1e-9);
  }
}

TEST(GCode, WithArcsOrLinesLinuxCncRebuildsTheWheelPathOfTheTriangle) {
  for (const double degrees : {0.0, 17.0}) {
    const Job job = job::planJob(test::triangle600(degrees), {}, {});
    expectRebuildsTheWheelPath(job, TransitionForm::Arcs);
    expectRebuildsTheWheelPath(job, TransitionForm::Lines);
  }
}

TEST(GCode, WithArcsOrLinesLinuxCncRebuildsTheWheelPathOfARectangle) {
  const Job job = job::planJob(test::polygon({{0, 0}, {800, 0}, {800, 500}, {0, 500}}), {}, {});
  expectRebuildsTheWheelPath(job, TransitionForm::Arcs);
  expectRebuildsTheWheelPath(job, TransitionForm::Lines);
}

TEST(GCode, WithArcsOrLinesLinuxCncRebuildsTheWheelPathOfRandomPanes) {
  std::uint64_t seed = 77000;
  for (int i = 0; i < 12; ++i) {
    const Job job = test::randomJob(seed);
    SCOPED_TRACE(fmt::format("seed {}", seed - 1));
    expectAccepted(test::interpret(gcode(job, "pane.dxf", TransitionForm::Spline)));
    expectRebuildsTheWheelPath(job, TransitionForm::Arcs);
    expectRebuildsTheWheelPath(job, TransitionForm::Lines);
  }
}

TEST(GCode, ACircleIsAFullTurnAndNotAPoint) {
  for (const auto direction : {recipe::Direction::Clockwise, recipe::Direction::CounterClockwise}) {
    recipe::Recipe recipe;
    recipe.direction = direction;
    recipe.overlap = 0;
    const Job job = job::planJob(test::paneOf({geometry::arcAbout({0, 0}, 400, 0, 2 * base::kPi)}), recipe, {});
    ASSERT_TRUE(job.canBeGround());
    expectRebuildsTheWheelPath(job, TransitionForm::Arcs);
  }
}

// Edges that look straight: arcs of up to a million kilometres of radius.
TEST(GCode, ArcsThatAControllerCouldTakeForFullCirclesAreWrittenAsLines) {
  for (const double bulge : {1.0, 1e-2, 1e-3, 1e-4, 2e-5, 1e-6, 1e-9, 1e-13}) {
    const double sweep = 8 * bulge / 1000;
    const Job job = job::planJob(test::paneOf({geometry::arcBetween({0, 0}, {1000, 0}, sweep),
                                               geometry::arcBetween({1000, 0}, {1000, 700}, sweep),
                                               geometry::arcBetween({1000, 700}, {0, 700}, sweep),
                                               geometry::arcBetween({0, 700}, {0, 0}, sweep)}),
                                 {}, {});
    SCOPED_TRACE(bulge);
    ASSERT_TRUE(job.canBeGround()) << base::describeWithPlace(job.problems.front());
    expectRebuildsTheWheelPath(job, TransitionForm::Arcs);
  }
}

TEST(GCode, TheFeedIsNeverMoreThanTheAxesHoldFromEndToEndOfABlock) {
  // A rounded pane whose roundings ask for more than the feed allows them.
  const double radius = 30;
  std::vector<geometry::Curve> edges;
  const std::vector<Point> corners{{0, 0}, {700, 0}, {700, 500}, {0, 500}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point way = (corners[(i + 1) % 4] - corners[i]).normalized();
    const Point next = (corners[(i + 2) % 4] - corners[(i + 1) % 4]).normalized();
    const Point from = corners[i] + radius * way;
    const Point to = corners[(i + 1) % 4] - radius * way;
    edges.emplace_back(geometry::Line{from, to});
    edges.emplace_back(geometry::arcBetween(to, corners[(i + 1) % 4] + radius * next, base::kPi / 2));
  }
  recipe::Recipe recipe;
  recipe.lead = 500;
  recipe.accelX = 15;
  const Job job = job::planJob(test::paneOf(edges), recipe, {});
  ASSERT_TRUE(job.canBeGround()) << base::describeWithPlace(job.problems.front());
  const Interpretation canon = test::interpret(gcode(job, "pane.dxf", TransitionForm::Arcs));
  int roundings = 0;
  for (const CanonicalMotion& motion : canon.motions) {
    if (motion.kind == Kind::Arc) {
      const double pathRadius = (motion.from.head<2>() - motion.center).norm();
      const double speed = motion.feed / 60;
      if (std::abs(pathRadius - 105) < 1e-3) {
        ++roundings;
        EXPECT_NEAR(speed * speed / pathRadius, 15, 1e-3); // where it points along X
      } else {
        EXPECT_EQ(motion.feed, 3600); // the leads
      }
    }
  }
  EXPECT_GE(roundings, 4);
}

TEST(GCode, AnExactStopIsOneForItsBlockOnly) {
  Job job = triangle();
  const auto side = std::find_if(job.track.begin(), job.track.end(),
                                 [](const motion::Segment& segment) { return segment.move == motion::Move::Contour; });
  ASSERT_NE(side, job.track.end());
  side->stopAtEnd = true;
  const geometry::Point end = std::get<geometry::Line>(side->shape).to;
  const Interpretation canon = test::interpret(gcode(job, "triangle.dxf", TransitionForm::Arcs));
  expectAccepted(canon);
  int stops = 0;
  for (const CanonicalMotion& motion : canon.motions) {
    if (motion.exactStop) {
      ++stops;
      EXPECT_LT((motion.to.head<2>() - end).norm(), 1e-4);
    }
  }
  EXPECT_EQ(stops, 1);
}

TEST(GCode, NamesInCommentsCannotBreakTheProgram) {
  for (const char* name : {"pane (copy).dxf", "a)b(c", "(((", ")))", "玻璃 ñ.dxf", "line\nbreak\r\t.dxf", "%",
                           "msg,hello", "", "\xff\xfe"}) {
    const std::string text = gcode(triangle(), name, TransitionForm::Lines);
    expectAccepted(test::interpret(text));
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  }
  const std::string text = gcode(triangle(), std::string(5000, 'x'), TransitionForm::Spline);
  for (const std::string& line : test::linesOf(text)) {
    EXPECT_LT(line.size(), 255U);
  }
}

TEST(GCode, IsTheSameInEveryLocale) {
  const std::string text = gcode(triangle(), "triangle.dxf", TransitionForm::Arcs);
  for (const char* locale : {"de_DE.UTF-8", "it_IT.UTF-8", "zh_CN.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr) << locale;
    EXPECT_EQ(gcode(triangle(), "triangle.dxf", TransitionForm::Arcs), text);
    std::setlocale(LC_ALL, "C");
  }
}

} // namespace
} // namespace arris::files
