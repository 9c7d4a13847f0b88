#pragma once

#include "core/motion/speed_limits.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace arris::motion {

/// A stretch of time over which λ̈ is constant: what the forward pass decides at each event (the end of an interval,
/// meeting K or the feed, a changed override).
struct Piece {
  double time = 0;     ///< s, when it begins
  double duration = 0; ///< s
  int segment = 0;
  double lambda = 0;       ///< mm, at its beginning
  double endLambda = 0;    ///< mm, at its end
  double speed = 0;        ///< λ̇ at its beginning, mm/s
  double acceleration = 0; ///< λ̈, mm/s²
};

/// Where the wheel is to be: everything at one instant.
struct SetPoint {
  double time = 0; ///< s
  int segment = 0;
  double lambda = 0, speed = 0, acceleration = 0; ///< of λ: mm, mm/s, mm/s²
  Eigen::Vector3d position{0, 0, 0};              ///< mm
  Eigen::Vector3d velocity{0, 0, 0};              ///< mm/s
  Eigen::Vector3d axisAcceleration{0, 0, 0};      ///< mm/s²
};

/// The set-point of a piece at an instant inside it.
[[nodiscard]] SetPoint setPointAt(const Piece& piece, const Segment& segment, double time);

/// A track in memory, as far as it is there: rings whose index i stands at i & mask. A track that stands there as a
/// whole needs no ring: its mask is all ones.
struct TrackView {
  const Segment* segments = nullptr;
  std::size_t segmentMask = 0;
  const Interval* intervals = nullptr;
  std::size_t intervalMask = 0;
  std::size_t end = 0; ///< of the intervals that are there

  TrackView() = default;

  TrackView(std::span<const Segment> track, std::span<const Interval> all)
      : segments(track.data()), segmentMask(~std::size_t{0}), intervals(all.data()), intervalMask(~std::size_t{0}),
        end(all.size()) {}

  [[nodiscard]] const Interval& interval(std::size_t index) const {
    return intervals[index & intervalMask];
  }

  [[nodiscard]] const Segment& segment(int index) const {
    return segments[static_cast<std::size_t>(index) & segmentMask];
  }
};

/// The forward pass: from rest at the start of a track to rest at its end, at every instant with the largest λ̈ that the
/// limits admit while λ̇ ≤ c(λ): for an override o up to 1 c = o·min(K, feed), above 1 c = min(K, o·feed). What it does
/// depends on the instants at which the override changes, never on those at which it is asked. The preview runs it
/// ahead of time, the controller at the servo period. Nothing here allocates, locks or throws. The track is referred to
/// and must outlive it; it may not be empty.
class Interpolator {
public:
  Interpolator(const TrackView& track, AxisLimits limits);

  Interpolator(std::span<const Segment> track, std::span<const Interval> intervals, AxisLimits limits)
      : Interpolator(TrackView(track, intervals), std::move(limits)) {}

  /// More of the track is there: its intervals up to before `end`. Not to be called once `atEnd`.
  void extend(std::size_t end) {
    m_track.end = end;
  }

  /// Feed override as a factor, 0.1 to 1.5, from the instant reached on; 0 is a feed hold.
  void setOverride(double factor);

  /// Advances to the instant `time` (s, not before the last one) and tells where the wheel is then.
  SetPoint advanceTo(double time);

  /// The piece that the instant reached lies in, from where it was decided to the next event.
  [[nodiscard]] const Piece& piece() const {
    return m_piece;
  }

  /// Advances to the end of the present piece and decides the next; false at the end of the track and at rest in a
  /// hold.
  bool nextPiece();

  /// At the end of the track, as far as it is there.
  [[nodiscard]] bool atEnd() const {
    return m_index == m_track.end;
  }

  /// At rest in a hold.
  [[nodiscard]] bool standsStill() const;

  /// The interval that the wheel is on.
  [[nodiscard]] std::size_t intervalIndex() const {
    return m_index;
  }

  /// The instant reached, s from the start.
  [[nodiscard]] double time() const {
    return m_time;
  }

private:
  /// What bounds λ̇ in an interval: the feed, the speeds of blend and machine, braking. λ̇² may not exceed any of these
  /// straight lines over λ.
  enum class Bound { Feed, Cap, Brake };

  struct Line {
    double speed2 = 0; ///< λ̇² where the piece begins
    double slope = 0;  ///< of λ̇² over λ, mm/s²
  };

  using Lines = std::array<Line, 3>;

  [[nodiscard]] const Interval& interval() const {
    return m_track.interval(m_index);
  }

  [[nodiscard]] const Segment& segment() const {
    return m_track.segment(interval().segment);
  }

  [[nodiscard]] Lines lines() const;
  void decide();
  void settle(double acceleration, double distance, double endSpeed2, std::optional<Bound> next);
  void decideAlong(const Lines& lines, Bound bound, double speed2);
  void decideFree(const Lines& lines, double speed2);
  void decideFall(const Lines& lines, double speed2);
  void enterInterval();
  void standStill();

  TrackView m_track;
  AxisLimits m_limits;
  double m_override = 1;
  std::size_t m_index = 0;
  double m_time = 0;
  Piece m_piece;
  double m_endSpeed2 = 0;            ///< λ̇² at the end of the piece
  std::optional<Bound> m_followNext; ///< the line that λ̇² lies on then
};

} // namespace arris::motion
