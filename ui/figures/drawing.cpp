#include "ui/figures/drawing.h"

#include "core/base/numbers.h"
#include "core/base/window_thread.h"
#include "core/job/placement.h"
#include "ui/figures/polyline.h"

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

using geometry::Curve;

constexpr double kMostPiecesPerCurve = 20000;

TraceKind kindOf(toolpath::Role role) {
  switch (role) {
  case toolpath::Role::LeadIn:
  case toolpath::Role::LeadOut:
    return TraceKind::Lead;
  case toolpath::Role::Transition:
    return TraceKind::Transition;
  case toolpath::Role::Roll:
    return TraceKind::Roll;
  case toolpath::Role::Contour:
    break;
  }
  return TraceKind::Path;
}

// Neighbours of one kind make one trace, so that dashes run through.
void addChain(Drawing& drawing, const toolpath::Chain& chain) {
  std::optional<TraceKind> running;
  for (const toolpath::PathSegment& segment : chain.segments) {
    const TraceKind kind = kindOf(segment.role);
    if (running != kind) {
      drawing.traces.push_back({kind, {}});
      running = kind;
    }
    drawing.traces.back().curves.push_back(segment.shape);
    drawing.box.extend(geometry::bounds(segment.shape));
  }
}

void addEnds(Drawing& drawing, const toolpath::Chain& chain) {
  if (chain.segments.empty()) {
    return;
  }
  const auto onContour =
      std::find_if(chain.segments.begin(), chain.segments.end(),
                   [](const toolpath::PathSegment& segment) { return segment.role != toolpath::Role::LeadIn; });
  if (onContour != chain.segments.end()) {
    drawing.starts.push_back({startPoint(onContour->shape), startTangent(onContour->shape)});
  }
  if (chain.segments.front().role == toolpath::Role::LeadIn) {
    drawing.ups.push_back(startPoint(chain.segments.front().shape));
  }
  if (chain.segments.back().role == toolpath::Role::LeadOut) {
    drawing.ups.push_back(endPoint(chain.segments.back().shape));
  }
}

void addRapids(Drawing& drawing, const std::vector<motion::Segment>& track) {
  for (const motion::Segment& segment : track) {
    const auto* line = std::get_if<geometry::Line>(&segment.shape);
    if (line && (segment.move == motion::Move::Approach || segment.move == motion::Move::Traverse)) {
      drawing.traces.push_back({TraceKind::Rapid, {*line}});
    }
  }
}

CornerMark markOf(const toolpath::Corner& corner) {
  // Between the tangent points, seen from the corner of the glass.
  const geometry::Vector outwards = (corner.a - corner.s) + (corner.c - corner.s);
  const double clearance = std::max(corner.widest, (corner.a - corner.s).norm());
  return {corner.id, corner.s, outwards.norm() > 0 ? outwards.normalized() : geometry::Vector(0, 1), corner.angle,
          clearance};
}

PathMark markAt(const motion::Segment& segment, double lambda) {
  const motion::Evaluation here = motion::evaluate(segment, std::clamp(lambda, 0.0, parameterLength(segment)));
  return {here.point.head<2>(), here.first.head<2>()};
}

// P_d is where the first deceleration that is due to a corner begins, P_a where the last acceleration after it ends.
void addSpeedMarks(Drawing& drawing, const job::Job& job) {
  const auto endsRun = [&](std::size_t i, std::size_t neighbour) {
    return neighbour >= job.pieces.size() || job.pieces[neighbour].phase != job.pieces[i].phase ||
           job.pieces[neighbour].corner != job.pieces[i].corner;
  };
  for (std::size_t i = 0; i < job.pieces.size(); ++i) {
    const job::PlannedPiece& piece = job.pieces[i];
    const motion::Piece& m = piece.motion;
    if (piece.corner == 0) {
      continue;
    }
    const motion::Segment& segment = job.track[static_cast<std::size_t>(m.segment)];
    if (piece.phase == job::Phase::Decelerate && endsRun(i, i - 1)) {
      drawing.speedMarks.push_back(markAt(segment, m.lambda));
    }
    if (piece.phase == job::Phase::Accelerate && endsRun(i, i + 1)) {
      const double way = m.speed * m.duration + m.acceleration * base::squared(m.duration) / 2;
      drawing.speedMarks.push_back(markAt(segment, m.lambda + way));
    }
  }
}

void addContours(Drawing& drawing, const std::vector<pattern::Contour>& contours) {
  drawing.contours = contours;
  for (const pattern::Contour& contour : contours) {
    drawing.traces.push_back({TraceKind::Contour, contour.curves});
    drawing.box.extend(geometry::bounds(contour.curves));
  }
}

void addLoose(Drawing& drawing, const Curve& piece) {
  drawing.traces.push_back({TraceKind::Loose, {piece}});
  drawing.box.extend(geometry::bounds(piece));
}

void extendByPlaces(Drawing& drawing, const base::Problems& problems) {
  for (const base::Problem& problem : problems) {
    if (problem.where) {
      drawing.box.extend(*problem.where);
    }
  }
}

void addProblems(Drawing& drawing, base::Problems problems) {
  extendByPlaces(drawing, problems);
  drawing.problems = std::move(problems);
}

void addRepairs(Drawing& drawing, base::Problems repairs) {
  extendByPlaces(drawing, repairs);
  drawing.repairs = std::move(repairs);
}

int piecesFor(const Curve& curve, double tolerance) {
  double pieces = 1;
  if (const auto* arc = std::get_if<geometry::Arc>(&curve)) {
    const double most = 2 * std::acos(std::max(0.0, 1 - tolerance / arc->radius()));
    pieces = std::ceil(std::abs(arc->sweep()) / most);
  } else if (const auto* parabola = std::get_if<geometry::Parabola>(&curve)) {
    pieces = std::ceil(std::sqrt((parabola->a - 2 * parabola->q + parabola->c).norm() / (4 * tolerance)));
  }
  return static_cast<int>(std::clamp(pieces, 1.0, kMostPiecesPerCurve));
}

} // namespace

Drawing drawingOf(const job::Job& job) {
  base::takesLong("drawingOf");
  Drawing drawing;
  drawing.wheelRadius = job.recipe.wheelRadius;
  drawing.travel = geometry::Box(geometry::Point(0, 0), geometry::Point(job.machine.travel.head<2>()));
  addContours(drawing, job.contours);
  addRapids(drawing, job.track);
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    addChain(drawing, chain);
    addEnds(drawing, chain);
  }
  for (const toolpath::Corner& corner : job.toolpath.corners) {
    drawing.corners.push_back(markOf(corner));
    if (corner.treatment == toolpath::Treatment::Stop) {
      drawing.stops.push_back(corner.a);
    }
  }
  addSpeedMarks(drawing, job);
  addProblems(drawing, job.problems);
  return drawing;
}

Drawing drawingOf(const job::Job& job, const pattern::Pattern& planned) {
  Drawing drawing = drawingOf(job);
  for (const Curve& piece : planned.loose) {
    addLoose(drawing, transformed(piece, job.placement.motion));
  }
  addRepairs(drawing, job::placed(planned.repairs, job.placement));
  return drawing;
}

Drawing drawingOf(const pattern::Pattern& pattern) {
  base::takesLong("drawingOf");
  Drawing drawing;
  addContours(drawing, pattern.contours);
  for (const Curve& piece : pattern.loose) {
    addLoose(drawing, piece);
  }
  addProblems(drawing, pattern.problems);
  addRepairs(drawing, pattern.repairs);
  return drawing;
}

QPolygonF flattened(const std::vector<geometry::Curve>& curves, const QTransform& toDevice, double tolerance) {
  const double scale = std::hypot(toDevice.m11(), toDevice.m12());
  QPolygonF result;
  Thinner thinner(tolerance / 2, result);
  bool first = true;
  for (const Curve& curve : curves) {
    const int pieces = piecesFor(curve, tolerance / 2 / scale);
    const double length = parameterLength(curve);
    for (int i = first ? 0 : 1; i <= pieces; ++i) {
      thinner.add(toDevice.map(toQt(i < pieces ? pointAt(curve, length * i / pieces) : endPoint(curve))));
    }
    first = false;
  }
  thinner.finish();
  return result;
}

} // namespace arris::ui
