#include "core/base/tolerances.h"
#include "core/program/manoeuvres.h"
#include "core/program/way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace arris::program {
namespace {

using geometry::Curve;
using geometry::Line;
using geometry::Point;
using motion::Move;
using motion::Segment;

/// Curves meet where neither a gap (mm) nor a turn (rad) between them is more than rounding makes.
constexpr double kMeets = 1e-9;

/// A first curve shorter than this is left out, mm: what the wheel stands beside it would turn it too far.
constexpr double kShortStart = 1e-3;

/// How far from its place the wheel may stand, mm.
constexpr double kBesidePlace = 2e-3;

/// A line or an arc of a step, and the λ of the job's segment at its ends.
struct Leg {
  Curve curve;
  int segment = 0;
  double from = 0;
  double to = 0;
};

bool meet(const Curve& before, const Curve& after) {
  return (geometry::endPoint(before) - geometry::startPoint(after)).norm() < kMeets &&
         (geometry::endTangent(before) - geometry::startTangent(after)).norm() < kMeets;
}

// From `at`, which lies beside the start, to the end and tangential there.
Curve startedAt(const Point& at, const Curve& curve) {
  const Point end = geometry::endPoint(curve);
  const double half = geometry::turn(end - at, geometry::endTangent(curve));
  return std::abs(half) <= base::kTangentTurn ? Curve(Line{at, end}) : geometry::arcBetween(at, end, 2 * half);
}

/// Goes along the job's way in one direction and gathers the legs.
class StepWalk {
public:
  StepWalk(const job::Job& job, const Room& room, double beside, bool back)
      : m_job(job), m_room(room), m_beside(beside), m_back(back) {}

  std::vector<Leg> from(JobPlace place, double distance) {
    m_left = distance;
    const int contour = m_job.track[static_cast<std::size_t>(place.segment)].contour;
    while (contour > 0 && isOpen(place.segment, contour)) {
      along(place);
      if (m_left < base::kZeroLength || (!m_legs.empty() && stopsBehind(place.segment))) {
        break;
      }
      place.segment += m_back ? -1 : 1;
      place.lambda = m_back ? std::numeric_limits<double>::infinity() : 0;
    }
    return std::move(m_legs);
  }

private:
  [[nodiscard]] bool isOpen(int segment, int contour) const {
    return segment >= 0 && segment < static_cast<int>(m_job.track.size()) &&
           m_job.track[static_cast<std::size_t>(segment)].contour == contour && m_room.has(segment, m_beside);
  }

  [[nodiscard]] bool stopsBehind(int segment) const {
    const int before = m_back ? segment - 1 : segment;
    return before < 0 || m_job.track[static_cast<std::size_t>(before)].stopAtEnd;
  }

  void along(const JobPlace& place) {
    std::vector<WayPiece> pieces = piecesOf(motion::curveOf(m_job.track[static_cast<std::size_t>(place.segment)]));
    if (m_back) {
      std::reverse(pieces.begin(), pieces.end());
      for (WayPiece& piece : pieces) {
        piece = {geometry::reversed(piece.curve), piece.to, piece.from};
      }
    }
    for (const WayPiece& piece : pieces) {
      const double share = std::clamp((place.lambda - piece.from) / (piece.to - piece.from), 0.0, 1.0);
      add(piece, place.segment, share * geometry::parameterLength(piece.curve));
    }
  }

  // The piece from the way `start` on it, mm, as far as the step still goes.
  void add(const WayPiece& piece, int segment, double start) {
    const double length = geometry::parameterLength(piece.curve);
    const double end = std::min(length, start + m_left);
    m_left -= end - start;
    const bool isLast = end < length;
    if (end - start < base::kZeroLength && (m_legs.empty() || isLast)) {
      return;
    }
    const auto lambdaAt = [&](double way) {
      return way >= length ? piece.to : piece.from + (piece.to - piece.from) * way / length;
    };
    const double left = toolpath::wheelSide(m_job.recipe.direction) * (m_back ? -m_beside : m_beside);
    const Curve curve = geometry::offset(geometry::part(piece.curve, start, end), left);
    if (!m_legs.empty() && !meet(m_legs.back().curve, curve)) {
      m_left = 0;
      return;
    }
    m_legs.push_back({curve, segment, lambdaAt(start), lambdaAt(end)});
  }

  const job::Job& m_job;
  const Room& m_room;
  double m_beside;
  bool m_back;
  double m_left = 0;
  std::vector<Leg> m_legs;
};

// Puts the start where the wheel is; false where that is too far away and the way there not free.
bool startAt(std::vector<Leg>& legs, const Point& at, double beside, const Room& room) {
  while (legs.size() > 1 && geometry::arcLength(legs.front().curve) < kShortStart) {
    legs.erase(legs.begin());
  }
  const Point start = geometry::startPoint(legs.front().curve);
  const double apart = (start - at).norm();
  if (apart <= kBesidePlace) {
    legs.front().curve = startedAt(at, legs.front().curve);
    return true;
  }
  const Leg over{Line{at, start}, legs.front().segment, legs.front().from, legs.front().from};
  legs.insert(legs.begin(), over);
  return apart <= 2 * beside + kBesidePlace && room.isFree(over.curve);
}

Segment segmentOf(const Leg& leg, const job::Job& job, double z) {
  Segment segment = job.track[static_cast<std::size_t>(leg.segment)];
  std::visit([&](const auto& shape) { segment.shape = shape; }, leg.curve);
  segment.move = segment.move == Move::Transition ? Move::Roll : segment.move;
  segment.z = z;
  segment.feed = std::min(job.recipe.feedPerSecond(), kStepFeed);
  segment.stopAtEnd = leg.from == leg.to; // before the way itself
  segment.stopCorner = 0;
  return segment;
}

} // namespace

std::optional<Step> stepProgram(const job::Job& job, const JobPlace& place, double distance, double beside,
                                const Position& at) {
  if (place.segment < 0) {
    return std::nullopt;
  }
  const Room room(job);
  std::vector<Leg> legs = StepWalk(job, room, beside, distance < 0).from(place, std::abs(distance));
  if (legs.empty() || !startAt(legs, at.head<2>(), beside, room)) {
    return std::nullopt;
  }
  Program program{Kind::Step, {}, {}, {}, job.limits};
  for (const Leg& leg : legs) {
    program.track.push_back(segmentOf(leg, job, at.z()));
    const double length = motion::parameterLength(program.track.back());
    program.places.push_back({{leg.segment, leg.from}, (leg.to - leg.from) / length});
  }
  program.track.back().stopAtEnd = true;
  program.intervals = motion::speedLimits(program.track, program.limits);
  return Step{std::move(program), {legs.back().segment, legs.back().to}};
}

} // namespace arris::program
