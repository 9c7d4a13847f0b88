#include "ui/views/pattern_view.h"

#include "ui/figures/drawing_painter.h"

#include <QPainter>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr double kPatternUnit = 0.56; // px: 27 units of text are 15 px
constexpr double kPatternMargin = 20; // px
constexpr double kLeastSide = 1e-3;   // mm

QTransform fitted(const geometry::Box& box, const QRectF& room) {
  const geometry::Vector size = box.sizes().cwiseMax(kLeastSide);
  const double scale = std::min(room.width() / size.x(), room.height() / size.y());
  const QPointF middle = toQt(box.center());
  QTransform toView = QTransform::fromTranslate(room.center().x(), room.center().y());
  toView.scale(scale, -scale);
  toView.translate(-middle.x(), -middle.y());
  return toView;
}

} // namespace

PatternView::PatternView(QWidget* parent) : QWidget(parent), m_style(screenStyle(kPatternUnit)) {
  setMinimumSize(200, 150);
  setAccessibleName(tr("Drawing"));
}

void PatternView::showDrawing(const Drawing& drawing, const QString& words) {
  m_drawing = drawing;
  m_words = words;
  update();
}

void PatternView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame(rect());
  const QRectF room = frame.adjusted(kPatternMargin, kPatternMargin, -kPatternMargin, -kPatternMargin);
  painter.fillRect(frame, m_style.palette.paper);
  if (!m_drawing.box.isEmpty()) {
    paintDrawing(painter, m_drawing, fitted(m_drawing.box, room), frame, m_style);
  }
  painter.setPen(m_style.palette.faint);
  painter.setFont(font());
  painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, m_words);
}

} // namespace arris::ui
