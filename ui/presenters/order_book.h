#pragma once

#include "core/files/pane_journal.h"

#include <QObject>
#include <QThreadPool>

#include <string>

namespace arris::ui {

/// The order: so many good panes of one pattern, and what the operator says of each that has ended. Every pane becomes
/// a line of the journal, written in the background. A pane that is not judged counts as good when the next one begins.
class OrderBook : public QObject {
  Q_OBJECT

public:
  /// What waits for the operator's word.
  enum class Open {
    None,
    Ended, ///< a pane has been ground
    Broken ///< one was broken off: it can be gone on with, or given up
  };

  explicit OrderBook(std::filesystem::path journal, QObject* parent = nullptr);
  ~OrderBook() override; ///< writes what waits; a pane that nobody has judged stands there as that
  OrderBook(const OrderBook&) = delete;
  OrderBook& operator=(const OrderBook&) = delete;
  OrderBook(OrderBook&&) = delete;
  OrderBook& operator=(OrderBook&&) = delete;

  /// Good panes that are wanted, from 1.
  [[nodiscard]] int wanted() const {
    return m_wanted;
  }

  void setWanted(int panes);

  [[nodiscard]] int good() const {
    return m_counts.good;
  }

  [[nodiscard]] int rejects() const {
    return m_counts.rejects;
  }

  [[nodiscard]] Open open() const {
    return m_open;
  }

  /// Number of the pane that waits for its verdict, is being ground or comes next; rejects counted.
  [[nodiscard]] int pane() const {
    return m_counts.good + m_counts.rejects + 1;
  }

  /// Panes to be ground in all: those that are wanted, and one more for each reject.
  [[nodiscard]] int toGrind() const {
    return m_wanted + m_counts.rejects;
  }

  [[nodiscard]] bool isComplete() const {
    return m_counts.good >= m_wanted;
  }

  /// Whether panes of this pattern belong to the order that is under way.
  [[nodiscard]] bool isUnderWay(const std::string& patternHash) const;

  /// A new order, or one that was broken off with so many panes done.
  void begin(const std::string& patternFile, const std::string& patternHash, const files::PaneCounts& before = {});

  /// Of the pane that is being ground, s.
  void paneEnded(double duration);
  void paneBroken(double duration);
  /// A run begins: what has ended and was not judged is good; what was broken off goes on.
  void runBegins();
  void judge(files::Verdict verdict);

Q_SIGNALS:
  void changed();
  void failed(const arris::base::Problem& problem);

private:
  void write(files::Verdict verdict);

  std::filesystem::path m_journal;
  std::string m_patternFile;
  std::string m_patternHash;
  int m_wanted = 1;
  files::PaneCounts m_counts;
  Open m_open = Open::None;
  double m_duration = 0;
  QThreadPool m_writer; // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
