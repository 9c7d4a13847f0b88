#include "tests/support/panes.h"
#include "tests/ui/support/artefacts.h"
#include "ui/figures/profile_plot.h"
#include "ui/figures/relief_plot.h"
#include "ui/text/quantities.h"

#include <QTest>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

// The wheel's centre by the paper's Eq. (1): slowing along AQ, speeding up along QC.
geometry::Point centreAt(const toolpath::Corner& corner, double time) {
  const geometry::Vector along = (corner.q - corner.a).normalized();
  const geometry::Vector then = (corner.c - corner.q).normalized();
  const double a = corner.blendAcceleration;
  return corner.a + (corner.transitionSpeed * time - a * time * time / 2) * along + a * time * time / 2 * then;
}

TEST(ReliefDistance, IsThatOfThePlacesOfEquationOne) {
  for (const double degrees : {30.0, 60.0, 89.0, 110.0}) {
    recipe::Recipe slow; // so that no axis limits the blend
    slow.feed = 600;
    const job::Job job = job::planJob(test::isosceles(degrees, 600), slow, recipe::Machine{});
    for (const toolpath::Corner& corner : job.toolpath.corners) {
      if (corner.treatment != toolpath::Treatment::Transition) {
        continue;
      }
      for (int i = 0; i <= 10; ++i) {
        const double time = corner.blendTime * i / 10;
        EXPECT_NEAR(reliefDistance(corner, job.recipe.wheelRadius, time), (centreAt(corner, time) - corner.s).norm(),
                    1e-9)
            << degrees << "° at " << time;
      }
      EXPECT_NEAR(reliefDistance(corner, job.recipe.wheelRadius, corner.blendTime / 2), corner.widest, 1e-9);
    }
  }
}

class Relief : public testing::Test {
protected:
  static void show(ReliefPlot& plot, const job::Job& job, bool relief = true) {
    const auto& corners = job.toolpath.corners;
    const auto sharp = std::find_if(corners.begin(), corners.end(), [relief](const toolpath::Corner& corner) {
      return corner.relief == relief && corner.treatment == toolpath::Treatment::Transition;
    });
    ASSERT_NE(sharp, corners.end());
    plot.showCorner(*sharp, job.recipe.wheelRadius);
    plot.resize(320, 190);
    plot.show();
    QTest::qWait(20);
  }

  static QString namesOf(const ReliefPlot& plot) {
    return QStringList(plot.yAxis2->ticker().dynamicCast<QCPAxisTickerText>()->ticks().values()).join(' ');
  }
};

TEST_F(Relief, ShowsTheDistanceAgainstBothLimits) {
  const job::Job job = job::planJob(test::triangle600(), {}, recipe::Machine{});
  ReliefPlot plot(screenStyle(kPlotUnit));
  show(plot, job);
  // L(t_m/2) = 93.75 as in the paper's example; d = 0.13 / sin 30° = 0.26
  EXPECT_NEAR(plot.graph(0)->data()->at(60)->value, 93.75, 1e-6);
  EXPECT_NEAR(plot.graph(0)->data()->at(0)->value, 75, 1e-9);
  EXPECT_NEAR(plot.graph(0)->data()->at(120)->key, 12.99038, 1e-4);
  EXPECT_NEAR(plot.graph(2)->data()->at(0)->value, 75.26, 1e-6);
  EXPECT_TRUE(namesOf(plot).contains("75.26")) << namesOf(plot).toStdString();
  EXPECT_TRUE(plot.findChild<QCPItemText*>()->text().contains("+18.49")); // 93.75 − 75.26
  test::keep("relief", plot);
}

TEST_F(Relief, IsInInchesWhereTheWindowIs) {
  showLengthsIn(LengthUnit::Inch);
  ReliefPlot plot(screenStyle(kPlotUnit));
  showLengthsIn(LengthUnit::Millimetre);
  show(plot, job::planJob(test::triangle600(), {}, recipe::Machine{}));
  EXPECT_NEAR(plot.graph(0)->data()->at(60)->value, 93.75 / 25.4, 1e-9);
  EXPECT_TRUE(namesOf(plot).contains("2.963")) << namesOf(plot).toStdString(); // 75.26 mm
  EXPECT_TRUE(plot.yAxis->label().endsWith(", in")) << plot.yAxis->label().toStdString();
}

TEST_F(Relief, SaysWhenTheWheelDoesNotLiftEnough) {
  recipe::Recipe deep;
  deep.depth = 4;
  ReliefPlot plot(screenStyle(kPlotUnit));
  show(plot, job::planJob(test::isosceles(115, 900), deep, recipe::Machine{}), false);
  // (R/2)(s + 1/s) − R − d/s with s = sin 57.5°
  EXPECT_TRUE(plot.findChild<QCPItemText*>()->text().contains("-3.65"))
      << plot.findChild<QCPItemText*>()->text().toStdString();
  EXPECT_EQ(plot.findChild<QCPItemText*>()->color(), Palette().error);
  test::keep("relief-narrow", plot);
}

} // namespace
} // namespace arris::ui
