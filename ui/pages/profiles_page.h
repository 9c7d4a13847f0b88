#pragma once

#include "ui/presenters/planner.h"
#include "ui/presenters/profile_files.h"

#include <QWidget>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

class QBoxLayout;
class QLabel;
class QToolButton;

namespace arris::ui {

class BusyBar;
class InstantValues;
class ProfilePlot;

/// The profile of the planned job, or an exported profile or the record of a run over it: velocities, accelerations and
/// the distance to the corner over time, with the values at the time that is pointed at.
class ProfilesPage : public QWidget {
  Q_OBJECT

public:
  explicit ProfilesPage(Planner& planner, QWidget* parent = nullptr);

  /// Shows an exported profile (CSV) or the record of a run. Where it cannot be read, what is shown stays and the
  /// reason is told.
  void openFile(const std::filesystem::path& file);

  /// What is shown as a picture, in the format of the file's ending: SVG, PNG or PDF.
  void savePicture(const std::filesystem::path& file);

  [[nodiscard]] bool isBusy() const {
    return m_files.isBusy();
  }

private:
  enum class View { Keep, Work };

  QWidget* makeButtons();
  QWidget* makeTexts();
  QToolButton* addButton(QBoxLayout& layout, const QString& text, const char* name, const QString& what,
                         const std::function<void()>& act);
  void connectPlanner();
  void connectFiles();
  void showPlan(const PlanPointer& plan);
  void showProfiles(View view);
  void showState();
  void showPlanned();
  void askForFile();
  void askForPicture();
  void goToNextCorner(int step);
  void goToPass(std::size_t at);
  void selectCorner(int corner);
  void pointAt(std::optional<double> time);
  void tellProblem(const base::Problem& problem);

  Planner& m_planner;
  ProfileFiles m_files;
  PlanPointer m_plan;
  CurvesPointer m_planned; ///< of the plan; null until it is there, and where the plan cannot be ground
  CurvesPointer m_actual;  ///< of the open file; null without one
  base::Problems m_damage; ///< of the open file
  std::vector<ProfileCurves> m_shown;
  std::vector<CornerPass> m_passes; ///< of what is shown first
  std::optional<std::size_t> m_pass;
  std::optional<double> m_instant;
  std::optional<base::Problem> m_problem;
  std::optional<std::filesystem::path> m_saved;
  QString m_folder;
  ProfilePlot* m_plot;
  InstantValues* m_values;
  QToolButton* m_back = nullptr;
  QToolButton* m_overlay = nullptr;
  QLabel* m_stateSign;
  QLabel* m_state;
  BusyBar* m_busy;
  std::vector<QToolButton*> m_forProfiles; ///< of use only while something is shown
  std::vector<QToolButton*> m_forCorners;  ///< of use only while it has corners
};

} // namespace arris::ui
