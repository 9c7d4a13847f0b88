#pragma once

#include "core/control/report.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"

#include <QLabel>
#include <QPushButton>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace arris::test {

/// The pages by the names of their buttons.
inline constexpr const char* kPages[] = {"pageJob",    "pageSetup",    "pageRun", "pageProfiles",
                                         "pageAlarms", "pageSettings", "pageHelp"};

/// The whole window with the simulated machine and a planner that reads panes by name, to be driven as a person would.
class DrivenWindow : public testing::Test {
protected:
  DrivenWindow() : DrivenWindow(control::Pace::Simulated) {}

  explicit DrivenWindow(control::Pace pace) : DrivenWindow(pace, paneSteps()) {}

  DrivenWindow(control::Pace pace, ui::PlannerSteps steps);

  void TearDown() override; ///< puts back what counts for the whole process

  template <typename Widget = QWidget> Widget* find(const char* name) {
    return m_window.findChild<Widget*>(QString::fromLatin1(name));
  }

  QPushButton* button(const char* name) {
    return find<QPushButton>(name);
  }

  QString label(const char* name) {
    return find<QLabel>(name)->text();
  }

  void tap(const char* name); ///< as soon as it can be; it is in sight
  void holdDown(const char* name);
  void settle(); ///< until nothing is planned and the layouts are settled

  /// Now or at some time since the last tap: in fast time states pass quickly.
  [[nodiscard]] bool becomes(control::State state);
  [[nodiscard]] bool becomes(control::JobState state);

  void keep(const std::string& name);

  /// From an empty program to a job that can be started, on the page Run.
  void getReady();

  /// Starts slowly, so that the run is met in its middle.
  void getOntoGlass();

  Scratch m_scratch;
  ui::MainWindow m_window;
  std::set<control::State> m_seen;
};

} // namespace arris::test
