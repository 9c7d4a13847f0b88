#pragma once

#include "ui/presenters/machine_link.h"
#include "ui/presenters/profile_files.h"

#include <QMainWindow>
#include <QPointer>
#include <QStackedWidget>

#include <filesystem>

class QMessageBox;

namespace arris::ui {

class ControlStrip;

/// The window of the program: an alarm banner above, pages, and beside them the strip with FEED HOLD and STOP. It opens
/// patterns, by dialog or dropped on it. While the axes move it asks before it closes, and stops them first.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(const MachineSetup& setup, PlannerSteps steps = plannerSteps(), QWidget* parent = nullptr);

  ~MainWindow() override; ///< the pages first: they use planner and machine
  MainWindow(const MainWindow&) = delete;
  MainWindow& operator=(const MainWindow&) = delete;
  MainWindow(MainWindow&&) = delete;
  MainWindow& operator=(MainWindow&&) = delete;

  void openPattern(const std::filesystem::path& file);

  [[nodiscard]] Planner& planner() {
    return m_planner;
  }

  [[nodiscard]] MachineLink& machine() {
    return m_machine;
  }

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void askForPattern();

  void addPage(QWidget* page, const QString& text, const QString& name);

  Planner m_planner;
  MachineLink m_machine;
  ProfileFiles m_profileFiles;
  ControlStrip* m_strip;
  QStackedWidget* m_pages;
  QPointer<QMessageBox> m_question; // whether to stop and close
  bool m_closes = false;            // as soon as the axes are at rest
  QString m_folder;                 // where the last pattern was
};

} // namespace arris::ui
