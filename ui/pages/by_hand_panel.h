#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

class NumberEdit;

/// Where the table's zero lies, what the glass lies on, and spindle and coolant by hand. Nothing here moves an axis.
class ByHandPanel : public QWidget {
  Q_OBJECT

public:
  explicit ByHandPanel(MachineLink& machine, QWidget* parent = nullptr);

private:
  QWidget* makeOrigin();
  QWidget* makeSupport();
  QWidget* makeServices();
  void setOriginHere(int axis);
  void setTypedOrigin();
  void showAllowed();
  void showServices();
  void showReport();

  MachineLink& m_machine;
  std::array<NumberEdit*, control::kAxes> m_origin{};
  std::array<QPushButton*, control::kAxes> m_here{};
  QPushButton* m_set = nullptr;
  QLabel* m_originHint;
  QLabel* m_support;
  NumberEdit* m_speed = nullptr;
  QLabel* m_services;
  QPushButton* m_spindleOn = nullptr;
  QPushButton* m_spindleOff = nullptr;
  QPushButton* m_coolantOn = nullptr;
  QPushButton* m_coolantOff = nullptr;
  Eigen::Vector3d m_shown{0, 0, 0}; // the origin that the fields were filled with
};

} // namespace arris::ui
