#pragma once

#include "ui/presenters/back_ups.h"

#include <QWidget>

class QGroupBox;
class QLabel;
class QPushButton;

namespace arris::ui {

class BusyBar;
class SignalModel;

/// What the machine has done in its life, and back-up, restore and support bundle in one file each.
class BackUpPanel : public QWidget {
  Q_OBJECT

public:
  BackUpPanel(MachineLink& machine, BackUps& backUps, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  QWidget* makeCounters();
  QWidget* makeBackUps();
  [[nodiscard]] QPushButton* add(QGroupBox& box, const QString& text, const QString& name, const QString& what,
                                 void (BackUpPanel::*act)()) const;
  QWidget* makeState();
  void showCounters();
  void showState();
  void askForBackUp();
  void askForRestore();
  void askForSupport();
  [[nodiscard]] static QStringList filters();

  MachineLink& m_machine;
  BackUps& m_backUps;
  SignalModel* m_life;
  QLabel* m_damage;
  QPushButton* m_save = nullptr;
  QPushButton* m_restore = nullptr;
  QPushButton* m_support = nullptr;
  QPushButton* m_confirm;
  QPushButton* m_giveUp;
  QLabel* m_sign;
  QLabel* m_state;
  BusyBar* m_busy;
};

} // namespace arris::ui
