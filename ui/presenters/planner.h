#pragma once

#include "core/base/monitor.h"
#include "core/job/trajectory.h"
#include "core/pattern/pattern.h"
#include "ui/figures/drawing.h"
#include "ui/figures/profile.h"
#include "ui/figures/profile_path.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace arris::ui {

/// A pattern file as it was read, with the options that it was read with.
struct Import {
  std::filesystem::path file;
  pattern::ImportOptions options;
  pattern::Pattern pattern;
  std::string hash; ///< of the file's bytes
};

/// One planning, whole: what was planned, from what, and what there is to show of it. Never changed once made, so it is
/// shared between threads and widgets.
struct Plan {
  std::shared_ptr<const Import> import;
  job::Job job;
  Drawing drawing;         ///< with every problem, those of the job and the repairs of the pattern
  PathSetting pathSetting; ///< of the plot of the path
  std::unique_ptr<const job::Trajectory> trajectory; ///< of the job; null where it cannot be ground
};

using ImportPointer = std::shared_ptr<const Import>;
using PlanPointer = std::shared_ptr<const Plan>;
using CurvesPointer = std::shared_ptr<const ProfileCurves>;

/// The plan of a job that was made of the import.
[[nodiscard]] PlanPointer planOf(ImportPointer import, job::Job job);

/// How the planner does its work; replaced in tests only.
struct PlannerSteps {
  std::function<base::Expected<Import>(const std::filesystem::path&, const pattern::ImportOptions&,
                                       const base::Monitor&)>
      read;
  std::function<job::Job(const pattern::Pattern&, const recipe::Recipe&, const recipe::Machine&, const base::Monitor&)>
      plan;
};

[[nodiscard]] PlannerSteps plannerSteps();

/// Reads and plans in the background. Every change of the pattern or the recipe is a new request; the latest wins: what
/// an earlier one has under way is given up. What was asked for can be cancelled too. All functions are called from,
/// and all signals arrive in, the thread of the object.
class Planner : public QObject {
  Q_OBJECT

public:
  explicit Planner(recipe::Machine machine, PlannerSteps steps = plannerSteps(), QObject* parent = nullptr);
  ~Planner() override; ///< waits until the work under way has given up
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;
  Planner(Planner&&) = delete;
  Planner& operator=(Planner&&) = delete;

  void openPattern(const std::filesystem::path& file);
  void setRecipe(const recipe::Recipe& recipe);

  /// Gives up what is under way. The plan before stays; what was being opened is forgotten, the recipe is not. The next
  /// request plans again.
  void cancel();

  [[nodiscard]] const recipe::Recipe& recipe() const {
    return m_recipe;
  }

  [[nodiscard]] const recipe::Machine& machine() const {
    return m_machine;
  }

  /// The last plan, null before the first; and its profile, null until it is ready and where it cannot be ground.
  [[nodiscard]] const PlanPointer& plan() const {
    return m_plan;
  }

  [[nodiscard]] const CurvesPointer& curves() const {
    return m_curves;
  }

  /// Whether the plan is that of the pattern and the recipe in effect. It is not while it is made, where that was
  /// cancelled, and where the pattern cannot be read again with other options.
  [[nodiscard]] bool isPresent() const {
    return m_plan && m_plan->import == m_import && m_plan->job.recipe == m_recipe;
  }

  /// Why the last pattern could not be opened; none once something else is asked for.
  [[nodiscard]] const std::optional<base::Problem>& openProblem() const {
    return m_openProblem;
  }

  /// Something asked for is not there yet.
  [[nodiscard]] bool isBusy() const {
    return m_busy;
  }

  /// What was asked for last was cancelled.
  [[nodiscard]] bool isCancelled() const {
    return m_cancelled;
  }

  /// Which part of the work is under way, where one is.
  [[nodiscard]] base::Stage stage() const {
    return m_stage;
  }

Q_SIGNALS:
  void busyChanged(bool busy);
  /// Another part of the work has begun.
  void progressed(arris::base::Stage stage);
  /// Another recipe is in effect, whoever has changed it.
  void recipeChanged(const arris::recipe::Recipe& recipe);
  /// The plan for the latest request. With errors among the job's problems it cannot be ground.
  void planned(const arris::ui::PlanPointer& plan);
  /// The profile of that plan; does not come when it cannot be ground.
  void profileReady(const arris::ui::CurvesPointer& curves);
  /// The pattern could not be opened or read; the plan before stays.
  void openFailed(const arris::base::Problem& problem);

private:
  struct Request;

  void request();
  void start();
  void stopAll();
  void work(const Request& request);
  [[nodiscard]] ImportPointer read(const Request& request, const pattern::ImportOptions& options);
  void plan(const Request& request, const ImportPointer& import);
  [[nodiscard]] base::Monitor monitor(const std::stop_token& stop);
  template <typename Call> void deliver(const std::stop_token& stop, Call call);
  void begins(base::Stage stage);
  void giveUpOpening(const base::Problem& problem);
  void finished();
  void setBusy(bool busy);

  recipe::Machine m_machine;
  PlannerSteps m_steps;
  recipe::Recipe m_recipe;
  PlanPointer m_plan;
  CurvesPointer m_curves;
  std::optional<base::Problem> m_openProblem;
  std::optional<std::filesystem::path> m_opening; // not read yet
  ImportPointer m_import;                         // the last that was read
  std::stop_source m_stopReading;                 // of the reading under way
  std::stop_source m_stopPlanning;                // of the rest of it
  base::Stage m_stage = base::Stage::Reading;
  bool m_busy = false;
  bool m_working = false; // after a cancellation for a little longer than it is busy
  bool m_again = false;   // a request came while working
  bool m_cancelled = false;
  QThreadPool m_pool; // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
