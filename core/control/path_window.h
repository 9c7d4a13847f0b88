#pragma once

#include "core/control/rotary_buffers.h"
#include "core/motion/interpolator.h"

#include <vector>

namespace arris::control {

/// What of a program the controller has taken out of the rotary buffers: the segments with their transitions put into
/// the broken zones, as the interpolator needs them. Bounded; nothing is allocated after construction.
class PathWindow {
public:
  static constexpr std::size_t kSegments = std::size_t{1} << 15;
  static constexpr std::size_t kIntervals = std::size_t{1} << 17;

  PathWindow();

  /// Forgets all; from now on pairs of this program are taken, those of earlier ones are thrown away. 0: of none.
  void begin(std::uint32_t program);

  /// Takes as many pairs as there is room for; what lies before the interval `inUse` is no longer needed.
  void takeFrom(RotaryBuffers& buffers, std::size_t inUse);

  /// Everything that is there.
  [[nodiscard]] const motion::TrackView& view() const {
    return m_view;
  }

  /// The end of the program is there.
  [[nodiscard]] bool isComplete() const {
    return m_complete;
  }

  /// Enough is there to go on without asking where it ends: the window is more than half full.
  [[nodiscard]] bool reachesFar(std::size_t inUse) const;

  /// Where a place of a segment lies on the job's way.
  [[nodiscard]] program::JobPlace placeOf(int segment, double lambda) const {
    return placeOn(extra(segment).place, lambda);
  }

  /// How far the wheel may go off the glass on a segment, mm.
  [[nodiscard]] double room(int segment) const {
    return extra(segment).room;
  }

private:
  struct Extra {
    program::JobStretch place;
    double room = 0;
  };

  [[nodiscard]] const Extra& extra(int segment) const {
    return m_extras[static_cast<std::size_t>(segment) & (kSegments - 1)];
  }

  [[nodiscard]] std::size_t segmentsFrom(std::size_t interval) const;
  void add(const motion::Segment& segment, const Extra& extra);
  void take(RotaryBuffers& buffers);

  std::vector<motion::Segment> m_segments; ///< rings
  std::vector<motion::Interval> m_intervals;
  std::vector<Extra> m_extras;
  motion::TrackView m_view;
  std::size_t m_endSegment = 0;
  std::uint32_t m_program = 0;
  std::uint32_t m_newest = 0; ///< program that was ever begun; numbers ascend
  bool m_complete = false;
};

} // namespace arris::control
