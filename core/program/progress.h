#pragma once

#include "core/job/job.h"
#include "core/program/input_point.h"

#include <span>
#include <vector>

namespace arris::program {

/// How much of a job is ground at a place of its way: the true length along the glass, leads and rapids left out.
/// Refers to the job's track.
class WorkingWay {
public:
  explicit WorkingWay(const job::Job& job);

  /// Of all contours, mm.
  [[nodiscard]] double length() const {
    return m_before.back();
  }

  /// Before the place, mm; 0 off the job's way.
  [[nodiscard]] double before(const JobPlace& place) const;

private:
  std::span<const motion::Segment> m_track;
  std::vector<double> m_before; ///< by segment, and the whole
};

/// When the wheel passes each place of a job that runs at one override: the interpolator ahead of time.
class Timetable {
public:
  /// Takes as long as planning the profile does. Refers to nothing.
  Timetable(const job::Job& job, double overrideFactor);

  [[nodiscard]] double overrideFactor() const {
    return m_override;
  }

  /// s from the place to the end at the park position; the whole where the place is off the job's way.
  [[nodiscard]] double left(const JobPlace& place) const;

private:
  double m_override;
  double m_duration = 0; ///< s
  std::vector<motion::Piece> m_pieces;
};

} // namespace arris::program
