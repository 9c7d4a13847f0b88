#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

class NumberEdit;

/// The order on the page Run: how many panes, good or reject for each that has ended, the size correction for the next
/// one, and loading. What is loaded is never touched: another size correction is a revision for the next pane.
class OrderPanel : public QWidget {
  Q_OBJECT

public:
  OrderPanel(Planner& planner, MachineLink& machine, QWidget* parent = nullptr);

private:
  QWidget* makeVerdict();
  QWidget* makeOrder();
  QWidget* makeCorrection();
  void judge(files::Verdict verdict);
  void changePanes(int by);
  void changeCorrection(double to);
  void load();
  void showState();
  [[nodiscard]] QString hint() const;
  [[nodiscard]] bool isRevision() const;

  Planner& m_planner;
  MachineLink& m_machine;
  QLabel* m_hint;
  QLabel* m_counts;
  QLabel* m_wanted;
  QPushButton* m_good = nullptr;
  QPushButton* m_reject = nullptr;
  QPushButton* m_fewer = nullptr;
  QPushButton* m_more = nullptr;
  QPushButton* m_smaller = nullptr;
  QPushButton* m_larger = nullptr;
  NumberEdit* m_correction = nullptr;
  QPushButton* m_load = nullptr;
};

} // namespace arris::ui
