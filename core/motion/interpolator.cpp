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

Interpolator::Interpolator(std::span<const Segment> track, std::span<const Interval> intervals, AxisLimits limits)
    : m_track(track), m_intervals(intervals), m_limits(std::move(limits)) {
  assert(!m_intervals.empty());
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
  m_followNext = Follow::Nothing;
  decide();
}

SetPoint Interpolator::advanceTo(double time) {
  while (!atEnd() && m_piece.time + m_piece.duration <= time) {
    if (!nextPiece()) {
      break;
    }
  }
  m_time = std::max(m_time, time);
  const Segment& on = m_track[static_cast<std::size_t>(m_piece.segment)];
  return setPointAt(m_piece, on, std::min(time, m_piece.time + m_piece.duration));
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
    m_followNext = Follow::Nothing;
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

// (mm/s)²: the constant part of c².
double Interpolator::feed2() const {
  const double feed = segment().feed;
  return m_override <= 1 ? squared(m_override) * std::min(squared(feed), interval().cap2)
                         : std::min(interval().cap2, squared(m_override * feed));
}

// The falling part of c²: K scaled by an override below 1 is admissible with o² of the acceleration.
double Interpolator::brake() const {
  return interval().brake * squared(std::min(1.0, m_override));
}

double Interpolator::brakeLine2(double lambda) const {
  const double scale = squared(std::min(1.0, m_override));
  return scale * (interval().end2 + 2 * interval().brake * (interval().to - lambda));
}

void Interpolator::settle(double acceleration, double distance, double endSpeed2, Follow next) {
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
  m_follow = m_followNext;
  const double speed2 = squared(m_piece.speed);
  const double cap = std::min(feed2(), brakeLine2(m_piece.lambda));
  if (m_follow == Follow::Nothing && (m_override == 0 || speed2 > cap * (1 + kOnLine))) {
    decideFall(speed2);
    return;
  }
  if (m_follow == Follow::Nothing && speed2 >= cap * (1 - kOnLine) && cap > 0) {
    m_follow = feed2() <= brakeLine2(m_piece.lambda) ? Follow::Feed : Follow::Brake;
  }
  switch (m_follow) {
  case Follow::Feed:
    decideFeed(speed2);
    break;
  case Follow::Brake:
    decideBrake(speed2);
    break;
  case Follow::Nothing:
    decideFree(speed2);
    break;
  }
}

// Along the feed until K is met; where the axes do not admit that, what they admit.
void Interpolator::decideFeed(double speed2) {
  if (admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).most < 0) {
    decideFree(speed2);
    return;
  }
  const double rest = interval().to - m_piece.lambda;
  const double over = std::max(0.0, brakeLine2(m_piece.lambda) - speed2);
  const double meetsBrake = brake() > 0 ? over / (2 * brake()) : kNever;
  settle(0, std::min(rest, meetsBrake), speed2, meetsBrake < rest ? Follow::Brake : Follow::Nothing);
}

// Down along K to its value at the end of the interval; where the axes do not admit that, what they admit.
void Interpolator::decideBrake(double speed2) {
  const double rest = interval().to - m_piece.lambda;
  const double most = admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).most;
  if (most < -brake() - kRounding) {
    settle(most, rest, speed2 + 2 * most * rest, Follow::Nothing);
  } else {
    settle(-brake(), rest, brakeLine2(interval().to), Follow::Nothing);
  }
}

// As fast as the axes admit, until the feed or K is met.
void Interpolator::decideFree(double speed2) {
  const double most = admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).most;
  const double rest = interval().to - m_piece.lambda;
  const double feed = feed2();
  const double meetsFeed = most > 0 ? (feed - speed2) / (2 * most) : kNever;
  const double closing = most + brake();
  const double meetsBrake = closing > 0 ? std::max(0.0, brakeLine2(m_piece.lambda) - speed2) / (2 * closing) : kNever;
  if (meetsBrake < rest && meetsBrake <= meetsFeed) {
    settle(most, meetsBrake, brakeLine2(m_piece.lambda + meetsBrake), Follow::Brake);
  } else if (meetsFeed < rest) {
    settle(most, meetsFeed, feed, Follow::Feed);
  } else {
    settle(most, rest, std::min(speed2 + 2 * most * rest, brakeLine2(interval().to)), Follow::Nothing);
  }
}

// Above the cap, or in a hold: down as fast as the axes admit, until the cap is met or the wheel rests.
void Interpolator::decideFall(double speed2) {
  if (speed2 == 0) {
    standStill();
    return;
  }
  const double least = std::min(0.0, admissible(segment(), interval(), m_limits, m_piece.lambda, speed2).least);
  const double rest = interval().to - m_piece.lambda;
  const double toRest = least < 0 ? speed2 / (-2 * least) : kNever;
  if (m_override == 0) {
    settle(least, std::min(rest, toRest), toRest <= rest ? 0.0 : speed2 + 2 * least * rest, Follow::Nothing);
    return;
  }
  double toFeed = kNever;
  if (least < 0) {
    toFeed = std::max(0.0, (speed2 - feed2()) / (-2 * least));
  }
  const double closing = -least - brake();
  const double over = speed2 - brakeLine2(m_piece.lambda);
  double toBrake = closing > 0 ? over / (2 * closing) : kNever;
  if (over <= 0) {
    toBrake = 0;
  }
  const double meets = std::max(toFeed, toBrake);
  if (meets < rest) {
    settle(least, meets, std::min(feed2(), brakeLine2(m_piece.lambda + meets)),
           toFeed >= toBrake ? Follow::Feed : Follow::Brake);
  } else {
    settle(least, rest, speed2 + 2 * least * rest, Follow::Nothing);
  }
}

} // namespace arris::motion
