#pragma once

#include "core/files/recipe_folder.h"

#include <QAbstractTableModel>

namespace arris::ui {

/// Recipes that have names, one a row, in the order given.
class RecipeModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Name, Thickness, Wheel, Depth, Feed, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void setRecipes(files::NamedRecipes recipes);

  [[nodiscard]] QString name(int row) const;
  [[nodiscard]] int rowOf(const QString& name) const; ///< −1 where there is none

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

private:
  files::NamedRecipes m_recipes;
};

} // namespace arris::ui
