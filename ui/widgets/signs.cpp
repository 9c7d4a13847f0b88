#include "ui/widgets/signs.h"

#include "ui/figures/drawing_painter.h"

#include <QPainter>
#include <QPixmap>

namespace arris::ui {

QIcon signIcon(base::Severity severity) {
  QIcon icon;
  for (const int size : {24, 48}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSign(painter, QPointF(size / 2.0, size / 2.0), severity, screenStyle(size / 42.0));
    painter.end();
    icon.addPixmap(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // else the selection would tint it
  }
  return icon;
}

} // namespace arris::ui
