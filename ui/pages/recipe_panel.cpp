#include "ui/pages/recipe_panel.h"

#include "ui/pages/recipe_dialog.h"
#include "ui/pages/recipe_fields.h"
#include "ui/text/file_texts.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/sign_button.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kRecipePanelGap = 4; // px
constexpr int kNameHeight = 13;

QString elidedTo(const QLabel& label, const QString& text) {
  return label.fontMetrics().elidedText(text, Qt::ElideMiddle, label.width());
}

} // namespace

RecipePanel::RecipePanel(Planner& planner, RecipeDesk& desk, QWidget* parent)
    : QWidget(parent), m_planner(planner), m_desk(desk), m_open(new QPushButton(tr("&Pattern…"))),
      m_recipes(new QPushButton(tr("&Recipes…"))), m_pattern(new QLabel), m_recipe(new QLabel),
      m_undo(makeSignButton(QStringLiteral("↶"), QStringLiteral("undo"), tr("Undo"))),
      m_redo(makeSignButton(QStringLiteral("↷"), QStringLiteral("redo"), tr("Redo"))), m_moreHeading(new QLabel),
      m_fields(new RecipeFields(planner.recipe(), planner.machine())) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 0);
  layout->setSpacing(2);
  layout->addWidget(makeButtons());
  layout->addWidget(makeNames());
  layout->addWidget(makePages());
  layout->addWidget(makeMore());
  layout->addWidget(m_fields, 1);
  m_undo->setShortcut(QKeySequence::Undo);
  m_redo->setShortcut(QKeySequence::Redo);
  connect(m_open, &QPushButton::clicked, this, &RecipePanel::openRequested);
  connect(m_recipes, &QPushButton::clicked, this, &RecipePanel::askForRecipe);
  connect(m_undo, &QPushButton::clicked, this, &RecipePanel::undo);
  connect(m_redo, &QPushButton::clicked, &desk.history, &RecipeHistory::redo);
  connect(m_fields, &RecipeFields::recipeChanged, &planner, &Planner::setRecipe);
  connect(m_fields, &RecipeFields::fieldLeft, &desk.history, &RecipeHistory::endStep);
  connect(m_fields, &RecipeFields::complaintChanged, this, &RecipePanel::complaintChanged);
  connect(m_fields, &RecipeFields::complaintChanged, this, &RecipePanel::showSteps);
  connect(&planner, &Planner::recipeChanged, m_fields, &RecipeFields::setRecipe);
  connect(&planner, &Planner::recipeChanged, this, &RecipePanel::showNames);
  connect(&desk.book, &RecipeBook::changed, this, &RecipePanel::showNames);
  connect(&desk.history, &RecipeHistory::changed, this, &RecipePanel::showSteps);
  showPage(RecipeFields::Grinding);
  showSteps();
}

QWidget* RecipePanel::makeButtons() {
  m_open->setObjectName(QStringLiteral("open"));
  m_open->setShortcut(QKeySequence::Open);
  m_recipes->setObjectName(QStringLiteral("recipes"));
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kRecipePanelGap);
  row->addWidget(m_open, 1);
  row->addWidget(m_recipes, 1);
  return buttons;
}

QWidget* RecipePanel::makeNames() {
  m_pattern->setObjectName(QStringLiteral("patternName"));
  m_recipe->setObjectName(QStringLiteral("recipeName"));
  auto* names = new QWidget;
  auto* row = new QHBoxLayout(names);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kRecipePanelGap);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  QFont small = font();
  small.setPixelSize(kNameHeight);
  for (QLabel* label : {m_pattern, m_recipe}) {
    label->setFont(small);
    label->setMinimumWidth(1); // a name is shortened, never the buttons
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(label);
  }
  row->addLayout(column, 1);
  row->addWidget(m_undo);
  row->addWidget(m_redo);
  return names;
}

QWidget* RecipePanel::makePages() {
  auto* pages = new Segments({{QStringLiteral("showGrinding"), tr("Grinding")},
                              {QStringLiteral("showPane"), tr("Pane")},
                              {QStringLiteral("showMore"), QStringLiteral("⋯")}});
  pages->findChild<QAbstractButton*>(QStringLiteral("showMore"))->setAccessibleName(tr("More values"));
  connect(pages, &Segments::picked, this,
          [this](int page) { showPage(page == RecipeFields::More ? RecipeFields::More + m_morePage : page); });
  return pages;
}

QWidget* RecipePanel::makeMore() {
  m_more = new QWidget;
  auto* row = new QHBoxLayout(m_more);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kRecipePanelGap);
  const auto addTurn = [&](const QString& sign, const QString& name, const QString& what, int pages) {
    QPushButton* button = makeSignButton(sign, name, what);
    connect(button, &QPushButton::clicked, this, [this, pages] { turn(pages); });
    row->addWidget(button);
  };
  addTurn(QStringLiteral("◀"), QStringLiteral("moreBack"), tr("Page before"), -1);
  m_moreHeading->setObjectName(QStringLiteral("moreHeading"));
  m_moreHeading->setAlignment(Qt::AlignCenter);
  row->addWidget(m_moreHeading, 1);
  addTurn(QStringLiteral("▶"), QStringLiteral("moreOn"), tr("Next page"), 1);
  return m_more;
}

void RecipePanel::showPage(int page) {
  m_more->setVisible(page >= RecipeFields::More);
  m_fields->showPage(page);
  m_moreHeading->setText(m_fields->moreHeadings().at(m_morePage));
}

void RecipePanel::turn(int pages) {
  const auto count = static_cast<int>(m_fields->moreHeadings().size());
  m_morePage = (m_morePage + pages + count) % count;
  showPage(RecipeFields::More + m_morePage);
}

// What cannot be taken goes first: to the eye it was the last change.
void RecipePanel::undo() {
  if (!m_fields->dropWrongTexts()) {
    m_desk.history.undo();
  }
}

void RecipePanel::askForRecipe() {
  RecipeDialog::show(*this, m_planner, m_desk.book, m_isOpen);
}

void RecipePanel::setPlan(const Plan& plan) {
  m_patternName = nameOfFile(plan.import->file);
  m_fields->setPlan(plan);
  showNames();
}

void RecipePanel::setEngineeringEnabled(bool enabled) {
  m_isOpen = enabled;
  m_fields->setEngineeringEnabled(enabled);
}

NumberEdit* RecipePanel::field(std::string_view key) const {
  return m_fields->field(key);
}

void RecipePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showNames();
}

void RecipePanel::showNames() {
  const QString& recipe = m_desk.book.current();
  const QString shown = recipe.isEmpty()          ? tr("Unnamed recipe")
                        : m_desk.book.isChanged() ? tr("%1, changed").arg(recipe)
                                                  : recipe;
  const QString pattern = m_patternName.isEmpty() ? tr("No pattern yet") : m_patternName;
  m_pattern->setToolTip(pattern);
  m_pattern->setText(elidedTo(*m_pattern, pattern));
  m_recipe->setToolTip(shown);
  m_recipe->setText(elidedTo(*m_recipe, shown));
}

void RecipePanel::showSteps() {
  const bool hasWrong = m_fields->hasWrongText();
  m_undo->setEnabled(hasWrong || m_desk.history.canUndo());
  m_redo->setEnabled(m_desk.history.canRedo());
}

} // namespace arris::ui
