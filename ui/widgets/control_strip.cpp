#include "ui/widgets/control_strip.h"

#include <QApplication>
#include <QButtonGroup>
#include <QMouseEvent>
#include <QPushButton>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kStripSpacing = 6; // px

bool isOn(const QPushButton& button, const QPoint& place) {
  return button.isEnabled() && button.rect().contains(button.mapFromGlobal(place));
}

} // namespace

ControlStrip::ControlStrip(MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_layout(new QVBoxLayout(this)), m_pages(new QButtonGroup(this)),
      m_lock(new QPushButton(tr("Lock\n30 s"))) {
  setFixedWidth(kWidth);
  m_layout->setContentsMargins(0, 4, 6, 6);
  m_layout->setSpacing(kStripSpacing);
  m_lock->setObjectName(QStringLiteral("lockScreen"));
  m_lock->setToolTip(tr("Lock the screen for 30 s to wipe it"));
  m_layout->addStretch(1);
  m_layout->addWidget(m_lock);
  connect(m_lock, &QPushButton::clicked, this, &ControlStrip::lockRequested);
  m_hold = addStop(tr("FEED\nHOLD"), QStringLiteral("feedHold"));
  m_stop = addStop(tr("STOP"), QStringLiteral("stop"));
  connect(m_pages, &QButtonGroup::idClicked, this, &ControlStrip::pageChosen);
  connect(m_hold, &QPushButton::pressed, &machine, &MachineLink::hold); // as soon as it is touched
  connect(m_stop, &QPushButton::pressed, &machine, &MachineLink::stop);
  connect(&machine, &MachineLink::changed, this, &ControlStrip::enableStops);
  enableStops();
  qApp->installEventFilter(this);
}

QPushButton* ControlStrip::addStop(const QString& text, const QString& name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  m_layout->addWidget(button);
  return button;
}

void ControlStrip::addPage(const QString& text, const QString& name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setCheckable(true);
  const int page = static_cast<int>(m_pages->buttons().size());
  m_pages->addButton(button, page);
  m_layout->insertWidget(page, button);
}

void ControlStrip::showPage(int page) {
  m_pages->button(page)->setChecked(true);
}

void ControlStrip::setLocked(bool locked) {
  m_lock->setEnabled(!locked);
  for (QAbstractButton* page : m_pages->buttons()) {
    page->setEnabled(!locked);
  }
}

void ControlStrip::enableStops() {
  const Allowed allowed = m_machine.allowed();
  m_hold->setEnabled(allowed.hold);
  m_stop->setEnabled(allowed.stop);
}

// A list that is open takes every press and key for itself: the first press on STOP would only close it.
bool ControlStrip::eventFilter(QObject* watched, QEvent* event) {
  if (QApplication::activePopupWidget() != nullptr) {
    stopBesidePopup(*event);
  }
  return QWidget::eventFilter(watched, event);
}

void ControlStrip::stopBesidePopup(const QEvent& event) {
  const bool isPress = event.type() == QEvent::MouseButtonPress;
  const int key = event.type() == QEvent::KeyPress ? static_cast<const QKeyEvent&>(event).key() : 0;
  const QPoint place = isPress ? static_cast<const QMouseEvent&>(event).globalPosition().toPoint() : QPoint();
  if (key == Qt::Key_F12 || (isPress && isOn(*m_stop, place))) {
    m_machine.stop();
  } else if (key == Qt::Key_F11 || (isPress && isOn(*m_hold, place))) {
    m_machine.hold();
  }
}

} // namespace arris::ui
