#include "ui/pages/recipe_panel.h"

#include "core/base/numbers.h"
#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/number_edit.h"
#include "ui/widgets/segments.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace arris::ui {
namespace {

// In the order of the paper's man–machine interface.
constexpr std::array kGrinding{&recipe::Recipe::wheelRadius, &recipe::Recipe::accelX, &recipe::Recipe::accelY,
                               &recipe::Recipe::thickness,   &recipe::Recipe::depth,  &recipe::Recipe::feed,
                               &recipe::Recipe::spindle};

// What concerns the pane; the operator's first.
constexpr std::array kPane{&recipe::Recipe::sizeCorrection, &recipe::Recipe::lead, &recipe::Recipe::overlap,
                           &recipe::Recipe::rotate, &recipe::Recipe::smooth};

// What a code can protect.
constexpr std::array kEngineering{&recipe::Recipe::accelX, &recipe::Recipe::accelY};

NumberSpec specOf(const recipe::NumberField& field, double most) {
  return {toQString(field.key), fieldText(field), toQString(field.unit), field.least, std::min(most, field.most)};
}

double mostOn(const recipe::NumberField& field, const recipe::Machine& machine) {
  if (field.member == &recipe::Recipe::accelX) {
    return machine.maxAccel.x();
  }
  return field.member == &recipe::Recipe::accelY ? machine.maxAccel.y() : field.most;
}

} // namespace

double rimSpeed(const recipe::Recipe& recipe) {
  return 2 * base::kPi * recipe.wheelRadius / 1000 * recipe.spindle / 60;
}

RecipePanel::RecipePanel(recipe::Recipe recipe, const recipe::Machine& machine, QWidget* parent)
    : QWidget(parent), m_recipe(std::move(recipe)), m_open(new QPushButton(tr("&Open pattern…"))),
      m_pattern(new QLabel), m_pages(new QStackedWidget), m_rimSpeed(new QLabel) {
  m_open->setObjectName(QStringLiteral("open"));
  m_open->setShortcut(QKeySequence::Open);
  QWidget* grinding = makePage(kGrinding, machine);
  grinding->layout()->addWidget(m_rimSpeed);
  QWidget* pane = makePage(kPane, machine);
  pane->layout()->addWidget(makeAcceptUnreached());
  for (QWidget* page : {grinding, pane}) {
    static_cast<QVBoxLayout*>(page->layout())->addStretch(1);
    m_pages->addWidget(page);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 0);
  layout->setSpacing(2);
  layout->addWidget(m_open);
  layout->addWidget(m_pattern);
  layout->addWidget(makePages());
  layout->addWidget(m_pages);
  layout->addStretch(1);
  connect(m_open, &QPushButton::clicked, this, &RecipePanel::openRequested);
  setPatternName({});
  showRimSpeed();
}

// Which of the two pages is shown.
QWidget* RecipePanel::makePages() {
  auto* pages =
      new Segments({{QStringLiteral("showGrinding"), tr("Grinding")}, {QStringLiteral("showPane"), tr("Pane")}});
  connect(pages, &Segments::picked, m_pages, &QStackedWidget::setCurrentIndex);
  return pages;
}

QWidget* RecipePanel::makePage(std::span<double recipe::Recipe::*const> members, const recipe::Machine& machine) {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  for (double recipe::Recipe::*const member : members) {
    const recipe::NumberField& field = recipe::numberField(member);
    auto* edit = new NumberEdit(specOf(field, mostOn(field, machine)), m_recipe.*member);
    m_fields.push_back({edit, member});
    layout->addWidget(edit);
    connect(edit, &NumberEdit::valueChanged, this, [this, member](double value) {
      m_recipe.*member = value;
      showRimSpeed();
      Q_EMIT recipeChanged(m_recipe);
    });
    connect(edit, &NumberEdit::complaintChanged, this, &RecipePanel::showComplaint);
  }
  return page;
}

QCheckBox* RecipePanel::makeAcceptUnreached() {
  auto* accept = new QCheckBox(tr("Leave unground what\nthe wheel cannot reach"));
  m_accept = accept;
  accept->setObjectName(QStringLiteral("accept_unreached"));
  accept->setChecked(m_recipe.acceptUnreached);
  connect(accept, &QCheckBox::toggled, this, [this](bool on) {
    m_recipe.acceptUnreached = on;
    Q_EMIT recipeChanged(m_recipe);
  });
  return accept;
}

void RecipePanel::setPatternName(const QString& name) {
  m_pattern->setToolTip(name);
  m_pattern->setText(name.isEmpty() ? tr("No pattern yet")
                                    : fontMetrics().elidedText(name, Qt::ElideMiddle, width() - 16));
}

NumberEdit* RecipePanel::field(std::string_view key) const {
  const auto found = std::find_if(m_fields.begin(), m_fields.end(),
                                  [key](const Field& field) { return field.edit->spec().name == toQString(key); });
  return found != m_fields.end() ? found->edit : nullptr;
}

// A field that has this value already keeps its text, also a wrong one.
void RecipePanel::setRecipe(const recipe::Recipe& recipe) {
  m_recipe = recipe;
  for (const auto& [edit, member] : m_fields) {
    if (edit->value() != m_recipe.*member) {
      edit->setValue(m_recipe.*member);
    }
  }
  const QSignalBlocker silent(m_accept);
  m_accept->setChecked(m_recipe.acceptUnreached);
  showRimSpeed();
}

void RecipePanel::setEngineeringEnabled(bool enabled) {
  for (const auto& [edit, member] : m_fields) {
    edit->setEnabled(enabled || std::find(kEngineering.begin(), kEngineering.end(), member) == kEngineering.end());
  }
}

void RecipePanel::showRimSpeed() {
  m_rimSpeed->setText(tr("Rim speed: %1 m/s").arg(fixedText(rimSpeed(m_recipe), 1, QLocale())));
}

// One at a time, that of the field being typed into first: there is no room for more.
void RecipePanel::showComplaint() {
  QString complaint;
  for (const auto& [edit, member] : m_fields) {
    if (!edit->complaint().isEmpty() && (complaint.isEmpty() || edit->line()->hasFocus())) {
      complaint = edit->complaint();
    }
  }
  Q_EMIT complaintChanged(complaint.isEmpty()
                              ? complaint
                              : complaint + QLatin1Char('\n') + tr("The drawing still shows the last valid values."));
}

} // namespace arris::ui
