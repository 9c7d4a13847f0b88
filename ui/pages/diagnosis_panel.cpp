#include "ui/pages/diagnosis_panel.h"

#include "ui/models/signal_model.h"
#include "ui/widgets/signal_table.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kLookEvery = 200; // ms: as fast as an eye reads

QVBoxLayout* addColumn(QHBoxLayout& row, int stretch) {
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  row.addLayout(column, stretch);
  return column;
}

} // namespace

DiagnosisPanel::DiagnosisPanel(MachineLink& machine, QWidget* parent) : QWidget(parent), m_machine(machine) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  QVBoxLayout* left = addColumn(*row, 4);
  QVBoxLayout* right = addColumn(*row, 3);
  m_axes = add(*left, {tr("Axes"), QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")},
               QStringLiteral("axisSignals"));
  m_control = add(*left, {tr("Controller"), tr("Now")}, QStringLiteral("controlFigures"));
  m_inputs = add(*right, {tr("Inputs"), tr("Now")}, QStringLiteral("inputSignals"));
  m_outputs = add(*right, {tr("Outputs"), tr("Now")}, QStringLiteral("outputSignals"));
  left->addStretch(1);
  right->addStretch(1);
  m_timer.setInterval(kLookEvery);
  connect(&m_timer, &QTimer::timeout, this, &DiagnosisPanel::look);
  look();
}

SignalModel* DiagnosisPanel::add(QVBoxLayout& column, const QStringList& headings, const QString& name) {
  auto* model = new SignalModel(headings, this);
  column.addWidget(new SignalTable(*model, name));
  return model;
}

void DiagnosisPanel::showEvent(QShowEvent* event) {
  look();
  m_timer.start();
  QWidget::showEvent(event);
}

void DiagnosisPanel::hideEvent(QHideEvent* event) {
  m_timer.stop();
  QWidget::hideEvent(event);
}

void DiagnosisPanel::look() {
  const control::Report& report = m_machine.report();
  m_axes->show(axisSignals(report, m_machine.worstFollowingError()));
  m_control->show(controlFigures(report, m_machine.timing()));
  m_inputs->show(inputSignals(report));
  m_outputs->show(outputSignals(report, report.tick != m_tick));
  m_tick = report.tick;
}

} // namespace arris::ui
