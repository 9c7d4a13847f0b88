#include "ui/figures/style.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace arris::ui {
namespace {

// Contrast as the Web Content Accessibility Guidelines (WCAG 2.1) define it: 1 to 21.
double luminance(const QColor& color) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double lighter = std::max(luminance(a), luminance(b));
  const double darker = std::min(luminance(a), luminance(b));
  return (lighter + 0.05) / (darker + 0.05);
}

std::vector<QColor> linesOf(const Palette& p) {
  return {p.ink,   p.faint, p.contour, p.path, p.transition, p.roll,  p.lead,
          p.loose, p.error, p.warning, p.x,    p.y,          p.speed, p.distance};
}

class InAppearance : public ::testing::TestWithParam<Appearance> {
protected:
  void SetUp() override {
    showAppearance(GetParam());
  }

  void TearDown() override {
    showAppearance(Appearance::Light);
  }
};

TEST_P(InAppearance, TextAndLinesStandOutFromThePaper) {
  const Palette palette = screenStyle(1).palette;
  for (const QColor& text : {palette.ink, palette.faint}) {
    EXPECT_GE(contrast(text, palette.paper), 4.5) << text.name().toStdString();
  }
  for (const QColor& line : linesOf(palette)) {
    EXPECT_GE(contrast(line, palette.paper), 3) << line.name().toStdString();
  }
  EXPECT_GE(contrast(palette.rapid, palette.paper), 3);
  for (const QColor& sign : {palette.error, palette.warning, palette.faint}) {
    EXPECT_GE(contrast(palette.paper, sign), 4.5) << "what is written in a sign on " << sign.name().toStdString();
  }
}

TEST_P(InAppearance, LinesStandOutFromGlassAndBands) {
  const Palette palette = screenStyle(1).palette;
  for (const QColor& line : linesOf(palette)) {
    for (const QColor& area : {palette.glass, palette.cornerBand, palette.phaseBand}) {
      EXPECT_GE(contrast(line, area), 3) << line.name().toStdString() << " on " << area.name().toStdString();
    }
  }
  for (const QColor& curve : {palette.x, palette.y, palette.speed, palette.distance}) {
    EXPECT_GE(contrast(curve, palette.awayBand), 3) << curve.name().toStdString();
  }
}

INSTANTIATE_TEST_SUITE_P(Style, InAppearance, ::testing::Values(Appearance::Light, Appearance::Dark));

TEST(Style, PicturesInFilesAreLightWhateverTheWindowLooksLike) {
  showAppearance(Appearance::Dark);
  EXPECT_EQ(FigureStyle().palette.paper, QColor(Qt::white));
  EXPECT_NE(screenStyle(1).palette.paper, QColor(Qt::white));
  showAppearance(Appearance::Light);
  EXPECT_EQ(screenStyle(1).palette.paper, QColor(Qt::white));
}

TEST(Style, TheWindowsUnitOfLengthIsForScreensOnly) {
  showLengthsIn(LengthUnit::Inch);
  EXPECT_EQ(FigureStyle().lengths, LengthUnit::Millimetre);
  EXPECT_EQ(screenStyle(1).lengths, LengthUnit::Inch);
  showLengthsIn(LengthUnit::Millimetre);
}

} // namespace
} // namespace arris::ui
