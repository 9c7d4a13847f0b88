#pragma once

#include "core/base/monitor.h"
#include "core/motion/interpolator.h"
#include "core/toolpath/toolpath.h"

#include <array>
#include <string_view>

namespace arris::job {

/// `phase` of the profile (contract).
enum class Phase {
  Approach,
  Plunge,
  LeadIn,
  Cruise,
  Decelerate,
  Transition,
  Roll,
  Stop,
  Accelerate,
  LeadOut,
  Retract,
  Traverse,
};
inline constexpr int kPhaseCount = 12;
[[nodiscard]] std::string_view name(Phase phase);

/// A piece of the planned profile with what it is for.
struct PlannedPiece {
  motion::Piece motion;
  Phase phase = Phase::Approach;
  int corner = 0; ///< whose transition, roll, stop, deceleration or acceleration this is; 0 none
};

/// How the pattern was put on the table: mirror, then rotate about the drawing's origin, then shift.
struct Placement {
  geometry::Point place; ///< lower-left corner of the outlines' box on the table, mm
  double rotation = 0;   ///< rad
  recipe::Mirror mirror = recipe::Mirror::None;
  geometry::Point patternOrigin;                            ///< the drawing's origin on the table, mm
  Eigen::Isometry2d motion = Eigen::Isometry2d::Identity(); ///< drawing → table
};

/// What the profile makes of a corner beside what the method asks of it.
struct CornerResult {
  double plannedSpeed = 0;                               ///< highest λ̇ in the corner, mm/s
  double plannedTime = 0;                                ///< s
  double decelerationLength = 0, accelerationLength = 0; ///< L_d, L_a that the profile has, mm
  geometry::Point decelerationPoint, accelerationPoint;  ///< P_d, P_a
};

/// A planned pane: everything that previews, exports and the controller need. No samples; those come from the pieces.
struct Job {
  recipe::Recipe recipe;
  recipe::Machine machine;
  Placement placement;
  std::vector<pattern::Contour> contours; ///< on the table; numbered as they are machined once that is known
  toolpath::Toolpath toolpath;
  std::vector<motion::Segment> track; ///< the whole program, park position to park position
  motion::AxisLimits limits;
  std::vector<motion::Interval> intervals;
  std::vector<PlannedPiece> pieces;
  std::vector<CornerResult> cornerResults;   ///< index = corner id − 1
  double duration = 0;                       ///< s, to the end at the park position
  double working = 0;                        ///< s, start of lead-ins to end of lead-outs
  std::array<double, kPhaseCount> byPhase{}; ///< s
  base::Problems problems;                   ///< of the pattern (places moved to the table) and of every later step

  [[nodiscard]] bool canBeGround() const {
    return !base::hasErrors(problems);
  }
};

/// Values in, value out; the same input gives the same bytes. Recipe and machine have been checked. With errors among
/// the problems, as many of the steps were done as could be, for the preview; track and pieces are empty then.
[[nodiscard]] Job planJob(const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine,
                          toolpath::Leads leads = toolpath::Leads::With, const base::Monitor& monitor = {});

/// One row of the profile.
struct Sample {
  motion::SetPoint setPoint;
  double speed = 0; ///< actual speed in space, mm/s
  double path = 0;  ///< true length travelled, mm
  int contour = 0, segment = 0, corner = 0;
  Phase phase = Phase::Approach;
  double distance = 0; ///< wheel centre to the corner's S, mm; 0 where corner is 0
};

/// The rows of the profile: one per period from t = 0, and a last one at the exact end. Refers to the job.
class Sampler {
public:
  explicit Sampler(const Job& job) : Sampler(job, job.machine.period) {}

  /// One row each `period` (s) instead of the machine's.
  Sampler(const Job& job, double period);
  [[nodiscard]] std::size_t count() const;
  /// The next row; rows come in order. Not to be called once `done`.
  Sample next();
  [[nodiscard]] bool done() const;

private:
  void goTo(double time);

  const Job& m_job;
  double m_period;
  std::size_t m_periods = 0; ///< begun; the last may be cut short
  std::size_t m_row = 0;
  std::size_t m_piece = 0;
  double m_travelled = 0; ///< true length of the segments left behind, mm
};

} // namespace arris::job
