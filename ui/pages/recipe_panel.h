#pragma once

#include "ui/presenters/recipe_desk.h"

#include <QWidget>

#include <string_view>

class QLabel;
class QPushButton;

namespace arris::ui {

class NumberEdit;
class RecipeFields;

/// The operator's values: the pattern, the recipe with its name, undo and redo, and a field for every value.
class RecipePanel : public QWidget {
  Q_OBJECT

public:
  RecipePanel(Planner& planner, RecipeDesk& desk, QWidget* parent = nullptr);

  /// Whether the values that a code can protect may be changed.
  void setEngineeringEnabled(bool enabled);

  void setPlan(const Plan& plan);

  /// The field with this key of the recipe; null where it is no number.
  [[nodiscard]] NumberEdit* field(std::string_view key) const;

Q_SIGNALS:
  void openRequested();
  /// What is wrong with a field, in words, with what stays in effect; empty where nothing is.
  void complaintChanged(const QString& complaint);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* makeButtons();
  QWidget* makeNames();
  QWidget* makePages();
  QWidget* makeMore();
  void showPage(int page);
  void turn(int pages);
  void undo();
  void askForRecipe();
  void showNames();
  void showSteps();

  Planner& m_planner;
  RecipeDesk& m_desk;
  QPushButton* m_open;
  QPushButton* m_recipes;
  QLabel* m_pattern;
  QLabel* m_recipe;
  QPushButton* m_undo;
  QPushButton* m_redo;
  QLabel* m_moreHeading;
  QWidget* m_more = nullptr; // turns the pages of what is seldom changed
  RecipeFields* m_fields;
  QString m_patternName;
  int m_morePage = 0;
  bool m_isOpen = true;
};

} // namespace arris::ui
