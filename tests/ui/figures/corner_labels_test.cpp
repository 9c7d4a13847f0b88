#include "tests/support/random_panes.h"
#include "ui/figures/corner_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

// As a figure or a view would show it: the whole drawing in the middle of a frame.
QTransform fitted(const Drawing& drawing, const QRectF& frame) {
  const geometry::Vector size = drawing.box.sizes();
  const double scale = 0.8 * std::min(frame.width() / size.x(), frame.height() / size.y());
  QTransform result = QTransform::fromTranslate(frame.center().x(), frame.center().y());
  result.scale(scale, -scale);
  return result.translate(-drawing.box.center().x(), -drawing.box.center().y());
}

TEST(CornerLabels, NeverStandOnEachOtherNorOutsideTheFrame) {
  const QRectF frame(0, 0, 2600, 1500);
  const FigureStyle style;
  std::uint64_t seed = 1;
  std::size_t shown = 0;
  std::size_t corners = 0;
  for (int i = 0; i < 30; ++i) {
    const Drawing drawing = drawingOf(test::randomJob(seed));
    const std::vector<CornerLabel> labels = placeCornerLabels(drawing, fitted(drawing, frame), frame, style);
    for (std::size_t a = 0; a < labels.size(); ++a) {
      EXPECT_TRUE(frame.contains(labels[a].box));
      EXPECT_TRUE(labels[a].box.contains(labels[a].badge));
      for (std::size_t b = a + 1; b < labels.size(); ++b) {
        EXPECT_FALSE(labels[a].box.intersects(labels[b].box)) << "seed " << seed;
      }
    }
    shown += labels.size();
    corners += drawing.corners.size();
  }
  EXPECT_GE(shown, corners * 9 / 10); // what a page has room for
}

} // namespace
} // namespace arris::ui
