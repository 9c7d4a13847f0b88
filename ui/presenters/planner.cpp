#include "ui/presenters/planner.h"

#include "core/files/file_hash.h"
#include "core/files/whole_file.h"

#include <utility>

namespace arris::ui {
namespace {

base::Expected<Import> readPattern(const std::filesystem::path& file, const pattern::ImportOptions& options) {
  return files::readFile(file).map([&](const std::string& text) {
    return Import{file, options, pattern::readDxf(text, options), files::fileHash(text)};
  });
}

job::Job plan(const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine) {
  return job::planJob(pattern, recipe, machine);
}

bool isOf(const Import& import, const std::filesystem::path& file, const pattern::ImportOptions& options) {
  return import.file == file && import.options == options;
}

} // namespace

PlannerSteps plannerSteps() {
  return {readPattern, plan};
}

// All that the worker needs, as values.
struct Planner::Request {
  quint64 number = 0;
  std::filesystem::path file;
  recipe::Recipe recipe;
  std::shared_ptr<const Import> import; // null: to be read
};

Planner::Planner(recipe::Machine machine, PlannerSteps steps, QObject* parent)
    : QObject(parent), m_machine(std::move(machine)), m_steps(std::move(steps)) {
  m_pool.setMaxThreadCount(1);
}

Planner::~Planner() {
  ++m_latest; // what is under way need not go on to its profile
  m_pool.waitForDone();
}

void Planner::openPattern(const std::filesystem::path& file) {
  m_file = file;
  m_reread = true; // opening the same file again reads it again
  request();
}

void Planner::setRecipe(const recipe::Recipe& recipe) {
  if (recipe != m_recipe) {
    m_recipe = recipe;
    Q_EMIT recipeChanged(m_recipe);
    request();
  }
}

void Planner::request() {
  if (m_file.empty()) {
    return;
  }
  ++m_latest;
  m_again = m_running;
  if (!m_running) {
    m_running = true;
    Q_EMIT busyChanged(true);
    start();
  }
}

void Planner::start() {
  m_pool.start([this, request = Request{m_latest, m_file, m_recipe, m_reread ? nullptr : m_import}] { work(request); });
}

bool Planner::isLatest(quint64 number) const {
  return m_latest == number;
}

template <typename Call> void Planner::deliver(quint64 number, Call call) {
  QMetaObject::invokeMethod(
      this,
      [this, number, call] {
        if (isLatest(number)) {
          call();
        }
      },
      Qt::QueuedConnection);
}

// In the worker's thread: of the object it reads only the request number and what never changes.
void Planner::work(const Request& request) {
  std::shared_ptr<const Import> import = request.import;
  const pattern::ImportOptions options = pattern::importOptions(request.recipe);
  if (!import || !isOf(*import, request.file, options)) {
    import = read(request, options);
  }
  if (import && isLatest(request.number)) {
    auto plan = std::make_shared<Plan>();
    plan->import = import;
    plan->job = m_steps.plan(import->pattern, request.recipe, m_machine);
    plan->drawing = drawingOf(plan->job, import->pattern);
    deliver(request.number, [this, plan] {
      m_plan = plan;
      m_curves.reset();
      m_openProblem.reset();
      Q_EMIT planned(plan);
    });
    if (plan->job.canBeGround() && isLatest(request.number)) {
      const ProfileColumns columns = columnsOf(plan->job, [&] { return isLatest(request.number); });
      auto curves = std::make_shared<const ProfileCurves>(curvesOf(columns, QString()));
      deliver(request.number, [this, curves] {
        m_curves = curves;
        Q_EMIT profileReady(curves);
      });
    }
  }
  QMetaObject::invokeMethod(this, &Planner::finished, Qt::QueuedConnection);
}

std::shared_ptr<const Import> Planner::read(const Request& request, const pattern::ImportOptions& options) {
  base::Expected<Import> opened = m_steps.read(request.file, options);
  if (!opened) {
    deliver(request.number, [this, problem = opened.error()] { giveUpOpening(problem); });
    return nullptr;
  }
  auto import = std::make_shared<const Import>(std::move(*opened));
  deliver(request.number, [this, import] {
    m_import = import;
    m_reread = false;
  });
  return import;
}

// Back to the pattern before, with whatever changed in the recipe meanwhile.
void Planner::giveUpOpening(const base::Problem& problem) {
  m_reread = false;
  m_file = m_import ? m_import->file : std::filesystem::path();
  if (m_plan && m_recipe != m_plan->job.recipe) {
    request();
  }
  m_openProblem = problem;
  Q_EMIT openFailed(problem);
}

void Planner::finished() {
  if (std::exchange(m_again, false)) {
    start();
    return;
  }
  m_running = false;
  Q_EMIT busyChanged(false);
}

} // namespace arris::ui
