#include "ui/presenters/recipe_history.h"

#include "core/recipe/fields.h"

#include <algorithm>

namespace arris::ui {

RecipeHistory::RecipeHistory(Planner& planner, QObject* parent)
    : QObject(parent), m_planner(planner), m_now(planner.recipe()) {
  connect(&planner, &Planner::recipeChanged, this, &RecipeHistory::take);
}

void RecipeHistory::take(const recipe::Recipe& recipe) {
  const auto keys = recipe::differences(m_now, recipe);
  if (keys.empty()) { // by undo or redo
    return;
  }
  const std::string_view key = keys.size() == 1 ? keys.front() : std::string_view();
  if (key.empty() || key != m_openKey) {
    m_before.push_back(m_now);
    m_before.erase(m_before.begin(), m_before.end() - static_cast<int>(std::min(m_before.size(), kMostSteps)));
  }
  m_openKey = key;
  if (m_before.back() == recipe) { // typed back to what it was: no step
    m_before.pop_back();
    endStep();
  }
  m_after.clear();
  m_now = recipe;
  Q_EMIT changed();
}

void RecipeHistory::undo() {
  move(m_before, m_after);
}

void RecipeHistory::redo() {
  move(m_after, m_before);
}

void RecipeHistory::move(std::vector<recipe::Recipe>& from, std::vector<recipe::Recipe>& to) {
  if (from.empty()) {
    return;
  }
  to.push_back(m_now);
  m_now = from.back();
  from.pop_back();
  endStep();
  m_planner.setRecipe(m_now);
  Q_EMIT changed();
}

void RecipeHistory::forget() {
  m_before.clear();
  m_after.clear();
  endStep();
  Q_EMIT changed();
}

} // namespace arris::ui
