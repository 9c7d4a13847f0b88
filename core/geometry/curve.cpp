#include "core/geometry/curve.h"

#include "core/base/numbers.h"
#include "core/geometry/meetings.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace arris::geometry {
namespace {

using base::kPi;
using base::squared;

template <class... F> struct Overloaded : F... { using F::operator()...; };
template <class... F> Overloaded(F...) -> Overloaded<F...>;

Vector rotated(const Vector& v, double sine, double cosine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

double leg(const Parabola& p) {
  return (p.q - p.a).norm();
}

// |q'|² = (1+c)/2 + 2(1−c)w² with w = u − ½ and c = e_s·e_d, so its root has a primitive in closed form.
double parabolaLength(const Parabola& p, double lambda) {
  const double l = leg(p);
  const Vector es = (p.q - p.a) / l;
  const Vector ed = (p.c - p.q) / l;
  const double constant = (es + ed).squaredNorm() / 4;
  const double quadratic = (es - ed).squaredNorm();
  if (quadratic == 0) {
    return lambda;
  }
  const auto primitive = [&](double w) {
    const double ratio = std::sqrt(quadratic / constant);
    return (w * std::sqrt(constant + quadratic * w * w) + constant / std::sqrt(quadratic) * std::asinh(w * ratio)) / 2;
  };
  return 2 * l * (primitive(lambda / (2 * l) - 0.5) - primitive(-0.5));
}

Nearest nearestOnLine(const Line& line, const Point& point) {
  const Vector way = line.to - line.from;
  const double length = way.norm();
  const double lambda = std::clamp((point - line.from).dot(way) / length, 0.0, length);
  return {lambda, (line.from + (lambda / length) * way - point).norm()};
}

// In the frame of the start, x along the tangent and y to the left; neither step loses digits on an all but straight
// arc.
Nearest nearestOnArc(const Arc& arc, const Point& point) {
  const Vector from = point - arc.start;
  const double x = from.dot(arc.tangent);
  const double y = from.dot(leftOf(arc.tangent));
  const double k = arc.curvature;
  double lambda = std::atan2(k * x, 1 - k * y) / k;
  if (lambda < 0) {
    lambda += 2 * kPi / std::abs(k);
  }
  if (lambda <= arc.length) {
    const double side = k > 0 ? 1 : -1;
    const double outside = (std::abs(k) * (x * x + y * y) - 2 * side * y) / (std::hypot(k * x, 1 - k * y) + 1);
    return {lambda, std::abs(outside)};
  }
  const double toStart = from.norm();
  const double toEnd = (evaluate(arc, arc.length).point - point).norm();
  return toStart <= toEnd ? Nearest{0, toStart} : Nearest{arc.length, toEnd};
}

// Where an arc's direction of travel is parallel to an axis: λ of each, from the start on.
std::vector<double> axisParallel(const Arc& arc) {
  std::vector<double> result;
  const double heading = std::atan2(arc.tangent.y(), arc.tangent.x());
  const double quarter = kPi / 2;
  const double first = heading + std::min(0.0, arc.sweep());
  const double last = heading + std::max(0.0, arc.sweep());
  for (double k = std::ceil(first / quarter); k * quarter <= last; ++k) {
    result.push_back(std::clamp((k * quarter - heading) / arc.curvature, 0.0, arc.length));
  }
  return result;
}

bool lineCrossesLine(const Line& a, const Line& b) {
  const Vector da = a.to - a.from;
  const Vector db = b.to - b.from;
  return cross(da, b.from - a.from) * cross(da, b.to - a.from) <= 0 &&
         cross(db, a.from - b.from) * cross(db, a.to - b.from) <= 0 && cross(da, db) != 0;
}

double distanceLineLine(const Line& a, const Line& b) {
  if (lineCrossesLine(a, b)) {
    return 0;
  }
  return std::min({nearestOnLine(a, b.from).distance, nearestOnLine(a, b.to).distance,
                   nearestOnLine(b, a.from).distance, nearestOnLine(b, a.to).distance});
}

// Where two curves cross, however flat they are: their centres may lie too far away to compute with.
double distanceAtMeetings(const Curve& a, const Curve& b) {
  const Track track(a);
  const Track::Meetings meetings = track.meetWhole(b);
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < meetings.count; ++i) {
    if (std::abs(meetings.s[i]) <= track.end()) {
      best = std::min(best, nearest(b, track.at(meetings.s[i])).distance);
    }
  }
  return best;
}

// Between the ends only the foot of the centre on the line, and the crossings of line and circle, can be nearest.
double distanceLineArc(const Line& line, const Arc& arc) {
  double best = std::min({nearestOnLine(line, arc.start).distance, nearestOnLine(line, endPoint(arc)).distance,
                          nearestOnArc(arc, line.from).distance, nearestOnArc(arc, line.to).distance,
                          distanceAtMeetings(line, arc)});
  const Vector way = line.to - line.from;
  const double length = way.norm();
  const Vector direction = way / length;
  const double along = (arc.center() - line.from).dot(direction);
  if (along >= 0 && along <= length) {
    best = std::min(best, nearestOnArc(arc, line.from + along * direction).distance);
  }
  return best;
}

// Between the ends only points on the line of the centres, and the crossings of the circles, can be nearest.
double distanceArcArc(const Arc& a, const Arc& b) {
  double best =
      std::min({nearestOnArc(a, b.start).distance, nearestOnArc(a, endPoint(b)).distance,
                nearestOnArc(b, a.start).distance, nearestOnArc(b, endPoint(a)).distance, distanceAtMeetings(a, b)});
  const Vector between = b.center() - a.center();
  const double apart = between.norm();
  if (apart < 1e-9 * (a.radius() + b.radius())) { // concentric: any common direction will do
    for (int i = 1; i < 8; ++i) {
      best = std::min(best, nearestOnArc(b, evaluate(a, a.length * i / 8).point).distance);
    }
    return best;
  }
  const Vector direction = between / apart;
  const std::array<Point, 2> candidates{a.center() + a.radius() * direction, a.center() - a.radius() * direction};
  for (const Point& candidate : candidates) {
    const Nearest onA = nearestOnArc(a, candidate);
    best = std::min(best, nearestOnArc(b, evaluate(a, onA.lambda).point).distance);
  }
  return best;
}

// |q'| ≤ 1, so over a stretch of length h the distance is at least that from its middle less h/2.
void refineParabolaDistance(const Parabola& p, const Curve& other, double from, double to, double relevant,
                            double& best) {
  constexpr double kAccuracy = 1e-6;
  const double middle = (from + to) / 2;
  const double here = nearest(other, evaluate(p, middle).point).distance;
  best = std::min(best, here);
  if (here - (to - from) / 2 >= std::min(best, relevant) - kAccuracy) {
    return;
  }
  refineParabolaDistance(p, other, from, middle, relevant, best);
  refineParabolaDistance(p, other, middle, to, relevant, best);
}

} // namespace

double turn(const Vector& a, const Vector& b) {
  return std::atan2(cross(a, b), a.dot(b));
}

double parameterLength(const Curve& curve) {
  return std::visit(Overloaded{[](const Line& line) { return (line.to - line.from).norm(); },
                               [](const Arc& arc) { return arc.length; }, [](const Parabola& p) { return 2 * leg(p); }},
                    curve);
}

Evaluation evaluate(const Line& line, double lambda) {
  const Vector way = line.to - line.from;
  const Vector direction = way / way.norm();
  return {line.from + lambda * direction, direction, Vector::Zero()};
}

// The chord from the start has length 2 sin(κλ/2)/κ and lies half-way between the tangents: exact for any curvature.
Evaluation evaluate(const Arc& arc, double lambda) {
  const double half = arc.curvature * lambda / 2;
  const double s = std::sin(half);
  const double c = std::cos(half);
  const Vector chordDirection = rotated(arc.tangent, s, c);
  const Vector tangent = rotated(chordDirection, s, c);
  return {arc.start + (2 * s / arc.curvature) * chordDirection, tangent, arc.curvature * leftOf(tangent)};
}

Evaluation evaluate(const Parabola& p, double lambda) {
  const double l = leg(p);
  const double u = lambda / (2 * l);
  const Vector es = (p.q - p.a) / l;
  const Vector ed = (p.c - p.q) / l;
  return {p.a + (lambda - lambda * u / 2) * es + (lambda * u / 2) * ed, (1 - u) * es + u * ed, (ed - es) / (2 * l)};
}

Evaluation evaluate(const Curve& curve, double lambda) {
  return std::visit([lambda](const auto& shape) { return evaluate(shape, lambda); }, curve);
}

Point pointAt(const Curve& curve, double lambda) {
  return evaluate(curve, lambda).point;
}

Point startPoint(const Curve& curve) {
  return std::visit(Overloaded{[](const Line& line) { return line.from; }, [](const Arc& arc) { return arc.start; },
                               [](const Parabola& p) { return p.a; }},
                    curve);
}

Point endPoint(const Curve& curve) {
  return std::visit(Overloaded{[](const Line& line) { return line.to; },
                               [](const Arc& arc) { return evaluate(arc, arc.length).point; },
                               [](const Parabola& p) { return p.c; }},
                    curve);
}

Vector startTangent(const Curve& curve) {
  return std::visit(Overloaded{[](const Line& line) -> Vector { return (line.to - line.from).normalized(); },
                               [](const Arc& arc) { return arc.tangent; },
                               [](const Parabola& p) -> Vector { return (p.q - p.a).normalized(); }},
                    curve);
}

Vector endTangent(const Curve& curve) {
  return std::visit(Overloaded{[](const Line& line) -> Vector { return (line.to - line.from).normalized(); },
                               [](const Arc& arc) { return evaluate(arc, arc.length).first; },
                               [](const Parabola& p) -> Vector { return (p.c - p.q).normalized(); }},
                    curve);
}

double arcLength(const Curve& curve, double lambda) {
  const auto* parabola = std::get_if<Parabola>(&curve);
  return parabola ? parabolaLength(*parabola, lambda) : lambda;
}

double arcLength(const Curve& curve) {
  return arcLength(curve, parameterLength(curve));
}

Curve part(const Curve& curve, double from, double to) {
  assert(from < to);
  return std::visit(Overloaded{[=](const Line& line) -> Curve {
                                 const Vector way = line.to - line.from;
                                 const double length = way.norm();
                                 return Line{from <= 0 ? line.from : Point(line.from + (from / length) * way),
                                             to >= length ? line.to : Point(line.from + (to / length) * way)};
                               },
                               [=](const Arc& arc) -> Curve {
                                 const Evaluation start = evaluate(arc, from);
                                 return Arc{start.point, start.first, arc.curvature, to - from};
                               },
                               [=](const Parabola& p) -> Curve {
                                 assert(from <= 0 && to >= 2 * leg(p));
                                 return p;
                               }},
                    curve);
}

Curve reversed(const Curve& curve) {
  return std::visit(Overloaded{[](const Line& line) -> Curve {
                                 return Line{line.to, line.from};
                               },
                               [](const Arc& arc) -> Curve {
                                 const Evaluation end = evaluate(arc, arc.length);
                                 return Arc{end.point, -end.first, -arc.curvature, arc.length};
                               },
                               [](const Parabola& p) -> Curve {
                                 return Parabola{p.c, p.q, p.a};
                               }},
                    curve);
}

Curve offset(const Curve& curve, double distance) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    const Vector shift = distance * leftOf(startTangent(curve));
    return Line{line->from + shift, line->to + shift};
  }
  const auto& arc = std::get<Arc>(curve);
  const double scale = 1 - arc.curvature * distance;
  assert(scale > 0);
  return Arc{arc.start + distance * leftOf(arc.tangent), arc.tangent, arc.curvature / scale, arc.length * scale};
}

Curve transformed(const Curve& curve, const Eigen::Isometry2d& motion) {
  return std::visit(
      Overloaded{[&](const Line& line) -> Curve {
                   return Line{motion * line.from, motion * line.to};
                 },
                 [&](const Arc& arc) -> Curve {
                   const bool mirrored = motion.linear().determinant() < 0;
                   const Vector tangent = motion.linear() * arc.tangent;
                   return Arc{motion * arc.start, tangent, mirrored ? -arc.curvature : arc.curvature, arc.length};
                 },
                 [&](const Parabola& p) -> Curve {
                   return Parabola{motion * p.a, motion * p.q, motion * p.c};
                 }},
      curve);
}

Box bounds(const Curve& curve) {
  Box box(startPoint(curve));
  box.extend(endPoint(curve));
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    for (const double lambda : axisParallel(*arc)) {
      box.extend(evaluate(*arc, lambda).point);
    }
  } else if (const auto* p = std::get_if<Parabola>(&curve)) {
    const Vector before = p->q - p->a;
    const Vector after = p->c - p->q;
    for (int axis = 0; axis < 2; ++axis) { // q' is linear between them
      const double u = before[axis] / (before[axis] - after[axis]);
      if (u > 0 && u < 1) {
        box.extend(evaluate(*p, 2 * leg(*p) * u).point);
      }
    }
  }
  return box;
}

Nearest nearest(const Curve& lineOrArc, const Point& point) {
  const auto* line = std::get_if<Line>(&lineOrArc);
  return line ? nearestOnLine(*line, point) : nearestOnArc(std::get<Arc>(lineOrArc), point);
}

double distance(const Curve& a, const Curve& lineOrArc, double relevant) {
  const auto* lineB = std::get_if<Line>(&lineOrArc);
  if (const auto* lineA = std::get_if<Line>(&a)) {
    return lineB ? distanceLineLine(*lineA, *lineB) : distanceLineArc(*lineA, std::get<Arc>(lineOrArc));
  }
  if (const auto* arcA = std::get_if<Arc>(&a)) {
    return lineB ? distanceLineArc(*lineB, *arcA) : distanceArcArc(*arcA, std::get<Arc>(lineOrArc));
  }
  const auto& p = std::get<Parabola>(a);
  double best = std::min(nearest(lineOrArc, p.a).distance, nearest(lineOrArc, p.c).distance);
  refineParabolaDistance(p, lineOrArc, 0, 2 * leg(p), relevant, best);
  return best;
}

Arc arcBetween(const Point& from, const Point& to, double sweep) {
  const Vector chord = to - from;
  const double half = sweep / 2;
  const double curvature = 2 * std::sin(half) / chord.norm();
  return {from, rotated(chord.normalized(), -std::sin(half), std::cos(half)), curvature, sweep / curvature};
}

Arc arcAbout(const Point& center, double radius, double startAngle, double sweep) {
  const Vector outwards(std::cos(startAngle), std::sin(startAngle));
  const double side = sweep > 0 ? 1 : -1;
  return {center + radius * outwards, side * leftOf(outwards), side / radius, radius * std::abs(sweep)};
}

double doubledArea(const Curve& lineOrArc) {
  const double chord = cross(startPoint(lineOrArc), endPoint(lineOrArc));
  const auto* arc = std::get_if<Arc>(&lineOrArc);
  return arc ? chord + (arc->sweep() - std::sin(arc->sweep())) / squared(arc->curvature) : chord;
}

double signedArea(const std::vector<Curve>& closedChain) {
  double doubled = 0;
  for (const Curve& curve : closedChain) {
    doubled += doubledArea(curve);
  }
  return doubled / 2;
}

double totalLength(const std::vector<Curve>& chain) {
  double sum = 0;
  for (const Curve& curve : chain) {
    sum += arcLength(curve);
  }
  return sum;
}

Box bounds(const std::vector<Curve>& chain) {
  Box box;
  for (const Curve& curve : chain) {
    box.extend(bounds(curve));
  }
  return box;
}

} // namespace arris::geometry
