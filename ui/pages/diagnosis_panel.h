#pragma once

#include "ui/presenters/machine_link.h"

#include <QTimer>
#include <QWidget>

class QVBoxLayout;

namespace arris::ui {

class SignalModel;

/// Every input and output as it is now, and how the controller fares. It looks at the machine only while it is shown.
class DiagnosisPanel : public QWidget {
  Q_OBJECT

public:
  explicit DiagnosisPanel(MachineLink& machine, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  SignalModel* add(QVBoxLayout& column, const QStringList& headings, const QString& name);
  void look();

  MachineLink& m_machine;
  SignalModel* m_axes;
  SignalModel* m_control;
  SignalModel* m_inputs;
  SignalModel* m_outputs;
  std::int64_t m_tick = -1; ///< when it was looked at last
  QTimer m_timer;
};

} // namespace arris::ui
