#include "core/control/path_window.h"

#include <algorithm>

namespace arris::control {

using motion::Segment;
using program::InputPoint;

PathWindow::PathWindow() : m_segments(kSegments), m_intervals(kIntervals), m_extras(kSegments) {
  m_view.segments = m_segments.data();
  m_view.segmentMask = kSegments - 1;
  m_view.intervals = m_intervals.data();
  m_view.intervalMask = kIntervals - 1;
}

void PathWindow::begin(std::uint32_t program) {
  m_program = program;
  m_newest = std::max(m_newest, program);
  m_view.end = 0;
  m_endSegment = 0;
  m_complete = false;
}

void PathWindow::takeFrom(RotaryBuffers& buffers, std::size_t inUse) {
  while (const InputPoint* record = buffers.next()) {
    if (record->program > m_newest) { // the command that loads it is still under way
      return;
    }
    if (record->program != m_program) {
      static_cast<void>(buffers.take([](const motion::Interval&) {}));
      continue;
    }
    const auto limits = static_cast<std::size_t>(record->limits + record->transition.limits);
    if (m_view.end + limits - inUse > kIntervals || segmentsFrom(inUse) + 2 > kSegments) {
      return;
    }
    take(buffers);
  }
}

void PathWindow::take(RotaryBuffers& buffers) {
  const InputPoint record = *buffers.next();
  const Segment segment = buffers.take([this](const motion::Interval& limit) {
    m_intervals[m_view.end & (kIntervals - 1)] = limit;
    ++m_view.end;
  });
  add(segment, {record.place, record.room});
  if (record.side == program::CornerSide::Before) { // the transition goes into the broken zone, Eq. (1)
    Segment blend;
    blend.shape = geometry::Parabola{record.transition.a, record.transition.q, record.transition.c};
    blend.move = motion::Move::Transition;
    blend.z = segment.z;
    blend.feed = record.normalSpeed;
    blend.speedCap = record.transitionSpeed;
    blend.contour = segment.contour;
    blend.number = record.transition.number;
    blend.corner = record.corner;
    add(blend, {record.transitionPlace, record.transitionRoom});
  }
  m_complete = record.isLast;
}

void PathWindow::add(const Segment& segment, const Extra& extra) {
  m_segments[m_endSegment & (kSegments - 1)] = segment;
  m_extras[m_endSegment & (kSegments - 1)] = extra;
  ++m_endSegment;
}

std::size_t PathWindow::segmentsFrom(std::size_t interval) const {
  return interval < m_view.end ? m_endSegment - static_cast<std::size_t>(m_view.interval(interval).segment) : 1;
}

bool PathWindow::reachesFar(std::size_t inUse) const {
  return m_view.end - inUse > kIntervals / 2 || segmentsFrom(inUse) > kSegments / 2;
}

} // namespace arris::control
