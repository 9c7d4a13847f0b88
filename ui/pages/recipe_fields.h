#pragma once

#include "core/recipe/fields.h"
#include "ui/presenters/planner.h"

#include <QStackedWidget>

#include <functional>
#include <span>
#include <string_view>
#include <vector>

class QCheckBox;
class QLabel;
class QVBoxLayout;

namespace arris::ui {

class ChoiceEdit;
class NumberEdit;
class PlaceEdit;

/// Every value of the recipe in a field: a page for grinding, one for the pane, and pages for what is seldom changed.
/// Only values that are valid leave it.
class RecipeFields : public QStackedWidget {
  Q_OBJECT

public:
  RecipeFields(recipe::Recipe recipe, const recipe::Machine& machine, QWidget* parent = nullptr);

  enum Page { Grinding, Pane, More };

  /// The pages from `More` on have a heading each.
  [[nodiscard]] const QStringList& moreHeadings() const {
    return m_moreHeadings;
  }

  /// The panel is as high as this page needs, not as the highest of all.
  void showPage(int page);

  /// Shows a recipe that somebody else has changed, without saying so.
  void setRecipe(const recipe::Recipe& recipe);

  /// The plan tells where pane and start are when nobody says so, and which layers there are.
  void setPlan(const Plan& plan);

  /// Whether the values that a code can protect may be changed.
  void setEngineeringEnabled(bool enabled);

  /// Something is typed that cannot be taken.
  [[nodiscard]] bool hasWrongText() const;

  /// What is typed and cannot be taken goes; false where there is none of that.
  bool dropWrongTexts();

  /// The field with this key of the recipe; null where it is no number.
  [[nodiscard]] NumberEdit* field(std::string_view key) const;

Q_SIGNALS:
  void recipeChanged(const arris::recipe::Recipe& recipe);
  void fieldLeft();
  /// What is wrong with a field, in words, with what stays in effect; empty where nothing is.
  void complaintChanged(const QString& complaint);

private:
  QVBoxLayout& addPage();
  QVBoxLayout& addMore(const QString& heading);
  void addNumbers(QVBoxLayout& page, std::span<double recipe::Recipe::*const> members, const recipe::Machine& machine);
  void addChoice(QVBoxLayout& page, std::string_view key);
  void addPlace(QVBoxLayout& page, std::string_view key, const QString& caption, const QString& left);
  void addAcceptUnreached(QVBoxLayout& page);
  void addLayers(QVBoxLayout& page);
  void addMorePages(const recipe::Machine& machine);
  void watch(NumberEdit& edit);
  void change(const std::function<void(recipe::Recipe&)>& edit);
  [[nodiscard]] std::vector<std::string> drawnAndChosenLayers() const;
  void chooseLayer(const std::string& layer, bool isChosen);
  void showLayers();
  void showComplaint();
  void showRimSpeed();

  template <typename Field, typename Edit> struct Of {
    const Field* field;
    Edit* edit;
  };

  recipe::Recipe m_recipe;
  QStringList m_moreHeadings;
  std::vector<Of<recipe::NumberField, NumberEdit>> m_numbers;
  std::vector<Of<recipe::ChoiceField, ChoiceEdit>> m_choices;
  std::vector<Of<recipe::PlaceField, PlaceEdit>> m_places;
  std::vector<NumberEdit*> m_edits; // of numbers and places
  std::vector<std::string> m_drawnLayers;
  std::vector<std::string> m_shownLayers;
  QVBoxLayout* m_layers = nullptr; // a box for each
  QCheckBox* m_accept = nullptr;
  QLabel* m_rimSpeed;
};

/// Speed of the wheel's rim, m/s.
[[nodiscard]] double rimSpeed(const recipe::Recipe& recipe);

} // namespace arris::ui
