#include "ui/pages/recipe_panel.h"

#include "core/base/numbers.h"
#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/number_edit.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace arris::ui {
namespace {

// In the order of the paper's man–machine interface.
constexpr std::array<std::string_view, 7> kKeys{"wheel_radius_mm", "accel_x_mm_s2", "accel_y_mm_s2", "thickness_mm",
                                                "depth_mm",        "feed_mm_min",   "spindle_r_min"};

// What concerns the pane; the operator's first.
constexpr std::array<std::string_view, 5> kPaneKeys{"size_correction_mm", "lead_mm", "overlap_mm", "rotate_deg",
                                                    "smooth_mm"};

QString toText(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

NumberSpec specOf(const recipe::NumberField& field, double most) {
  return {toText(field.key), fieldText(field), toText(field.unit), field.least, std::min(most, field.most)};
}

double mostOn(const recipe::NumberField& field, const recipe::Machine& machine) {
  if (field.member == &recipe::Recipe::accelX) {
    return machine.maxAccel.x();
  }
  return field.member == &recipe::Recipe::accelY ? machine.maxAccel.y() : field.most;
}

const recipe::NumberField& fieldOf(std::string_view key) {
  const auto fields = recipe::numberFields();
  return *std::find_if(fields.begin(), fields.end(), [key](const recipe::NumberField& f) { return f.key == key; });
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
  QWidget* grinding = makePage(kKeys, machine);
  grinding->layout()->addWidget(m_rimSpeed);
  QWidget* pane = makePage(kPaneKeys, machine);
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
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* group = new QButtonGroup(this);
  const std::array<std::pair<QString, QString>, 2> pages{
      {{tr("Grinding"), QStringLiteral("showGrinding")}, {tr("Pane"), QStringLiteral("showPane")}}};
  for (int i = 0; i < 2; ++i) {
    const auto& [text, name] = pages.at(static_cast<std::size_t>(i));
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setCheckable(true);
    button->setChecked(i == 0);
    group->addButton(button, i);
    layout->addWidget(button, 1);
  }
  connect(group, &QButtonGroup::idClicked, m_pages, &QStackedWidget::setCurrentIndex);
  return row;
}

QWidget* RecipePanel::makePage(std::span<const std::string_view> keys, const recipe::Machine& machine) {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  for (const std::string_view key : keys) {
    const recipe::NumberField& field = fieldOf(key);
    auto* edit = new NumberEdit(specOf(field, mostOn(field, machine)), m_recipe.*field.member);
    m_fields.push_back(edit);
    layout->addWidget(edit);
    connect(edit, &NumberEdit::valueChanged, this, [this, member = field.member](double value) {
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
                                  [key](const NumberEdit* edit) { return edit->spec().name == toText(key); });
  return found != m_fields.end() ? *found : nullptr;
}

void RecipePanel::showRimSpeed() {
  m_rimSpeed->setText(tr("Rim speed: %1 m/s").arg(fixedText(rimSpeed(m_recipe), 1, QLocale())));
}

// One at a time, that of the field being typed into first: there is no room for more.
void RecipePanel::showComplaint() {
  QString complaint;
  for (const NumberEdit* edit : m_fields) {
    if (!edit->complaint().isEmpty() && (complaint.isEmpty() || edit->line()->hasFocus())) {
      complaint = edit->complaint();
    }
  }
  Q_EMIT complaintChanged(complaint.isEmpty()
                              ? complaint
                              : complaint + QLatin1Char('\n') + tr("The drawing still shows the last valid values."));
}

} // namespace arris::ui
