#pragma once

#include "core/files/state_folder.h"
#include "ui/presenters/recipe_book.h"
#include "ui/presenters/recipe_history.h"

namespace arris::ui {

/// What stands beside the planner's recipe: the steps that led to it, and the recipes that have names.
struct RecipeDesk {
  RecipeDesk(Planner& planner, const files::StateFolder& folder) : history(planner), book(folder.recipes(), planner) {
    QObject::connect(&book, &RecipeBook::loading, &history, &RecipeHistory::endStep);
  }

  RecipeHistory history;
  RecipeBook book;
};

} // namespace arris::ui
