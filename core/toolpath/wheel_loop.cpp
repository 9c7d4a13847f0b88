#include "core/toolpath/wheel_loop.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/toolpath/corners.h"
#include "core/toolpath/kink.h"

#include <cmath>
#include <optional>

namespace arris::toolpath {
namespace {

using base::Code;
using base::kPi;
using base::Problem;
using geometry::Curve;
using geometry::Line;
using geometry::Parabola;
using geometry::Point;

/// Spans that follow each other without a cut are tangential to within rounding, rad.
constexpr double kNoKink = 4 * base::kTangentTurn;

/// Place of the glass that a path comes too near to, if any.
std::optional<Point> whatIsInTheWay(const Glass& glass, const Parabola& path, EdgeId before, double radius) {
  const double least = radius - base::kContourAccuracy;
  geometry::FlatBox box(path.a);
  box.extend(geometry::FlatBox(path.q));
  box.extend(geometry::FlatBox(path.c));
  std::optional<Point> place;
  glass.tree().forNear(box, least, [&](std::size_t index) {
    const Curve& edge = glass.edges()[index];
    const bool isBeside = index == before || index == glass.next(before);
    if ((isBeside && std::holds_alternative<Line>(edge)) || geometry::distance(path, edge, least) >= least) {
      return true;
    }
    // The nearest point of the edge to the middle of the transition is near enough to be found.
    place = geometry::pointAt(
        edge, geometry::nearest(edge, geometry::pointAt(path, geometry::parameterLength(path) / 2)).lambda);
    return false;
  });
  return place;
}

/// Walks along the spans of a loop and decides each corner.
class Maker {
public:
  Maker(const Glass& glass, const Offset& offset, const recipe::Recipe& recipe)
      : m_glass(glass), m_offset(offset), m_recipe(recipe) {}

  WheelLoop make(const Loop& loop, const std::stop_token& stop) {
    for (const Span& span : loop) {
      if (stop.stop_requested()) {
        return {};
      }
      const Piece& piece = m_offset.pieces[span.piece];
      piece.isRoll ? addCorner(piece, span) : addEdge(piece, span);
    }
    roundKinks();
    return std::move(m_result);
  }

private:
  static Curve partOf(const Piece& piece, const Span& span) {
    const bool whole = span.from <= 0 && span.to >= piece.length;
    return whole ? piece.path : geometry::part(piece.path, span.from, span.to);
  }

  void addEdge(const Piece& piece, const Span& span) {
    const double scale = geometry::parameterLength(m_glass.edges()[piece.edge]) / piece.length;
    Step step;
    step.path = partOf(piece, span);
    step.edge = piece.edge;
    step.ground = {span.from * scale, span.to * scale};
    m_result.steps.push_back(step);
  }

  void addCorner(const Piece& piece, const Span& span) {
    Corner corner = cornerAfter(piece);
    Step step;
    step.edge = piece.edge;
    step.corner = addCorner(corner);
    step.role = Role::Roll;
    step.path = partOf(piece, span);
    if (corner.treatment == Treatment::Transition) {
      const Parabola transition{corner.a, corner.q, corner.c};
      const bool whole = span.from <= 0 && span.to >= piece.length;
      const std::optional<Point> other =
          whole ? whatIsInTheWay(m_glass, transition, piece.edge, m_recipe.wheelRadius) : corner.s;
      if (!other) {
        step.role = Role::Transition;
        step.path = transition;
      } else {
        m_result.corners.back() = rolledInstead(corner, m_recipe);
        m_result.problems.push_back(Problem(Code::TransitionBlocked).at(*other).ofContour(corner.contour));
        m_result.problems.back().corner = step.corner; // numbered later
      }
    }
    m_result.steps.push_back(step);
  }

  [[nodiscard]] Corner cornerAfter(const Piece& roll) const {
    const Curve& before = m_glass.edges()[roll.edge];
    const Curve& after = m_glass.edges()[m_glass.next(roll.edge)];
    Corner corner =
        classify(geometry::startPoint(after), geometry::endTangent(before), geometry::startTangent(after), m_recipe);
    corner.contour = m_glass.ringOf(roll.edge).contour;
    corner.a = geometry::startPoint(roll.path); // without a gap
    corner.c = geometry::endPoint(roll.path);
    if (corner.treatment == Treatment::Transition) {
      corner.q = corner.a + m_offset.radius / std::tan(corner.angle / 2) * geometry::endTangent(before);
    }
    return corner;
  }

  int addCorner(const Corner& corner) {
    m_result.corners.push_back(corner);
    return static_cast<int>(m_result.corners.size()) - 1;
  }

  /// What stands between a step and the next.
  struct Bridge {
    bool isKink = false;
    int corner = kNoCorner; ///< the concave corner at the kink
    std::optional<KinkArc> arc;
  };

  // Of each step at most half is replaced at either end, so that no bridge depends on another.
  void roundKinks() {
    const std::vector<Step> steps = std::move(m_result.steps);
    std::vector<Bridge> bridges;
    bridges.reserve(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      bridges.push_back(bridgeBetween(steps[i], steps[(i + 1) % steps.size()]));
    }
    m_result.steps.clear();
    m_result.steps.reserve(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      addBetween(steps[i], bridges[i > 0 ? i - 1 : steps.size() - 1], bridges[i]);
    }
  }

  Bridge bridgeBetween(const Step& step, const Step& next) {
    const double turn = geometry::turn(geometry::endTangent(step.path), geometry::startTangent(next.path));
    Bridge bridge;
    bridge.isKink = std::abs(turn) > kNoKink;
    if (!bridge.isKink) {
      return bridge;
    }
    const auto most = [](const Step& s) {
      return s.role == Role::Transition ? 0 : geometry::parameterLength(s.path) / 2;
    };
    bridge.arc = arcAtKink(step.path, next.path, m_glass.side(), most(step), most(next));
    if (step.role != Role::Contour || next.role != Role::Contour) {
      return bridge;
    }
    if (const std::optional<EdgeId> joint = concaveJointBetween(step.edge, next.edge)) {
      bridge.corner = addCorner(concaveCorner(step, next, *joint, bridge.arc));
      m_result.fillets.push_back({step.edge, next.edge});
    }
    return bridge;
  }

  // The edge before the concave corner where that is all that lies between two edges: curves may need several edges
  // from where the wheel touches them to the corner, joined tangentially and none too hollow for the wheel.
  [[nodiscard]] std::optional<EdgeId> concaveJointBetween(EdgeId from, EdgeId to) const {
    constexpr int kMostEdges = 1000;
    std::optional<EdgeId> joint;
    EdgeId edge = from;
    for (int i = 0; i < kMostEdges && edge != to; ++i) {
      const JointKind kind = m_glass.jointAfter(edge);
      if (kind == JointKind::Convex || (kind == JointKind::Concave && joint)) {
        return std::nullopt;
      }
      joint = kind == JointKind::Concave ? std::optional(edge) : joint;
      edge = m_glass.next(edge);
      if (edge != to && isTooHollow(m_glass.edges()[edge])) {
        return std::nullopt;
      }
    }
    return edge == to ? joint : std::nullopt;
  }

  [[nodiscard]] bool isTooHollow(const Curve& edge) const {
    const auto* arc = std::get_if<geometry::Arc>(&edge);
    return arc && arc->curvature * m_glass.side() * m_offset.radius > 1;
  }

  /// Length of contour from a place on an edge to the end of another one that comes after it.
  [[nodiscard]] double lengthBetween(EdgeId from, double along, EdgeId to) const {
    double length = -along;
    for (EdgeId edge = from;; edge = m_glass.next(edge)) {
      length += geometry::parameterLength(m_glass.edges()[edge]);
      if (edge == to) {
        return length;
      }
    }
  }

  [[nodiscard]] Corner concaveCorner(const Step& step, const Step& next, EdgeId joint,
                                     const std::optional<KinkArc>& arc) const {
    const Point kink = geometry::endPoint(step.path);
    Corner corner;
    corner.contour = m_glass.ringOf(step.edge).contour;
    corner.kind = CornerKind::Concave;
    corner.treatment = arc ? Treatment::Arc : Treatment::Stop;
    corner.reason = arc ? Reason::ConcaveShallow : Reason::ConcaveDeep;
    corner.s = geometry::endPoint(m_glass.edges()[joint]);
    corner.angle = kPi + m_glass.side() * m_glass.turnAfter(joint);
    corner.a = arc ? arc->arc.start : kink;
    corner.c = arc ? geometry::endPoint(arc->arc) : kink;
    corner.widest = (kink - corner.s).norm();
    corner.fillet = corner.widest - m_offset.radius;
    const double before = lengthBetween(step.edge, step.ground.to, joint);
    const double after = lengthBetween(m_glass.next(joint), 0, next.edge) -
                         (geometry::parameterLength(m_glass.edges()[next.edge]) - next.ground.from);
    corner.unground = std::max(before, after);
    return corner;
  }

  void addBetween(Step step, const Bridge& before, const Bridge& after) {
    const double from = before.arc ? before.arc->cutAfter : 0;
    const double length = geometry::parameterLength(step.path);
    const double to = length - (after.arc ? after.arc->cutBefore : 0);
    const double scale = (step.ground.to - step.ground.from) / length; // 0 on a roll
    if (from > 0 || to < length) {
      step.path = geometry::part(step.path, from, to);
      step.ground = {step.ground.from + scale * from, step.ground.from + scale * to};
    }
    step.stopAtEnd = after.isKink && !after.arc;
    step.stopCorner = step.stopAtEnd ? after.corner : kNoCorner;
    m_result.steps.push_back(step);
    if (after.arc) {
      Step arc;
      arc.path = after.arc->arc;
      arc.role = Role::Roll;
      arc.edge = step.edge;
      arc.corner = after.corner;
      m_result.steps.push_back(arc);
    }
  }

  const Glass& m_glass;
  const Offset& m_offset;
  const recipe::Recipe& m_recipe;
  WheelLoop m_result;
};

} // namespace

WheelLoop makeWheelLoop(const Glass& glass, const Offset& offset, const Loop& loop, const recipe::Recipe& recipe,
                        const std::stop_token& stop) {
  return Maker(glass, offset, recipe).make(loop, stop);
}

} // namespace arris::toolpath
