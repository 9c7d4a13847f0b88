#include "ui/pages/findings_panel.h"

#include "ui/models/corner_model.h"
#include "ui/models/problem_model.h"
#include "ui/models/time_model.h"
#include "ui/widgets/corner_card.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/touch_delegate.h"
#include "ui/widgets/touch_table.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QListView>
#include <QScrollArea>
#include <QTableView>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kProblemTab = 1;
constexpr int kCardWidth = 300;
constexpr int kSideBySideFrom = 1160; // px: the card needs room for its plot beside its figures

QTableView* makeTable(QAbstractItemModel* model) {
  auto* table = new QTableView;
  table->setModel(model);
  makeTouchTable(*table);
  return table;
}

} // namespace

FindingsPanel::FindingsPanel(QWidget* parent)
    : QTabWidget(parent), m_cornerModel(new CornerModel(this)), m_problemModel(new ProblemModel(this)),
      m_timeModel(new TimeModel(this)) {
  addTab(makeCorners(), tr("Corners"));
  addTab(makeProblems(), tr("Problems"));
  addTab(makeTimes(), tr("Times"));
  setWide(true);
}

QWidget* FindingsPanel::makeCorners() {
  m_corners = makeTable(m_cornerModel);
  m_corners->setObjectName(QStringLiteral("corners"));
  m_corners->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_corners->horizontalHeader()->setSectionResizeMode(CornerModel::Treatment, QHeaderView::Stretch);
  m_card = new CornerCard;
  auto* scroll = new QScrollArea;
  m_cardArea = scroll;
  scroll->setWidget(m_card);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kCardWidth);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->viewport()->setAutoFillBackground(false);
  m_card->setAutoFillBackground(false);
  makeTouchable(*scroll);
  auto* page = new QWidget;
  m_cornersLayout = new QBoxLayout(QBoxLayout::LeftToRight, page);
  m_cornersLayout->setContentsMargins(4, 4, 4, 4);
  m_cornersLayout->addWidget(m_corners, 1);
  m_cornersLayout->addWidget(scroll, 1);
  connect(m_corners->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
    if (row.isValid() && row.row() + 1 != m_selected) {
      selectCorner(row.row() + 1);
      Q_EMIT cornerChosen(m_selected);
    }
  });
  connect(m_corners, &QTableView::clicked, this,
          [this](const QModelIndex& row) { Q_EMIT cornerChosen(row.row() + 1); });
  return page;
}

QWidget* FindingsPanel::makeProblems() {
  m_problems = new QListView;
  m_problems->setObjectName(QStringLiteral("problems"));
  m_problems->setModel(m_problemModel);
  m_problems->setWordWrap(true);
  m_problems->setIconSize(QSize(24, 24));
  m_problems->setResizeMode(QListView::Adjust);
  m_problems->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_problems->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_problems->setItemDelegate(new TouchDelegate(m_problems));
  makeTouchable(*m_problems);
  const auto choose = [this](const QModelIndex& row) { Q_EMIT problemChosen(m_problemModel->problem(row.row())); };
  connect(m_problems, &QListView::clicked, this, choose);
  connect(m_problems, &QListView::activated, this, choose);
  return m_problems;
}

QWidget* FindingsPanel::makeTimes() {
  QTableView* times = makeTable(m_timeModel);
  times->setObjectName(QStringLiteral("times"));
  times->setSelectionMode(QAbstractItemView::NoSelection);
  times->setFocusPolicy(Qt::NoFocus);
  times->verticalHeader()->setDefaultSectionSize(30); // nothing to tap here
  times->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  times->horizontalHeader()->setStretchLastSection(true);
  return times;
}

void FindingsPanel::setPlan(const PlanPointer& plan) {
  const bool another = !m_plan || !plan || m_plan->import->file != plan->import->file;
  m_plan = plan;
  m_cornerModel->setPlan(plan);
  m_problemModel->setPlan(plan);
  m_timeModel->setPlan(plan);
  showProblemCount();
  selectCorner(another ? 0 : m_selected);
}

void FindingsPanel::showProblemCount() {
  const int count = m_problemModel->rowCount();
  setTabText(kProblemTab, count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
  QIcon sign;
  for (const base::Severity severity : {base::Severity::Error, base::Severity::Warning}) {
    if (m_problemModel->count(severity) > 0) {
      sign = signIcon(severity);
      break;
    }
  }
  setTabIcon(kProblemTab, sign);
}

void FindingsPanel::selectCorner(int corner) {
  m_selected = corner <= m_cornerModel->rowCount() ? corner : 0;
  m_card->show(m_plan, m_selected);
  if (m_selected == 0) {
    m_corners->clearSelection();
    m_corners->selectionModel()->setCurrentIndex({}, QItemSelectionModel::NoUpdate);
    return;
  }
  m_corners->setCurrentIndex(m_cornerModel->index(m_selected - 1, 0));
}

void FindingsPanel::selectProblem(const base::Problem& problem) {
  const QModelIndex row = m_problemModel->index(m_problemModel->rowOf(problem));
  if (row.isValid()) {
    setCurrentIndex(kProblemTab);
    m_problems->setCurrentIndex(row);
    m_problems->scrollTo(row);
  }
}

void FindingsPanel::setWide(bool wide) {
  m_wide = wide;
  m_cornersLayout->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  placeCard();
}

// Beside or below the table where there is room for both, else on a tab of its own.
void FindingsPanel::placeCard() {
  const bool isAlone = m_wide && width() < kSideBySideFrom;
  const int tab = indexOf(m_cardArea);
  if (isAlone && tab < 0) {
    addTab(m_cardArea, tr("Details"));
  } else if (!isAlone && tab >= 0) {
    removeTab(tab);
    m_cornersLayout->addWidget(m_cardArea, 1);
    m_cardArea->show();
  }
}

void FindingsPanel::showCard() {
  if (m_selected != 0) {
    setCurrentIndex(std::max(0, indexOf(m_cardArea)));
  }
}

void FindingsPanel::resizeEvent(QResizeEvent* event) {
  QTabWidget::resizeEvent(event);
  placeCard();
}

} // namespace arris::ui
