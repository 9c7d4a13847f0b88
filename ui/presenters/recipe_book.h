#pragma once

#include "core/files/recipe_folder.h"
#include "ui/presenters/planner.h"

#include <QObject>
#include <QString>

namespace arris::ui {

/// The recipes that have names, each a file of the state folder. What goes wrong is told and changes nothing.
class RecipeBook : public QObject {
  Q_OBJECT

public:
  RecipeBook(std::filesystem::path folder, Planner& planner, QObject* parent = nullptr);

  /// By thickness of the glass, then by name.
  [[nodiscard]] const files::NamedRecipes& recipes() const {
    return m_recipes;
  }

  [[nodiscard]] const files::NamedRecipe* find(const QString& name) const; ///< null where there is none

  /// The one that was loaded or saved last, or that is in effect; empty where none.
  [[nodiscard]] const QString& current() const {
    return m_current;
  }

  /// Whether the recipe in effect has another value than that one.
  [[nodiscard]] bool isChanged() const;

  /// "12 mm, wheel 75 mm": a name for the recipe in effect, so that nobody must type one.
  [[nodiscard]] QString suggestedName() const;

  // Each says what was wrong: with errors among it, nothing has happened.
  base::Problems load(const QString& name); ///< into effect
  base::Problems save(const QString& name); ///< the recipe in effect, over an earlier one of this name
  base::Problems remove(const QString& name);
  base::Problems importFile(const std::filesystem::path& file, const QString& name); ///< kept, not put into effect
  [[nodiscard]] base::Problems exportTo(const std::filesystem::path& file, const QString& name) const;

  /// Reads the folder anew; what is damaged there is set aside and told.
  base::Problems refresh();

  [[nodiscard]] bool keeps() const {
    return m_keeps;
  }

  /// Off: nothing is written any more, since the files have been replaced by others.
  void setKeeping(bool keeps);

Q_SIGNALS:
  void changed(); ///< the recipes, or which is current
  void loading(); ///< another recipe is about to be in effect

private:
  base::Problems keep(const QString& name, const recipe::Recipe& recipe);
  void setCurrent(const QString& name);

  std::filesystem::path m_folder;
  Planner& m_planner;
  files::NamedRecipes m_recipes;
  QString m_current;
  bool m_keeps = true;
};

} // namespace arris::ui
