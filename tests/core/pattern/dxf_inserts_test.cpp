#include "core/base/numbers.h"
#include "core/geometry/arc_fitter.h"
#include "core/pattern/dxf_inserts.h"
#include "core/pattern/dxf_reader.h"
#include "tests/support/contours.h"
#include "tests/support/dxf_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using geometry::Curve;
using geometry::Point;
using test::DxfText;
using testing::Pair;

const std::string kTriangle = test::polylineGroups({{0, 0}, {40, 0}, {0, 30}}, true);

/// The pattern of a drawing with the triangle as block T (base at 10, 0), and with these INSERTs.
Pattern withInserts(std::string_view inserts) {
  return readDxf(DxfText().insUnits(4).addBlock("T", {10, 0}, kTriangle).addGroups(inserts).text(), {});
}

TEST(Insert, PutsTheBaseOfItsBlockWhereItSays) {
  const Pattern pattern = withInserts("0 INSERT\n2 t\n10 500\n20 300\n41 2\n42 2\n50 90");
  ASSERT_EQ(pattern.contours.size(), 1U);
  const geometry::Box box = geometry::bounds(pattern.contours[0].curves);
  EXPECT_LT((box.min() - Point(440, 280)).norm(), 1e-9);
  EXPECT_LT((box.max() - Point(500, 360)).norm(), 1e-9);
  EXPECT_THAT(pattern.entities, testing::ElementsAre(Pair("INSERT", 1), Pair("LWPOLYLINE", 1)));
}

TEST(Insert, RepeatsItsBlockInColumnsAndRows) {
  const Pattern pattern = withInserts("0 INSERT\n2 T\n10 0\n20 0\n41 0.5\n42 0.5\n50 90\n70 3\n71 2\n44 100\n45 200");
  ASSERT_EQ(pattern.contours.size(), 6U);
  geometry::Box box;
  for (const Contour& contour : pattern.contours) {
    EXPECT_NEAR(std::abs(geometry::signedArea(contour.curves)), 150, 1e-9);
    box.extend(geometry::bounds(contour.curves));
  }
  EXPECT_LT((box.min() - Point(-215, -5)).norm(), 1e-9) << "rows run to the left of the turned columns";
  EXPECT_LT((box.max() - Point(0, 215)).norm(), 1e-9);
}

TEST(Insert, SeenFromBelowIsMirrored) {
  const Pattern pattern = withInserts("0 INSERT\n2 T\n10 500\n20 0\n210 0\n220 0\n230 -1");
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_NEAR(geometry::bounds(pattern.contours[0].curves).min().x(), -530, 1e-9);
}

TEST(Insert, KeepsCirclesUnderEvenScalesAndMakesEllipsesOfThemUnderOthers) {
  const auto circles = [](std::string_view insert) {
    return readDxf(
        DxfText().insUnits(4).addBlock("C", {0, 0}, "0 CIRCLE\n8 0\n10 0\n20 0\n40 10").addGroups(insert).text(), {});
  };
  const Pattern even = circles("0 INSERT\n2 C\n10 0\n20 0\n41 -3\n42 3\n50 33");
  ASSERT_EQ(even.contours.size(), 1U);
  EXPECT_EQ(even.contours[0].curves.size(), 1U);
  EXPECT_NEAR(geometry::signedArea(even.contours[0].curves), 900 * kPi, 1e-9);
  const Pattern uneven = circles("0 INSERT\n2 C\n10 0\n20 0\n41 3\n42 1\n50 90");
  ASSERT_EQ(uneven.contours.size(), 1U);
  EXPECT_NEAR(geometry::signedArea(uneven.contours[0].curves), 300 * kPi, 0.1);
  EXPECT_NEAR(geometry::bounds(uneven.contours[0].curves).max().y(), 30, 1e-3);
  EXPECT_TRUE(test::isWellJoined(uneven.contours[0].curves, 1e-10));
}

/// A random INSERT's groups, and the matrix that it stands for, put together from its parts by hand.
struct RandomInsert {
  std::string groups;
  Eigen::Matrix3d matrix;
};

RandomInsert randomInsert(std::mt19937& random, std::string_view block, const Point& base) {
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const double x = uniform(-300, 300);
  const double y = uniform(-300, 300);
  const double sx = (random() % 2 == 0 ? 1 : -1) * uniform(0.5, 2);
  const double sy = random() % 2 == 0 ? sx : uniform(0.5, 2);
  const double angle = uniform(0, 360);
  const int below = random() % 3 == 0 ? -1 : 1;
  const double c = std::cos(base::radians(angle));
  const double s = std::sin(base::radians(angle));
  Eigen::Matrix3d matrix;
  matrix << below * c * sx, -below * s * sy, 0, s * sx, c * sy, 0, 0, 0, 1;
  matrix.col(2) = Eigen::Vector3d(below * x, y, 1) - matrix * Eigen::Vector3d(base.x(), base.y(), 0);
  matrix(2, 2) = 1;
  return {
      fmt::format("0 INSERT\n8 0\n2 {}\n10 {}\n20 {}\n41 {}\n42 {}\n50 {}\n230 {}", block, x, y, sx, sy, angle, below),
      matrix};
}

TEST(Insert, NestedAsItMayBeEqualsTheProductOfTheMatrices) {
  std::mt19937 random(77);
  for (int round = 0; round < 200; ++round) {
    const Point innerBase(3, -4);
    const Point outerBase(-20, 9);
    const RandomInsert inner = randomInsert(random, "Inner", innerBase);
    const RandomInsert outer = randomInsert(random, "Outer", outerBase);
    const std::string text =
        DxfText()
            .insUnits(4)
            .addBlock("Outer", outerBase, inner.groups)
            .addBlock("Inner", innerBase,
                      "0 LINE\n8 0\n10 10\n20 20\n11 80\n21 -5\n0 ARC\n8 0\n10 5\n20 6\n40 9\n50 20\n51 200")
            .addGroups(outer.groups)
            .text();
    const base::Expected<Inventory> inventory = inspectDxf(text, std::nullopt);
    const ReadEntities read = readEntities(selectEntities(*inventory, {}, 1));
    ASSERT_EQ(read.pieces.size(), 2U);
    const auto moved = [&](const Point& p) -> Point {
      return (outer.matrix * inner.matrix * p.homogeneous()).hnormalized();
    };
    EXPECT_LT((geometry::startPoint(read.pieces[0].front()) - moved({10, 20})).norm(), 1e-9) << round;
    EXPECT_LT((geometry::endPoint(read.pieces[0].back()) - moved({80, -5})).norm(), 1e-9) << round;
    for (double degrees = 20; degrees <= 200; degrees += 15) {
      const Point point =
          moved(Point(5, 6) + 9 * Point(std::cos(base::radians(degrees)), std::sin(base::radians(degrees))));
      double nearest = 1;
      for (const Curve& curve : read.pieces[1]) {
        nearest = std::min(nearest, geometry::nearest(curve, point).distance);
      }
      EXPECT_LT(nearest, geometry::kFitTolerance) << round;
    }
  }
}

TEST(Insert, MirroredTwiceIsTheSame) {
  const std::string mirrored =
      DxfText()
          .insUnits(4)
          .addBlock("A", {0, 0}, "0 INSERT\n8 0\n2 T\n10 0\n20 0\n41 -1\n42 1")
          .addBlock("T", {0, 0}, "0 LWPOLYLINE\n90 2\n70 1\n10 0\n20 0\n42 0.5\n10 70\n20 9\n42 0.2")
          .addGroups("0 INSERT\n2 A\n10 0\n20 0\n230 -1")
          .text();
  const std::string plain =
      DxfText().insUnits(4).addGroups("0 LWPOLYLINE\n90 2\n70 1\n10 0\n20 0\n42 0.5\n10 70\n20 9\n42 0.2").text();
  const Pattern a = readDxf(mirrored, {});
  const Pattern b = readDxf(plain, {});
  ASSERT_EQ(a.contours.size(), 1U);
  EXPECT_TRUE(test::areSame(a.contours[0].curves, b.contours[0].curves, 1e-9));
}

TEST(Insert, IgnoresItsAttributes) {
  const Pattern pattern = withInserts(
      "0 INSERT\n66 1\n2 T\n10 0\n20 0\n0 ATTRIB\n10 0\n20 0\n1 twelve\n0 SEQEND\n8 0\n0 CIRCLE\n10 200\n20 0\n40 1");
  EXPECT_EQ(pattern.contours.size(), 2U);
  EXPECT_EQ(test::problemsOf(pattern, Code::EntitiesPassedOver).size(), 1U);
}

/// The only problem of a drawing that is about its blocks.
base::Problem refusalOf(const DxfText& drawing, Code code) {
  const std::vector<base::Problem> found = test::problemsOf(readDxf(drawing.text(), {}), code);
  EXPECT_EQ(found.size(), 1U) << base::info(code).name;
  return found.empty() ? base::Problem() : found.front();
}

TEST(Insert, OfAnUnknownBlockIsRefusedWithItsLine) {
  DxfText drawing;
  drawing.addGroups("0 INSERT\n8 BAD\n2 Nobody\n10 0\n20 0");
  const base::Problem problem = refusalOf(drawing, Code::BlockUnknown);
  EXPECT_EQ(problem.line, test::lineOf(drawing.text(), "INSERT"));
  EXPECT_EQ(base::describe(problem),
            "1 × INSERT of block \"Nobody\", which the file does not have; explode it before saving.");
}

TEST(Insert, OfABlockThatInsertsItselfIsRefusedWithTheLineThatDoes) {
  DxfText drawing;
  drawing.addBlock("A", {0, 0}, "0 INSERT\n8 0\n2 B\n10 0\n20 0")
      .addBlock("B", {0, 0}, "0 INSERT\n8 BAD\n2 a\n10 0\n20 0")
      .addGroups("0 INSERT\n2 A\n10 0\n20 0\n0 INSERT\n2 A\n10 0\n20 0");
  EXPECT_EQ(refusalOf(drawing, Code::BlockInsertsItself).line, test::lineOf(drawing.text(), "INSERT\n8\nBAD"));
}

TEST(Insert, OfBlocksThatWouldFillTheMemoryIsRefusedAtOnce) {
  DxfText drawing;
  drawing.addBlock("X0", {0, 0}, kTriangle);
  for (int i = 1; i < 20; ++i) {
    drawing.addBlock(fmt::format("X{}", i), {0, 0},
                     fmt::format("0 INSERT\n2 X{}\n10 0\n20 0\n70 30000\n71 30000\n44 1\n45 1", i - 1));
  }
  drawing.addGroups("0 INSERT\n8 BAD\n2 X19\n10 0\n20 0\n0 CIRCLE\n10 0\n20 0\n40 1");
  EXPECT_EQ(refusalOf(drawing, Code::InsertsTooMany).line, test::lineOf(drawing.text(), "INSERT\n8\nBAD"));
}

TEST(Insert, OfAnEmptyBlockInAHugeArrayIsRefusedToo) {
  DxfText drawing;
  drawing.addBlock("E", {0, 0}, "").addGroups("0 INSERT\n2 E\n10 0\n20 0\n70 30000\n71 30000");
  refusalOf(drawing, Code::InsertsTooMany);
}

TEST(Insert, NestedTooDeepIsRefused) {
  DxfText drawing;
  drawing.addBlock("X0", {0, 0}, kTriangle);
  for (int i = 1; i < 5000; ++i) {
    drawing.addBlock(fmt::format("X{}", i), {0, 0}, fmt::format("0 INSERT\n2 X{}\n10 0\n20 0", i - 1));
  }
  drawing.addGroups("0 INSERT\n2 X4999\n10 0\n20 0");
  refusalOf(drawing, Code::BlockInsertsItself);
}

TEST(Insert, ThatThrowsItsBlockFarAwayIsRefusedWithItsLine) {
  for (const char* groups : {"41 1e9\n42 1e9", "41 1e300\n42 1e300", "41 1\n42 1e12"}) {
    DxfText drawing;
    drawing
        .addBlock("A", {0, 0},
                  "0 SPLINE\n71 1\n40 0\n40 0\n40 1\n40 1\n10 9\n20 9\n10 5\n20 5\n0 CIRCLE\n10 1\n20 1\n40 1")
        .addGroups(std::string("0 INSERT\n8 BAD\n2 A\n10 0\n20 0\n") + groups);
    EXPECT_EQ(refusalOf(drawing, Code::PlaceAbsurd).line, test::lineOf(drawing.text(), "INSERT\n8\nBAD")) << groups;
  }
}

TEST(Block, ThatIsWrongMattersOnlyWhereItIsInserted) {
  DxfText drawing;
  drawing.addBlock("Bad", {0, 0}, "0 CIRCLE\n10 1\n20 2\n40 0.00").addGroups("0 CIRCLE\n10 0\n20 0\n40 5");
  EXPECT_FALSE(base::hasErrors(readDxf(drawing.text(), {}).problems));
  drawing.addGroups("0 INSERT\n2 Bad\n10 0\n20 0\n0 INSERT\n2 Bad\n10 0\n20 0");
  EXPECT_EQ(refusalOf(drawing, Code::DxfEntityValue).line, test::lineOf(drawing.text(), "0.00"));
}

TEST(Block, DefinedTwiceMattersOnlyWhereItIsInserted) {
  DxfText drawing;
  drawing.addBlock("A", {0, 0}, kTriangle).addBlock("a", {0, 0}, "").addGroups("0 CIRCLE\n10 0\n20 0\n40 5");
  EXPECT_FALSE(base::hasErrors(readDxf(drawing.text(), {}).problems));
  drawing.addGroups("0 INSERT\n2 A\n10 0\n20 0");
  refusalOf(drawing, Code::BlockTwice);
}

DxfText layered() {
  return DxfText()
      .insUnits(4)
      .layer("Cut", 7, 0)
      .layer("Off", -7, 0)
      .layer("Cold", 7, 1)
      .addBlock("B", {0, 0},
                "0 CIRCLE\n8 0\n10 0\n20 0\n40 10\n0 CIRCLE\n8 Cut\n10 100\n20 0\n40 10\n0 CIRCLE\n8 Off\n10 200\n20 "
                "0\n40 10");
}

ImportOptions onlyLayers(std::vector<std::string> layers) {
  ImportOptions options;
  options.layers = std::move(layers);
  return options;
}

std::size_t contoursOn(const std::string& layer, std::vector<std::string> only = {}) {
  const std::string text = layered().addGroups("0 INSERT\n8 " + layer + "\n2 B\n10 0\n20 0").text();
  return readDxf(text, onlyLayers(std::move(only))).contours.size();
}

TEST(Layers, OfABlockAreItsOwnAndThatOfTheInsertForWhatIsOnLayer0) {
  EXPECT_EQ(contoursOn("Plan"), 2U) << "all but what is on Off";
  EXPECT_EQ(contoursOn("Off"), 1U) << "what is on layer 0 is hidden with the INSERT";
  EXPECT_EQ(contoursOn("Cold"), 0U) << "a frozen INSERT draws nothing";
  const std::string text = layered().addGroups("0 INSERT\n8 Plan\n2 B\n10 0\n20 0").text();
  const Pattern pattern = readDxf(text, {});
  EXPECT_EQ(pattern.layers.at("Plan"), (EntityCounts{{"CIRCLE", 1}, {"INSERT", 1}}));
  EXPECT_EQ(pattern.layers.at("Cut"), (EntityCounts{{"CIRCLE", 1}}));
}

TEST(Layers, ThatAreChosenAloneAreRead) {
  EXPECT_EQ(contoursOn("Plan", {"plan"}), 1U) << "in any case of letters";
  EXPECT_EQ(contoursOn("Plan", {"PLAN", "cut"}), 2U);
  EXPECT_EQ(contoursOn("Plan", {"Elsewhere"}), 0U);
  const std::string text = layered().addGroups("0 INSERT\n8 Plan\n2 B\n10 0\n20 0").text();
  const Pattern pattern = readDxf(text, onlyLayers({"Plan"}));
  std::vector<std::string> notes;
  for (const base::Problem& note : test::problemsOf(pattern, Code::EntitiesPassedOver)) {
    notes.push_back(base::describe(note));
  }
  EXPECT_THAT(notes, testing::UnorderedElementsAre("1 × CIRCLE passed over: layer \"Cut\" is not chosen.",
                                                   "1 × CIRCLE passed over: layer \"Off\" is off."));
}

} // namespace
} // namespace arris::pattern
