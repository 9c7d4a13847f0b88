#include "core/geometry/spline.h"

#include "core/base/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::geometry {
namespace {

using Homogeneous = Eigen::Vector3d;
using Controls = std::array<Homogeneous, kMostDegree + 1>;

/// Knots nearer to each other than this part of the whole range are one knot: what a file's decimals leave of it.
constexpr double kSameKnot = 1e-9;

/// Pieces that meet with a smaller turn than this run on: it is rounding, rad.
constexpr double kSameDirection = 1e-9;

/// Control points nearer to the end than this part of the curve's size tell no direction.
constexpr double kSamePoint = 1e-10;

Point planar(const Homogeneous& h) {
  return h.head<2>() / h.z();
}

/// From the first control point towards the first that lies apart from it.
Vector directionOf(const Controls& controls, std::size_t count) {
  const Point first = planar(controls[0]);
  double size = 0;
  for (std::size_t i = 1; i < count; ++i) {
    size = std::max(size, (planar(controls[i]) - first).norm());
  }
  for (std::size_t i = 1; i < count; ++i) {
    const Vector way = planar(controls[i]) - first;
    if (way.norm() > kSamePoint * size) {
      return way.normalized();
    }
  }
  return Vector::UnitX(); // a point: it has no direction
}

// De Casteljau leaves the control points of the rest of the curve.
Station stationFromStart(Controls& controls, std::size_t count, double t) {
  for (std::size_t last = count - 1; t > 0 && last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) {
      controls[i] += t * (controls[i + 1] - controls[i]);
    }
  }
  return {planar(controls[0]), directionOf(controls, count)};
}

std::vector<double> withoutNearlySameKnots(std::vector<double> knots) {
  const double same = kSameKnot * (knots.back() - knots.front());
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] - knots[i - 1] <= same) {
      knots[i] = knots[i - 1];
    }
  }
  return knots;
}

std::vector<Homogeneous> homogeneous(const Spline& spline) {
  const double most = spline.weights.empty() ? 1 : *std::max_element(spline.weights.begin(), spline.weights.end());
  std::vector<Homogeneous> result;
  result.reserve(spline.points.size());
  for (std::size_t i = 0; i < spline.points.size(); ++i) {
    const double weight = spline.weights.empty() ? 1 : spline.weights[i] / most;
    result.emplace_back(weight * spline.points[i].x(), weight * spline.points[i].y(), weight);
  }
  return result;
}

// The control point number `j` of the piece between two knots is the blossom of the spline at the lower knot
// (degree − j times) and the upper one (j times): de Boor's scheme with these in place of one parameter.
Homogeneous blossom(const std::vector<Homogeneous>& points, const std::vector<double>& knots, std::size_t degree,
                    std::size_t span, std::size_t j) {
  Controls d;
  d.fill(Homogeneous::Zero());
  std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(span - degree), degree + 1, d.begin());
  for (std::size_t round = 1; round <= degree; ++round) {
    const double at = round <= j ? knots[span + 1] : knots[span];
    for (std::size_t i = degree; i >= round; --i) {
      const double low = knots[span - degree + i];
      const double high = knots[span + 1 + i - round];
      d[i] = d[i - 1] + (at - low) / (high - low) * (d[i] - d[i - 1]);
    }
  }
  return d[degree];
}

std::string flawOfKnots(const Spline& spline) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  const std::size_t needed = spline.points.size() + degree + 1;
  if (spline.knots.size() != needed) {
    return fmt::format("it has {} knots and needs {}", spline.knots.size(), needed);
  }
  for (std::size_t i = 1; i < needed; ++i) {
    if (spline.knots[i] < spline.knots[i - 1]) {
      return fmt::format("its knots fall from {} to {}", spline.knots[i - 1], spline.knots[i]);
    }
  }
  const std::vector<double> knots = withoutNearlySameKnots(spline.knots);
  return knots[degree] < knots[spline.points.size()] ? "" : "its knots are all the same";
}

std::string flawOfWeights(const Spline& spline) {
  constexpr double kMostRatio = 1e9; // above it the sums lose what the lightest points say
  if (spline.weights.empty()) {
    return "";
  }
  if (spline.weights.size() != spline.points.size()) {
    return fmt::format("it has {} weights and needs {}", spline.weights.size(), spline.points.size());
  }
  const auto [least, most] = std::minmax_element(spline.weights.begin(), spline.weights.end());
  if (!(*least > 0)) {
    return fmt::format("it has a weight of {}, which is not positive", *least);
  }
  return *most <= kMostRatio * *least ? "" : fmt::format("its weights reach from {} to {}", *least, *most);
}

/// The slopes of a cubic spline through points: one equation a·m(i−1) + b·m(i) + c·m(i+1) = d each.
struct SlopeEquation {
  double a = 0;
  double b = 1;
  double c = 0;
  Vector d = Vector::Zero();
};

std::vector<Vector> solved(std::vector<SlopeEquation> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double factor = rows[i].a / rows[i - 1].b;
    rows[i].b -= factor * rows[i - 1].c;
    rows[i].d -= factor * rows[i - 1].d;
  }
  std::vector<Vector> slopes(rows.size());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const Vector next = i + 1 < rows.size() ? Vector(rows[i].c * slopes[i + 1]) : Vector(Vector::Zero());
    slopes[i] = (rows[i].d - next) / rows[i].b;
  }
  return slopes;
}

/// Equal curvature on both sides of a point: h the parameters before and after, s the slopes of the chords.
SlopeEquation smoothBetween(double before, double after, const Vector& slopeBefore, const Vector& slopeAfter) {
  return {after, 2 * (before + after), before, 3 * (after * slopeBefore + before * slopeAfter)};
}

// The corners of the periodic matrix are taken for a correction of rank one (Sherman and Morrison).
std::vector<Vector> solvedPeriodic(std::vector<SlopeEquation> rows) {
  const std::size_t last = rows.size() - 1;
  const double top = rows[0].a;
  const double bottom = rows[last].c;
  const double gamma = -rows[0].b;
  rows[0].b -= gamma;
  rows[last].b -= bottom * top / gamma;
  std::vector<SlopeEquation> unit = rows;
  for (SlopeEquation& row : unit) {
    row.d.setZero();
  }
  unit[0].d.setConstant(gamma);
  unit[last].d.setConstant(bottom);
  std::vector<Vector> slopes = solved(std::move(rows));
  const std::vector<Vector> correction = solved(std::move(unit));
  const double ratio = top / gamma;
  const double scale = 1 + correction[0].x() + ratio * correction[last].x();
  const Vector factor = (slopes[0] + ratio * slopes[last]) / scale;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    slopes[i] -= correction[i].x() * factor;
  }
  return slopes;
}

std::vector<Point> withoutDoubled(const std::vector<Point>& points, bool closed) {
  constexpr double kApart = 1e-9; // mm
  std::vector<Point> result;
  for (const Point& point : points) {
    if (result.empty() || (point - result.back()).norm() > kApart) {
      result.push_back(point);
    }
  }
  if (closed && result.size() > 1 && (result.back() - result.front()).norm() <= kApart) {
    result.pop_back();
  }
  return result;
}

/// The equation at a point between two others, or on a closed curve at any.
SlopeEquation smoothAt(const std::vector<Point>& points, const std::vector<double>& h, std::size_t i) {
  const std::size_t count = points.size();
  const std::size_t before = (i + count - 1) % count;
  return smoothBetween(h[before], h[i], (points[i] - points[before]) / h[before],
                       (points[(i + 1) % count] - points[i]) / h[i]);
}

std::vector<Vector> slopesOfClosed(const std::vector<Point>& points, const std::vector<double>& h) {
  std::vector<SlopeEquation> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    rows.push_back(smoothAt(points, h, i));
  }
  return solvedPeriodic(std::move(rows));
}

std::vector<Vector> slopesOfOpen(const Interpolation& wanted, const std::vector<Point>& points,
                                 const std::vector<double>& h) {
  const std::size_t last = points.size() - 1;
  std::vector<SlopeEquation> rows;
  rows.push_back(wanted.startDirection ? SlopeEquation{0, 1, 0, wanted.startDirection->normalized()}
                                       : SlopeEquation{0, 2, 1, 3 * (points[1] - points[0]) / h[0]});
  for (std::size_t i = 1; i < last; ++i) {
    rows.push_back(smoothAt(points, h, i));
  }
  rows.push_back(wanted.endDirection ? SlopeEquation{0, 1, 0, wanted.endDirection->normalized()}
                                     : SlopeEquation{1, 2, 0, 3 * (points[last] - points[last - 1]) / h[last - 1]});
  return solved(std::move(rows));
}

} // namespace

std::string flawOf(const Spline& spline) {
  if (spline.degree < 1 || spline.degree > kMostDegree) {
    return fmt::format("its degree is {}; up to {} are read", spline.degree, kMostDegree);
  }
  if (spline.points.size() <= static_cast<std::size_t>(spline.degree)) {
    return fmt::format("it has {} control points and needs {}", spline.points.size(), spline.degree + 1);
  }
  const std::string flaw = flawOfKnots(spline);
  return flaw.empty() ? flawOfWeights(spline) : flaw;
}

Station stationAt(const Bezier& bezier, double t) {
  Controls controls;
  controls.fill(Homogeneous::Zero());
  if (t <= 0.5) {
    std::copy(bezier.points.begin(), bezier.points.end(), controls.begin());
    return stationFromStart(controls, bezier.points.size(), t);
  }
  std::copy(bezier.points.rbegin(), bezier.points.rend(), controls.begin());
  const Station back = stationFromStart(controls, bezier.points.size(), 1 - t);
  return {back.point, -back.tangent};
}

std::vector<Bezier> bezierPieces(const Spline& spline) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  const std::vector<double> knots = withoutNearlySameKnots(spline.knots);
  const std::vector<Homogeneous> points = homogeneous(spline);
  std::vector<Bezier> pieces;
  for (std::size_t span = degree; span < points.size(); ++span) {
    if (knots[span] < knots[span + 1]) {
      Bezier piece;
      piece.points.reserve(degree + 1);
      for (std::size_t j = 0; j <= degree; ++j) {
        piece.points.push_back(blossom(points, knots, degree, span, j));
      }
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

std::vector<Bezier> bezierPieces(const Interpolation& interpolation) {
  const std::vector<Point> points = withoutDoubled(interpolation.points, interpolation.closed);
  const std::size_t count = points.size();
  const bool closed = interpolation.closed && count > 2;
  std::vector<Bezier> pieces;
  if (count < 2) {
    return pieces;
  }
  std::vector<double> h;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    h.push_back((points[(i + 1) % count] - points[i]).norm());
  }
  const std::vector<Vector> slopes = closed ? slopesOfClosed(points, h) : slopesOfOpen(interpolation, points, h);
  for (std::size_t i = 0; i < h.size(); ++i) {
    const std::size_t next = (i + 1) % count;
    const Point first = points[i] + h[i] / 3 * slopes[i];
    const Point second = points[next] - h[i] / 3 * slopes[next];
    pieces.push_back(
        {{points[i].homogeneous(), first.homogeneous(), second.homogeneous(), points[next].homogeneous()}});
  }
  return pieces;
}

namespace {

/// Joint by joint from the start: where pieces meet without a turn, both get the direction between theirs.
struct Ends {
  Station start;
  Station end;
};

void shareDirection(Station& before, Station& after) {
  constexpr double kSamePlace = 1e-9; // mm
  if ((before.point - after.point).norm() <= kSamePlace &&
      std::abs(turn(before.tangent, after.tangent)) < kSameDirection) {
    before.tangent = (before.tangent + after.tangent).normalized();
    after.tangent = before.tangent;
    before.point = after.point;
  }
}

} // namespace

bool follow(const std::vector<Bezier>& pieces, ArcFitter& fitter) {
  std::vector<Ends> ends;
  ends.reserve(pieces.size());
  for (const Bezier& piece : pieces) {
    ends.push_back({stationAt(piece, 0), stationAt(piece, 1)});
  }
  for (std::size_t i = 0; i < ends.size(); ++i) { // the last with the first too: a closed curve runs on
    shareDirection(ends[i].end, ends[(i + 1) % ends.size()].start);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int places = std::max(16, 4 * pieces[i].degree());
    const auto trace = [&piece = pieces[i]](double t) { return stationAt(piece, t); };
    if (!fitter.follow(trace, ends[i].start, ends[i].end, places)) {
      return false;
    }
  }
  return true;
}

} // namespace arris::geometry
