#include "ui/widgets/busy_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace arris::ui {
namespace {

constexpr int kBusyRowAfter = 250; // ms

} // namespace

BusyRow::BusyRow(QWidget* parent) : QWidget(parent), m_text(new QLabel), m_cancel(new QPushButton(tr("Cancel"))) {
  m_text->setObjectName(QStringLiteral("busyText"));
  m_text->setWordWrap(true);
  m_cancel->setObjectName(QStringLiteral("cancelPlanning"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_cancel);
  m_delay.setSingleShot(true);
  m_delay.setInterval(kBusyRowAfter);
  connect(&m_delay, &QTimer::timeout, this, [this] { Q_EMIT shownChanged(true); });
  connect(m_cancel, &QPushButton::clicked, this, &BusyRow::cancelled);
}

void BusyRow::setBusy(bool busy) {
  if (busy) {
    m_delay.start();
  } else {
    m_delay.stop();
    Q_EMIT shownChanged(false);
  }
}

void BusyRow::setText(const QString& what) {
  m_text->setText(what);
}

} // namespace arris::ui
