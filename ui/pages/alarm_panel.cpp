#include "ui/pages/alarm_panel.h"

#include "ui/models/alarm_model.h"
#include "ui/text/alarm_texts.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/touch_table.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace arris::ui {
namespace {

constexpr int kAlarmRowHeight = 58; // px: three lines
constexpr int kAlarmSign = 24;      // px
constexpr int kDetailLines = 8;
constexpr int kCellRoom = 14; // px beside a text
constexpr int kLeastSentenceWidth = 260;

// The sentence wraps in its column: it asks for little room.
class SentenceDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& /*option*/, const QModelIndex& /*index*/) const override {
    return {kLeastSentenceWidth, kAlarmRowHeight};
  }
};

int widestLine(const QFontMetrics& metrics, const QString& text) {
  int widest = 0;
  for (const QString& line : text.split(QLatin1Char('\n'))) {
    widest = std::max(widest, metrics.horizontalAdvance(line));
  }
  return widest;
}

} // namespace

AlarmPanel::AlarmPanel(MachineLink& machine, AlarmHistory& history, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_history(history), m_model(new AlarmModel(this)), m_table(new QTableView),
      m_summarySign(new QLabel), m_summary(new QLabel), m_sign(new QLabel), m_detail(new QLabel),
      m_acknowledge(new QPushButton(tr("Acknowledge"))) {
  setUpTable();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(makeButtons());
  layout->addWidget(m_table, 1);
  layout->addWidget(makeDetail());
  connect(m_acknowledge, &QPushButton::clicked, &machine, &MachineLink::acknowledge);
  connect(&history, &AlarmHistory::changed, this, &AlarmPanel::showAlarms);
  connect(&machine, &MachineLink::changed, this, &AlarmPanel::showAllowed);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
    if (row.isValid()) {
      m_history.choose(m_model->alarm(row.row()).alarm);
    }
  });
  showAlarms();
  showAllowed();
}

QWidget* AlarmPanel::makeButtons() {
  m_summarySign->setFixedSize(kAlarmSign, kAlarmSign);
  m_summary->setObjectName(QStringLiteral("alarmSummary"));
  m_summary->setWordWrap(true);
  m_acknowledge->setObjectName(QStringLiteral("acknowledgeHere"));
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  auto* filter =
      new Segments({{QStringLiteral("alarmsAll"), tr("All")}, {QStringLiteral("alarmsActive"), tr("Active")}},
                   m_history.showsActiveOnly() ? 1 : 0);
  connect(filter, &Segments::picked, this, [this](int which) { m_history.showActiveOnly(which == 1); });
  layout->addWidget(filter, 1);
  layout->addWidget(m_summarySign);
  layout->addWidget(m_summary, 3);
  layout->addWidget(m_acknowledge);
  return row;
}

void AlarmPanel::setUpTable() {
  m_table->setObjectName(QStringLiteral("alarms"));
  m_table->setModel(m_model);
  makeTouchTable(*m_table);
  m_table->setWordWrap(true);
  m_table->setIconSize(QSize(kAlarmSign, kAlarmSign));
  m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // nothing jumps when it fills
  m_table->setItemDelegateForColumn(AlarmModel::What, new SentenceDelegate(m_table));
  m_table->verticalHeader()->setDefaultSectionSize(kAlarmRowHeight);
  m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  m_table->horizontalHeader()->setSectionResizeMode(AlarmModel::What, QHeaderView::Stretch);
}

// By all that may stand in a column, not by what stands there: thousands of rows would have to be measured.
void AlarmPanel::sizeColumns() {
  const QFontMetrics metrics = m_table->fontMetrics();
  std::array<int, AlarmModel::ColumnCount> widths{};
  const auto fit = [&](AlarmModel::Column column, const QString& text, int more = 0) {
    widths.at(column) = std::max(widths.at(column), widestLine(metrics, text) + kCellRoom + more);
  };
  for (const PastAlarm& past : {PastAlarm{{}, true}, PastAlarm{{{}, {}, {}, {}, true}}, PastAlarm{}}) {
    fit(AlarmModel::State, alarmStateText(past), past.isActive ? kAlarmSign : 0);
  }
  fit(AlarmModel::Time, alarmTimeText({"2038-12-28T20:58:58", {}, {}, {}, false}, QLocale()));
  for (const control::FaultInfo& row : control::allFaults()) {
    fit(AlarmModel::Code, QString::fromLatin1(row.name.data(), static_cast<int>(row.name.size())));
  }
  for (const AlarmModel::Column column : {AlarmModel::State, AlarmModel::Time, AlarmModel::Code}) {
    const int heading = m_table->horizontalHeader()->sectionSizeHint(column);
    m_table->setColumnWidth(column, std::max(widths.at(column), heading));
  }
}

QWidget* AlarmPanel::makeDetail() {
  m_sign->setFixedSize(kAlarmSign, kAlarmSign);
  m_detail->setObjectName(QStringLiteral("alarmDetail"));
  m_detail->setWordWrap(true);
  m_detail->setTextFormat(Qt::PlainText); // a log may hold anything
  m_detail->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_detail->setMinimumHeight(kDetailLines * fontMetrics().lineSpacing()); // nothing jumps when it fills
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(4, 0, 4, 0);
  layout->setSpacing(8);
  layout->addWidget(m_sign, 0, Qt::AlignTop);
  layout->addWidget(m_detail, 1);
  return row;
}

// Runs elsewhere may have added to the log.
void AlarmPanel::showEvent(QShowEvent* event) {
  sizeColumns();
  m_history.reload();
  QWidget::showEvent(event);
}

void AlarmPanel::showAlarms() {
  m_summarySign->setPixmap(m_history.isIncomplete() ? signIcon(base::Severity::Warning).pixmap(kAlarmSign) : QPixmap());
  m_summary->setText(m_history.summary());
  const QSignalBlocker blocked(m_table->selectionModel()); // what is chosen is not chosen by this
  m_model->setAlarms(m_history.shown());
  const auto chosen = m_history.chosen();
  const int row = chosen ? m_model->rowOf(chosen->alarm) : -1;
  if (row < 0) {
    m_table->clearSelection();
    m_table->selectionModel()->setCurrentIndex({}, QItemSelectionModel::NoUpdate);
  } else if (m_table->currentIndex().row() != row) {
    m_table->setCurrentIndex(m_model->index(row, 0));
  }
  m_table->viewport()->update();
  m_sign->setPixmap(chosen && chosen->isActive ? signIcon(base::Severity::Error).pixmap(kAlarmSign) : QPixmap());
  m_detail->setText(chosen                        ? alarmInFull(*chosen, QLocale())
                    : m_model->rowCount() > 0     ? tr("Tap an alarm to read its cause and what to do.")
                    : m_history.showsActiveOnly() ? tr("No alarm is active.")
                                                  : tr("There has been no alarm yet."));
}

void AlarmPanel::showAllowed() {
  m_acknowledge->setEnabled(m_machine.allowed().acknowledge);
}

} // namespace arris::ui
