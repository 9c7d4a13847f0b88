#include "core/job/trajectory.h"

#include "core/base/window_thread.h"
#include "core/geometry/parabola_nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::job {
namespace {

/// Places that differ by no more are equally near, mm.
constexpr double kAsNear = 1e-9;

/// Halvings of the whole time, after which nothing of it is left.
constexpr int kTimeHalvings = 60;

geometry::FlatBox boxOnTable(const motion::Segment& segment) {
  if (motion::parameterLength(segment) <= 0 || std::holds_alternative<motion::Vertical>(segment.shape)) {
    return {};
  }
  if (const auto* parabola = std::get_if<geometry::Parabola>(&segment.shape)) {
    geometry::FlatBox box(parabola->a);
    box.extend(geometry::FlatBox(parabola->q));
    box.extend(geometry::FlatBox(parabola->c));
    return box;
  }
  return geometry::flatBounds(motion::curveOf(segment));
}

bool isSamePhase(const PlannedPiece& a, const PlannedPiece& b) {
  return a.phase == b.phase && a.corner == b.corner;
}

} // namespace

Sample sampleOn(const Job& job, const PlannedPiece& piece, double before, double time) {
  const motion::Segment& segment = job.track[static_cast<std::size_t>(piece.motion.segment)];
  Sample sample;
  sample.setPoint = motion::setPointAt(piece.motion, segment, time);
  sample.speed = sample.setPoint.velocity.norm();
  sample.path = before + motion::arcLength(segment, sample.setPoint.lambda);
  sample.contour = segment.contour;
  sample.segment = segment.number;
  sample.corner = piece.corner;
  sample.phase = piece.phase;
  if (piece.corner != 0) {
    const toolpath::Corner& corner = job.toolpath.corners[static_cast<std::size_t>(piece.corner - 1)];
    sample.distance = (sample.setPoint.position.head<2>() - corner.s).norm();
  }
  return sample;
}

Trajectory::Trajectory(const Job& job) : m_job(job), m_before{0} {
  base::takesLong("Trajectory");
  std::vector<geometry::FlatBox> boxes;
  boxes.reserve(job.track.size());
  m_before.reserve(job.track.size() + 1);
  for (const motion::Segment& segment : job.track) {
    m_before.push_back(m_before.back() + motion::arcLength(segment, motion::parameterLength(segment)));
    boxes.push_back(boxOnTable(segment));
  }
  m_boxes = geometry::BoxTree(boxes);
}

std::size_t Trajectory::pieceAt(double time) const {
  const auto later = [](double at, const PlannedPiece& piece) { return at < piece.motion.time; };
  const auto next = std::upper_bound(m_job.pieces.begin() + 1, m_job.pieces.end(), time, later);
  return static_cast<std::size_t>(next - m_job.pieces.begin()) - 1;
}

Sample Trajectory::at(double time) const {
  const double within = std::clamp(time, 0.0, m_job.duration);
  const PlannedPiece& piece = m_job.pieces[pieceAt(within)];
  return sampleOn(m_job, piece, m_before[static_cast<std::size_t>(piece.motion.segment)], within);
}

double Trajectory::timeAfter(double way) const {
  double before = 0;
  double after = m_job.duration;
  if (way <= 0) {
    return before;
  }
  for (int i = 0; i < kTimeHalvings; ++i) {
    const double middle = (before + after) / 2;
    (at(middle).path < way ? before : after) = middle;
  }
  return after;
}

double Trajectory::firstChange(double from, double to) const {
  const auto& pieces = m_job.pieces;
  const auto begins = [&](std::size_t piece) {
    const double time = pieces[piece].motion.time;
    return time > std::min(from, to) && time < std::max(from, to) && !isSamePhase(pieces[piece - 1], pieces[piece]);
  };
  const std::size_t first = pieceAt(from);
  const std::size_t last = pieceAt(to);
  for (std::size_t piece = first + 1; piece <= last; ++piece) {
    if (begins(piece)) {
      return pieces[piece].motion.time;
    }
  }
  for (std::size_t piece = first; piece > last; --piece) {
    if (begins(piece)) {
      return pieces[piece].motion.time;
    }
  }
  return to;
}

Trajectory::Place Trajectory::nearestOn(std::size_t segment, const geometry::Point& point) const {
  const motion::Segment& on = m_job.track[segment];
  const auto* parabola = std::get_if<geometry::Parabola>(&on.shape);
  const geometry::Nearest nearest =
      parabola ? geometry::nearestOnParabola(*parabola, point) : geometry::nearest(motion::curveOf(on), point);
  return {m_before[segment] + motion::arcLength(on, nearest.lambda), nearest.distance};
}

Trajectory::Place Trajectory::nearestPlace(const geometry::Point& point) const {
  Place best{0, std::numeric_limits<double>::infinity()};
  const auto look = [&](std::size_t segment) {
    const Place place = nearestOn(segment, point);
    const bool isNearer = place.distance < best.distance - kAsNear;
    const bool isEarlier = place.distance < best.distance + kAsNear && place.way < best.way;
    if (isNearer || isEarlier) {
      best = place;
    }
    return place.distance + 2 * kAsNear; // so that one as near is looked at too
  };
  (void)m_boxes.least(point, std::numeric_limits<double>::infinity(), look);
  return best;
}

Trajectory::Place Trajectory::nearestAround(const geometry::Point& point, double way, double reach) const {
  Place best{way, std::numeric_limits<double>::infinity()};
  const auto after = std::upper_bound(m_before.begin() + 1, m_before.end(), way - reach);
  for (auto segment = static_cast<std::size_t>(after - m_before.begin()) - 1;
       segment < m_job.track.size() && m_before[segment] <= way + reach; ++segment) {
    const motion::Segment& on = m_job.track[segment];
    if (!std::holds_alternative<motion::Vertical>(on.shape) && motion::parameterLength(on) > 0) {
      const Place place = nearestOn(segment, point);
      best = place.distance < best.distance ? place : best;
    }
  }
  return best;
}

Trajectory::Near Trajectory::nearest(const geometry::Point& point) const {
  const Place place = nearestPlace(point);
  return {timeAfter(place.way), place.distance};
}

Trajectory::Near Trajectory::nearest(const geometry::Point& point, double time, double reach) const {
  const Place anywhere = nearestPlace(point);
  Place here = nearestAround(point, at(time).path, reach);
  for (Place next = nearestAround(point, here.way, reach); next.distance < here.distance - kAsNear;
       next = nearestAround(point, here.way, reach)) {
    here = next;
  }
  const Place& place = here.distance <= anywhere.distance + reach ? here : anywhere;
  return {timeAfter(place.way), place.distance};
}

} // namespace arris::job
