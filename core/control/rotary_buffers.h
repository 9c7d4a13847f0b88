#pragma once

#include "core/program/stream.h"

#include <boost/lockfree/spsc_queue.hpp>

#include <variant>

namespace arris::control {

/// The two rotary buffers between the program and the controller, filled and emptied in step: buffer 1 takes the
/// segments, buffer 2 the auxiliary record of each and after it its speed limits. One thread puts, one takes; neither
/// waits, and nothing is allocated after construction.
class RotaryBuffers {
public:
  /// Places in buffer 1 and in buffer 2; a full circle has some 6,300 speed limits.
  static constexpr std::size_t kSegments = 1024;
  static constexpr std::size_t kRecords = 16384;

  RotaryBuffers() : m_segments(kSegments), m_records(kRecords) {}

  /// Puts a pair, whole or not at all; false where there is no room for it.
  bool put(const program::Pair& pair) {
    if (m_segments.write_available() < 1 || m_records.write_available() < 1 + pair.limits.size()) {
      return false;
    }
    m_records.push(pair.record);
    for (const motion::Interval& limit : pair.limits) {
      m_records.push(limit);
    }
    m_segments.push(*pair.segment); // last, so that its record is there when it is seen
    return true;
  }

  /// The record of the pair that comes next; null where there is none.
  [[nodiscard]] const program::InputPoint* next() {
    return m_segments.read_available() > 0 ? &std::get<program::InputPoint>(m_records.front()) : nullptr;
  }

  /// Takes that pair; `sink` is given each of its speed limits.
  template <typename Sink> motion::Segment take(Sink sink) {
    const program::InputPoint& record = std::get<program::InputPoint>(m_records.front());
    const int limits = record.limits + record.transition.limits;
    m_records.pop();
    for (int i = 0; i < limits; ++i) {
      sink(std::get<motion::Interval>(m_records.front()));
      m_records.pop();
    }
    motion::Segment segment = m_segments.front();
    m_segments.pop();
    return segment;
  }

  /// Pairs in the buffers, seen by the thread that takes.
  [[nodiscard]] std::size_t pairs() const {
    return m_segments.read_available();
  }

private:
  using Record = std::variant<program::InputPoint, motion::Interval>;

  boost::lockfree::spsc_queue<motion::Segment> m_segments;
  boost::lockfree::spsc_queue<Record> m_records;
};

} // namespace arris::control
