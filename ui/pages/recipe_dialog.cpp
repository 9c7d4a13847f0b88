#include "ui/pages/recipe_dialog.h"

#include "ui/models/recipe_model.h"
#include "ui/text/file_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/widgets/file_question.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/touch_table.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <utility>

namespace arris::ui {
namespace {

constexpr QSize kRecipeDialog(760, 600);
constexpr int kRecipeSign = 24; // px
constexpr int kRecipeMessageLines = 3;
constexpr int kActionsWidth = 180;

QStringList recipeFilters() {
  return RecipeDialog::tr("Recipes (*.json);;All files (*)").split(QStringLiteral(";;"));
}

} // namespace

void RecipeDialog::show(QWidget& asker, Planner& planner, RecipeBook& book, bool isOpen) {
  auto* dialog = asker.findChild<RecipeDialog*>(QString(), Qt::FindDirectChildrenOnly);
  if (dialog == nullptr) {
    dialog = new RecipeDialog(asker, planner, book, isOpen);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(false);
    dialog->QDialog::show();
  }
  dialog->raise();
  dialog->activateWindow();
}

RecipeDialog::RecipeDialog(QWidget& asker, Planner& planner, RecipeBook& book, bool isOpen)
    : QDialog(&asker), m_planner(planner), m_book(book), m_isOpen(isOpen), m_model(new RecipeModel(this)),
      m_table(new QTableView), m_name(new QLineEdit), m_sign(new QLabel), m_message(new QLabel),
      m_load(makeButton(tr("Load"), QStringLiteral("recipeLoad"), [this] { load(); })),
      m_delete(makeButton(tr("Delete"), QStringLiteral("recipeDelete"), [this] { askToDelete(); })),
      m_import(makeButton(tr("Import…"), QStringLiteral("recipeImport"), [this] { importFile(); })),
      m_export(makeButton(tr("Export…"), QStringLiteral("recipeExport"), [this] { exportFile(); })),
      m_save(makeButton(tr("Save"), QStringLiteral("recipeSave"), [this] { save(); })),
      m_yes(makeButton(tr("Yes"), QStringLiteral("recipeYes"), [this] { answer(true); })),
      m_no(makeButton(tr("No"), QStringLiteral("recipeNo"), [this] { answer(false); })) {
  setWindowTitle(tr("Recipes"));
  setObjectName(QStringLiteral("recipeDialog"));
  resize(kRecipeDialog);
  setUpTable();
  auto* list = new QHBoxLayout;
  list->addWidget(m_table, 1);
  list->addWidget(makeActions());
  auto* column = new QVBoxLayout(this);
  column->addWidget(makeFilter());
  column->addLayout(list, 1);
  column->addWidget(makeSaving());
  column->addWidget(makeQuestion());
  connect(&book, &RecipeBook::changed, this, &RecipeDialog::showRecipes);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &RecipeDialog::showAllowed);
  connect(m_table, &QTableView::doubleClicked, this, &RecipeDialog::load);
  connect(m_name, &QLineEdit::textChanged, this, &RecipeDialog::showAllowed);
  tell(m_book.refresh(), QString());
  m_name->setText(book.current().isEmpty() ? book.suggestedName() : book.current());
  showRecipes();
}

QPushButton* RecipeDialog::makeButton(const QString& text, const QString& name, const std::function<void()>& act) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setAutoDefault(false);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void RecipeDialog::setUpTable() {
  m_table->setObjectName(QStringLiteral("recipeTable"));
  m_table->setAccessibleName(tr("Recipes"));
  m_table->setModel(m_model);
  makeTouchTable(*m_table);
  m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(RecipeModel::Name, QHeaderView::Stretch);
}

QWidget* RecipeDialog::makeFilter() {
  auto* filter = new Segments({{QStringLiteral("recipesAll"), tr("All recipes")},
                               {QStringLiteral("recipesOfGlass"), tr("For the glass thickness set now")}});
  connect(filter, &Segments::picked, this, [this](int which) {
    m_thisGlassOnly = which == 1;
    showRecipes();
  });
  return filter;
}

QWidget* RecipeDialog::makeActions() {
  auto* actions = new QWidget;
  actions->setFixedWidth(kActionsWidth);
  auto* column = new QVBoxLayout(actions);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_load);
  column->addWidget(m_delete);
  column->addSpacing(kRecipeSign);
  column->addWidget(m_import);
  column->addWidget(m_export);
  column->addStretch(1);
  column->addWidget(makeButton(tr("Close"), QStringLiteral("recipeClose"), [this] { close(); }));
  return actions;
}

QWidget* RecipeDialog::makeSaving() {
  m_name->setObjectName(QStringLiteral("newRecipe"));
  m_name->setMaxLength(static_cast<int>(files::kLongestRecipeName));
  auto* label = new QLabel(tr("Save the values in effect as"));
  label->setBuddy(m_name);
  m_save->setFixedWidth(kActionsWidth);
  auto* saving = new QWidget;
  auto* row = new QHBoxLayout(saving);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label);
  row->addWidget(m_name, 1);
  row->addWidget(m_save);
  connect(m_name, &QLineEdit::returnPressed, m_save, &QPushButton::click);
  return saving;
}

QWidget* RecipeDialog::makeQuestion() {
  m_sign->setFixedSize(kRecipeSign, kRecipeSign);
  m_message->setObjectName(QStringLiteral("recipeMessage"));
  m_message->setWordWrap(true);
  m_message->setTextFormat(Qt::PlainText);                                        // names may hold anything
  m_message->setMinimumHeight(kRecipeMessageLines * fontMetrics().lineSpacing()); // nothing jumps when it fills
  auto* question = new QWidget;
  auto* row = new QHBoxLayout(question);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_sign);
  row->addWidget(m_message, 1);
  row->addWidget(m_yes);
  row->addWidget(m_no);
  return question;
}

QString RecipeDialog::chosen() const {
  const QModelIndex row = m_table->currentIndex();
  return row.isValid() ? m_model->name(row.row()) : QString();
}

void RecipeDialog::load() {
  const QString name = chosen();
  tell(m_book.load(name), tr("“%1” is in effect.").arg(name));
  m_name->setText(m_book.current());
}

void RecipeDialog::save() {
  const QString name = m_name->text();
  keepAs(name, tr("Replace “%1” by the values in effect?").arg(name),
         [this, name] { tell(m_book.save(name), tr("Saved as “%1”.").arg(name)); });
}

// Nothing of that name is replaced unasked.
void RecipeDialog::keepAs(const QString& name, const QString& question, const std::function<void()>& act) {
  if (m_book.find(name) != nullptr) {
    ask(question, act);
  } else {
    act();
  }
}

void RecipeDialog::askToDelete() {
  const QString name = chosen();
  ask(tr("Delete “%1”?").arg(name), [this, name] { tell(m_book.remove(name), tr("“%1” is deleted.").arg(name)); });
}

void RecipeDialog::importFile() {
  askForFile(*this, {tr("Import a recipe"), QString(), recipeFilters()},
             [this](const std::filesystem::path& file) { keepImported(file); });
}

void RecipeDialog::keepImported(const std::filesystem::path& file) {
  const QString name = QFileInfo(QString::fromStdString(file.string())).completeBaseName().trimmed();
  keepAs(name, tr("Replace “%1” by the file?").arg(name), [this, file, name] {
    tell(m_book.importFile(file, name), tr("Imported as “%1”; it is not in effect yet.").arg(name));
  });
}

void RecipeDialog::exportFile() {
  const QString name = chosen();
  askForFile(*this, {tr("Export a recipe"), name + QStringLiteral(".json"), recipeFilters(), true},
             [this, name](const std::filesystem::path& file) {
               tell(m_book.exportTo(file, name), tr("“%1” is written to %2.").arg(name, nameOfFile(file)));
             });
}

void RecipeDialog::ask(const QString& question, const std::function<void()>& act) {
  m_asked = act;
  m_tellsNone = false;
  m_sign->setPixmap({});
  m_message->setText(question);
  showAllowed();
}

void RecipeDialog::answer(bool yes) {
  const std::function<void()> act = std::exchange(m_asked, {});
  m_message->clear();
  if (yes && act) {
    act();
  }
  showAllowed();
}

void RecipeDialog::tell(const base::Problems& problems, const QString& done) {
  QStringList lines;
  for (const base::Problem& problem : problems) {
    lines.append(problemText(problem, QLocale()));
  }
  const bool hasFailed = base::hasErrors(problems);
  if (!hasFailed && !done.isEmpty()) {
    lines.prepend(done);
  }
  m_sign->setPixmap(problems.empty()
                        ? QPixmap()
                        : signIcon(hasFailed ? base::Severity::Error : base::Severity::Warning).pixmap(kRecipeSign));
  m_tellsNone = false;
  m_message->setText(breakableAtFolders(lines.join(QLatin1Char('\n'))));
  showRecipes();
}

void RecipeDialog::showRecipes() {
  files::NamedRecipes shown = m_book.recipes();
  if (m_thisGlassOnly) {
    const double thickness = m_planner.recipe().thickness;
    std::erase_if(shown, [&](const files::NamedRecipe& recipe) { return recipe.recipe.thickness != thickness; });
  }
  const QString before = chosen().isEmpty() ? m_book.current() : chosen();
  const QString none =
      m_book.recipes().empty() ? tr("No recipe has been saved yet.") : tr("No recipe is for this thickness of glass.");
  if (m_message->text().isEmpty() || m_tellsNone) {
    m_tellsNone = shown.empty();
    m_message->setText(m_tellsNone ? none : QString());
  }
  m_model->setRecipes(std::move(shown));
  const int row = m_model->rowOf(before);
  m_table->setCurrentIndex(row >= 0 ? m_model->index(row, 0) : QModelIndex());
  showAllowed();
}

void RecipeDialog::showAllowed() {
  const bool mayWrite = m_isOpen && m_book.keeps() && !m_asked;
  const bool hasChosen = !chosen().isEmpty() && !m_asked;
  m_load->setEnabled(hasChosen);
  m_export->setEnabled(hasChosen);
  m_delete->setEnabled(hasChosen && mayWrite);
  m_import->setEnabled(mayWrite);
  m_save->setEnabled(mayWrite && files::isRecipeName(m_name->text().toStdString()));
  m_yes->setVisible(static_cast<bool>(m_asked));
  m_no->setVisible(static_cast<bool>(m_asked));
}

} // namespace arris::ui
