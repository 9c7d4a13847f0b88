#include "core/motion/interpolator.h"

#include "core/base/numbers.h"
#include "core/motion/axis_range.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace arris::motion {
namespace {

using base::squared;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// λ̇² nearer to a line than this share of it lies on the line.
constexpr double kOnLine = 1e-12;

/// What rounding may add to an acceleration, mm/s².
constexpr double kRounding = 1e-9;

} // namespace

SetPoint setPointAt(const Piece& piece, const Segment& segment, double time) {
  const double t = time - piece.time;
  SetPoint point;
  point.time = time;
  point.segment = piece.segment;
  point.acceleration = piece.acceleration;
  point.speed = std::max(0.0, piece.speed + piece.acceleration * t);
  point.lambda =
      std::clamp(piece.lambda + (piece.speed + piece.acceleration * t / 2) * t, piece.lambda, piece.endLambda);
  const Evaluation q = evaluate(segment, point.lambda);
  point.position = q.point;
  point.velocity = point.speed * q.first;
  point.axisAcceleration = point.acceleration * q.first + squared(point.speed) * q.second;
  return point;
}

Interpolator::Interpolator(const TrackView& track, AxisLimits limits) : m_track(track), m_limits(std::move(limits)) {
  assert(m_track.end > 0);
  enterInterval();
  decide();
}

void Interpolator::setOverride(double factor) {
  if (factor == m_override) {
    return;
  }
  m_override = factor;
  if (atEnd()) {
    return;
  }
  const SetPoint now = setPointAt(m_piece, segment(), m_time);
  m_piece.time = m_time;
  m_piece.lambda = now.lambda;
  m_piece.speed = now.speed;
  m_followNext.reset();
  decide();
}

SetPoint Interpolator::advanceTo(double time) {
  while (!atEnd() && m_piece.time + m_piece.duration <= time) {
    if (!nextPiece()) {
      break;
    }
  }
  m_time = std::max(m_time, time);
  return setPointAt(m_piece, m_track.segment(m_piece.segment), std::min(time, m_piece.time + m_piece.duration));
}

bool Interpolator::standsStill() const {
  return m_piece.duration == kNever;
}

bool Interpolator::nextPiece() {
  if (atEnd() || m_piece.duration == kNever) {
    return false;
  }
  m_time = m_piece.time + m_piece.duration;
  m_piece.time = m_time;
  m_piece.lambda = m_piece.endLambda;
  m_piece.speed = std::sqrt(m_endSpeed2);
  if (m_piece.lambda >= interval().to) {
    ++m_index;
    m_followNext.reset();
    if (atEnd()) {
      m_piece.duration = 0;
      m_piece.acceleration = 0;
      return false;
    }
    enterInterval();
  }
  decide();
  return true;
}

void Interpolator::enterInterval() {
  m_piece.segment = interval().segment;
  m_piece.lambda = interval().from;
}

// Up to an override of 1 the whole profile scales: K scaled by o is admissible with o² of the acceleration.
Interpolator::Lines Interpolator::lines() const {
  const Interval& on = interval();
  const double scale = squared(std::min(1.0, m_override));
  const double length = on.to - on.from;
  const double rise = length > 0 ? (on.capEnd2 - on.cap2) / length : 0;
  return {Line{squared(m_override * segment().feed), 0},
          Line{scale * (on.cap2 + rise * (m_piece.lambda - on.from)), scale * rise},
          Line{scale * (on.end2 + 2 * on.brake * (on.to - m_piece.lambda)), -2 * scale * on.brake}};
}

void Interpolator::settle(double acceleration, double distance, double endSpeed2, std::optional<Bound> next) {
  const double end = m_piece.lambda + distance;
  m_piece.acceleration = acceleration;
  const bool reachesEnd = end >= interval().to;
  m_piece.endLambda = reachesEnd ? interval().to : end;
  m_endSpeed2 = std::clamp(endSpeed2, 0.0, reachesEnd ? interval().end2 : kNever); // a stop is a stop to the last bit
  // From rest to rest only over what rounding left before a stop.
  const double speeds = m_piece.speed + std::sqrt(m_endSpeed2);
  m_piece.duration = speeds > 0 ? 2 * (m_piece.endLambda - m_piece.lambda) / speeds : 0;
  m_followNext = next;
}

void Interpolator::standStill() {
  m_piece.acceleration = 0;
  m_piece.speed = 0;
  m_piece.duration = kNever;
  m_piece.endLambda = m_piece.lambda;
}

void Interpolator::decide() {
  const std::optional<Bound> follow = std::exchange(m_followNext, std::nullopt);
  const Lines bounds = lines();
  if (follow) {
    decideAlong(bounds, *follow, squared(m_piece.speed));
    return;
  }
  const double speed2 = squared(m_piece.speed);
  const auto* const lowest =
      std::min_element(bounds.begin(), bounds.end(), [](const Line& a, const Line& b) { return a.speed2 < b.speed2; });
  if (m_override == 0 || speed2 > lowest->speed2 * (1 + kOnLine)) {
    decideFall(bounds, speed2);
  } else if (speed2 >= lowest->speed2 * (1 - kOnLine) && lowest->speed2 > 0) {
    decideAlong(bounds, static_cast<Bound>(lowest - bounds.begin()), speed2);
  } else {
    decideFree(bounds, speed2);
  }
}

// Along a line until a lower one is met; where the axes do not admit that, what they admit.
void Interpolator::decideAlong(const Lines& lines, Bound bound, double speed2) {
  const Line& line = lines[static_cast<std::size_t>(bound)];
  if (admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).most < line.slope / 2 - kRounding) {
    decideFree(lines, speed2);
    return;
  }
  double distance = interval().to - m_piece.lambda;
  std::optional<Bound> next;
  for (const Bound other : {Bound::Feed, Bound::Cap, Bound::Brake}) {
    const Line& under = lines[static_cast<std::size_t>(other)];
    const double meets = (under.speed2 - line.speed2) / (line.slope - under.slope);
    if (line.slope > under.slope && meets < distance) {
      distance = std::max(0.0, meets);
      next = other;
    }
  }
  settle(line.slope / 2, distance, line.speed2 + line.slope * distance, next);
}

// As fast as the axes admit, until a line is met.
void Interpolator::decideFree(const Lines& lines, double speed2) {
  const double most = admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).most;
  double distance = interval().to - m_piece.lambda;
  std::optional<Bound> next;
  for (const Bound bound : {Bound::Feed, Bound::Cap, Bound::Brake}) {
    const Line& line = lines[static_cast<std::size_t>(bound)];
    const double meets = std::max(0.0, line.speed2 - speed2) / (2 * most - line.slope);
    if (2 * most > line.slope && meets < distance) {
      distance = meets;
      next = bound;
    }
  }
  double endSpeed2 = speed2 + 2 * most * distance;
  for (const Line& line : lines) {
    endSpeed2 = std::min(endSpeed2, line.speed2 + line.slope * distance);
  }
  settle(most, distance, endSpeed2, next);
}

// Above the bounds, or in a hold: down as fast as the axes admit, until the last line is met or the wheel rests.
void Interpolator::decideFall(const Lines& lines, double speed2) {
  if (speed2 == 0) {
    standStill();
    return;
  }
  const double least = std::min(0.0, admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).least);
  const double rest = interval().to - m_piece.lambda;
  if (m_override == 0) {
    const double toRest = least < 0 ? speed2 / (-2 * least) : kNever;
    settle(least, std::min(rest, toRest), toRest <= rest ? 0.0 : speed2 + 2 * least * rest, std::nullopt);
    return;
  }
  double distance = 0;
  std::optional<Bound> last;
  for (const Bound bound : {Bound::Feed, Bound::Cap, Bound::Brake}) {
    const Line& line = lines[static_cast<std::size_t>(bound)];
    if (speed2 <= line.speed2) {
      continue;
    }
    const double meets = line.slope > 2 * least ? (speed2 - line.speed2) / (line.slope - 2 * least) : kNever;
    if (meets >= distance) {
      distance = meets;
      last = bound;
    }
  }
  if (distance < rest) {
    const Line& line = lines[static_cast<std::size_t>(*last)];
    settle(least, distance, line.speed2 + line.slope * distance, last);
  } else {
    settle(least, rest, speed2 + 2 * least * rest, std::nullopt);
  }
}

} // namespace arris::motion
