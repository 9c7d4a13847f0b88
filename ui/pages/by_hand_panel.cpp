#include "ui/pages/by_hand_panel.h"

#include "core/job/program_track.h"
#include "core/recipe/fields.h"
#include "ui/text/machine_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/number_edit.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace arris::ui {
ByHandPanel::ByHandPanel(MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_originHint(new QLabel), m_support(new QLabel), m_services(new QLabel) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(makeOrigin(), 0, 0, 2, 1);
  grid->addWidget(makeServices(), 0, 1);
  grid->addWidget(makeSupport(), 1, 1);
  grid->setRowStretch(2, 1);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  connect(&machine, &MachineLink::changed, this, &ByHandPanel::showAllowed);
  connect(&machine, &MachineLink::reported, this, &ByHandPanel::showReport);
  showAllowed();
  showReport();
}

QWidget* ByHandPanel::makeOrigin() {
  auto* box = new QGroupBox(tr("Origin of the table (G54)"));
  auto* grid = new QGridLayout(box);
  m_shown = m_machine.report().origin;
  const std::array<QString, control::kAxes> names{QStringLiteral("origin_x_mm"), QStringLiteral("origin_y_mm"),
                                                  QStringLiteral("origin_z_mm")};
  const std::array<QString, control::kAxes> texts{tr("Zero of the table in X"), tr("Zero of the table in Y"),
                                                  tr("Zero of the table in Z")};
  for (int axis = 0; axis < control::kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double most = m_machine.machine().travel[axis];
    auto* edit = new NumberEdit({names.at(i), texts.at(i), QStringLiteral("mm"), -most, most},
                                std::clamp(m_shown[axis], -most, most));
    auto* here = new QPushButton(tr("Set here"));
    here->setObjectName(QStringLiteral("originHere") + QStringLiteral("XYZ").at(axis));
    here->setAccessibleName(tr("The table's zero of %1 is where the wheel is").arg(QStringLiteral("XYZ").at(axis)));
    connect(here, &QPushButton::clicked, this, [this, axis] { setOriginHere(axis); });
    connect(edit, &NumberEdit::complaintChanged, this, &ByHandPanel::showAllowed);
    grid->addWidget(edit, axis, 0);
    grid->addWidget(here, axis, 1, Qt::AlignBottom);
    m_origin[i] = edit;
    m_here[i] = here;
  }
  m_set = new QPushButton(tr("Set the typed origin"));
  m_set->setObjectName(QStringLiteral("originSet"));
  connect(m_set, &QPushButton::clicked, this, &ByHandPanel::setTypedOrigin);
  grid->addWidget(m_set, control::kAxes, 0, 1, 2);
  m_originHint->setObjectName(QStringLiteral("originHint"));
  m_originHint->setWordWrap(true);
  m_originHint->setMinimumHeight(4 * fontMetrics().lineSpacing()); // nothing jumps
  m_originHint->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  grid->addWidget(m_originHint, control::kAxes + 1, 0, 1, 2);
  return box;
}

QWidget* ByHandPanel::makeSupport() {
  auto* box = new QGroupBox(tr("Support of the glass"));
  auto* layout = new QVBoxLayout(box);
  m_support->setObjectName(QStringLiteral("support"));
  m_support->setWordWrap(true);
  m_support->setMinimumHeight(4 * fontMetrics().lineSpacing());
  m_support->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  layout->addWidget(m_support);
  return box;
}

QWidget* ByHandPanel::makeServices() {
  auto* box = new QGroupBox(tr("Spindle and coolant by hand"));
  auto* grid = new QGridLayout(box);
  const double chosen = m_machine.setupChoices().spindle;
  const double usual = m_machine.loaded() ? m_machine.loaded()->job.recipe.spindle : recipe::Recipe{}.spindle;
  m_speed = new NumberEdit({QStringLiteral("spindle_by_hand_r_min"), tr("Spindle speed by hand"),
                            QStringLiteral("r/min"), 1, recipe::numberField(&recipe::Recipe::spindle).most},
                           chosen > 0 ? chosen : std::max(1.0, usual));
  connect(m_speed, &NumberEdit::valueChanged, this, [this](double speed) { m_machine.setupChoices().spindle = speed; });
  connect(m_speed, &NumberEdit::complaintChanged, this, &ByHandPanel::showAllowed);
  grid->addWidget(m_speed, 0, 0, 1, 2);
  const auto put = [&](const QString& text, const char* name, int row, int column, auto act) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    connect(button, &QPushButton::clicked, this, act);
    grid->addWidget(button, row, column);
    return button;
  };
  m_spindleOn = put(tr("Spindle on"), "spindleOn", 1, 0, [this] { m_machine.spindleByHand(m_speed->value()); });
  m_spindleOff = put(tr("Spindle off"), "spindleOff", 1, 1, [this] { m_machine.spindleByHand(0); });
  m_coolantOn = put(tr("Coolant on"), "coolantOn", 2, 0, [this] { m_machine.coolantByHand(true); });
  m_coolantOff = put(tr("Coolant off"), "coolantOff", 2, 1, [this] { m_machine.coolantByHand(false); });
  m_services->setObjectName(QStringLiteral("byHandServices"));
  m_services->setWordWrap(true);
  m_services->setMinimumHeight(3 * fontMetrics().lineSpacing());
  grid->addWidget(m_services, 3, 0, 1, 2);
  return box;
}

// Where the wheel is in machine coordinates; the other axes keep their zero.
void ByHandPanel::setOriginHere(int axis) {
  const control::Report& report = m_machine.report();
  Eigen::Vector3d origin = report.origin;
  origin[axis] += report.commanded[axis];
  m_machine.setOrigin(origin);
}

void ByHandPanel::setTypedOrigin() {
  Eigen::Vector3d origin;
  for (int axis = 0; axis < control::kAxes; ++axis) {
    origin[axis] = m_origin[static_cast<std::size_t>(axis)]->value();
  }
  m_machine.setOrigin(origin);
}

void ByHandPanel::showAllowed() {
  const Allowed allowed = m_machine.allowed();
  QString complaint;
  for (std::size_t i = 0; i < m_origin.size(); ++i) {
    m_here[i]->setEnabled(allowed.origin);
    complaint = complaint.isEmpty() ? m_origin[i]->complaint() : complaint;
  }
  m_set->setEnabled(allowed.origin && complaint.isEmpty());
  m_originHint->setText(!complaint.isEmpty() ? complaint
                        : m_machine.goesOnWithAPane()
                            ? tr("A pane was broken off: its origin stays until it has been ground or given up.")
                        : allowed.origin
                            ? tr("Where the zero of the table lies in machine coordinates. Whether the job still fits "
                                 "into the travel is checked at once.")
                            : tr("The origin can be set when the axes are homed and at rest."));
  showServices();
  m_spindleOn->setEnabled(allowed.byHand && m_speed->complaint().isEmpty());
  m_spindleOff->setEnabled(allowed.byHand);
  m_coolantOn->setEnabled(allowed.byHand);
  m_coolantOff->setEnabled(allowed.byHand);
  if (!m_machine.loaded()) {
    m_support->setText(tr("No job is loaded: its recipe says how high the glass lies."));
    return;
  }
  const job::Job& job = m_machine.loaded()->job;
  const QLocale locale;
  m_support->setText(inShownUnits(tr("Of the job that is loaded: the underside of the glass lies %1 mm above the "
                                     "table, the glass is %2 mm thick, and the middle of the wheel grinds at Z %3 mm."))
                         .arg(lengthText(job.recipe.support, 3, locale), lengthText(job.recipe.thickness, 3, locale),
                              lengthText(job::heightsOf(job.recipe, job.machine).grinding, 3, locale)));
}

// What is wrong with the typed speed goes first: it is being typed.
void ByHandPanel::showServices() {
  m_services->setText(m_speed->complaint().isEmpty() ? servicesText(m_machine.report()) : m_speed->complaint());
}

void ByHandPanel::showReport() {
  if (!isVisible()) {
    return;
  }
  const control::Report& report = m_machine.report();
  showServices();
  if (report.origin == m_shown) {
    return;
  }
  m_shown = report.origin;
  for (int axis = 0; axis < control::kAxes; ++axis) {
    const double most = m_machine.machine().travel[axis];
    m_origin[static_cast<std::size_t>(axis)]->setValue(std::clamp(m_shown[axis], -most, most));
  }
}

} // namespace arris::ui
