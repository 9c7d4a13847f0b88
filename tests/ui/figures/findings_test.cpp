#include "ui/figures/finding_rows.h"
#include "ui/figures/place_signs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace arris::ui {
namespace {

using base::Code;
using base::Problem;

Drawing scattered(int findings) {
  Drawing drawing;
  for (int i = 0; i < findings; ++i) { // a spiral of Fermat: evenly over a disc
    const double radius = 500 * std::sqrt((i + 0.5) / findings);
    const geometry::Point place(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i));
    Problem problem(i % 7 == 0 ? Code::OpenChain : i % 3 == 0 ? Code::ConcaveFillet : Code::GapClosed);
    (i % 2 == 0 ? drawing.problems : drawing.repairs).push_back(std::move(problem).at(place));
  }
  return drawing;
}

const QRectF kFrame(-1000, -1000, 2000, 2000);

TEST(PlaceSigns, StandForEveryFindingInTheFrameAndForNoneTwice) {
  for (const int findings : {0, 1, 5, 40, 300, 3000}) {
    int count = 0;
    for (const PlaceSign& sign : placeSigns(scattered(findings), {}, kFrame, {})) {
      count += sign.count;
    }
    EXPECT_EQ(count, findings);
  }
  EXPECT_TRUE(placeSigns(scattered(10), {}, QRectF(2000, 2000, 10, 10), {}).empty());
}

TEST(PlaceSigns, AreNeverSoManyThatTheyHideTheDrawing) {
  for (const int findings : {40, 300, 3000}) {
    EXPECT_LE(placeSigns(scattered(findings), {}, kFrame, {}).size(), 50U);
  }
}

TEST(PlaceSigns, DoNotCoverEachOther) {
  const std::vector<PlaceSign> signs = placeSigns(scattered(300), {}, kFrame, {});
  for (std::size_t a = 0; a < signs.size(); ++a) {
    for (std::size_t b = a + 1; b < signs.size(); ++b) {
      const QPointF way = signs[a].place - signs[b].place;
      EXPECT_GE(std::hypot(way.x(), way.y()), 54);
    }
  }
}

TEST(PlaceSigns, ShowTheWorstOfWhatTheyStandFor) {
  Drawing drawing;
  drawing.problems = {Problem(Code::ConcaveFillet).at({0, 0}), Problem(Code::OpenChain).at({3, 0})};
  drawing.repairs = {Problem(Code::GapClosed).at({1, 0})};
  const std::vector<PlaceSign> signs = placeSigns(drawing, {}, kFrame, {});
  ASSERT_EQ(signs.size(), 1U);
  EXPECT_EQ(signs[0].worst, base::Severity::Error);
  EXPECT_EQ(signs[0].count, 3);
}

TEST(FindingRows, HaveOneForEachCodeErrorsFirst) {
  Drawing drawing;
  drawing.problems = {Problem(Code::UnitsAssumed), Problem(Code::ContourDegenerate).at({1, 2}),
                      Problem(Code::ContourDegenerate).at({3, 4}),
                      Problem(Code::MoreNotListed, {{"count", std::int64_t{30}}, {"code", "contour-degenerate"}})};
  drawing.repairs = {Problem(Code::GapClosed, {{"size_mm", 0.02}}).at({5, 6}).onLine(7)};
  const std::vector<FindingRow> rows = findingRows(drawing, QLocale::c());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].severity, base::Severity::Error);
  EXPECT_EQ(QString(rows[0].words).replace(QChar::Nbsp, ' ').toStdString(),
            "The contour encloses no area. (at X 1.0, Y 2.0 mm) And 31 more like it.");
  EXPECT_EQ(rows[1].words.toStdString(), "The file does not say its unit; millimetres are assumed.");
  EXPECT_EQ(QString(rows[2].words).replace(QChar::Nbsp, ' ').toStdString(),
            "A gap of 0.02 mm was closed. (line 7 of the file, at X 5.0, Y 6.0 mm)");
}

} // namespace
} // namespace arris::ui
