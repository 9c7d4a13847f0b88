#pragma once

#include "ui/figures/figure.h"
#include "ui/figures/profile_path.h"
#include "ui/presenters/planner.h"
#include "ui/presenters/profile_files.h"
#include "ui/presenters/profile_sight.h"

#include <QWidget>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

class QBoxLayout;
class QButtonGroup;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace arris::ui {

class BusyBar;
class InstantValues;
class PathPlot;
class PointedPlot;
class ProfilePlot;

/// The profile of the planned job, or an exported profile or the record of a run over it, with the values at the time
/// that is pointed at: velocities, accelerations and the distance to the corner over time, or the positions, or the
/// path in the plane.
class ProfilesPage : public QWidget {
  Q_OBJECT

public:
  ProfilesPage(Planner& planner, ProfileFiles& files, ProfileSight& sight, QWidget* parent = nullptr);
  ~ProfilesPage() override; ///< what is looked at stands in the sight
  ProfilesPage(const ProfilesPage&) = delete;
  ProfilesPage& operator=(const ProfilesPage&) = delete;
  ProfilesPage(ProfilesPage&&) = delete;
  ProfilesPage& operator=(ProfilesPage&&) = delete;

  /// Shows an exported profile (CSV) or the record of a run. Where it cannot be read, what is shown stays and the
  /// reason is told.
  void openFile(const std::filesystem::path& file);

  /// What is shown as a picture, in the format of the file's ending: SVG, PNG or PDF.
  void savePicture(const std::filesystem::path& file);

  /// The profile of the run whose record is open, else the planned one, as CSV.
  void saveProfile(const std::filesystem::path& file);

  /// The job sheet of the plan, PDF.
  void saveJobSheet(const std::filesystem::path& file);

  [[nodiscard]] bool isBusy() const {
    return m_files.isBusy();
  }

protected:
  void showEvent(QShowEvent* event) override;

private:
  enum class View { Keep, Work };

  using Content = ProfileSight::Content;

  QWidget* makeFileButtons();
  QWidget* makeViewButtons();
  QWidget* makeTexts();
  QWidget* makePlots();
  QToolButton* addButton(QBoxLayout& layout, const QString& text, const char* name, const QString& what,
                         const std::function<void()>& act);
  void addContent(QBoxLayout& layout, Content content, const QString& text, const char* name, const QString& what);
  void connectPlanner();
  void connectFiles();
  void showPlan(const PlanPointer& plan);
  void showProfiles(View view);
  void showContent();
  void showValuesOf(Content content);
  void lookAgain(const ProfileSight& before);
  void feed();
  void feedPlot(Content content, bool keepView);
  void showState();
  void showEnabled();
  void showPlanned();
  void askForFile();
  void askWhere(const QString& title, const QStringList& filters,
                const std::function<void(const std::filesystem::path&)>& save);
  void askForPicture();
  void askForProfile();
  void askForJobSheet();
  void goToNextCorner(int step);
  void goToPass(std::size_t at);
  void showPass(std::size_t at);
  void selectCorner(int corner);
  void markCorner(int corner);
  void pointAt(std::optional<double> time);
  void beginSaving();
  void tellProblem(const base::Problem& problem);
  [[nodiscard]] Content content() const;
  [[nodiscard]] std::array<PointedPlot*, ProfileSight::ContentCount> plots() const; ///< in the order of the contents
  [[nodiscard]] PointedPlot* plot() const;                                          ///< of the content
  [[nodiscard]] ProfilePlot& timePlot() const; ///< of the content, where it is over time
  [[nodiscard]] CurvesPointer actual() const;  ///< of the open file; null without one
  [[nodiscard]] ProfileLimits limits() const;
  [[nodiscard]] Figure picture() const;

  Planner& m_planner;
  ProfileFiles& m_files;
  ProfileSight& m_sight;
  PlanPointer m_plan;
  CurvesPointer m_planned; ///< of the plan; null until it is there, and where the plan cannot be ground
  std::vector<ProfileCurves> m_shown;
  std::vector<CornerPass> m_passes; ///< of what is shown first
  std::optional<base::Problem> m_problem;
  std::optional<std::filesystem::path> m_saved;
  bool m_openIsRecord = false;
  std::array<bool, ProfileSight::ContentCount> m_stale{}; ///< plots that do not show yet what is shown
  std::array<bool, ProfileSight::ContentCount> m_anew{};  ///< and are to show all of it
  QString m_folder;
  ProfilePlot* m_speeds;
  ProfilePlot* m_positions;
  PathPlot* m_path;
  QStackedWidget* m_plots;
  InstantValues* m_values;
  QButtonGroup* m_contents;
  QToolButton* m_back = nullptr;
  QToolButton* m_overlay = nullptr;
  QToolButton* m_saveProfile = nullptr;
  QToolButton* m_saveSheet = nullptr;
  QLabel* m_stateSign;
  QLabel* m_state;
  BusyBar* m_busy;
  std::vector<QToolButton*> m_forProfiles; ///< of use only while something is shown
  std::vector<QToolButton*> m_forCorners;  ///< of use only while it has corners
};

} // namespace arris::ui
