#pragma once

#include "ui/presenters/recipe_book.h"

#include <QDialog>

#include <functional>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace arris::ui {

class RecipeModel;

/// The recipes that have names: load, save, delete, import and export. It is not modal: FEED HOLD and STOP stay within
/// reach. What replaces or deletes one is asked about in the dialog itself.
class RecipeDialog : public QDialog {
  Q_OBJECT

public:
  /// Shows it over `asker`, with which it ends; one that is open already is brought to the front. `isOpen`: recipes can
  /// be saved, deleted and imported, which a code can protect.
  static void show(QWidget& asker, Planner& planner, RecipeBook& book, bool isOpen);

private:
  RecipeDialog(QWidget& asker, Planner& planner, RecipeBook& book, bool isOpen);

  void setUpTable();
  QWidget* makeFilter();
  QWidget* makeActions();
  QWidget* makeSaving();
  QWidget* makeQuestion();
  QPushButton* makeButton(const QString& text, const QString& name, const std::function<void()>& act);
  [[nodiscard]] QString chosen() const;
  void load();
  void save();
  void askToDelete();
  void importFile();
  void exportFile();
  void keepImported(const std::filesystem::path& file);
  void keepAs(const QString& name, const QString& question, const std::function<void()>& act);
  void ask(const QString& question, const std::function<void()>& act);
  void answer(bool yes);
  void tell(const base::Problems& problems, const QString& done);
  void showRecipes();
  void showAllowed();

  Planner& m_planner;
  RecipeBook& m_book;
  bool m_isOpen;
  bool m_thisGlassOnly = false;
  bool m_tellsNone = false; ///< the message says why the list is empty
  RecipeModel* m_model;
  QTableView* m_table;
  QLineEdit* m_name;
  QLabel* m_sign;
  QLabel* m_message;
  QPushButton* m_load;
  QPushButton* m_delete;
  QPushButton* m_import;
  QPushButton* m_export;
  QPushButton* m_save;
  QPushButton* m_yes;
  QPushButton* m_no;
  std::function<void()> m_asked; // what happens at a yes
};

} // namespace arris::ui
