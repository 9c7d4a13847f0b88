#include "ui/pages/back_up_panel.h"

#include "ui/models/signal_model.h"
#include "ui/text/file_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/widgets/busy_bar.h"
#include "ui/widgets/file_question.h"
#include "ui/widgets/signal_table.h"
#include "ui/widgets/signs.h"

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kBackUpSign = 24; // px
constexpr int kMessageLines = 5;

} // namespace

BackUpPanel::BackUpPanel(MachineLink& machine, BackUps& backUps, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_backUps(backUps),
      m_life(new SignalModel({tr("In the machine's life"), tr("So far")}, this)), m_damage(new QLabel),
      m_confirm(new QPushButton(tr("Restore"))), m_giveUp(new QPushButton(tr("Keep as it is"))), m_sign(new QLabel),
      m_state(new QLabel), m_busy(new BusyBar(tr("Reading or writing"))) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(makeCounters(), 2);
  row->addWidget(makeBackUps(), 3);
  connect(&machine, &MachineLink::reported, this, &BackUpPanel::showCounters);
  connect(&machine, &MachineLink::changed, this, &BackUpPanel::showState);
  connect(&backUps, &BackUps::changed, this, &BackUpPanel::showState);
  connect(m_confirm, &QPushButton::clicked, &backUps, &BackUps::restore);
  connect(m_giveUp, &QPushButton::clicked, &backUps, &BackUps::giveUp);
  m_life->show(lifeFigures(machine.counters()));
  showState();
}

QWidget* BackUpPanel::makeCounters() {
  m_damage->setObjectName(QStringLiteral("counterDamage"));
  m_damage->setWordWrap(true);
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(new SignalTable(*m_life, QStringLiteral("lifeFigures")));
  column->addWidget(m_damage);
  column->addStretch(1);
  return box;
}

QWidget* BackUpPanel::makeBackUps() {
  auto* box = new QGroupBox(tr("Settings, machine, recipes and counters"));
  auto* column = new QVBoxLayout(box);
  column->setSpacing(6);
  m_save = add(*box, tr("Back up…"), QStringLiteral("backUp"), tr("Saves all of them in one file."),
               &BackUpPanel::askForBackUp);
  m_restore = add(*box, tr("Restore…"), QStringLiteral("restore"),
                  tr("Brings them back from such a file: while nothing moves and no job is loaded."),
                  &BackUpPanel::askForRestore);
  m_support = add(*box, tr("Support bundle…"), QStringLiteral("supportBundle"),
                  tr("Saves them with the alarm log, the last runs and versions, for whoever helps."),
                  &BackUpPanel::askForSupport);
  m_busy->hide();
  column->addWidget(m_busy);
  column->addWidget(makeState());
  auto* answers = new QHBoxLayout;
  m_confirm->setObjectName(QStringLiteral("restoreConfirm"));
  m_giveUp->setObjectName(QStringLiteral("restoreGiveUp"));
  answers->addWidget(m_confirm);
  answers->addWidget(m_giveUp);
  column->addLayout(answers);
  column->addStretch(1);
  return box;
}

QPushButton* BackUpPanel::add(QGroupBox& box, const QString& text, const QString& name, const QString& what,
                              void (BackUpPanel::*act)()) const {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, this, act);
  auto* label = new QLabel(what);
  label->setWordWrap(true);
  box.layout()->addWidget(button);
  box.layout()->addWidget(label);
  return button;
}

QWidget* BackUpPanel::makeState() {
  m_sign->setFixedSize(kBackUpSign, kBackUpSign);
  m_state->setObjectName(QStringLiteral("backUpState"));
  m_state->setWordWrap(true);
  m_state->setTextFormat(Qt::PlainText);
  m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_state->setMinimumHeight(kMessageLines * fontMetrics().lineSpacing()); // nothing jumps when it fills
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_sign, 0, Qt::AlignTop);
  layout->addWidget(m_state, 1);
  return row;
}

void BackUpPanel::showEvent(QShowEvent* event) {
  m_life->show(lifeFigures(m_machine.counters()));
  QWidget::showEvent(event);
}

void BackUpPanel::showCounters() {
  if (isVisible()) {
    m_life->show(lifeFigures(m_machine.counters()));
  }
}

void BackUpPanel::showState() {
  const bool isBusy = m_backUps.isBusy();
  const bool isAsked = m_backUps.opened().has_value();
  const auto damage = m_machine.counterDamage();
  m_damage->setText(damage ? breakableAtFolders(problemText(*damage, QLocale())) : QString());
  m_busy->setVisible(isBusy);
  m_state->setText(isBusy ? tr("Reading or writing…") : breakableAtFolders(m_backUps.message()));
  const auto sign = isBusy ? std::nullopt : m_backUps.sign();
  m_sign->setPixmap(sign ? signIcon(*sign).pixmap(kBackUpSign) : QPixmap());
  m_save->setEnabled(!isBusy);
  m_support->setEnabled(!isBusy);
  m_restore->setEnabled(m_backUps.mayRestore());
  m_confirm->setEnabled(isAsked && m_backUps.mayRestore());
  m_giveUp->setEnabled(isAsked && !isBusy);
}

void BackUpPanel::askForBackUp() {
  askForFile(*this, {tr("Back up"), m_backUps.suggested(QStringLiteral("arris-back-up")), filters(), true},
             [this](const std::filesystem::path& file) { m_backUps.saveBackUp(file); });
}

void BackUpPanel::askForSupport() {
  askForFile(*this, {tr("Support bundle"), m_backUps.suggested(QStringLiteral("arris-support")), filters(), true},
             [this](const std::filesystem::path& file) { m_backUps.saveSupportBundle(file); });
}

void BackUpPanel::askForRestore() {
  askForFile(*this, {tr("Restore a back-up"), m_backUps.folder(), filters()},
             [this](const std::filesystem::path& file) { m_backUps.open(file); });
}

QStringList BackUpPanel::filters() {
  return tr("Archives (*.tar.gz);;All files (*)").split(QStringLiteral(";;"));
}

} // namespace arris::ui
