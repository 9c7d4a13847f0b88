#pragma once

#include "core/job/job.h"
#include "core/pattern/pattern.h"
#include "ui/figures/drawing.h"
#include "ui/figures/profile.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

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
  Drawing drawing; ///< with every problem, those of the job and the repairs of the pattern
};

using PlanPointer = std::shared_ptr<const Plan>;
using CurvesPointer = std::shared_ptr<const ProfileCurves>;

/// How the planner does its work; replaced in tests only.
struct PlannerSteps {
  std::function<base::Expected<Import>(const std::filesystem::path&, const pattern::ImportOptions&)> read;
  std::function<job::Job(const pattern::Pattern&, const recipe::Recipe&, const recipe::Machine&)> plan;
};

[[nodiscard]] PlannerSteps plannerSteps();

/// Reads and plans in the background. Every change of the pattern or the recipe is a new request; the latest wins: what
/// an earlier one yields after it is dropped. All functions are called from, and all signals arrive in, the thread of
/// the object.
class Planner : public QObject {
  Q_OBJECT

public:
  explicit Planner(recipe::Machine machine, PlannerSteps steps = plannerSteps(), QObject* parent = nullptr);
  ~Planner() override; ///< waits for the work under way
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;
  Planner(Planner&&) = delete;
  Planner& operator=(Planner&&) = delete;

  void openPattern(const std::filesystem::path& file);
  void setRecipe(const recipe::Recipe& recipe);

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

  /// Why the last pattern could not be opened; none once there is another plan.
  [[nodiscard]] const std::optional<base::Problem>& openProblem() const {
    return m_openProblem;
  }

  /// Something asked for is not there yet.
  [[nodiscard]] bool isBusy() const {
    return m_running;
  }

Q_SIGNALS:
  void busyChanged(bool busy);
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
  void work(const Request& request);
  [[nodiscard]] bool isLatest(quint64 number) const;
  [[nodiscard]] std::shared_ptr<const Import> read(const Request& request, const pattern::ImportOptions& options);
  void giveUpOpening(const base::Problem& problem);
  template <typename Call> void deliver(quint64 number, Call call);
  void finished();

  recipe::Machine m_machine;
  PlannerSteps m_steps;
  recipe::Recipe m_recipe;
  PlanPointer m_plan;
  CurvesPointer m_curves;
  std::optional<base::Problem> m_openProblem;
  std::filesystem::path m_file;
  std::shared_ptr<const Import> m_import; // the last that was read
  std::atomic<quint64> m_latest = 0;
  bool m_running = false;
  bool m_reread = false;
  bool m_again = false; // a request came while working
  QThreadPool m_pool;   // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
