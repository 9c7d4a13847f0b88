#include "core/job/phases.h"

#include <algorithm>
#include <cmath>

namespace arris::job {
namespace {

using motion::Move;
using motion::Segment;

/// A change of speed slower than this is rounding, mm/s².
constexpr double kNoAcceleration = 1e-6;

Phase phaseOf(Move move, double acceleration) {
  switch (move) {
  case Move::Approach:
    return Phase::Approach;
  case Move::Plunge:
    return Phase::Plunge;
  case Move::LeadIn:
    return Phase::LeadIn;
  case Move::Transition:
    return Phase::Transition;
  case Move::Roll:
    return Phase::Roll;
  case Move::LeadOut:
    return Phase::LeadOut;
  case Move::Retract:
    return Phase::Retract;
  case Move::Traverse:
    return Phase::Traverse;
  case Move::Contour:
    break;
  }
  if (std::abs(acceleration) < kNoAcceleration) {
    return Phase::Cruise;
  }
  return acceleration > 0 ? Phase::Accelerate : Phase::Decelerate;
}

// A change of speed belongs to the corner that it runs into or comes out of, without a break.
template <typename Iterator> void attribute(Iterator from, Iterator to, Phase phase) {
  int corner = 0;
  for (; from != to; ++from) {
    if (from->phase == Phase::Transition || from->phase == Phase::Roll) {
      corner = from->corner;
    } else if (from->phase != phase) {
      corner = 0;
    } else {
      from->corner = corner;
    }
  }
}

bool isCorner(const PlannedPiece& piece) {
  return piece.phase == Phase::Transition || piece.phase == Phase::Roll;
}

double lengthOf(const PlannedPiece& piece) {
  return piece.motion.endLambda - piece.motion.lambda; // on the contour λ is the length travelled
}

geometry::Point pointAt(const std::vector<Segment>& track, const motion::Piece& piece, double lambda) {
  return motion::evaluate(track[static_cast<std::size_t>(piece.segment)], lambda).point.head<2>();
}

double fastest(const motion::Piece& piece) {
  return std::max(piece.speed, piece.speed + piece.acceleration * piece.duration);
}

// From the first piece of a corner to one behind its last.
CornerResult resultOf(const std::vector<Segment>& track, const std::vector<PlannedPiece>& pieces, std::size_t first,
                      std::size_t behind) {
  const int corner = pieces[first].corner;
  CornerResult result;
  for (std::size_t i = first; i < behind; ++i) {
    result.plannedTime += pieces[i].motion.duration;
    result.plannedSpeed = std::max(result.plannedSpeed, fastest(pieces[i].motion));
  }
  std::size_t before = first;
  while (before > 0 && pieces[before - 1].phase == Phase::Decelerate && pieces[before - 1].corner == corner) {
    --before;
    result.decelerationLength += lengthOf(pieces[before]);
  }
  result.decelerationPoint = pointAt(track, pieces[before].motion, pieces[before].motion.lambda);
  std::size_t after = behind;
  while (after < pieces.size() && pieces[after].phase == Phase::Accelerate && pieces[after].corner == corner) {
    result.accelerationLength += lengthOf(pieces[after]);
    ++after;
  }
  const motion::Piece& last = pieces[after - 1].motion;
  result.accelerationPoint = pointAt(track, last, last.endLambda);
  return result;
}

} // namespace

std::vector<PlannedPiece> planPieces(const std::vector<Segment>& track, const std::vector<motion::Interval>& intervals,
                                     const motion::AxisLimits& limits) {
  std::vector<PlannedPiece> pieces;
  pieces.reserve(intervals.size() + 2 * track.size());
  motion::Interpolator interpolator(track, intervals, limits);
  do {
    const motion::Piece& piece = interpolator.piece();
    if (piece.duration > 0) {
      const Segment& segment = track[static_cast<std::size_t>(piece.segment)];
      pieces.push_back({piece, phaseOf(segment.move, piece.acceleration), segment.corner});
    }
  } while (interpolator.nextPiece());
  attribute(pieces.begin(), pieces.end(), Phase::Accelerate);
  attribute(pieces.rbegin(), pieces.rend(), Phase::Decelerate);
  return pieces;
}

std::vector<CornerResult> cornerResults(const std::vector<Segment>& track, const std::vector<PlannedPiece>& pieces,
                                        std::size_t corners) {
  std::vector<CornerResult> results(corners);
  std::vector<bool> done(corners, false);
  for (std::size_t first = 0; first < pieces.size();) {
    std::size_t behind = first + 1;
    if (isCorner(pieces[first])) {
      const auto index = static_cast<std::size_t>(pieces[first].corner - 1);
      while (behind < pieces.size() && pieces[behind].motion.segment == pieces[first].motion.segment) {
        ++behind;
      }
      if (!done[index]) {
        results[index] = resultOf(track, pieces, first, behind);
        done[index] = true;
      }
    }
    first = behind;
  }
  return results;
}

} // namespace arris::job
