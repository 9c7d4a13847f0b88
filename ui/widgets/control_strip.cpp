#include "ui/widgets/control_strip.h"

#include <QButtonGroup>
#include <QPushButton>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kStripSpacing = 6; // px

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

} // namespace arris::ui
