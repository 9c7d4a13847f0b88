#include "tests/support/promises.h"

#include "core/base/tolerances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::test {
namespace {

using base::Problem;
using geometry::Curve;
using geometry::Point;
using Broken = std::optional<std::string>;

constexpr double kSameSpot = 1e-6; ///< mm, on a pane that can be ground

bool isFinite(const base::Value& value) {
  const double* number = std::get_if<double>(&value.value);
  return !number || std::isfinite(*number);
}

bool hasValue(const Problem& problem, std::string_view name) {
  return std::any_of(problem.values.begin(), problem.values.end(), [name](const auto& v) { return v.name == name; });
}

/// A name within braces in the text for which there is no value.
std::string missingValue(const Problem& problem) {
  const std::string_view text = base::info(problem.code).text;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::string_view name = text.substr(open + 1, text.find('}', open) - open - 1);
    if (!hasValue(problem, name)) {
      return std::string(name);
    }
  }
  return {};
}

Broken untold(const base::Problems& problems) {
  for (const Problem& problem : problems) {
    const std::string text = base::describeWithPlace(problem);
    if (problem.code == base::Code::NumericalFailure) {
      return text;
    }
    if (const std::string missing = missingValue(problem); !missing.empty()) {
      return fmt::format("no value of {}: {}", missing, text);
    }
    if (!std::all_of(problem.values.begin(), problem.values.end(), isFinite) ||
        (problem.where && !problem.where->allFinite())) {
      return "a number is not finite: " + text;
    }
    if (problem.line && *problem.line < 1) {
      return "there is no such line: " + text;
    }
  }
  return std::nullopt;
}

bool isFinite(const Curve& curve) {
  const double length = geometry::parameterLength(curve);
  return std::isfinite(length) && length > 0 && geometry::startPoint(curve).allFinite() &&
         geometry::endPoint(curve).allFinite() && geometry::startTangent(curve).allFinite() &&
         geometry::endTangent(curve).allFinite();
}

/// Rounding of coordinates far from the origin.
double samePointAt(const Point& point) {
  return kSameSpot + 1e-12 * point.cwiseAbs().maxCoeff();
}

Broken brokenChain(const std::vector<Curve>& chain, std::string_view what) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (!isFinite(chain[i])) {
      return fmt::format("curve {} of {} has no length or is not finite", i, what);
    }
    const Point end = geometry::endPoint(chain[i]);
    const double gap = i + 1 < chain.size() ? (geometry::startPoint(chain[i + 1]) - end).norm() : 0;
    if (!(gap <= samePointAt(end))) {
      return fmt::format("{} has a gap of {} mm after curve {} at ({}, {})", what, gap, i, end.x(), end.y());
    }
  }
  return std::nullopt;
}

Broken openContour(const pattern::Contour& contour) {
  const std::string what = fmt::format("contour {}", contour.id);
  if (contour.curves.empty()) {
    return what + " is empty";
  }
  std::vector<Curve> closed = contour.curves;
  closed.push_back(closed.front());
  return brokenChain(closed, what);
}

Broken cuts(const toolpath::PathSegment& segment, const std::vector<pattern::Contour>& contours, double radius) {
  constexpr int kSteps = 4;
  const double length = geometry::parameterLength(segment.shape);
  for (int step = 0; step <= kSteps; ++step) {
    const Point centre = geometry::pointAt(segment.shape, length * step / kSteps);
    for (const pattern::Contour& contour : contours) {
      for (const Curve& curve : contour.curves) {
        const double distance = geometry::nearest(curve, centre).distance;
        if (!(distance >= radius - base::kContourAccuracy - samePointAt(centre))) {
          return fmt::format("the wheel of {} mm comes within {} mm of contour {} with its centre at ({}, {})", radius,
                             distance, contour.id, centre.x(), centre.y());
        }
      }
    }
  }
  return std::nullopt;
}

Broken brokenPath(const job::Job& job) {
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    std::vector<Curve> curves;
    for (const toolpath::PathSegment& segment : chain.segments) {
      if (Broken broken = cuts(segment, job.contours, job.recipe.wheelRadius)) {
        return broken;
      }
      curves.push_back(segment.shape);
    }
    if (Broken broken = brokenChain(curves, fmt::format("the wheel path of contour {}", chain.contour))) {
      return broken;
    }
  }
  return std::nullopt;
}

Broken brokenTrack(const job::Job& job) {
  Eigen::Vector3d reached = job.machine.park;
  for (std::size_t i = 0; i < job.track.size(); ++i) {
    const motion::Segment& segment = job.track[i];
    const double length = motion::parameterLength(segment);
    if (!std::isfinite(length) || !(length >= 0)) {
      return fmt::format("segment {} of the track has a length of {} mm", i, length);
    }
    const double gap = (motion::evaluate(segment, 0).point - reached).norm();
    if (!(gap <= kSameSpot)) {
      return fmt::format("the track has a gap of {} mm before segment {}", gap, i);
    }
    reached = motion::evaluate(segment, length).point;
  }
  return (reached - job.machine.park).norm() <= kSameSpot ? Broken() : "the track does not end at the park position";
}

Broken brokenProfile(const job::Job& job) {
  double time = 0;
  for (std::size_t i = 0; i < job.pieces.size(); ++i) {
    const motion::Piece& piece = job.pieces[i].motion;
    const std::array numbers{piece.time,      piece.duration, piece.lambda,
                             piece.endLambda, piece.speed,    piece.acceleration};
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) {
      return fmt::format("a number of piece {} is not finite", i);
    }
    if (piece.duration < 0 || piece.speed < 0 || piece.endLambda < piece.lambda ||
        std::abs(piece.time - time) > 1e-9 * (1 + time)) {
      return fmt::format("piece {} goes backwards", i);
    }
    time = piece.time + piece.duration;
  }
  return std::isfinite(job.duration) && job.duration > 0 ? Broken() : "the program takes no time";
}

Broken brokenSamples(const job::Job& job) {
  constexpr double kRows = 100;
  for (job::Sampler sampler(job, job.duration / kRows); !sampler.done();) {
    const job::Sample sample = sampler.next();
    const motion::SetPoint& point = sample.setPoint;
    if (!point.position.allFinite() || !point.velocity.allFinite() || !point.axisAcceleration.allFinite() ||
        !std::isfinite(sample.speed) || !std::isfinite(sample.path)) {
      return fmt::format("the set-point at {} s is not finite", point.time);
    }
    const Eigen::Array3d beyond = (point.position - job.machine.travel).array().max(-point.position.array());
    if (beyond.maxCoeff() > kSameSpot) {
      return fmt::format("the set-point at {} s lies {} mm outside of the travel", point.time, beyond.maxCoeff());
    }
  }
  return std::nullopt;
}

} // namespace

recipe::Recipe recipeFor(std::string_view file) {
  constexpr unsigned kNormal = '\n';
  const unsigned choice = (file.empty() ? kNormal : static_cast<unsigned char>(file.back())) ^ kNormal;
  recipe::Recipe recipe;
  recipe.wheelRadius = std::array{75.0, 10.0, 0.5, 500.0}.at(choice & 3U);
  recipe.acceptUnreached = (choice & 4U) != 0;
  recipe.smooth = (choice & 8U) != 0 ? 0 : recipe.smooth;
  recipe.units =
      std::array<std::optional<recipe::Units>, 4>{std::nullopt, recipe::Units::Inch, recipe::Units::Metre, std::nullopt}
          .at((choice >> 4U) & 3U);
  recipe.gap = (choice & 64U) != 0 ? 1 : recipe.gap;
  recipe.sizeCorrection = (choice & 128U) != 0 ? 0.5 : 0;
  recipe.direction = (choice & 128U) != 0 ? recipe::Direction::CounterClockwise : recipe::Direction::Clockwise;
  recipe.lead = std::min(recipe.lead, 2 * recipe.wheelRadius);
  return recipe;
}

recipe::Machine largeMachine() {
  constexpr double kLongest = 100000; // mm
  recipe::Machine machine;
  machine.travel.head<2>().setConstant(kLongest);
  return machine;
}

std::optional<std::string> brokenPromise(const pattern::Pattern& pattern) {
  Broken broken = untold(pattern.problems);
  broken = broken ? broken : untold(pattern.repairs);
  if (broken || base::hasErrors(pattern.problems)) {
    return broken;
  }
  for (const pattern::Contour& contour : pattern.contours) {
    if (broken = openContour(contour); broken) {
      return broken;
    }
  }
  return pattern.contours.empty() ? "no error and no contour" : broken;
}

std::optional<std::string> brokenPromise(const job::Job& job) {
  Broken broken = untold(job.problems);
  if (broken || !job.canBeGround()) {
    return broken;
  }
  for (Broken (*check)(const job::Job&) : {brokenPath, brokenTrack, brokenProfile, brokenSamples}) {
    broken = broken ? broken : check(job);
  }
  return broken;
}

} // namespace arris::test
