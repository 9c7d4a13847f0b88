#pragma once

#include "ui/presenters/planner.h"

#include <QObject>

#include <optional>

namespace arris::ui {

/// The wheel that the operator moves along the planned way, to see what the machine does there: where it is, and what
/// is planned for that place. Nothing of it moves the machine. Another pattern puts it to where the wheel first comes
/// onto the glass; another value leaves it at its share of the way.
class WheelWalk : public QObject {
  Q_OBJECT

public:
  explicit WheelWalk(const Planner& planner, QObject* parent = nullptr);

  /// What is planned for the place of the wheel; nothing where there is no plan, or one that cannot be ground.
  [[nodiscard]] std::optional<job::Sample> place() const;

  /// Of the whole program, s; 0 without a place.
  [[nodiscard]] double duration() const;

  [[nodiscard]] bool isAtStart() const;
  [[nodiscard]] bool isAtEnd() const;

  // The following do nothing without a place.

  /// 10 mm of the way, or to the next change of the phase where that is nearer.
  void stepOn();
  void stepBack();

  /// Follows a hand at a point of the table, mm. Where the way leads as near to it as anywhere else, but for `reach`
  /// (mm), the wheel stays on it.
  void dragTo(const geometry::Point& point, double reach);

  /// Goes to the place of the way that is nearest to a point, unless it is farther than `reach` (mm); false then.
  bool putTo(const geometry::Point& point, double reach);

Q_SIGNALS:
  void changed();
  /// After a step, which may lead out of what is seen.
  void stepped();

private:
  void takePlan(const PlanPointer& plan);
  [[nodiscard]] const job::Trajectory* trajectory() const; ///< null where there is no place
  void goTo(double time);
  void step(double way);

  PlanPointer m_plan;            ///< the last, whether it can be ground or not
  double m_time = 0;             ///< s
  std::optional<double> m_share; ///< of the way; none until somebody moves the wheel
};

} // namespace arris::ui
