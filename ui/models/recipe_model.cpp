#include "ui/models/recipe_model.h"

#include "ui/text/quantities.h"

#include <algorithm>
#include <utility>

namespace arris::ui {

void RecipeModel::setRecipes(files::NamedRecipes recipes) {
  if (recipes == m_recipes) {
    return;
  }
  beginResetModel();
  m_recipes = std::move(recipes);
  endResetModel();
}

QString RecipeModel::name(int row) const {
  return QString::fromStdString(m_recipes.at(static_cast<std::size_t>(row)).name);
}

int RecipeModel::rowOf(const QString& name) const {
  const auto row = std::find_if(m_recipes.begin(), m_recipes.end(), [&](const files::NamedRecipe& recipe) {
    return QString::fromStdString(recipe.name) == name;
  });
  return row != m_recipes.end() ? static_cast<int>(row - m_recipes.begin()) : -1;
}

int RecipeModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_recipes.size());
}

int RecipeModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant RecipeModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  if (role == Qt::TextAlignmentRole && index.column() != Name) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  const recipe::Recipe& recipe = m_recipes[static_cast<std::size_t>(index.row())].recipe;
  switch (index.column()) {
  case Name:
    return name(index.row());
  case Thickness:
    return lengthText(recipe.thickness, 2, QLocale());
  case Wheel:
    return lengthText(recipe.wheelRadius, 2, QLocale());
  case Depth:
    return lengthText(recipe.depth, 3, QLocale());
  case Feed:
    return lengthText(recipe.feed, 1, QLocale());
  default:
    return {};
  }
}

QVariant RecipeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case Name:
    return tr("Name");
  case Thickness:
    return inShownUnits(tr("Glass\nmm"));
  case Wheel:
    return inShownUnits(tr("Wheel\nmm"));
  case Depth:
    return inShownUnits(tr("Depth\nmm"));
  case Feed:
    return inShownUnits(tr("Feed\nmm/min"));
  default:
    return {};
  }
}

} // namespace arris::ui
