#include "core/job/track_builder.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::job {

using geometry::Point;
using motion::Move;
using motion::Segment;

void TrackBuilder::vertical(Move move, double to) {
  if (std::abs(to - m_at.z()) < base::kZeroLength) {
    return;
  }
  Segment segment;
  segment.shape = motion::Vertical{m_at.head<2>(), m_at.z(), to};
  segment.move = move;
  segment.feed = move == Move::Plunge ? m_machine.plungeFeed / 60 : m_machine.maxSpeed.z() / 60;
  segment.stopAtEnd = true;
  m_track.push_back(segment);
  m_at.z() = to;
}

void TrackBuilder::across(Move move, const Point& to) {
  const Point way = to - m_at.head<2>();
  if (way.norm() < base::kZeroLength) {
    return;
  }
  const Point share = way.cwiseAbs() / way.norm();
  Segment segment;
  segment.shape = geometry::Line{m_at.head<2>(), to};
  segment.move = move;
  segment.z = m_at.z();
  segment.feed = std::min(m_machine.maxSpeed.x() / share.x(), m_machine.maxSpeed.y() / share.y()) / 60;
  segment.stopAtEnd = true;
  m_track.push_back(segment);
  m_at.head<2>() = to;
}

void TrackBuilder::add(const Segment& segment) {
  m_track.push_back(segment);
  const auto* vertical = std::get_if<motion::Vertical>(&segment.shape);
  const Point end = vertical ? vertical->at : geometry::endPoint(motion::curveOf(segment));
  m_at = {end.x(), end.y(), vertical ? vertical->to : segment.z};
}

} // namespace arris::job
