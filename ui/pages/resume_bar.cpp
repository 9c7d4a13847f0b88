#include "ui/pages/resume_bar.h"

#include "ui/text/file_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/text/quantities.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

using control::BrokenJob;
using Offer = ResumeOffer::State;

QString endedText(files::Ended ended) {
  switch (ended) {
  case files::Ended::Running:
    return ResumeBar::tr("a power failure, or Arris ended");
  case files::Ended::Held:
    return ResumeBar::tr("Arris ended in a hold");
  case files::Ended::Stopped:
    return ResumeBar::tr("a stop");
  case files::Ended::Fault:
    return ResumeBar::tr("a fault");
  case files::Ended::EmergencyStop:
    return ResumeBar::tr("the emergency stop");
  case files::Ended::Interrupted:
    return ResumeBar::tr("its end from the terminal");
  }
  return {};
}

QString whichText(const BrokenJob& job) {
  const QDateTime time = QDateTime::fromString(QString::fromStdString(job.time), Qt::ISODate);
  const std::filesystem::path file(job.point.patternFile);
  return ResumeBar::tr("Resume the job of %1: %2, pane %3 of %4, interrupted by %5?")
      .arg(QLocale().toString(time, QLocale::ShortFormat), nameOfFile(file))
      .arg(job.point.pane)
      .arg(job.point.panes)
      .arg(endedText(job.point.ended));
}

} // namespace

ResumeBar::ResumeBar(MachineLink& machine, QWidget* parent) : QWidget(parent), m_machine(machine), m_text(new QLabel) {
  setObjectName(QStringLiteral("resumeBar"));
  m_text->setObjectName(QStringLiteral("resumeText"));
  m_text->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 4);
  layout->addWidget(m_text);
  layout->addLayout(new QHBoxLayout);
  m_takeUp = add(tr("Take it up"), QStringLiteral("resumeTakeUp"));
  m_cancel = add(tr("Cancel"), QStringLiteral("resumeCancel"));
  m_discard = add(tr("Discard"), QStringLiteral("resumeDiscard"));
  m_keep = add(tr("Keep it"), QStringLiteral("resumeKeep"));
  m_dismiss = add(tr("Understood"), QStringLiteral("resumeDismiss"));
  connect(m_takeUp, &QPushButton::clicked, this, [this] { m_machine.resumeOffer().takeUp(); });
  connect(m_cancel, &QPushButton::clicked, this, [this] { m_machine.resumeOffer().cancel(); });
  connect(m_discard, &QPushButton::clicked, this, &ResumeBar::discard);
  connect(m_keep, &QPushButton::clicked, this, [this] {
    m_asks = false;
    showOffer(m_machine.resumeOffer());
  });
  connect(m_dismiss, &QPushButton::clicked, this, [this] { m_machine.resumeOffer().dismiss(); });
  connect(&machine, &MachineLink::changed, this, [this] { showOffer(m_machine.resumeOffer()); });
  showOffer(machine.resumeOffer());
}

QPushButton* ResumeBar::add(const QString& text, const QString& name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  static_cast<QHBoxLayout*>(layout()->itemAt(1)->layout())->addWidget(button);
  return button;
}

void ResumeBar::discard() {
  if (m_asks) {
    m_machine.resumeOffer().discard();
  }
  m_asks = !m_asks;
  showOffer(m_machine.resumeOffer());
}

void ResumeBar::showOffer(const ResumeOffer& offer) {
  const bool isOffered = offer.state() == Offer::Offered;
  m_asks = m_asks && isOffered;
  setVisible(offer.state() != Offer::None);
  m_text->setText(text(offer));
  m_takeUp->setVisible(!m_asks && (isOffered || offer.state() == Offer::Planning));
  m_takeUp->setEnabled(isOffered && m_machine.allowed().load);
  m_cancel->setVisible(offer.state() == Offer::Planning);
  m_discard->setVisible(isOffered);
  m_discard->setText(m_asks ? tr("Discard it for good") : tr("Discard"));
  m_keep->setVisible(m_asks);
  m_dismiss->setVisible(offer.state() == Offer::SetAside);
}

QString ResumeBar::text(const ResumeOffer& offer) const {
  QStringList lines;
  for (const base::Problem& problem : offer.problems()) {
    lines += problemText(problem, QLocale());
  }
  switch (offer.state()) {
  case Offer::None:
    return {};
  case Offer::Planning:
    return tr("The job that was broken off is being read and planned…");
  case Offer::Offered:
    lines += m_asks ? tr("Discard the job that was broken off? It cannot be resumed then.") : whichText(*offer.job());
    break;
  case Offer::SetAside:
    lines += offer.aside().empty()
                 ? tr("The job that was broken off cannot be resumed.")
                 : tr("The job that was broken off is not resumed; what is known of it is kept as %1.")
                       .arg(nameOfFile(offer.aside()));
    break;
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace arris::ui
