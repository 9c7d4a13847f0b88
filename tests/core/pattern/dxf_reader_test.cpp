#include "core/base/numbers.h"
#include "core/pattern/pattern.h"
#include "tests/support/contours.h"
#include "tests/support/dxf_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <locale>

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using test::DxfText;
using test::lineOf;

Pattern readGroups(std::string_view groups) {
  return readDxf(DxfText().insUnits(4).addGroups(groups).text(), {});
}

Arc onlyArc(const Pattern& pattern) {
  EXPECT_EQ(pattern.loose.size(), 1U);
  return std::get<Arc>(pattern.loose.at(0));
}

/// Whether the curve runs between the points in either direction.
testing::AssertionResult joins(const Curve& curve, const Point& a, const Point& b) {
  const Point start = geometry::startPoint(curve);
  const Point end = geometry::endPoint(curve);
  const double off = std::min((start - a).norm() + (end - b).norm(), (start - b).norm() + (end - a).norm());
  return off < 1e-9 ? testing::AssertionSuccess()
                    : testing::AssertionFailure() << "from " << start.transpose() << " to " << end.transpose();
}

TEST(Reader, TakesALineFromItsStartToItsEnd) {
  const Pattern pattern = readGroups("0 LINE\n8 0\n10 1.5\n20 -2.25\n30 7\n11 1e2\n21 .5\n31 7");
  ASSERT_EQ(pattern.loose.size(), 1U);
  EXPECT_TRUE(joins(pattern.loose[0], {1.5, -2.25}, {100, 0.5}));
}

TEST(Reader, TakesAnArcCounterClockwiseAcrossZeroDegrees) {
  const Arc arc = onlyArc(readGroups("0 ARC\n8 0\n10 10\n20 20\n40 5\n50 300\n51 30"));
  EXPECT_NEAR(std::abs(arc.sweep()), kPi / 2, 1e-12);
  EXPECT_NEAR(arc.radius(), 5, 1e-12);
  EXPECT_TRUE(joins(arc, {12.5, 20 - 5 * std::sqrt(0.75)}, {10 + 5 * std::sqrt(0.75), 22.5}));
  EXPECT_LT((geometry::pointAt(arc, arc.length / 2) - Point(10 + 5 * std::cos(-kPi / 12), 20 + 5 * std::sin(-kPi / 12)))
                .norm(),
            1e-12);
}

TEST(Reader, TakesAnArcOfEqualAnglesForTheWholeCircle) {
  const Pattern pattern = readGroups("0 ARC\n8 0\n10 0\n20 0\n40 5\n50 45\n51 45");
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_NEAR(geometry::signedArea(pattern.contours[0].curves), 25 * kPi, 1e-9);
}

TEST(Reader, TakesACircleAsAContourOfItsOwn) {
  const Pattern pattern = readGroups("0 CIRCLE\n8 0\n10 10\n20 20\n40 5");
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  EXPECT_NEAR(geometry::totalLength(pattern.contours[0].curves), 10 * kPi, 1e-12);
  EXPECT_LT((geometry::startPoint(pattern.contours[0].curves[0]) - Point(10, 15)).norm(), 1e-12);
}

// A bulge is the tangent of a quarter of the angle swept, positive counter-clockwise: 1 is half a circle.
TEST(Reader, TakesBulgesOfALightweightPolyline) {
  const Pattern pattern =
      readGroups("0 LWPOLYLINE\n8 0\n90 4\n70 1\n43 0.0\n10 0\n20 0\n10 100\n20 0\n42 1\n10 100\n20 50\n10 0\n20 50\n"
                 "42 -0.41421356237309503");
  ASSERT_EQ(pattern.contours.size(), 1U);
  const std::vector<Curve>& curves = pattern.contours[0].curves;
  ASSERT_EQ(curves.size(), 4U);
  const double radius = 25 * std::sqrt(2); // a quarter circle over the chord of 50, bent into the pane
  EXPECT_NEAR(geometry::signedArea(curves), 5000 + 625 * kPi / 2 - (kPi / 4 - 0.5) * radius * radius, 1e-9);
  EXPECT_NEAR(geometry::bounds(curves).max().x(), 125, 1e-12);
}

TEST(Reader, TakesABulgeAboveOneForMoreThanHalfACircle) {
  const Pattern pattern = readGroups("0 LWPOLYLINE\n8 0\n90 2\n70 1\n10 0\n20 0\n42 3.05\n10 10\n20 0");
  ASSERT_EQ(pattern.contours.size(), 1U);
  const double sweep = 4 * std::atan(3.05);
  const double radius = 5 / std::sin(sweep / 2);
  EXPECT_NEAR(geometry::signedArea(pattern.contours[0].curves), radius * radius / 2 * (sweep - std::sin(sweep)), 1e-9);
}

TEST(Reader, TakesAnOldPolylineWithItsVertices) {
  const Pattern pattern =
      readGroups("0 POLYLINE\n8 0\n66 1\n70 1\n10 0\n20 0\n30 0\n0 VERTEX\n8 0\n10 0\n20 0\n42 0.0\n"
                 "0 VERTEX\n8 0\n10 60\n20 0\n42 1.0\n0 VERTEX\n8 0\n10 60\n20 40\n0 VERTEX\n8 0\n"
                 "10 0\n20 40\n0 SEQEND\n8 0");
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_NEAR(geometry::signedArea(pattern.contours[0].curves), 2400 + 200 * kPi, 1e-9);
  EXPECT_THAT(pattern.entities, testing::ElementsAre(testing::Pair("POLYLINE", 1)));
}

TEST(Reader, KeepsSeveralPolylinesApart) {
  const Pattern pattern = readGroups("0 LWPOLYLINE\n8 0\n90 3\n70 0\n10 0\n20 0\n10 5\n20 0\n10 5\n20 5\n"
                                     "0 LINE\n10 50\n20 50\n11 60\n21 60\n"
                                     "0 LWPOLYLINE\n8 0\n90 2\n70 0\n10 20\n20 0\n42 0.5\n10 25\n20 0");
  ASSERT_EQ(pattern.loose.size(), 4U);
  EXPECT_TRUE(pattern.contours.empty());
}

struct UnitCase {
  std::string name;
  std::optional<int> insUnits;
  std::optional<int> measurement;
  std::optional<recipe::Units> option;
  recipe::Units units;
  UnitsFrom from;
  double millimetres;
};

class UnitsOf : public testing::TestWithParam<UnitCase> {};

INSTANTIATE_TEST_SUITE_P(
    Drawing, UnitsOf,
    testing::Values(
        UnitCase{"inch", 1, 1, {}, recipe::Units::Inch, UnitsFrom::InsUnits, 25.4},
        UnitCase{"foot", 2, {}, {}, recipe::Units::Foot, UnitsFrom::InsUnits, 304.8},
        UnitCase{"millimetre", 4, 0, {}, recipe::Units::Millimetre, UnitsFrom::InsUnits, 1},
        UnitCase{"centimetre", 5, {}, {}, recipe::Units::Centimetre, UnitsFrom::InsUnits, 10},
        UnitCase{"metre", 6, {}, {}, recipe::Units::Metre, UnitsFrom::InsUnits, 1000},
        UnitCase{"unitlessAndImperial", 0, 0, {}, recipe::Units::Inch, UnitsFrom::Measurement, 25.4},
        UnitCase{"metric", {}, 1, {}, recipe::Units::Millimetre, UnitsFrom::Measurement, 1},
        UnitCase{"nothing", {}, {}, {}, recipe::Units::Millimetre, UnitsFrom::Assumed, 1},
        UnitCase{"option", 1, 0, recipe::Units::Centimetre, recipe::Units::Centimetre, UnitsFrom::Option, 10},
        UnitCase{"optionOverUnknown", 3, {}, recipe::Units::Metre, recipe::Units::Metre, UnitsFrom::Option, 1000}),
    [](const testing::TestParamInfo<UnitCase>& test) { return test.param.name; });

TEST_P(UnitsOf, AreTakenFromOptionThenInsunitsThenMeasurement) {
  DxfText drawing;
  if (GetParam().insUnits) {
    drawing.insUnits(*GetParam().insUnits);
  }
  if (GetParam().measurement) {
    drawing.measurement(*GetParam().measurement);
  }
  ImportOptions options;
  options.units = GetParam().option;
  const Pattern pattern = readDxf(drawing.add(Line{{0, 0}, {10, 0}}).text(), options);
  EXPECT_EQ(pattern.units, GetParam().units);
  EXPECT_EQ(pattern.unitsFrom, GetParam().from);
  ASSERT_EQ(pattern.loose.size(), 1U);
  EXPECT_NEAR(geometry::arcLength(pattern.loose[0]), 10 * GetParam().millimetres, 1e-9);
  EXPECT_EQ(test::problemsOf(pattern, Code::UnitsAssumed).size(), GetParam().from == UnitsFrom::Assumed ? 1U : 0U);
}

TEST(Units, ThatArrisDoesNotKnowAreAnError) {
  const Pattern pattern = readDxf(DxfText().insUnits(3).add(Line{{0, 0}, {10, 0}}).text(), {});
  ASSERT_EQ(test::problemsOf(pattern, Code::UnitsUnknown).size(), 1U);
  EXPECT_TRUE(base::hasErrors(pattern.problems));
}

TEST(Selection, CountsWhatItPassesOver) {
  const std::string text = DxfText()
                               .insUnits(4)
                               .layer("Hidden", -7, 0)
                               .layer("Cold", 7, 1)
                               .add(geometry::arcAbout({0, 0}, 10, 0, 2 * kPi))
                               .addGroups("0 TEXT\n8 Notes\n1 first\n0 TEXT\n8 Notes\n1 second")
                               .add(Line{{0, 0}, {1, 0}}, "DefPoints")
                               .add(Line{{0, 0}, {1, 0}}, "HIDDEN")
                               .add(Line{{0, 0}, {1, 0}}, "Cold")
                               .addGroups("0 LINE\n8 0\n60 1\n10 0\n20 0\n11 1\n21 1")
                               .addGroups("0 LINE\n8 0\n67 1\n10 0\n20 0\n11 1\n21 1")
                               .addGroups("0 VIEWPORT\n8 0\n67 1")
                               .text();
  const Pattern pattern = readDxf(text, {});
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  ASSERT_EQ(pattern.contours.size(), 1U) << "only the circle is left";
  EXPECT_TRUE(pattern.loose.empty());
  std::vector<std::string> notes;
  for (const base::Problem& note : test::problemsOf(pattern, Code::EntitiesPassedOver)) {
    notes.push_back(base::describe(note));
  }
  EXPECT_THAT(notes, testing::UnorderedElementsAre("2 × TEXT passed over: no part of a contour.",
                                                   "1 × LINE passed over: on layer \"DefPoints\", which is never "
                                                   "plotted.",
                                                   "1 × LINE passed over: layer \"HIDDEN\" is off.",
                                                   "1 × LINE passed over: layer \"Cold\" is frozen.",
                                                   "1 × LINE passed over: invisible.",
                                                   "1 × LINE passed over: in paper space."));
  EXPECT_THAT(pattern.entities, testing::UnorderedElementsAre(testing::Pair("CIRCLE", 1), testing::Pair("LINE", 4),
                                                              testing::Pair("TEXT", 2)));
  EXPECT_EQ(pattern.layers.at("Notes").at("TEXT"), 2);
  EXPECT_EQ(test::problemsOf(pattern, Code::EntitiesPassedOver).front().line.has_value(), true);
}

TEST(Selection, TakesNothingFromBlocks) {
  const std::string entities = DxfText().insUnits(4).add(geometry::arcAbout({0, 0}, 10, 0, 2 * kPi)).text();
  const std::string block =
      test::asGroups("0 SECTION\n2 BLOCKS\n0 BLOCK\n2 B\n0 LINE\n10 0\n20 0\n11 5\n21 5\n0 ENDBLK\n0 ENDSEC");
  const Pattern pattern = readDxf(block + entities, {});
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  EXPECT_THAT(pattern.entities, testing::ElementsAre(testing::Pair("CIRCLE", 1)));
}

struct Unread {
  std::string groups;
  Code code;
  std::string named;
};

class NotReadYet : public testing::TestWithParam<Unread> {};

INSTANTIATE_TEST_SUITE_P(
    Entity, NotReadYet,
    testing::Values(
        Unread{"0 WHATEVER\n8 X", Code::EntityNotSupported, "WHATEVER"},
        Unread{"0 CIRCLE\n8 X\n10 0\n20 0\n40 5\n210 0.02\n220 0.32\n230 0.95", Code::EntityNotPlanar, "CIRCLE"},
        Unread{"0 LINE\n8 X\n10 0\n20 0\n30 0\n11 5\n21 0\n31 0.5", Code::EntityNotPlanar, "LINE"},
        Unread{"0 LINE\n8 X\n10 0\n20 0\n11 5\n21 0\n31 0.5", Code::EntityNotPlanar, "LINE"},
        Unread{"0 POLYLINE\n8 X\n66 1\n70 8\n0 VERTEX\n10 0\n20 0\n30 0\n0 VERTEX\n10 5\n20 0\n30 2\n0 SEQEND",
               Code::EntityNotPlanar, "POLYLINE"},
        Unread{"0 POLYLINE\n8 X\n66 1\n70 64\n0 VERTEX\n10 0\n20 0\n30 0\n70 192\n0 VERTEX\n70 128\n71 1\n0 SEQEND",
               Code::EntityNotSupported, "POLYLINE as a mesh"}),
    [](const testing::TestParamInfo<Unread>& test) { return "Case" + std::to_string(test.index); });

TEST_P(NotReadYet, IsNamedWithItsLineAndNeverDropped) {
  const std::string text = DxfText()
                               .insUnits(4)
                               .add(geometry::arcAbout({0, 0}, 10, 0, 2 * kPi))
                               .addGroups(GetParam().groups)
                               .addGroups(GetParam().groups)
                               .text();
  const Pattern pattern = readDxf(text, {});
  EXPECT_TRUE(base::hasErrors(pattern.problems));
  const std::vector<base::Problem> found = test::problemsOf(pattern, GetParam().code);
  ASSERT_EQ(found.size(), 1U) << "one problem for the kind, with its count";
  EXPECT_EQ(found[0].values.at(0), (base::Value{"entity", GetParam().named}));
  EXPECT_EQ(found[0].values.at(1), (base::Value{"count", std::int64_t{2}}));
  EXPECT_EQ(found[0].line, lineOf(text, "8\nX") - 1);
  EXPECT_EQ(pattern.contours.size(), 1U) << "the rest can be previewed";
}

TEST(NotReadYet, HidesTheGapsThatItLeaves) {
  const Pattern pattern = readGroups("0 MLINE\n8 X\n0 LINE\n10 0\n20 0\n11 5\n21 0");
  EXPECT_TRUE(test::problemsOf(pattern, Code::OpenChain).empty());
  EXPECT_TRUE(test::problemsOf(pattern, Code::NoContour).empty());
  EXPECT_EQ(pattern.loose.size(), 1U);
}

TEST(Reader, TakesALineWhateverItsExtrusionSays) {
  const Pattern pattern = readGroups("0 LINE\n10 1\n20 2\n11 3\n21 4\n210 0\n220 0\n230 -1");
  EXPECT_TRUE(test::problemsOf(pattern, Code::EntityNotSupported).empty());
  ASSERT_EQ(pattern.loose.size(), 1U);
  EXPECT_TRUE(joins(pattern.loose[0], {1, 2}, {3, 4}));
}

TEST(Reader, RefusesABulgeWhoseArcIsAbsurd) {
  const Pattern pattern = readGroups("0 LWPOLYLINE\n8 0\n90 2\n10 0\n20 0\n42 1e12\n10 10\n20 0");
  ASSERT_EQ(test::problemsOf(pattern, Code::DxfEntityValue).size(), 1U);
}

TEST(Reader, TakesAnArcOfRadiusZeroForAPieceWithoutLength) {
  const Pattern pattern = readGroups("0 ARC\n10 30\n20 19\n40 0.0\n50 0\n51 0\n0 CIRCLE\n10 0\n20 0\n40 9");
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  ASSERT_EQ(pattern.repairs.size(), 1U);
  EXPECT_EQ(pattern.repairs[0].code, Code::ZeroLengthRemoved);
  EXPECT_EQ(pattern.repairs[0].where, Point(30, 19));
}

/// Sets both the C and the C++ locale while it lives.
class UnderLocale {
public:
  explicit UnderLocale(const char* name)
      : m_c(std::setlocale(LC_ALL, nullptr)), m_cpp(std::locale::global(std::locale(name))) {
    std::setlocale(LC_ALL, name);
  }

  ~UnderLocale() {
    std::locale::global(m_cpp);
    std::setlocale(LC_ALL, m_c.c_str());
  }

  UnderLocale(const UnderLocale&) = delete;
  UnderLocale& operator=(const UnderLocale&) = delete;
  UnderLocale(UnderLocale&&) = delete;
  UnderLocale& operator=(UnderLocale&&) = delete;

private:
  std::string m_c;
  std::locale m_cpp;
};

TEST(Reader, ReadsTheSameInEveryLocale) {
  const std::string text =
      DxfText()
          .insUnits(4)
          .addGroups("0 LWPOLYLINE\n90 3\n70 1\n10 1234567.890625\n20 -0.0009765625\n42 0.125\n10 1234667.5\n20 1.5e1\n"
                     "10 +1234600.25\n20 100.")
          .text();
  const Pattern expected = readDxf(text, {});
  ASSERT_EQ(expected.contours.size(), 1U);
  const geometry::Box box = geometry::bounds(expected.contours[0].curves);
  EXPECT_EQ(box.max().x(), 1234667.5);
  for (const char* name : {"de_DE.UTF-8", "it_IT.UTF-8", "zh_CN.UTF-8", "fr_FR.UTF-8"}) {
    const UnderLocale locale(name);
    ASSERT_EQ(std::string(std::localeconv()->decimal_point) == ",", std::string(name) != "zh_CN.UTF-8");
    const Pattern found = readDxf(text, {});
    ASSERT_EQ(found.contours.size(), 1U) << name;
    for (std::size_t i = 0; i < expected.contours[0].curves.size(); ++i) {
      EXPECT_EQ(geometry::startPoint(found.contours[0].curves[i]), geometry::startPoint(expected.contours[0].curves[i]))
          << name;
    }
    EXPECT_EQ(geometry::signedArea(found.contours[0].curves), geometry::signedArea(expected.contours[0].curves));
  }
}

} // namespace
} // namespace arris::pattern
