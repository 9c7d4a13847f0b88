#pragma once

#include "core/control/broken_job.h"
#include "core/files/pane_journal.h"
#include "ui/presenters/planner.h"

#include <QObject>
#include <QThreadPool>

#include <stop_token>

namespace arris::ui {

/// A job that was broken off and can be planned again: all that the machine needs to take it up.
struct TakenUp {
  PlanPointer plan;
  files::ResumePoint point;
  files::PaneCounts before; ///< panes of the order that were judged before
};

/// The job that an earlier process left broken off, as it is offered to the operator. It is read and planned in the
/// background, with the recipe and the machine that it was planned with. What cannot be used is told and set aside; it
/// never keeps anybody from working.
class ResumeOffer : public QObject {
  Q_OBJECT

public:
  enum class State {
    None,
    Offered,
    Planning,
    SetAside, ///< it could not be used: `problems` say why, the file is at `aside`
  };

  /// Looks into the folder at once.
  ResumeOffer(files::StateFolder folder, recipe::Machine machine, files::Axes axes, PlannerSteps steps,
              QObject* parent = nullptr);
  ~ResumeOffer() override; ///< waits until the work under way has given up
  ResumeOffer(const ResumeOffer&) = delete;
  ResumeOffer& operator=(const ResumeOffer&) = delete;
  ResumeOffer(ResumeOffer&&) = delete;
  ResumeOffer& operator=(ResumeOffer&&) = delete;

  [[nodiscard]] State state() const {
    return m_state;
  }

  /// Where it is offered or being planned.
  [[nodiscard]] const std::optional<control::BrokenJob>& job() const {
    return m_job;
  }

  /// Why it could not be taken up; where it is offered still, the operator can mend that and try again.
  [[nodiscard]] const base::Problems& problems() const {
    return m_problems;
  }

  /// Where the file went that was set aside; empty where it could not be moved.
  [[nodiscard]] const std::filesystem::path& aside() const {
    return m_aside;
  }

  void takeUp();
  /// It is not taken up now; it is offered still.
  void cancel();
  /// The job is not to be resumed: its file goes away.
  void discard();
  /// Another job comes first: the file is set aside, so that nothing of it is lost.
  void setAside();
  /// What was told has been read.
  void dismiss();

Q_SIGNALS:
  void changed();
  void ready(const arris::ui::TakenUp& job);

private:
  struct Outcome {
    std::optional<TakenUp> job;
    base::Problems problems;
    bool staysOffered = false;
  };

  [[nodiscard]] static Outcome plan(const files::ResumePoint& point, const PlannerSteps& steps,
                                    const std::filesystem::path& journal, const std::stop_token& stop);
  void take(const Outcome& outcome);
  void moveAside();

  files::StateFolder m_folder;
  recipe::Machine m_machine;
  files::Axes m_axes;
  PlannerSteps m_steps;
  State m_state = State::None;
  std::optional<control::BrokenJob> m_job;
  base::Problems m_problems;
  std::filesystem::path m_aside;
  std::stop_source m_stop; // of the planning under way
  QThreadPool m_pool;      // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
