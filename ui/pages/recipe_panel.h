#pragma once

#include "core/recipe/fields.h"

#include <QWidget>

#include <span>
#include <string_view>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace arris::ui {

class NumberEdit;

/// The operator's values: the pattern, the fields of the paper's man–machine interface, and on a second page what
/// concerns the pane. Only values that are valid leave it.
class RecipePanel : public QWidget {
  Q_OBJECT

public:
  RecipePanel(recipe::Recipe recipe, const recipe::Machine& machine, QWidget* parent = nullptr);

  [[nodiscard]] const recipe::Recipe& recipe() const {
    return m_recipe;
  }

  /// Shows a recipe that somebody else has changed, without saying so.
  void setRecipe(const recipe::Recipe& recipe);

  /// Whether the values that a code can protect may be changed.
  void setEngineeringEnabled(bool enabled);

  /// The name of the pattern that is shown.
  void setPatternName(const QString& name);

  /// The field with this key of the recipe; null where the panel has none.
  [[nodiscard]] NumberEdit* field(std::string_view key) const;

Q_SIGNALS:
  void recipeChanged(const arris::recipe::Recipe& recipe);
  void openRequested();
  /// What is wrong with a field, in words, with what stays in effect; empty where nothing is.
  void complaintChanged(const QString& complaint);

private:
  struct Field {
    NumberEdit* edit;
    double recipe::Recipe::*member;
  };

  QWidget* makePages();
  QWidget* makePage(std::span<double recipe::Recipe::*const> members, const recipe::Machine& machine);
  QCheckBox* makeAcceptUnreached();
  void showComplaint();
  void showRimSpeed();

  recipe::Recipe m_recipe;
  QPushButton* m_open;
  QLabel* m_pattern;
  QStackedWidget* m_pages;
  std::vector<Field> m_fields;
  QCheckBox* m_accept = nullptr;
  QLabel* m_rimSpeed;
};

/// Speed of the wheel's rim, m/s.
[[nodiscard]] double rimSpeed(const recipe::Recipe& recipe);

} // namespace arris::ui
