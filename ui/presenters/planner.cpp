#include "ui/presenters/planner.h"

#include "core/files/file_hash.h"
#include "core/files/whole_file.h"

#include <algorithm>
#include <utility>

namespace arris::ui {
namespace {

// Why there is nothing at all to be seen of a drawing; null where there is something.
const base::Problem* emptiness(const pattern::Pattern& pattern) {
  const auto error = std::find_if(pattern.problems.begin(), pattern.problems.end(), [](const base::Problem& problem) {
    return base::severityOf(problem) == base::Severity::Error;
  });
  const bool isEmpty = pattern.contours.empty() && pattern.loose.empty() && error != pattern.problems.end();
  return isEmpty ? &*error : nullptr;
}

base::Expected<Import> readPattern(const std::filesystem::path& file, const pattern::ImportOptions& options,
                                   const base::Monitor& monitor) {
  return files::readFile(file).and_then([&](const std::string& text) -> base::Expected<Import> {
    Import import{file, options, pattern::readDxf(text, options, monitor), files::fileHash(text)};
    if (const base::Problem* error = emptiness(import.pattern)) {
      return base::Unexpected(*error);
    }
    return import;
  });
}

job::Job planPattern(const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine,
                     const base::Monitor& monitor) {
  return job::planJob(pattern, recipe, machine, toolpath::Leads::With, monitor);
}

void renew(std::stop_source& stop) {
  stop.request_stop();
  stop = std::stop_source();
}

} // namespace

PlanPointer planOf(ImportPointer import, job::Job job) {
  auto plan = std::make_shared<Plan>();
  plan->import = std::move(import);
  plan->job = std::move(job);
  plan->drawing = drawingOf(plan->job, plan->import->pattern);
  plan->pathSetting = pathSettingOf(plan->job, plan->drawing);
  if (!plan->job.pieces.empty()) {
    plan->trajectory = std::make_unique<const job::Trajectory>(plan->job);
  }
  return plan;
}

PlannerSteps plannerSteps() {
  return {readPattern, planPattern};
}

// All that the worker needs, as values.
struct Planner::Request {
  std::filesystem::path file;
  recipe::Recipe recipe;
  ImportPointer import; // null: to be read
  std::stop_token stopReading;
  std::stop_token stopPlanning;
};

Planner::Planner(recipe::Machine machine, PlannerSteps steps, QObject* parent)
    : QObject(parent), m_machine(std::move(machine)), m_steps(std::move(steps)) {
  m_pool.setMaxThreadCount(1);
}

Planner::~Planner() {
  stopAll();
  m_pool.waitForDone();
}

void Planner::stopAll() {
  renew(m_stopReading);
  renew(m_stopPlanning);
}

// Opening the same file again reads it again.
void Planner::openPattern(const std::filesystem::path& file) {
  m_opening = file;
  renew(m_stopReading);
  request();
}

void Planner::setRecipe(const recipe::Recipe& recipe) {
  if (recipe == m_recipe) {
    return;
  }
  if (pattern::importOptions(recipe) != pattern::importOptions(m_recipe)) {
    renew(m_stopReading);
  }
  m_recipe = recipe;
  Q_EMIT recipeChanged(m_recipe);
  request();
}

void Planner::cancel() {
  if (m_busy) {
    stopAll();
    m_opening.reset();
    m_again = false;
    m_cancelled = true;
    setBusy(false);
  }
}

void Planner::request() {
  if (!m_opening && !m_import) {
    return;
  }
  renew(m_stopPlanning);
  m_openProblem.reset();
  m_cancelled = false;
  m_again = m_working;
  if (!m_working) {
    start();
  }
  setBusy(true);
}

void Planner::start() {
  m_working = true;
  m_pool.start(
      [this, request = Request{m_opening ? *m_opening : m_import->file, m_recipe, m_opening ? nullptr : m_import,
                               m_stopReading.get_token(), m_stopPlanning.get_token()}] { work(request); });
}

// Once a stop is requested nothing arrives any more.
template <typename Call> void Planner::deliver(const std::stop_token& stop, Call call) {
  QMetaObject::invokeMethod(
      this,
      [stop, call] {
        if (!stop.stop_requested()) {
          call();
        }
      },
      Qt::QueuedConnection);
}

base::Monitor Planner::monitor(const std::stop_token& stop) {
  return {stop, [this, stop](base::Stage stage) { deliver(stop, [this, stage] { begins(stage); }); }};
}

void Planner::begins(base::Stage stage) {
  m_stage = stage;
  Q_EMIT progressed(stage);
}

// In the worker's thread, as the next two: of the object they read only what never changes.
void Planner::work(const Request& request) {
  ImportPointer import = request.import;
  const pattern::ImportOptions options = pattern::importOptions(request.recipe);
  if (!import || import->options != options) {
    import = read(request, options);
  }
  if (import && !request.stopPlanning.stop_requested()) {
    plan(request, import);
  }
  QMetaObject::invokeMethod(this, &Planner::finished, Qt::QueuedConnection);
}

// What comes to read a pattern is not lost where only other values were asked for meanwhile.
ImportPointer Planner::read(const Request& request, const pattern::ImportOptions& options) {
  base::Expected<Import> opened = m_steps.read(request.file, options, monitor(request.stopReading));
  if (!opened) {
    deliver(request.stopReading, [this, problem = opened.error()] { giveUpOpening(problem); });
    return nullptr;
  }
  auto import = std::make_shared<const Import>(*std::move(opened));
  deliver(request.stopReading, [this, import] {
    m_import = import;
    m_opening.reset();
  });
  return request.stopReading.stop_requested() ? nullptr : import;
}

void Planner::plan(const Request& request, const ImportPointer& import) {
  const std::stop_token& stop = request.stopPlanning;
  const base::Monitor monitored = monitor(stop);
  job::Job job = m_steps.plan(import->pattern, request.recipe, m_machine, monitored);
  if (stop.stop_requested()) {
    return;
  }
  const PlanPointer plan = planOf(import, std::move(job));
  deliver(stop, [this, plan] {
    m_plan = plan;
    m_curves.reset();
    Q_EMIT planned(plan);
  });
  if (!plan->job.canBeGround()) {
    return;
  }
  monitored.begin(base::Stage::Profile);
  const auto wanted = [&] { return !stop.stop_requested(); };
  auto curves = std::make_shared<const ProfileCurves>(curvesOf(columnsOf(plan->job, wanted), QString(), wanted));
  deliver(stop, [this, curves] {
    m_curves = curves;
    Q_EMIT profileReady(curves);
  });
}

// Back to the pattern before. What was under way for it when the other one was to be opened is taken up again.
void Planner::giveUpOpening(const base::Problem& problem) {
  const bool wasAnother = std::exchange(m_opening, std::nullopt).has_value();
  const bool isComplete = isPresent() && (m_curves || !m_plan->job.canBeGround());
  if (wasAnother && !isComplete) {
    request();
  }
  m_openProblem = problem;
  Q_EMIT openFailed(problem);
}

void Planner::finished() {
  const bool hasPattern = m_opening || m_import; // what was to be opened may have come to nothing
  if (std::exchange(m_again, false) && hasPattern) {
    start();
    return;
  }
  m_working = false;
  setBusy(false);
}

void Planner::setBusy(bool busy) {
  if (m_busy != busy) {
    m_busy = busy;
    Q_EMIT busyChanged(busy);
  }
}

} // namespace arris::ui
