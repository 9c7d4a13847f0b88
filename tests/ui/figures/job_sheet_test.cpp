#include "core/base/numbers.h"
#include "tests/support/panes.h"
#include "tests/support/scratch.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "ui/figures/job_sheet.h"
#include "ui/figures/sheet.h"
#include "ui/text/quantities.h"

#include <QProcess>
#include <QRegularExpression>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace arris::ui {
namespace {

SheetRow rowOfHeight(double height) {
  return {height, [](QPainter&, const QRectF&) {}};
}

TEST(Paginated, PutsEveryRowOnAPageAndNoneBelowIt) {
  SheetPart first{"first", rowOfHeight(30), {}};
  SheetPart second{"second", {}, {}};
  for (int i = 0; i < 100; ++i) {
    first.rows.push_back(rowOfHeight(10 + i % 7));
    second.rows.push_back(rowOfHeight(17));
  }
  int continued = 0;
  const auto pages = paginated({first, second}, 300, [&](const QString&, bool again) {
    continued += again ? 1 : 0;
    return rowOfHeight(40);
  });
  std::size_t rows = 0;
  for (const auto& page : pages) {
    double below = 0;
    for (const PlacedRow& placed : page) {
      EXPECT_GE(placed.top, below);
      below = placed.top + placed.row.height;
      rows += placed.row.height < 30 ? 1 : 0;
    }
    EXPECT_LE(below, 300);
    EXPECT_EQ(page.front().row.height, 40); // a page begins with a title, as new or as continued
  }
  EXPECT_EQ(rows, 200U);
  EXPECT_GT(continued, 0);
}

TEST(Paginated, LeavesNoTitleAloneAtTheFootOfAPage) {
  const std::vector<SheetPart> parts{{"first", {}, {rowOfHeight(200)}}, {"second", {}, {rowOfHeight(30)}}};
  const auto pages = paginated(parts, 300, [](const QString&, bool) { return rowOfHeight(40); });
  ASSERT_EQ(pages.size(), 2U); // 40 + 200, a gap, 40: the row would not have followed
  EXPECT_EQ(pages[0].size(), 2U);
  EXPECT_EQ(pages[1].size(), 2U);
}

// A star with a wheel that goes into its notches.
pattern::Pattern star(int tips) {
  std::vector<geometry::Point> corners;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = base::kPi * i / tips;
    const double radius = i % 2 == 0 ? 600 : 560;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return test::polygon(corners);
}

QString textOf(const std::vector<Figure>& pages) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "sheet.pdf";
  const QByteArray pdf = encodedPdf(pages);
  std::ofstream(file, std::ios::binary).write(pdf.constData(), pdf.size());
  QProcess process;
  process.start(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), QString::fromStdString(file.string()), "-"});
  EXPECT_TRUE(process.waitForFinished(60000));
  return QString::fromUtf8(process.readAllStandardOutput());
}

std::vector<Figure> sheetOf(const pattern::Pattern& pattern, const recipe::Recipe& recipe, const QLocale& locale) {
  const job::Job job = job::planJob(pattern, recipe, recipe::Machine{});
  return jobSheet(job, drawingOf(job, pattern), QStringLiteral("pane.dxf"), QStringLiteral("11/25/26 10:00"), locale);
}

TEST(JobSheet, HoldsEverythingThatGoesWithAJob) {
  const std::vector<Figure> pages = sheetOf(test::triangle600(), {}, test::kEnglish);
  const QString text = textOf(pages);
  for (const char* words :
       {"Job sheet: pane.dxf", "11/25/26 10:00", "Wheel radius", "75 mm", "3600 mm/min", "Travel", "X 1500, Y 2500",
        "transition", "20.00", "12.990", "+18.49", "Lead-in", "Whole program", "Problems", "Page 1 of"}) {
    EXPECT_TRUE(text.contains(words)) << words << "\n" << text.toStdString();
  }
  for (std::size_t i = 0; i < pages.size(); ++i) {
    test::keep("job-sheet-" + std::to_string(i + 1), pages[i]);
  }
  test::keep("job-sheet.pdf", encodedPdf(pages));
}

TEST(JobSheet, GoesOnOverAsManyPagesAsHundredsOfCornersTake) {
  recipe::Recipe fine;
  fine.wheelRadius = 0.5;
  const std::vector<Figure> pages = sheetOf(star(200), fine, test::kEnglish);
  EXPECT_GT(pages.size(), 7U);
  const QString text = textOf(pages);
  for (std::size_t i = 1; i <= pages.size(); ++i) {
    EXPECT_TRUE(text.contains(QStringLiteral("Page %1 of %2").arg(i).arg(pages.size()))) << i;
  }
  for (int corner = 1; corner <= 400; ++corner) {
    const QRegularExpression row(QStringLiteral("\\n\\s*%1\\s+1\\s+[\\d.]+°\\s+(sharp|blunt|concave)").arg(corner));
    EXPECT_TRUE(row.match(text).hasMatch()) << corner;
  }
  test::keep("job-sheet-star", pages.back());
  test::keep("job-sheet-star-first", pages.front());
}

TEST(JobSheet, HasTheOperatorsNumbersAndMillimetresWhateverTheWindowShows) {
  showLengthsIn(LengthUnit::Inch);
  const QString text = textOf(sheetOf(test::triangle600(), {}, test::kGerman));
  showLengthsIn(LengthUnit::Millimetre);
  EXPECT_TRUE(text.contains("0,13 mm")) << text.toStdString();
  EXPECT_TRUE(text.contains("+18,49"));
  EXPECT_FALSE(text.contains(QRegularExpression(" in\\b")));
}

TEST(JobSheet, TellsProblemsOfAPaneThatCannotBeGround) {
  recipe::Recipe away;
  away.place = Eigen::Vector2d(-500, 0);
  const std::vector<Figure> pages = sheetOf(test::triangle600(), away, test::kEnglish);
  const QString text = textOf(pages);
  EXPECT_TRUE(text.contains("cannot be ground")) << text.toStdString();
  EXPECT_FALSE(text.contains(QRegularExpression("Problems\\s+None")));
  test::keep("job-sheet-problems", pages.front());
}

TEST(JobSheet, IsTheSameFileEveryTime) {
  EXPECT_EQ(encodedPdf(sheetOf(test::triangle600(), {}, test::kEnglish)),
            encodedPdf(sheetOf(test::triangle600(), {}, test::kEnglish)));
}

TEST(EncodedPdf, TurnsEachPageAsItAsks) {
  Figure lying;
  lying.paint = [](QCPPainter&) {};
  Figure standing = lying;
  standing.page = kA4Portrait;
  const QByteArray pdf = encodedPdf({standing, lying, standing});
  EXPECT_EQ(pdf.count("/Type /Page\n"), 3);
  EXPECT_EQ(pdf.count("/MediaBox [0 0 595"), 2);
  EXPECT_EQ(pdf.count("/MediaBox [0 0 842"), 1);
}

} // namespace
} // namespace arris::ui
