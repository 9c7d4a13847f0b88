// The same shape gives the same wheel path and the same time, however it was drawn and wherever it lies.

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/contours.h"
#include "tests/support/dxf_text.h"
#include "tests/support/panes.h"
#include "tests/support/swept_glass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::job {
namespace {

using base::kPi;
using geometry::Arc;
using geometry::arcBetween;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using test::DxfText;

constexpr double kSamePath = 1e-3; ///< mm
constexpr double kSameTime = 1e-3; ///< of the duration

/// Closed chains, counter-clockwise.
using Shape = std::vector<std::vector<Curve>>;

/// Lines and arcs, tangential joints, corners between lines and between line and arc; one longest line.
Shape convexShape() {
  return {{Line{{0, 0}, {500, 0}}, Line{{500, 0}, {500, 250}}, arcBetween({500, 250}, {420, 330}, kPi / 2),
           Line{{420, 330}, {200, 330}}, Line{{200, 330}, {60, 280}}, arcBetween({60, 280}, {0, 0}, 0.4)}};
}

/// An L with a hollow in one side: a concave corner, and an arc of which the wheel runs the inside.
Shape concaveShape() {
  return {{Line{{0, 0}, {900, 0}}, Line{{900, 0}, {900, 450}}, Line{{900, 450}, {520, 450}},
           Line{{520, 450}, {520, 800}}, Line{{520, 800}, {400, 800}}, arcBetween({400, 800}, {150, 800}, -1.2),
           Line{{150, 800}, {0, 800}}, Line{{0, 800}, {0, 0}}}};
}

/// The same with a round cut-out and a slot.
Shape shapeWithCutOuts() {
  Shape shape = concaveShape();
  shape.push_back({geometry::arcAbout({230, 250}, 100, -kPi / 2, 2 * kPi)});
  shape.push_back({Line{{550, 160}, {750, 160}}, arcBetween({750, 160}, {750, 280}, kPi), Line{{750, 280}, {550, 280}},
                   arcBetween({550, 280}, {550, 160}, kPi)});
  return shape;
}

recipe::Recipe wheelOf40() {
  recipe::Recipe recipe;
  recipe.wheelRadius = 40;
  return recipe;
}

Job planText(const std::string& dxf, const recipe::Recipe& recipe = wheelOf40()) {
  return planJob(pattern::readDxf(dxf, pattern::importOptions(recipe)), recipe, {});
}

std::vector<Curve> piecesOfShape(const Shape& shape) {
  std::vector<Curve> pieces;
  for (const std::vector<Curve>& ring : shape) {
    pieces.insert(pieces.end(), ring.begin(), ring.end());
  }
  return pieces;
}

std::string asEntities(const Shape& shape) {
  return DxfText().insUnits(4).add(piecesOfShape(shape)).text();
}

std::string asPolylines(const Shape& shape) {
  DxfText dxf;
  dxf.insUnits(4);
  for (const std::vector<Curve>& ring : shape) {
    if (ring.size() > 1) {
      dxf.addPolyline(ring);
    } else { // a full circle as two halves
      const double half = geometry::parameterLength(ring.front()) / 2;
      dxf.addPolyline({geometry::part(ring.front(), 0, half), geometry::part(ring.front(), half, 2 * half)});
    }
  }
  return dxf.text();
}

/// Exactly: a rational quadratic spline, a span for each quarter or less. A full circle has the nine controls of the
/// textbooks.
geometry::Spline asSpline(const Arc& arc) {
  const int spans = static_cast<int>(std::ceil(std::abs(arc.sweep()) / (kPi / 2) - 1e-9));
  const double half = arc.sweep() / spans / 2;
  const Point centre = arc.center();
  const geometry::Vector from = arc.start - centre;
  geometry::Spline spline{2, {0, 0, 0}, {arc.start}, {1}};
  for (int i = 0; i < spans; ++i) {
    spline.points.emplace_back(centre + Eigen::Rotation2Dd((2 * i + 1) * half) * from / std::cos(half));
    spline.points.emplace_back(centre + Eigen::Rotation2Dd((2 * i + 2) * half) * from);
    spline.weights.insert(spline.weights.end(), {std::cos(half), 1});
    spline.knots.insert(spline.knots.end(), {i + 1.0, i + 1.0});
  }
  spline.knots.push_back(spans);
  if (std::abs(arc.sweep()) > 2 * kPi - 1e-9) {
    spline.points.back() = spline.points.front();
  }
  return spline;
}

/// Lines in turn of degree 1 and 2, arcs as rational quadratics.
std::string asSplines(const Shape& shape) {
  DxfText dxf;
  dxf.insUnits(4);
  bool elevated = false;
  for (const Curve& curve : piecesOfShape(shape)) {
    if (const auto* arc = std::get_if<Arc>(&curve)) {
      dxf.add(asSpline(*arc));
      continue;
    }
    const auto& line = std::get<Line>(curve);
    dxf.add(elevated ? test::bezier({line.from, (line.from + line.to) / 2, line.to})
                     : test::bezier({line.from, line.to}));
    elevated = !elevated;
  }
  return dxf.text();
}

/// In a block that is mirrored into another, which is mirrored into the drawing.
std::string asBlockMirroredTwice(const Shape& shape) {
  const DxfText content = DxfText().add(piecesOfShape(shape));
  const DxfText inner = DxfText().insert("SHAPE", {123.5, -47.25}, {-1, 1});
  return DxfText()
      .insUnits(4)
      .block("SHAPE", content)
      .block("MIRRORED", inner)
      .insert("MIRRORED", {123.5, 47.25}, {-1, 1})
      .text();
}

Curve scaled(const Curve& curve, double by) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    return Line{by * line->from, by * line->to};
  }
  const auto& arc = std::get<Arc>(curve);
  return Arc{by * arc.start, arc.tangent, arc.curvature / by, by * arc.length};
}

std::string inInches(const Shape& shape) {
  std::vector<Curve> pieces = piecesOfShape(shape);
  std::transform(pieces.begin(), pieces.end(), pieces.begin(), [](const Curve& c) { return scaled(c, 1 / 25.4); });
  return DxfText().insUnits(1).decimals(12).add(pieces).text();
}

Shape runTheOtherWay(const Shape& shape) {
  Shape result = shape;
  for (std::vector<Curve>& ring : result) {
    std::reverse(ring.begin(), ring.end());
    std::transform(ring.begin(), ring.end(), ring.begin(), [](const Curve& c) { return geometry::reversed(c); });
  }
  return result;
}

std::string inAnotherOrder(const Shape& shape) {
  return DxfText().insUnits(4).add(test::shuffled(piecesOfShape(shape), 7)).text();
}

std::vector<Curve> pathOf(const Job& job, const Eigen::Isometry2d& motion = Eigen::Isometry2d::Identity()) {
  std::vector<Curve> path;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    for (const toolpath::PathSegment& piece : chain.segments) {
      path.push_back(geometry::transformed(piece.shape, motion));
    }
  }
  return path;
}

void expectSamePath(const Job& a, const Job& b, const Eigen::Isometry2d& aToB = Eigen::Isometry2d::Identity()) {
  ASSERT_TRUE(a.canBeGround()) << base::describe(a.problems.front());
  ASSERT_TRUE(b.canBeGround()) << base::describe(b.problems.front());
  const std::vector<Curve> one = pathOf(a, aToB);
  const std::vector<Curve> other = pathOf(b);
  EXPECT_LT(test::farthestApart(one, other), kSamePath);
  EXPECT_LT(test::farthestApart(other, one), kSamePath);
  ASSERT_EQ(a.toolpath.chains.size(), b.toolpath.chains.size());
  for (std::size_t i = 0; i < a.toolpath.chains.size(); ++i) {
    const Point start = aToB * geometry::startPoint(a.toolpath.chains[i].segments.front().shape);
    EXPECT_LT((start - geometry::startPoint(b.toolpath.chains[i].segments.front().shape)).norm(), kSamePath);
  }
}

struct Case {
  const char* name;
  Shape (*shape)();
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class SameShape : public testing::TestWithParam<Case> {
protected:
  /// Planned from lines and arcs, and from `other`: the same path, the same time.
  static void expectSameAs(const std::string& other) {
    const Job plain = planText(asEntities(theShape()));
    const Job job = planText(other);
    expectSamePath(plain, job);
    EXPECT_NEAR(job.duration, plain.duration, kSameTime * plain.duration);
  }

  [[nodiscard]] static Shape theShape() {
    return GetParam().shape();
  }
};

TEST_P(SameShape, AsPolylinesWithBulges) {
  expectSameAs(asPolylines(theShape()));
}

TEST_P(SameShape, AsSplines) {
  expectSameAs(asSplines(theShape()));
}

TEST_P(SameShape, AsABlockMirroredTwice) {
  expectSameAs(asBlockMirroredTwice(theShape()));
}

TEST_P(SameShape, InInches) {
  expectSameAs(inInches(theShape()));
}

TEST_P(SameShape, DrawnTheOtherWayRound) {
  expectSameAs(asEntities(runTheOtherWay(theShape())));
  expectSameAs(asPolylines(runTheOtherWay(theShape())));
}

TEST_P(SameShape, DrawnInAnotherOrder) {
  expectSameAs(inAnotherOrder(theShape()));
}

INSTANTIATE_TEST_SUITE_P(Shapes, SameShape,
                         testing::Values(Case{"Convex", convexShape}, Case{"Concave", concaveShape},
                                         Case{"WithCutOuts", shapeWithCutOuts}),
                         [](const auto& tested) { return tested.param.name; });

// Cut-outs choose their start on the table, so the turned shapes have an outline alone, with its start given.
class TurnedShape : public testing::TestWithParam<std::tuple<Case, double>> {
protected:
  /// Started at the middle of the lower side.
  [[nodiscard]] static Job turnedBy(double degrees, recipe::Recipe recipe) {
    const std::string dxf = asEntities(std::get<0>(GetParam()).shape());
    recipe.rotate = degrees;
    recipe.start = planText(dxf, recipe).placement.motion * Point(250, 0);
    return planText(dxf, recipe);
  }
};

TEST_P(TurnedShape, HasThePathTurned) {
  const Job plain = turnedBy(0, wheelOf40());
  const Job turned = turnedBy(std::get<1>(GetParam()), wheelOf40());
  expectSamePath(plain, turned, turned.placement.motion * plain.placement.motion.inverse());
}

// The paper's rule knows no axes, so neither does the time: as far as the intervals of the plan allow.
TEST_P(TurnedShape, WorksAsLongUnderTheCombinedRule) {
  recipe::Recipe recipe = wheelOf40();
  recipe.accelerationRule = recipe::AccelerationRule::Combined;
  const Job plain = turnedBy(0, recipe);
  const Job turned = turnedBy(std::get<1>(GetParam()), recipe);
  ASSERT_TRUE(plain.canBeGround());
  ASSERT_TRUE(turned.canBeGround());
  EXPECT_NEAR(turned.working / plain.working, 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Angles, TurnedShape,
                         testing::Combine(testing::Values(Case{"Convex", convexShape}, Case{"Concave", concaveShape}),
                                          testing::Values(33.0, 90.0, -117.3)));

} // namespace
} // namespace arris::job
