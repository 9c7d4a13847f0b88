#include "tests/support/panes.h"
#include "tests/support/scratch.h"
#include "tests/ui/support/artefacts.h"
#include "ui/figures/figure.h"
#include "ui/figures/preview_figure.h"
#include "ui/figures/profile_figure.h"
#include "ui/figures/style.h"

#include <QImage>
#include <QLineF>
#include <QPolygonF>
#include <QProcess>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace arris::ui {
namespace {

Figure previewOf(const pattern::Pattern& pattern, const recipe::Recipe& recipe = {}) {
  const job::Job job = job::planJob(pattern, recipe, recipe::Machine{});
  return previewFigure(drawingOf(job, pattern), previewTitle(job, QStringLiteral("pane.dxf")));
}

Figure profileOfTriangle() {
  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
  return profileFigure(job, QStringLiteral("pane.dxf"));
}

// What another program makes of a file.
QString outputOf(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  EXPECT_TRUE(process.waitForFinished(60000)) << program.toStdString();
  EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
  return QString::fromUtf8(process.readAllStandardOutput());
}

QString asText(const QByteArray& pdf) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "figure.pdf";
  std::ofstream(file, std::ios::binary).write(pdf.constData(), pdf.size());
  return outputOf(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), QString::fromStdString(file.string()), "-"});
}

// The polylines of an SVG with the colour of their stroke; coordinates as they stand there.
std::vector<std::pair<QString, QPolygonF>> polylinesOf(const QByteArray& svg) {
  std::vector<std::pair<QString, QPolygonF>> result;
  QString stroke;
  QXmlStreamReader xml(svg);
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QStringLiteral("g") && xml.attributes().hasAttribute("stroke")) {
      stroke = xml.attributes().value("stroke").toString();
    }
    if (xml.name() == QStringLiteral("polyline")) {
      QPolygonF points;
      for (const QString& pair : xml.attributes().value("points").toString().split(' ', Qt::SkipEmptyParts)) {
        const QStringList xy = pair.split(',');
        points.append({xy[0].toDouble(), xy[1].toDouble()});
      }
      result.emplace_back(stroke, points);
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return result;
}

TEST(FigureFormat, IsChosenByTheEndingInAnyCase) {
  EXPECT_EQ(figureFormat("a.svg"), FigureFormat::Svg);
  EXPECT_EQ(figureFormat("a.b.PDF"), FigureFormat::Pdf);
  EXPECT_EQ(figureFormat("/x.svg/a.Png"), FigureFormat::Png);
  EXPECT_EQ(figureFormat("a.jpg"), std::nullopt);
  EXPECT_EQ(figureFormat("svg"), std::nullopt);
}

TEST(FigureFile, HasTheSameBytesForTheSameFigure) {
  for (const Figure& figure : {previewOf(test::triangle600()), profileOfTriangle()}) {
    for (const FigureFormat format : {FigureFormat::Svg, FigureFormat::Pdf, FigureFormat::Png}) {
      EXPECT_EQ(encoded(figure, format), encoded(figure, format));
    }
    EXPECT_TRUE(encoded(figure, FigureFormat::Pdf).contains("/CreationDate (D:20000101000000Z"));
  }
}

TEST(FigureFile, IsWrittenWholeOrNotAtAll) {
  const test::Scratch scratch;
  EXPECT_TRUE(renderToFile(previewOf(test::triangle600()), scratch / "a.svg").has_value());
  EXPECT_TRUE(std::filesystem::exists(scratch / "a.svg"));
  const auto wrongEnding = renderToFile(previewOf(test::triangle600()), scratch / "a.jpg");
  ASSERT_FALSE(wrongEnding.has_value());
  EXPECT_EQ(wrongEnding.error().code, base::Code::ValueNotAChoice);
  EXPECT_FALSE(std::filesystem::exists(scratch / "a.jpg"));
  const auto noFolder = renderToFile(previewOf(test::triangle600()), scratch / "none/a.svg");
  ASSERT_FALSE(noFolder.has_value());
  EXPECT_EQ(noFolder.error().code, base::Code::CannotWrite);
}

TEST(FigureFile, AsPdfIsOneVectorPageOfA4WithRealText) {
  const QByteArray pdf = encoded(profileOfTriangle(), FigureFormat::Pdf);
  EXPECT_FALSE(pdf.contains("/Subtype /Image"));
  const QString text = asText(pdf);
  EXPECT_EQ(text.count(QChar::FormFeed), 1); // pages
  for (const char* words : {"pane.dxf", "60°", "time, s", "limit 20", "limit -20", "feed 60", "R + d 75.26"}) {
    EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << "\n" << text.toStdString();
  }
}

TEST(FigureFile, AsSvgIsReadByAnotherProgram) {
  const test::Scratch scratch;
  for (const Figure& figure : {previewOf(test::triangle600()), profileOfTriangle()}) {
    ASSERT_TRUE(renderToFile(figure, scratch / "a.svg").has_value());
    const QString png = QString::fromStdString((scratch / "a.png").string());
    outputOf(QStringLiteral("rsvg-convert"), {"-w", QString::number(figure.page.width() / 2),
                                              QString::fromStdString((scratch / "a.svg").string()), "-o", png});
    EXPECT_EQ(QImage(png).size(), (figure.page / 2).toSize());
  }
}

TEST(FigureFile, AsPngHasTwoHundredDotsPerInch) {
  const QImage image = QImage::fromData(encoded(profileOfTriangle(), FigureFormat::Png)); // A4 lying: 297 × 210
  EXPECT_EQ(image.size(), QSize(2339, 1654));
  EXPECT_EQ(image.dotsPerMeterX(), 7874);
}

TEST(PreviewFigure, IsTrueToTheScaleThatItStates) {
  const Figure figure = previewOf(test::triangle600());
  const QString text = asText(encoded(figure, FigureFormat::Pdf));
  const auto scale = QRegularExpression("Scale 1 : ([0-9.]+)").match(text);
  ASSERT_TRUE(scale.hasMatch()) << text.toStdString();
  const double side = 600 * 10 / scale.captured(1).toDouble(); // 0.1 mm on paper
  bool found = false;
  for (const auto& [stroke, points] : polylinesOf(encoded(figure, FigureFormat::Svg))) {
    if (stroke == FigureStyle().palette.contour.name() && points.size() == 4) {
      found = true;
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(QLineF(points[i], points[i + 1]).length(), side, 0.01);
      }
    }
  }
  EXPECT_TRUE(found);
}

TEST(PreviewFigure, StandsWhereThePaneStands) {
  const Figure tall = previewOf(test::polygon({{0, 0}, {400, 0}, {400, 1500}, {0, 1500}}));
  EXPECT_EQ(tall.page, kA4Portrait);
  EXPECT_EQ(previewOf(test::polygon({{0, 0}, {1200, 0}, {1200, 400}, {0, 400}})).page, kA4Landscape);
  test::keep("preview-tall", tall);
}

// Rapids come from the park position, the travel is far larger than the pane: both are cut off at the frame, because
// SVG has no clipping.
TEST(PreviewFigure, DrawsNothingOutsideThePage) {
  const Figure figure = previewOf(test::triangle600());
  for (const auto& [stroke, points] : polylinesOf(encoded(figure, FigureFormat::Svg))) {
    for (const QPointF& point : points) {
      EXPECT_TRUE(QRectF(QPointF(), figure.page).contains(point)) << stroke.toStdString();
    }
  }
}

TEST(PreviewFigure, SaysInWordsWhatIsWrongAndWhere) {
  pattern::Pattern gap = test::polygon({{0, 0}, {300, 0}, {300, 200}, {0, 200}});
  gap.loose = {geometry::Line{{20, 230}, {150, 260}}, geometry::Line{{150, 260.4}, {250, 240}}};
  gap.problems.push_back(
      base::Problem(base::Code::OpenChain, {{"gap_mm", 0.4}, {"tolerance_mm", 0.05}}).at({150, 260}));
  const Figure figure = previewFigure(drawingOf(gap), previewTitle(gap, QStringLiteral("gap.dxf")));
  test::keep("inspect-gap", figure);
  const QString text = asText(encoded(figure, FigureFormat::Pdf));
  EXPECT_TRUE(text.contains("The contour is open here") && text.contains("0.4 mm")) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("(at\u00a0X\u00a0150.0,\u00a0Y\u00a0260.0\u00a0mm)")) ||
              text.contains("(at X 150.0, Y 260.0 mm)"))
      << text.toStdString();
  EXPECT_TRUE(text.contains("pieces in no contour: 2"));
}

TEST(PreviewFigure, ShowsRepairsToo) {
  pattern::Pattern repaired = test::polygon({{0, 0}, {300, 0}, {300, 200}, {0, 200}});
  for (int i = 0; i < 200; ++i) {
    repaired.repairs.push_back(base::Problem(base::Code::GapClosed, {{"size_mm", 0.02}}).at({1.5 * i, 0}));
  }
  const Figure figure = previewOf(repaired);
  test::keep("preview-repairs", figure);
  const QString text = asText(encoded(figure, FigureFormat::Pdf));
  EXPECT_TRUE(text.contains("A gap of 0.02 mm was closed.")) << text.toStdString();
  EXPECT_TRUE(text.contains("And 199 more like it."));
  EXPECT_TRUE(text.contains("Note, repair"));
}

TEST(PreviewFigure, NamesTheNumberOfContours) {
  pattern::Pattern pattern = test::polygon({{0, 0}, {1000, 0}, {1000, 600}, {0, 600}});
  pattern::Contour hole = test::polygon({{300, 200}, {300, 400}, {700, 400}, {700, 200}}).contours.front();
  hole.id = 2;
  hole.kind = pattern::ContourKind::CutOut;
  hole.parent = 1;
  pattern.contours.push_back(hole);
  const QString text = asText(encoded(previewOf(pattern), FigureFormat::Pdf));
  EXPECT_TRUE(text.contains("Contours: 2 (outlines 1, cut-outs 1)")) << text.toStdString();
}

TEST(PreviewFigure, OfNothingIsStillAPage) {
  const pattern::Pattern nothing;
  const Figure figure = previewFigure(drawingOf(nothing), previewTitle(nothing, QStringLiteral("empty.dxf")));
  EXPECT_TRUE(asText(encoded(figure, FigureFormat::Pdf)).contains("Contours: 0"));
}

TEST(ProfileFigure, IsSmallHoweverLongAndNoisyTheProfile) {
  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
  const ProfileColumns planned = columnsOf(job);
  ProfileColumns noisy = planned;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.4);
  for (std::size_t i = 0; i < noisy.time.size(); ++i) {
    for (std::vector<double>* column : {&noisy.vx, &noisy.vy, &noisy.ax, &noisy.ay, &noisy.speed}) {
      (*column)[i] += noise(random);
    }
  }
  EXPECT_LT(encoded(profileOfTriangle(), FigureFormat::Svg).size(), 200'000);
  const Figure overlay =
      profileFigure({curvesOf(planned, QStringLiteral("planned")), curvesOf(noisy, QStringLiteral("actual"))},
                    limitsOf(job), QStringLiteral("plan.csv, run.csv"), QString());
  EXPECT_LT(encoded(overlay, FigureFormat::Svg).size(), 1'500'000);
  EXPECT_LT(encoded(overlay, FigureFormat::Pdf).size(), 1'500'000);
  const QString text = asText(encoded(overlay, FigureFormat::Pdf));
  EXPECT_TRUE(text.contains("planned"));
  EXPECT_TRUE(text.contains("actual"));
  test::keep("profile-overlay", overlay);
}

TEST(Figures, ToLookAt) {
  std::vector<geometry::Point> oval;
  for (int i = 0; i < 40; ++i) {
    oval.emplace_back(500 * std::cos(i * M_PI / 20), 320 * std::sin(i * M_PI / 20));
  }
  recipe::Recipe small;
  small.wheelRadius = 12;
  recipe::Recipe cornered;
  cornered.place = Eigen::Vector2d(40, 30);
  test::keep("preview-triangle", previewOf(test::triangle600()));
  test::keep("preview-oval", previewOf(test::polygon(oval), small));
  test::keep("preview-outside", previewOf(test::polygon({{0, 0}, {1200, 0}, {900, 350}}), cornered));
  test::keep("profile-triangle", profileOfTriangle());
  const job::Job many = job::planJob(test::polygon(oval), recipe::Recipe{}, recipe::Machine{});
  test::keep("profile-oval", profileFigure(many, QStringLiteral("oval.dxf")));
}

} // namespace
} // namespace arris::ui
