#pragma once

#include "core/base/window_thread.h"
#include "ui/presenters/alarms_state.h"
#include "ui/presenters/machine_link.h"
#include "ui/presenters/pattern_shelf.h"
#include "ui/presenters/preferences.h"
#include "ui/presenters/profile_files.h"
#include "ui/presenters/profile_sight.h"
#include "ui/presenters/recipe_desk.h"
#include "ui/presenters/wheel_walk.h"

#include <QMainWindow>
#include <QPointer>
#include <QStackedWidget>

#include <filesystem>

class QMessageBox;

namespace arris::ui {

class AlarmBanner;
class ControlStrip;
class HelpPage;
class WipeCover;

/// The window of the program: an alarm banner above, pages, and beside them the strip with FEED HOLD and STOP. It opens
/// patterns, by dialog or dropped on it. Another language, unit or appearance makes banner, pages and strip anew: what
/// they show lives in the presenters. While the axes move it asks before it closes, and stops them first.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(const MachineSetup& setup, PlannerSteps steps = plannerSteps(), QWidget* parent = nullptr);

  ~MainWindow() override; ///< the pages first: they use the presenters
  MainWindow(const MainWindow&) = delete;
  MainWindow& operator=(const MainWindow&) = delete;
  MainWindow(MainWindow&&) = delete;
  MainWindow& operator=(MainWindow&&) = delete;

  void openPattern(const std::filesystem::path& file);

  /// The last of the recent patterns that is still there; where there is none, a sample.
  void openLast();

  [[nodiscard]] Planner& planner() {
    return m_planner;
  }

  [[nodiscard]] WheelWalk& wheelWalk() {
    return m_wheelWalk;
  }

  [[nodiscard]] MachineLink& machine() {
    return m_machine;
  }

  [[nodiscard]] Preferences& preferences() {
    return m_preferences;
  }

  [[nodiscard]] BackUps& backUps() {
    return m_alarms.backUps;
  }

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void askForPattern();
  void build();
  void addPage(QWidget* page, const QString& text, const QString& name);
  void addShortcuts();
  void showPage(int page);
  void showHelp();
  void setLocked(bool locked);
  void applySettings();
  void tellProblems();
  void showTitle();

  base::WindowThread m_thread; // from here on nothing long runs on it
  Preferences m_preferences;
  Planner m_planner;
  RecipeDesk m_desk;
  WheelWalk m_wheelWalk{m_planner};
  PatternShelf m_shelf;
  MachineLink m_machine;
  ProfileFiles m_profileFiles;
  ProfileSight m_profileSight;
  AlarmsState m_alarms{m_machine};
  files::Settings m_shown; // the settings that the window was built with
  AlarmBanner* m_banner = nullptr;
  ControlStrip* m_strip = nullptr;
  QStackedWidget* m_pages = nullptr;
  WipeCover* m_cover = nullptr;
  HelpPage* m_help = nullptr;
  QTimer m_keepRecipe;
  QPointer<QMessageBox> m_question; // whether to stop and close
  bool m_closes = false;            // as soon as the axes are at rest
};

} // namespace arris::ui
