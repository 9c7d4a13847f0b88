#include "core/program/stream.h"

#include "core/base/numbers.h"

#include <cmath>
#include <utility>

namespace arris::program {

using motion::Move;
using motion::Segment;

Stream::Stream(const Program& program, std::uint32_t number, std::function<double(int)> room)
    : m_program(&program), m_number(number), m_room(std::move(room)) {
  if (!done()) {
    makePair();
  }
}

bool Stream::isTransition(std::size_t segment) const {
  return segment < m_program->track.size() && m_program->track[segment].move == Move::Transition &&
         std::holds_alternative<geometry::Parabola>(m_program->track[segment].shape);
}

double Stream::roomOn(std::size_t segment) const {
  const int onJob = m_program->places[segment].from.segment;
  return m_room && onJob >= 0 ? m_room(onJob) : 0;
}

int Stream::countLimits(std::size_t segment) {
  const std::size_t first = m_endInterval;
  while (m_endInterval < m_program->intervals.size() &&
         m_program->intervals[m_endInterval].segment == static_cast<int>(segment)) {
    ++m_endInterval;
  }
  return static_cast<int>(m_endInterval - first);
}

void Stream::makePair() {
  const Segment& segment = m_program->track[m_next];
  InputPoint record;
  record.program = m_number;
  record.segment = static_cast<int>(m_next);
  record.normalSpeed = segment.feed;
  record.accelerations = m_program->limits.acceleration.head<2>();
  record.place = m_program->places[m_next];
  record.room = roomOn(m_next);
  record.limits = countLimits(m_next);
  if (isTransition(m_next + 1)) {
    const Segment& blend = m_program->track[m_next + 1];
    const auto& path = std::get<geometry::Parabola>(blend.shape);
    record.side = CornerSide::Before;
    record.transition = {path.a, path.q, path.c, blend.number, countLimits(m_next + 1)};
    record.transitionPlace = m_program->places[m_next + 1];
    record.transitionRoom = roomOn(m_next + 1);
    describeCorner(record, blend);
  } else if (m_next > 0 && isTransition(m_next - 1)) {
    record.side = CornerSide::After;
    describeCorner(record, m_program->track[m_next - 1]);
  }
  record.isLast = m_next + (record.side == CornerSide::Before ? 2 : 1) == m_program->track.size();
  m_pair = {&segment, record, std::span(m_program->intervals).subspan(m_interval, m_endInterval - m_interval)};
}

void Stream::describeCorner(InputPoint& record, const Segment& blend) const {
  record.sharpCorner = true;
  record.corner = blend.corner;
  record.transitionSpeed = blend.speedCap;
  const auto& path = std::get<geometry::Parabola>(blend.shape);
  record.cornerAngle = base::kPi - std::abs(geometry::turn(path.q - path.a, path.c - path.q));
  const auto corner = static_cast<std::size_t>(blend.corner - 1);
  if (corner < m_program->corners.size()) {
    record.decelerationLength = m_program->corners[corner].decelerationLength;
    record.accelerationLength = m_program->corners[corner].accelerationLength;
  }
}

void Stream::advance() {
  m_next += m_pair.record.side == CornerSide::Before ? 2 : 1;
  m_interval = m_endInterval;
  if (!done()) {
    makePair();
  }
}

} // namespace arris::program
