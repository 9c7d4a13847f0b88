#include "core/base/numbers.h"
#include "core/job/program_track.h"
#include "core/job/track_builder.h"
#include "core/program/manoeuvres.h"
#include "core/program/way.h"
#include "core/toolpath/chain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace arris::program {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Point;
using motion::Move;
using motion::Segment;

/// What is left of a segment behind the place where a lead-in joins it, and before that place, is nothing or as long as
/// this, mm.
constexpr double kShortRest = 1e-3;

/// How often a lead-in is tried a little farther back, each time by what it needs to come clear of an edge behind it
/// and `kBackAgain` mm.
constexpr int kTriedNear = 4;
constexpr double kBackAgain = 1;

/// In the middle of how many segments before the place a lead-in is tried.
constexpr int kTriedMiddles = 100;

toolpath::EdgeId nearestEdge(const toolpath::Glass& glass, const Point& point) {
  toolpath::EdgeId best = 0;
  double least = std::numeric_limits<double>::infinity();
  (void)glass.tree().least(point, least, [&](std::size_t edge) {
    const double distance = geometry::nearest(glass.edges()[edge], point).distance;
    if (distance < least) {
      least = distance;
      best = static_cast<toolpath::EdgeId>(edge);
    }
    return distance;
  });
  return best;
}

/// A lead-in and where on the job's way it ends.
struct Joining {
  Arc lead;
  JobPlace place;
};

/// Finds where the job can be entered again.
class JoiningSearch {
public:
  explicit JoiningSearch(const job::Job& job)
      : m_job(job), m_glass(toolpath::glassOf(job.contours, job.recipe.direction)) {}

  [[nodiscard]] std::optional<Joining> before(const JobPlace& place, double overlap) const {
    const std::optional<JobPlace> first = back(place, overlap);
    const double radius = m_job.recipe.wheelRadius;
    const double again = std::sqrt(base::squared(radius + m_job.recipe.depth) - base::squared(radius)) + kBackAgain;
    std::optional<JobPlace> tried = first;
    for (int i = 0; tried && i < kTriedNear; ++i, tried = back(*tried, again)) {
      if (const std::optional<Arc> lead = leadTo(*tried)) {
        return Joining{*lead, *tried};
      }
    }
    return first ? inAMiddle(*first) : std::nullopt;
  }

private:
  [[nodiscard]] const Segment& at(int segment) const {
    return m_job.track[static_cast<std::size_t>(segment)];
  }

  // The place so much before another, mm along the way; the start of a transition instead of a place inside. Nothing
  // where that is before the contour.
  [[nodiscard]] std::optional<JobPlace> back(JobPlace place, double distance) const {
    while (motion::isAlongContour(at(place.segment).move)) {
      const Segment& segment = at(place.segment);
      const double way = motion::arcLength(segment, place.lambda);
      if (distance <= way) {
        return JobPlace{place.segment, segment.move == Move::Transition ? 0 : cutOf(segment, way - distance)};
      }
      distance -= way;
      --place.segment; // a contour never begins the track
      place.lambda = motion::parameterLength(at(place.segment));
    }
    return std::nullopt;
  }

  static double cutOf(const Segment& segment, double lambda) {
    const double cut = std::min(lambda, motion::parameterLength(segment) - kShortRest);
    return cut < kShortRest ? 0 : cut;
  }

  [[nodiscard]] std::optional<Joining> inAMiddle(const JobPlace& place) const {
    int segment = place.segment;
    for (int i = 0; i < kTriedMiddles && motion::isAlongContour(at(segment).move); ++i, --segment) {
      const JobPlace middle{segment, motion::parameterLength(at(segment)) / 2};
      if (at(segment).move == Move::Transition || (segment == place.segment && middle.lambda > place.lambda)) {
        continue;
      }
      if (const std::optional<Arc> lead = leadTo(middle)) {
        return Joining{*lead, middle};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Arc> leadTo(const JobPlace& place) const {
    const Curve whole = motion::curveOf(at(place.segment));
    const Curve rest = place.lambda > 0 ? geometry::part(whole, place.lambda, geometry::parameterLength(whole)) : whole;
    const Arc lead = toolpath::leadInTo(rest, m_job.recipe);
    const toolpath::EdgeId edge = nearestEdge(m_glass, geometry::startPoint(rest));
    const bool hasRoom = isInTravel(lead, m_job.machine) && checkLeadIn(lead, edge, m_glass, m_job.recipe).empty();
    return hasRoom ? std::optional(lead) : std::nullopt;
  }

  const job::Job& m_job;
  toolpath::Glass m_glass;
};

// Where the work on a contour begins: of the one that the segment belongs to, or of the next one behind its lead-out;
// the end of the track behind the last.
std::size_t contourBegin(const std::vector<Segment>& track, std::size_t segment) {
  const auto isAhead = [&](std::size_t i) { return track[i].contour > 0 && track[i].move != Move::LeadOut; };
  if (isAhead(segment)) {
    while (segment > 0 && track[segment - 1].contour > 0) {
      --segment;
    }
    return segment;
  }
  while (segment < track.size() && !isAhead(segment)) {
    ++segment;
  }
  return segment;
}

Segment leadSegment(const Joining& joining, const job::Job& job) {
  const Segment& onto = job.track[static_cast<std::size_t>(joining.place.segment)];
  Segment segment;
  segment.shape = joining.lead;
  segment.move = Move::LeadIn;
  segment.z = onto.z;
  segment.feed = job.recipe.feedPerSecond();
  segment.contour = onto.contour;
  segment.number = job.track[contourBegin(job.track, static_cast<std::size_t>(joining.place.segment))].number;
  return segment;
}

// The way there; what it leads to follows.
std::vector<Segment> wayTo(const Point& start, const std::optional<Joining>& joining, const job::Job& job,
                           const Position& at) {
  const job::Heights heights = job::heightsOf(job.recipe, job.machine);
  job::TrackBuilder builder(job.machine, at);
  builder.vertical(Move::Approach, std::max(at.z(), heights.clearance));
  builder.across(Move::Approach, start);
  builder.vertical(Move::Approach, heights.clearance);
  if (joining) {
    builder.vertical(Move::Plunge, heights.grinding);
    builder.add(leadSegment(*joining, job));
  }
  return builder.take();
}

// Adds the job from a place on to its end.
void addRest(Program& program, const job::Job& job, const JobPlace& place) {
  for (int i = place.segment; i < static_cast<int>(job.track.size()); ++i) {
    Segment segment = job.track[static_cast<std::size_t>(i)];
    const double from = i == place.segment ? place.lambda : 0;
    if (from > 0) {
      const Curve rest = geometry::part(motion::curveOf(segment), from, motion::parameterLength(segment));
      std::visit([&](const auto& shape) { segment.shape = shape; }, rest);
    }
    program.track.push_back(segment);
    program.places.push_back({{i, from}, 1});
  }
}

} // namespace

Program resumeProgram(const job::Job& job, const JobPlace& place, double overlap, const Position& at) {
  const auto segment = static_cast<std::size_t>(std::max(place.segment, 0));
  std::size_t begin = contourBegin(job.track, segment);
  if (begin == job.track.size()) {
    Program program = parkProgram(job.recipe, job.machine, at);
    program.kind = Kind::Job;
    return program;
  }
  const std::optional<Joining> joining =
      motion::isAlongContour(job.track[segment].move) ? JoiningSearch(job).before(place, overlap) : std::nullopt;
  const Point start = joining ? joining->lead.start : geometry::startPoint(motion::curveOf(job.track[begin]));
  if (begin > 0 && job.track[begin - 1].move == Move::Plunge) {
    --begin;
  }
  Program program{Kind::Job, wayTo(start, joining, job, at), {}, {}, job.limits};
  program.places.assign(program.track.size(), {{}, 0});
  addRest(program, job, joining ? joining->place : JobPlace{static_cast<int>(begin), 0});
  program.intervals = motion::speedLimits(program.track, program.limits);
  return program;
}

} // namespace arris::program
