#pragma once

#include "core/program/program.h"

#include <functional>
#include <span>

namespace arris::program {

/// A segment with its auxiliary record and the speed limits that belong to both: the segment's own, then the
/// transition's where one follows.
struct Pair {
  const motion::Segment* segment = nullptr;
  InputPoint record;
  std::span<const motion::Interval> limits;
};

/// A program as pairs, one after the other: transitions leave the segments and stand in the records as broken zones.
/// Refers to the program.
class Stream {
public:
  /// `number` marks the records. `room` tells how far the wheel may go off the glass on a segment of the job.
  Stream(const Program& program, std::uint32_t number, std::function<double(int)> room = {});

  [[nodiscard]] bool done() const {
    return m_next == m_program->track.size();
  }

  /// The next pair, until `advance`. Not to be called once `done`.
  [[nodiscard]] const Pair& pair() const {
    return m_pair;
  }

  void advance();

private:
  void makePair();
  void describeCorner(InputPoint& record, const motion::Segment& blend) const;
  [[nodiscard]] bool isTransition(std::size_t segment) const;
  [[nodiscard]] double roomOn(std::size_t segment) const;
  int countLimits(std::size_t segment);

  const Program* m_program;
  std::uint32_t m_number;
  std::function<double(int)> m_room;
  std::size_t m_next = 0;     ///< segment of the pair
  std::size_t m_interval = 0; ///< first of the pair
  std::size_t m_endInterval = 0;
  Pair m_pair;
};

} // namespace arris::program
