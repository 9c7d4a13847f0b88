#include "ui/presenters/order_book.h"

#include "core/files/run_record.h"
#include "core/files/wall_clock.h"

#include <algorithm>
#include <utility>

namespace arris::ui {

using files::Verdict;

OrderBook::OrderBook(std::filesystem::path journal, QObject* parent) : QObject(parent), m_journal(std::move(journal)) {
  m_writer.setMaxThreadCount(1);
}

OrderBook::~OrderBook() {
  if (m_open == Open::Ended) {
    write(Verdict::Unjudged);
  }
  m_writer.waitForDone();
}

void OrderBook::setWanted(int panes) {
  const int wanted = std::clamp(panes, 1, files::kMostPanes);
  if (wanted != m_wanted) {
    m_wanted = wanted;
    Q_EMIT changed();
  }
}

bool OrderBook::isUnderWay(const std::string& patternHash) const {
  const bool hasBegun = pane() > 1 || m_open != Open::None;
  const int good = m_counts.good + (m_open == Open::Ended ? 1 : 0); // which it is unless somebody says otherwise
  return !m_patternHash.empty() && m_patternHash == patternHash && hasBegun && good < m_wanted;
}

void OrderBook::begin(const std::string& patternFile, const std::string& patternHash, const files::PaneCounts& before) {
  m_patternFile = patternFile;
  m_patternHash = patternHash;
  m_counts = before;
  m_open = Open::None;
  Q_EMIT changed();
}

void OrderBook::paneEnded(double duration) {
  m_open = Open::Ended;
  m_duration = duration;
  Q_EMIT changed();
}

void OrderBook::paneBroken(double duration) {
  m_open = Open::Broken;
  m_duration = duration;
  Q_EMIT changed();
}

void OrderBook::runBegins() {
  if (m_open == Open::Ended) {
    judge(Verdict::Good);
  } else if (m_open == Open::Broken) {
    m_open = Open::None;
    Q_EMIT changed();
  }
}

void OrderBook::judge(Verdict verdict) {
  if (m_open == Open::None || (m_open == Open::Broken && verdict != Verdict::Reject)) {
    return;
  }
  write(verdict);
  m_open = Open::None;
  m_counts.good += verdict == Verdict::Reject ? 0 : 1;
  m_counts.rejects += verdict == Verdict::Reject ? 1 : 0;
  Q_EMIT changed();
}

void OrderBook::write(Verdict verdict) {
  const files::PaneEntry entry{files::wallClock(), m_patternFile, m_patternHash, pane(), verdict, m_duration};
  m_writer.start([this, journal = m_journal, entry] {
    if (const auto written = files::appendPane(journal, entry); !written) {
      QMetaObject::invokeMethod(
          this, [this, problem = written.error()] { Q_EMIT failed(problem); }, Qt::QueuedConnection);
    }
  });
}

} // namespace arris::ui
