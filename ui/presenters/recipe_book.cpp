#include "ui/presenters/recipe_book.h"

#include "core/files/whole_file.h"
#include "core/recipe/fields.h"
#include "ui/text/quantities.h"

#include <algorithm>
#include <utility>

namespace arris::ui {
namespace {

base::Problems problemsOf(const base::Expected<void>& done) {
  return done ? base::Problems() : base::Problems{done.error()};
}

QString lengthWithUnit(double millimetres) {
  return lengthText(millimetres, 2, QLocale()) + QChar::Space + inShownUnits(QStringLiteral("mm"));
}

} // namespace

RecipeBook::RecipeBook(std::filesystem::path folder, Planner& planner, QObject* parent)
    : QObject(parent), m_folder(std::move(folder)), m_planner(planner) {}

base::Problems RecipeBook::refresh() {
  files::Read<files::NamedRecipes> read = files::readRecipes(m_folder);
  m_recipes = std::move(read.value);
  if (find(m_current) == nullptr) {
    const auto inEffect = std::find_if(m_recipes.begin(), m_recipes.end(), [&](const files::NamedRecipe& recipe) {
      return recipe.recipe == m_planner.recipe();
    });
    m_current = inEffect != m_recipes.end() ? QString::fromStdString(inEffect->name) : QString();
  }
  Q_EMIT changed();
  return read.problems;
}

const files::NamedRecipe* RecipeBook::find(const QString& name) const {
  const auto found = std::find_if(m_recipes.begin(), m_recipes.end(), [&](const files::NamedRecipe& recipe) {
    return QString::fromStdString(recipe.name) == name;
  });
  return found != m_recipes.end() ? &*found : nullptr;
}

bool RecipeBook::isChanged() const {
  const files::NamedRecipe* current = find(m_current);
  return current != nullptr && current->recipe != m_planner.recipe();
}

QString RecipeBook::suggestedName() const {
  const recipe::Recipe& recipe = m_planner.recipe();
  return tr("%1, wheel R %2").arg(lengthWithUnit(recipe.thickness), lengthWithUnit(recipe.wheelRadius));
}

void RecipeBook::setCurrent(const QString& name) {
  m_current = name;
  Q_EMIT changed();
}

base::Problems RecipeBook::load(const QString& name) {
  const files::NamedRecipe* found = find(name);
  if (found == nullptr) {
    return {};
  }
  base::Problems problems = recipe::check(found->recipe, m_planner.machine());
  if (!base::hasErrors(problems)) {
    Q_EMIT loading();
    m_planner.setRecipe(found->recipe);
    setCurrent(name);
  }
  return problems;
}

base::Problems RecipeBook::keep(const QString& name, const recipe::Recipe& recipe) {
  if (!m_keeps) {
    return {};
  }
  base::Problems problems = problemsOf(files::keepRecipe(m_folder, {name.toStdString(), recipe}));
  if (problems.empty()) {
    problems = refresh();
  }
  return problems;
}

base::Problems RecipeBook::save(const QString& name) {
  base::Problems problems = keep(name, m_planner.recipe());
  if (const files::NamedRecipe* kept = find(name); kept != nullptr && kept->recipe == m_planner.recipe()) {
    setCurrent(name);
  }
  return problems;
}

base::Problems RecipeBook::remove(const QString& name) {
  if (!m_keeps) {
    return {};
  }
  base::Problems problems = problemsOf(files::removeRecipe(m_folder, name.toStdString()));
  base::Problems more = refresh();
  problems.insert(problems.end(), more.begin(), more.end());
  return problems;
}

base::Problems RecipeBook::importFile(const std::filesystem::path& file, const QString& name) {
  files::Read<recipe::Recipe> read = files::readRecipeFile(file);
  if (!base::hasErrors(read.problems)) {
    base::Problems more = keep(name, read.value);
    read.problems.insert(read.problems.end(), more.begin(), more.end());
  }
  return read.problems;
}

base::Problems RecipeBook::exportTo(const std::filesystem::path& file, const QString& name) const {
  const files::NamedRecipe* found = find(name);
  return found != nullptr ? problemsOf(files::writeWholeFile(file, files::writeRecipe(found->recipe)))
                          : base::Problems();
}

void RecipeBook::setKeeping(bool keeps) {
  m_keeps = keeps;
  Q_EMIT changed();
}

} // namespace arris::ui
