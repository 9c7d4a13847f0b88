#include "ui/widgets/signal_icon.h"

#include "ui/figures/style.h"
#include "ui/widgets/signs.h"

#include <QPainter>
#include <QPixmap>

namespace arris::ui {

QIcon signalIcon(SignalSign sign) {
  if (sign == SignalSign::Abnormal) {
    return signIcon(base::Severity::Error);
  }
  QIcon icon;
  if (sign == SignalSign::None) {
    return icon;
  }
  const QColor ink = screenStyle(1).palette.ink;
  for (const int size : {24, 48}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, size / 12.0));
    painter.setBrush(sign == SignalSign::On ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QPointF(size / 2.0, size / 2.0), size / 4.0, size / 4.0);
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

} // namespace arris::ui
