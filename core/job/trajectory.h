#pragma once

#include "core/geometry/box_tree.h"
#include "core/job/job.h"

#include <cstddef>
#include <vector>

namespace arris::job {

/// The row of the profile at an instant of a piece; `before` is the true length of the segments before the piece's, mm.
[[nodiscard]] Sample sampleOn(const Job& job, const PlannedPiece& piece, double before, double time);

/// The planned motion by time, by the way travelled and by place. To make one takes time in proportion to the track; to
/// ask it does not. Refers to the job, which has pieces.
class Trajectory {
public:
  explicit Trajectory(const Job& job);

  /// What a row of the profile at this time (s) would say; before the start and after the end, the first and the last.
  [[nodiscard]] Sample at(double time) const;

  /// True length of the whole way, mm; the last `Sample::path`.
  [[nodiscard]] double length() const {
    return m_before.back();
  }

  /// When this much of the way (mm, true length) has been travelled, s.
  [[nodiscard]] double timeAfter(double way) const;

  /// When the first other phase, or the same of another corner, begins on the way from one time to another, either of
  /// which may be the later; `to` where none begins between them.
  [[nodiscard]] double firstChange(double from, double to) const;

  /// A place of the way, and how far it is from a point in the plane, mm.
  struct Near {
    double time = 0; ///< s
    double distance = 0;
  };

  /// The place nearest to a point; of several, the first. Plunges and retractions count with their ends.
  [[nodiscard]] Near nearest(const geometry::Point& point) const;

  /// The same for a wheel that is dragged along its way from where it is at `time`: where following the way leads as
  /// near to the point as anywhere else, but for `reach` (mm), it stays on it.
  [[nodiscard]] Near nearest(const geometry::Point& point, double time, double reach) const;

private:
  struct Place {
    double way = 0; ///< mm travelled before it
    double distance = 0;
  };

  [[nodiscard]] std::size_t pieceAt(double time) const;
  [[nodiscard]] Place nearestPlace(const geometry::Point& point) const;
  [[nodiscard]] Place nearestAround(const geometry::Point& point, double way, double reach) const;
  [[nodiscard]] Place nearestOn(std::size_t segment, const geometry::Point& point) const;

  const Job& m_job;
  std::vector<double> m_before; ///< true length before each segment, and of all, mm
  geometry::BoxTree m_boxes;    ///< of the segments; empty where one has no length in the plane
};

} // namespace arris::job
