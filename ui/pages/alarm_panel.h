#pragma once

#include "ui/presenters/alarm_history.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace arris::ui {

class AlarmModel;

/// The alarms of now and before, the latest first, and the one that is chosen in full.
class AlarmPanel : public QWidget {
  Q_OBJECT

public:
  AlarmPanel(MachineLink& machine, AlarmHistory& history, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  QWidget* makeButtons();
  QWidget* makeDetail();
  void setUpTable();
  void sizeColumns();
  void showAlarms();
  void showAllowed();

  MachineLink& m_machine;
  AlarmHistory& m_history;
  AlarmModel* m_model;
  QTableView* m_table;
  QLabel* m_summarySign;
  QLabel* m_summary;
  QLabel* m_sign;
  QLabel* m_detail;
  QPushButton* m_acknowledge;
};

} // namespace arris::ui
