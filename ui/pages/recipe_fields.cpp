#include "ui/pages/recipe_fields.h"

#include "core/base/numbers.h"
#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/choice_edit.h"
#include "ui/widgets/number_edit.h"
#include "ui/widgets/place_edit.h"
#include "ui/widgets/touch_table.h"

#include <QCheckBox>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace arris::ui {
namespace {

using recipe::Recipe;
using Members = std::span<double Recipe::*const>;

// In the order of the paper's man–machine interface.
constexpr std::array kGrinding{&Recipe::wheelRadius, &Recipe::accelX, &Recipe::accelY, &Recipe::thickness,
                               &Recipe::depth,       &Recipe::feed,   &Recipe::spindle};

// What concerns the pane; the operator's first.
constexpr std::array kPane{&Recipe::sizeCorrection, &Recipe::lead, &Recipe::overlap, &Recipe::rotate, &Recipe::smooth};

constexpr std::array kHeights{&Recipe::wheelHeight, &Recipe::wheelZ, &Recipe::support, &Recipe::clearance};
constexpr std::array kCorners{&Recipe::cornerSpeed, &Recipe::accelZ};
constexpr std::array kDrawing{&Recipe::gap};

double mostOn(const recipe::NumberField& field, const recipe::Machine& machine) {
  constexpr std::array kAccelerations{&Recipe::accelX, &Recipe::accelY, &Recipe::accelZ};
  for (std::size_t axis = 0; axis < kAccelerations.size(); ++axis) {
    if (field.member == kAccelerations.at(axis)) {
      return std::min(field.most, machine.maxAccel[static_cast<int>(axis)]);
    }
  }
  return field.most;
}

template <typename Field> const Field* fieldWith(std::span<const Field> fields, std::string_view key) {
  return &*std::find_if(fields.begin(), fields.end(), [key](const Field& field) { return field.key == key; });
}

} // namespace

double rimSpeed(const Recipe& recipe) {
  return 2 * base::kPi * recipe.wheelRadius / 1000 * recipe.spindle / 60;
}

RecipeFields::RecipeFields(Recipe recipe, const recipe::Machine& machine, QWidget* parent)
    : QStackedWidget(parent), m_recipe(std::move(recipe)), m_rimSpeed(new QLabel) {
  QVBoxLayout& grinding = addPage();
  addNumbers(grinding, kGrinding, machine);
  grinding.addWidget(m_rimSpeed);
  grinding.addStretch(1);
  QVBoxLayout& pane = addPage();
  addNumbers(pane, kPane, machine);
  addAcceptUnreached(pane);
  pane.addStretch(1);
  addMorePages(machine);
  setRecipe(m_recipe);
}

void RecipeFields::addMorePages(const recipe::Machine& machine) {
  QVBoxLayout& heights = addMore(tr("Heights"));
  addNumbers(heights, kHeights, machine);
  heights.addStretch(1);
  QVBoxLayout& corners = addMore(tr("Corners"));
  addNumbers(corners, kCorners, machine);
  addChoice(corners, "acceleration_rule");
  corners.addStretch(1);
  QVBoxLayout& table = addMore(tr("On the table"));
  addChoice(table, "mirror");
  addPlace(table, "place_mm", tr("Lower left corner of the pane"), tr("Centred on the table"));
  table.addStretch(1);
  QVBoxLayout& start = addMore(tr("Start"));
  addChoice(start, "direction");
  addPlace(start, "start_mm", tr("Start near this place"), tr("Left to Arris"));
  start.addStretch(1);
  QVBoxLayout& drawing = addMore(tr("Drawing"));
  addChoice(drawing, "units");
  addNumbers(drawing, kDrawing, machine);
  addLayers(drawing);
}

void RecipeFields::showPage(int page) {
  for (int i = 0; i < count(); ++i) {
    widget(i)->setSizePolicy(QSizePolicy::Preferred, i == page ? QSizePolicy::Preferred : QSizePolicy::Ignored);
  }
  setCurrentIndex(page);
}

QVBoxLayout& RecipeFields::addPage() {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  addWidget(page);
  return *layout;
}

QVBoxLayout& RecipeFields::addMore(const QString& heading) {
  m_moreHeadings.append(heading);
  return addPage();
}

// A complaint is shown, and leaving the field ends what undo takes as one step.
void RecipeFields::watch(NumberEdit& edit) {
  m_edits.push_back(&edit);
  connect(&edit, &NumberEdit::complaintChanged, this, &RecipeFields::showComplaint);
  connect(edit.line(), &QLineEdit::editingFinished, this, &RecipeFields::fieldLeft);
}

void RecipeFields::change(const std::function<void(Recipe&)>& edit) {
  edit(m_recipe);
  showRimSpeed();
  Q_EMIT recipeChanged(m_recipe);
}

void RecipeFields::addNumbers(QVBoxLayout& page, Members members, const recipe::Machine& machine) {
  for (double Recipe::*const member : members) {
    const recipe::NumberField& field = recipe::numberField(member);
    const NumberSpec spec{toQString(field.key), fieldText(field), toQString(field.unit), field.least,
                          mostOn(field, machine)};
    auto* edit = new NumberEdit(spec, m_recipe.*member);
    m_numbers.push_back({&field, edit});
    page.addWidget(edit);
    watch(*edit);
    connect(edit, &NumberEdit::valueChanged, this,
            [this, member](double value) { change([&](Recipe& recipe) { recipe.*member = value; }); });
  }
}

// Units can be left to the file: a word more than the field has, the first.
void RecipeFields::addChoice(QVBoxLayout& page, std::string_view key) {
  const recipe::ChoiceField* field = fieldWith(recipe::choiceFields(), key);
  ChoiceTexts texts = choiceTexts(*field);
  const int offset = field->get(Recipe()) < 0 ? 1 : 0;
  if (offset == 1) {
    texts.words.prepend(tr("as the file says"));
  }
  auto* edit = new ChoiceEdit(toQString(key), texts.caption, texts.words);
  m_choices.push_back({field, edit});
  page.addWidget(edit);
  connect(edit, &ChoiceEdit::picked, this, [this, field, offset](int index) {
    change([&](Recipe& recipe) { field->set(recipe, index - offset); });
    Q_EMIT fieldLeft();
  });
}

void RecipeFields::addPlace(QVBoxLayout& page, std::string_view key, const QString& caption, const QString& left) {
  const recipe::PlaceField* field = fieldWith(recipe::placeFields(), key);
  auto* edit = new PlaceEdit(toQString(key), caption, left, recipe::kFarthestPlace);
  m_places.push_back({field, edit});
  page.addWidget(edit);
  for (NumberEdit* number : edit->numbers()) {
    watch(*number);
  }
  connect(edit, &PlaceEdit::placeChanged, this, [this, field](const std::optional<Eigen::Vector2d>& place) {
    change([&](Recipe& recipe) { recipe.*field->member = place; });
  });
}

void RecipeFields::addAcceptUnreached(QVBoxLayout& page) {
  m_accept = new QCheckBox(tr("Leave unground what\nthe wheel cannot reach"));
  m_accept->setObjectName(QStringLiteral("accept_unreached"));
  page.addWidget(m_accept);
  connect(m_accept, &QCheckBox::toggled, this,
          [this](bool on) { change([on](Recipe& recipe) { recipe.acceptUnreached = on; }); });
}

void RecipeFields::addLayers(QVBoxLayout& page) {
  auto* caption = new QLabel(tr("Only these layers (none chosen: all)"));
  caption->setWordWrap(true);
  auto* layers = new QWidget;
  m_layers = new QVBoxLayout(layers);
  m_layers->setContentsMargins(0, 0, 0, 0);
  m_layers->setSpacing(0);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("layers"));
  scroll->setAccessibleName(tr("Layers"));
  scroll->setWidget(layers);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  makeTouchable(*scroll);
  page.addWidget(caption);
  page.addWidget(scroll, 1);
}

std::vector<std::string> RecipeFields::drawnAndChosenLayers() const {
  std::vector<std::string> all = m_drawnLayers;
  for (const std::string& layer : m_recipe.layers) {
    if (std::find(all.begin(), all.end(), layer) == all.end()) {
      all.push_back(layer);
    }
  }
  return all;
}

void RecipeFields::chooseLayer(const std::string& layer, bool isChosen) {
  change([&](Recipe& recipe) {
    std::erase(recipe.layers, layer);
    if (isChosen) {
      recipe.layers.push_back(layer);
      std::sort(recipe.layers.begin(), recipe.layers.end());
    }
  });
  Q_EMIT fieldLeft();
}

// Boxes are made anew only where there are other layers: a person may be tapping one.
void RecipeFields::showLayers() {
  const std::vector<std::string> all = drawnAndChosenLayers();
  if (all != m_shownLayers) {
    m_shownLayers = all;
    while (QLayoutItem* item = m_layers->takeAt(0)) {
      if (QWidget* box = item->widget()) {
        box->deleteLater(); // it may be the one being tapped
      }
      delete item;
    }
    for (const std::string& layer : all) {
      auto* box = new QCheckBox(QString::fromStdString(layer).replace(QLatin1Char('&'), QLatin1String("&&")));
      m_layers->addWidget(box);
      connect(box, &QCheckBox::toggled, this, [this, layer](bool on) { chooseLayer(layer, on); });
    }
    m_layers->addStretch(1);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto* box = static_cast<QCheckBox*>(m_layers->itemAt(static_cast<int>(i))->widget());
    const QSignalBlocker silent(box);
    box->setChecked(std::find(m_recipe.layers.begin(), m_recipe.layers.end(), all[i]) != m_recipe.layers.end());
  }
}

void RecipeFields::setPlan(const Plan& plan) {
  m_drawnLayers.clear();
  for (const auto& [layer, entities] : plan.import->pattern.layers) {
    m_drawnLayers.push_back(layer);
  }
  showLayers();
  for (const auto& [field, edit] : m_places) {
    if (field->member == &Recipe::place) {
      edit->setDefault(plan.job.placement.place);
    } else if (!plan.drawing.starts.empty()) {
      edit->setDefault(plan.drawing.starts.front().place);
    }
  }
}

// A field that has this value already keeps its text, also a wrong one.
void RecipeFields::setRecipe(const Recipe& recipe) {
  m_recipe = recipe;
  for (const auto& [field, edit] : m_numbers) {
    if (edit->value() != m_recipe.*field->member) {
      edit->setValue(m_recipe.*field->member);
    }
  }
  for (const auto& [field, edit] : m_choices) {
    edit->setChosen(field->get(m_recipe) - std::min(field->get(Recipe()), 0));
  }
  for (const auto& [field, edit] : m_places) {
    edit->setPlace(m_recipe.*field->member);
  }
  const QSignalBlocker silent(m_accept);
  m_accept->setChecked(m_recipe.acceptUnreached);
  showLayers();
  showRimSpeed();
}

void RecipeFields::setEngineeringEnabled(bool enabled) {
  for (const auto& [field, edit] : m_numbers) {
    edit->setEnabled(enabled || !recipe::isEngineering(field->key));
  }
  for (const auto& [field, edit] : m_choices) {
    edit->setEnabled(enabled || !recipe::isEngineering(field->key));
  }
}

bool RecipeFields::hasWrongText() const {
  return std::any_of(m_edits.begin(), m_edits.end(),
                     [](const NumberEdit* edit) { return !edit->complaint().isEmpty(); });
}

bool RecipeFields::dropWrongTexts() {
  bool dropped = false;
  for (NumberEdit* edit : m_edits) {
    if (!edit->complaint().isEmpty()) {
      edit->setValue(edit->value());
      dropped = true;
    }
  }
  return dropped;
}

NumberEdit* RecipeFields::field(std::string_view key) const {
  const auto found = std::find_if(m_numbers.begin(), m_numbers.end(),
                                  [key](const auto& candidate) { return candidate.field->key == key; });
  return found != m_numbers.end() ? found->edit : nullptr;
}

void RecipeFields::showRimSpeed() {
  m_rimSpeed->setText(tr("Rim speed: %1 m/s").arg(fixedText(rimSpeed(m_recipe), 1, QLocale())));
}

// One at a time, that of the field being typed into first: there is no room for more.
void RecipeFields::showComplaint() {
  QString complaint;
  for (const NumberEdit* edit : m_edits) {
    if (!edit->complaint().isEmpty() && (complaint.isEmpty() || edit->line()->hasFocus())) {
      complaint = edit->complaint();
    }
  }
  Q_EMIT complaintChanged(complaint.isEmpty()
                              ? complaint
                              : complaint + QLatin1Char('\n') + tr("The drawing still shows the last valid values."));
}

} // namespace arris::ui
