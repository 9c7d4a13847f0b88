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

bool isCorner(const PlannedPiece& piece) {
  return piece.corner != 0 && (piece.phase == Phase::Transition || piece.phase == Phase::Roll);
}

/// The corner at which the wheel stops when a piece ends, if it does.
int stopAfter(const std::vector<Segment>& track, const std::vector<PlannedPiece>& pieces, std::size_t index) {
  const int segment = pieces[index].motion.segment;
  const bool endsSegment = index + 1 == pieces.size() || pieces[index + 1].motion.segment != segment;
  return endsSegment ? track[static_cast<std::size_t>(segment)].stopCorner : 0;
}

// A change of speed belongs to the corner that it runs into or comes out of, without a break.
void attributeAccelerations(const std::vector<Segment>& track, std::vector<PlannedPiece>& pieces) {
  int corner = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (isCorner(pieces[i])) {
      corner = pieces[i].corner;
    } else if (pieces[i].phase != Phase::Accelerate) {
      corner = 0;
    } else {
      pieces[i].corner = corner;
    }
    const int stop = stopAfter(track, pieces, i);
    corner = stop != 0 ? stop : corner;
  }
}

void attributeDecelerations(const std::vector<Segment>& track, std::vector<PlannedPiece>& pieces) {
  int corner = 0;
  for (std::size_t i = pieces.size(); i-- > 0;) {
    const int stop = stopAfter(track, pieces, i);
    corner = stop != 0 ? stop : corner;
    if (isCorner(pieces[i])) {
      corner = pieces[i].corner;
    } else if (pieces[i].phase != Phase::Decelerate) {
      corner = 0;
    } else {
      pieces[i].corner = corner;
    }
  }
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

// From the first piece of a corner to one behind its last; of a stop there is none.
CornerResult resultOf(const std::vector<Segment>& track, const std::vector<PlannedPiece>& pieces, int corner,
                      std::size_t first, std::size_t behind) {
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
                                     const motion::AxisLimits& limits, const std::stop_token& stop) {
  std::vector<PlannedPiece> pieces;
  pieces.reserve(intervals.size() + 2 * track.size());
  motion::Interpolator interpolator(track, intervals, limits);
  do {
    const motion::Piece& piece = interpolator.piece();
    if (piece.duration > 0) {
      const Segment& segment = track[static_cast<std::size_t>(piece.segment)];
      pieces.push_back({piece, phaseOf(segment.move, piece.acceleration), segment.corner});
    }
  } while (interpolator.nextPiece() && !stop.stop_requested());
  attributeAccelerations(track, pieces);
  attributeDecelerations(track, pieces);
  return pieces;
}

std::vector<CornerResult> cornerResults(const std::vector<Segment>& track, const std::vector<PlannedPiece>& pieces,
                                        std::size_t corners) {
  std::vector<CornerResult> results(corners);
  std::vector<bool> done(corners, false);
  const auto note = [&](int corner, std::size_t first, std::size_t behind) {
    const auto index = static_cast<std::size_t>(corner - 1);
    if (!done[index]) {
      results[index] = resultOf(track, pieces, corner, first, behind);
      done[index] = true;
    }
  };
  for (std::size_t first = 0; first < pieces.size();) {
    std::size_t behind = first + 1;
    if (isCorner(pieces[first])) {
      while (behind < pieces.size() && pieces[behind].motion.segment == pieces[first].motion.segment) {
        ++behind;
      }
      note(pieces[first].corner, first, behind);
    }
    if (const int stop = stopAfter(track, pieces, behind - 1); stop != 0) {
      note(stop, behind, behind);
    }
    first = behind;
  }
  return results;
}

} // namespace arris::job
