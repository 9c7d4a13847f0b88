#pragma once

#include "ui/presenters/preferences.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace arris::ui {

class NumberEdit;

/// Language, units, appearance; the machine; the code that protects the engineering values. The window follows at once;
/// machine, axes and scale count from the next start, and the page says so.
class SettingsPage : public QWidget {
  Q_OBJECT

public:
  explicit SettingsPage(Preferences& preferences, QWidget* parent = nullptr);

private:
  QWidget* makeWindow();
  QWidget* makeMachine();
  QWidget* makeCode();
  QComboBox* makeLanguages();
  QComboBox* makeScales();
  void addChoice(QGridLayout& grid, const QString& what, const std::vector<std::pair<QString, QString>>& buttons,
                 int chosen, const std::function<void(files::Settings&, int)>& take, int columns = 1);
  void addFieldsOfMachine(QGridLayout& grid);
  void addNumber(QGridLayout& grid, int column, NumberEdit* edit, const std::function<void(double)>& take);
  void change(const std::function<void(files::Settings&)>& edit);
  void keepMachine();
  void showComplaint();
  void showOpen();
  void showCodeButtons();
  void enterCode();
  void takeCode();

  Preferences& m_preferences;
  recipe::Machine m_machine; // as the fields say
  std::vector<NumberEdit*> m_numbers;
  QWidget* m_engineering = nullptr;
  QLabel* m_complaint;
  QLabel* m_codeState;
  QLineEdit* m_code;
  QPushButton* m_enter;
  QPushButton* m_set;
  QPushButton* m_remove;
  QPushButton* m_lock;
};

} // namespace arris::ui
