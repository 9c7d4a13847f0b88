#pragma once

#include "core/recipe/recipe.h"

#include <QWidget>

#include <string_view>
#include <vector>

class QLabel;
class QPushButton;

namespace arris::ui {

class NumberEdit;

/// The operator's values: the pattern, and the fields of the paper's man–machine interface. Only values that are valid
/// leave it.
class RecipePanel : public QWidget {
  Q_OBJECT

public:
  RecipePanel(const recipe::Recipe& recipe, const recipe::Machine& machine, QWidget* parent = nullptr);

  [[nodiscard]] const recipe::Recipe& recipe() const {
    return m_recipe;
  }

  /// The name of the pattern that is shown.
  void setPatternName(const QString& name);

  /// The field with this key of the recipe; null where the panel has none.
  [[nodiscard]] NumberEdit* field(std::string_view key) const;

Q_SIGNALS:
  void recipeChanged(const arris::recipe::Recipe& recipe);
  void openRequested();

private:
  void take(const NumberEdit& field);
  void showComplaint();
  void showRimSpeed();

  recipe::Recipe m_recipe;
  QPushButton* m_open;
  QLabel* m_pattern;
  std::vector<NumberEdit*> m_fields;
  QLabel* m_rimSpeed;
  QLabel* m_complaint;
};

/// Speed of the wheel's rim, m/s.
[[nodiscard]] double rimSpeed(const recipe::Recipe& recipe);

} // namespace arris::ui
