#pragma once

#include "ui/presenters/planner.h"

#include <QMainWindow>

#include <filesystem>

namespace arris::ui {

/// The window of the program. Its pages come and go with the tasks; it opens patterns, by dialog or dropped on it.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(recipe::Machine machine = {}, PlannerSteps steps = plannerSteps(), QWidget* parent = nullptr);

  void openPattern(const std::filesystem::path& file);

  [[nodiscard]] Planner& planner() {
    return m_planner;
  }

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void askForPattern();

  Planner m_planner;
  QString m_folder; // where the last pattern was
};

} // namespace arris::ui
