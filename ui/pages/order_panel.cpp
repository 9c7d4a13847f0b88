#include "ui/pages/order_panel.h"

#include "core/files/run_record.h"
#include "core/recipe/fields.h"
#include "ui/text/file_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/number_edit.h"
#include "ui/widgets/sign_button.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace arris::ui {

using control::JobState;
using files::Verdict;

namespace {

constexpr int kApart = 12; // px
constexpr int kCorrectionWidth = 224;
constexpr int kLoadWidth = 520;
constexpr int kNameWidth = 260;

// One press of − or +, mm.
double correctionStep() {
  constexpr double kStep = 0.01;      // mm
  constexpr double kInchStep = 0.001; // in
  return lengthUnit() == LengthUnit::Inch ? lengthFromShown(kInchStep) : kStep;
}

} // namespace

OrderPanel::OrderPanel(Planner& planner, MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_planner(planner), m_machine(machine), m_hint(new QLabel), m_counts(new QLabel),
      m_wanted(new QLabel) {
  m_hint->setObjectName(QStringLiteral("revision"));
  m_hint->setWordWrap(true);
  m_hint->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing jumps when it fills
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->addWidget(m_hint, 0, 0);
  grid->addWidget(makeVerdict(), 1, 0);
  grid->addWidget(makeOrder(), 2, 0);
  grid->addWidget(makeCorrection(), 3, 0);
  connect(&machine, &MachineLink::changed, this, &OrderPanel::showState);
  connect(&planner, &Planner::recipeChanged, this, &OrderPanel::showState);
  connect(&planner, &Planner::planned, this, &OrderPanel::showState);
  connect(&planner, &Planner::openFailed, this, &OrderPanel::showState);
  connect(&planner, &Planner::busyChanged, this, &OrderPanel::showState);
  showState();
}

QWidget* OrderPanel::makeVerdict() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  m_counts->setObjectName(QStringLiteral("paneCounts"));
  m_counts->setTextFormat(Qt::PlainText); // names may hold anything
  m_good = new QPushButton(tr("Good"));
  m_good->setObjectName(QStringLiteral("paneGood"));
  m_good->setAccessibleName(tr("The pane is good"));
  m_reject = new QPushButton(tr("Reject"));
  m_reject->setObjectName(QStringLiteral("paneReject"));
  m_reject->setAccessibleName(tr("The pane is a reject"));
  connect(m_good, &QPushButton::clicked, this, [this] { judge(Verdict::Good); });
  connect(m_reject, &QPushButton::clicked, this, [this] { judge(Verdict::Reject); });
  row->addWidget(m_counts, 1);
  row->addWidget(m_good);
  row->addWidget(m_reject);
  return box;
}

QWidget* OrderPanel::makeOrder() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  m_fewer = makeSignButton(QStringLiteral("−"), QStringLiteral("panesFewer"), tr("Fewer panes"));
  m_more = makeSignButton(QStringLiteral("+"), QStringLiteral("panesMore"), tr("More panes"));
  connect(m_fewer, &QPushButton::clicked, this, [this] { changePanes(-1); });
  connect(m_more, &QPushButton::clicked, this, [this] { changePanes(1); });
  m_wanted->setObjectName(QStringLiteral("panesWanted"));
  m_wanted->setAlignment(Qt::AlignCenter);
  m_wanted->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000")));
  m_load = new QPushButton;
  m_load->setObjectName(QStringLiteral("loadJob"));
  m_load->setMaximumWidth(kLoadWidth);
  connect(m_load, &QPushButton::clicked, this, &OrderPanel::load);
  row->addWidget(new QLabel(tr("Panes")));
  row->addWidget(m_fewer);
  row->addWidget(m_wanted);
  row->addWidget(m_more);
  row->addSpacing(kApart);
  row->addWidget(m_load, 100); // to its greatest width
  row->addStretch(1);
  return box;
}

QWidget* OrderPanel::makeCorrection() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  const recipe::NumberField& field = recipe::numberField(&recipe::Recipe::sizeCorrection);
  m_smaller = makeSignButton(QStringLiteral("−"), QStringLiteral("correctionDown"), tr("Grind the next pane smaller"));
  m_larger = makeSignButton(QStringLiteral("+"), QStringLiteral("correctionUp"), tr("Leave the next pane larger"));
  m_correction = new NumberEdit({QStringLiteral("nextPaneCorrection"), tr("Size correction, next pane"),
                                 QStringLiteral("mm"), field.least, field.most},
                                m_planner.recipe().sizeCorrection);
  m_correction->setToolTip(tr("More leaves the pane larger."));
  connect(m_correction, &NumberEdit::valueChanged, this, &OrderPanel::changeCorrection);
  connect(m_correction, &NumberEdit::complaintChanged, this, &OrderPanel::showState);
  connect(m_smaller, &QPushButton::clicked, this,
          [this] { changeCorrection(m_planner.recipe().sizeCorrection - correctionStep()); });
  connect(m_larger, &QPushButton::clicked, this,
          [this] { changeCorrection(m_planner.recipe().sizeCorrection + correctionStep()); });
  row->addWidget(m_smaller, 0, Qt::AlignBottom);
  m_correction->setFixedWidth(kCorrectionWidth);
  row->addWidget(m_correction);
  row->addWidget(m_larger, 0, Qt::AlignBottom);
  row->addStretch(1);
  return box;
}

void OrderPanel::judge(Verdict verdict) {
  m_machine.judge(verdict);
}

void OrderPanel::changePanes(int by) {
  m_machine.order().setWanted(m_machine.order().wanted() + by);
}

// The recipe of the next plan; what is loaded stays as it is.
void OrderPanel::changeCorrection(double to) {
  constexpr double kFinest = 1e-4; // mm: sums of steps stay round numbers
  recipe::Recipe recipe = m_planner.recipe();
  const NumberSpec& field = m_correction->spec();
  recipe.sizeCorrection = std::clamp(std::round(to / kFinest) * kFinest, field.least, field.most);
  m_planner.setRecipe(recipe);
  showState(); // also where rounding leaves it as it was
}

void OrderPanel::load() {
  if (m_planner.plan()) {
    m_machine.load(m_planner.plan());
  }
}

bool OrderPanel::isRevision() const {
  return m_planner.plan() && m_machine.isRevision(*m_planner.plan());
}

void OrderPanel::showState() {
  const Allowed allowed = m_machine.allowed();
  const OrderBook& order = m_machine.order();
  const PlanPointer& plan = m_planner.plan();
  m_hint->setText(hint());
  const bool isDone = order.isComplete() && order.open() == OrderBook::Open::None;
  const int pane = isDone ? std::min(order.pane(), order.toGrind()) : order.pane();
  const QString counts = tr("Pane %1 of %2: %3 good, %4 rejected")
                             .arg(pane)
                             .arg(std::max(order.toGrind(), pane))
                             .arg(order.good())
                             .arg(order.rejects());
  const PlanPointer& loaded = m_machine.loaded();
  m_counts->setText(loaded ? fontMetrics().elidedText(nameOfFile(loaded->import->file), Qt::ElideMiddle, kNameWidth) +
                                 QLatin1Char('\n') + counts
                           : counts);
  m_good->setEnabled(allowed.judge && order.open() == OrderBook::Open::Ended);
  m_reject->setEnabled(allowed.judge && order.open() != OrderBook::Open::None);
  m_wanted->setText(QString::number(order.wanted()));
  m_fewer->setEnabled(order.wanted() > 1);
  m_more->setEnabled(order.wanted() < files::kMostPanes);
  const double correction = m_planner.recipe().sizeCorrection;
  if (m_correction->complaint().isEmpty()) {
    m_correction->setValue(correction);
  }
  m_smaller->setEnabled(correction > m_correction->spec().least);
  m_larger->setEnabled(correction < m_correction->spec().most);
  const bool goesOn = isRevision() && order.isUnderWay(plan->import->hash);
  m_load->setText(goesOn ? tr("Load for the next pane") : tr("Load job"));
  m_load->setEnabled(allowed.load && plan && plan->job.canBeGround() && m_planner.isPresent() && !m_planner.isBusy());
}

QString OrderPanel::hint() const {
  const OrderBook& order = m_machine.order();
  const JobState job = m_machine.jobState();
  const PlanPointer& plan = m_planner.plan();
  if (!m_correction->complaint().isEmpty()) {
    return m_correction->complaint();
  }
  if (order.open() == OrderBook::Open::Broken) {
    const QString words = m_machine.allowed().acknowledge
                              ? tr("Pane %1 was broken off. After the alarm CYCLE START goes on with it; “Reject”, or "
                                   "loading a job, gives it up.")
                              : tr("Pane %1 was broken off: CYCLE START goes on with it. “Reject”, or loading a job, "
                                   "gives it up.");
    return words.arg(order.pane());
  }
  if (job == JobState::Interrupted) {
    return tr("The pane is interrupted: resume it, or stop it, before a job is loaded.");
  }
  if (plan && !plan->job.canBeGround()) {
    return tr("What is planned on the page Job cannot be ground: nothing can be loaded before that is put right.");
  }
  if (plan && !m_planner.isPresent() && !m_planner.isBusy()) {
    return tr("The page Job shows other values than it has: nothing can be loaded before they are planned.");
  }
  if (isRevision() && job == JobState::Running) {
    return tr("Values have changed; this pane stays as it was loaded. After it load the job for the next pane.");
  }
  if (isRevision() && order.open() == OrderBook::Open::Ended) {
    return tr("Pane %1 has ended: good or reject? Changed since it was loaded: load the job again for the next pane.")
        .arg(order.pane());
  }
  if (isRevision()) {
    return tr("Changed since it was loaded: load the job again for the next pane.");
  }
  if (order.open() == OrderBook::Open::Ended) {
    return tr("Pane %1 has ended: good or reject? It counts as good when the next one begins.").arg(order.pane());
  }
  return m_machine.loaded() && order.isComplete() ? tr("The order is complete.") : QString();
}

} // namespace arris::ui
