#include "core/pattern/dxf_reader.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/dxf_curves.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <cmath>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <stop_token>
#include <unordered_map>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using geometry::Arc;
using geometry::Curve;
using geometry::EllipticArc;
using geometry::Line;
using geometry::Point;
using geometry::Vector;
using Map = Eigen::AffineCompact2d;

/// A bulge whose arc rises less than this above its chord is a straight line, mm.
constexpr double kStraight = 1e-9;

/// No arc of a pane has a larger radius, mm.
constexpr double kMostBulgeRadius = 1e9;

constexpr std::int64_t kClosed = 1;

// dxflib reads numbers in the global locale, where a point may part thousands. 12.5 goes to it as 125e-1.
void appendReal(std::string& out, std::string_view number) {
  std::string_view exponent;
  if (const std::size_t e = number.find_first_of("eE"); e != std::string_view::npos) {
    exponent = number.substr(e + 1);
    number = number.substr(0, e);
  }
  const std::size_t point = number.find('.');
  out += number.substr(0, point);
  std::int64_t power = wholeNumber(exponent).value_or(0);
  if (point != std::string_view::npos) {
    out += number.substr(point + 1);
    power -= static_cast<std::int64_t>(number.size() - point - 1);
  }
  out += 'e';
  out += std::to_string(power);
}

bool isGeometry(EntityKind kind, int code) {
  switch (kind) {
  case EntityKind::Line:
    return code == 10 || code == 20 || code == 11 || code == 21;
  case EntityKind::Arc:
  case EntityKind::Circle:
    return code == 10 || code == 20 || code == 40 || code == 50 || code == 51;
  case EntityKind::LwPolyline:
  case EntityKind::Vertex:
    return code == 10 || code == 20 || code == 42;
  default:
    return false;
  }
}

/// A vertex of the frame that a fitted spline follows; the vertices of the spline itself follow it.
bool isControlVertex(std::string_view groupsFromVertex) {
  constexpr std::int64_t kOfFrame = 16;
  Group group;
  for (GroupCursor cursor(groupsFromVertex); cursor.next(group) && group.code != 0;) {
    if (group.code == 70) {
      return (wholeNumber(group.value).value_or(0) & kOfFrame) != 0;
    }
  }
  return false;
}

/// The entity as dxflib needs it: the groups of its geometry alone.
void appendEntity(std::string& out, const Entity& entity) {
  const auto begin = [&out](std::string_view type) { out.append("0\n").append(type).append("\n"); };
  begin(entity.type);
  if (entity.kind == EntityKind::LwPolyline) {
    out.append("90\n").append(std::to_string(entity.vertices)).append("\n");
  }
  const bool hasFrame = entity.kind == EntityKind::Polyline && (entity.flags & kSplineFit) != 0;
  EntityKind kind = entity.kind;
  Group group;
  for (GroupCursor cursor(entity.body); cursor.next(group);) {
    if (group.code == 0) {
      kind = kindOf(group.value);
      if (hasFrame && kind == EntityKind::Vertex && isControlVertex(entity.body.substr(cursor.offset()))) {
        kind = EntityKind::NeverPartOfContour;
      } else {
        begin(group.value);
      }
    } else if (isGeometry(kind, group.code)) {
      out.append(std::to_string(group.code)).append("\n");
      appendReal(out, group.value);
      out += '\n';
    }
  }
}

std::string asDxf(const std::vector<const Entity*>& entities) {
  std::string out;
  for (const Entity* entity : entities) {
    appendEntity(out, *entity);
  }
  return out += "0\nEOF\n";
}

/// A point of a polyline and the bulge of what leads on from it. Drawing units.
struct Vertex {
  Point point;
  double bulge = 0;
};

struct Round {
  Point center;
  double radius = 0;
  double start = 0; ///< rad
  double sweep = 0; ///< rad, counter-clockwise
};

/// Entities as dxflib gives them, in their own coordinates: a line or polyline by its vertices, an arc or circle as a
/// round; the range of each entity says which.
struct PlainShapes {
  struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  std::vector<Vertex> vertices;
  std::vector<Round> rounds;
  std::vector<Range> ranges;
};

/// Takes one call, or one polyline with its vertices, for each entity. A stop ends the stream.
class ShapeTaker : public DL_CreationAdapter {
public:
  ShapeTaker(PlainShapes& shapes, std::istream& stream, std::stop_token stop)
      : m_shapes(shapes), m_stream(stream), m_stop(std::move(stop)) {}

  void addLine(const DL_LineData& line) override {
    endWhenStopped();
    m_shapes.ranges.push_back({m_shapes.vertices.size(), 2});
    m_shapes.vertices.push_back({{line.x1, line.y1}, 0});
    m_shapes.vertices.push_back({{line.x2, line.y2}, 0});
  }

  void addArc(const DL_ArcData& arc) override {
    // Equal angles are the whole circle, as CAD systems draw it.
    const double sweep = std::fmod(arc.angle2 - arc.angle1, 360);
    addRound(arc.cx, arc.cy, arc.radius, arc.angle1, sweep > 0 ? sweep : sweep + 360);
  }

  void addCircle(const DL_CircleData& circle) override {
    addRound(circle.cx, circle.cy, circle.radius, -90, 360);
  }

  void addPolyline(const DL_PolylineData&) override {
    endWhenStopped();
    m_shapes.ranges.push_back({m_shapes.vertices.size(), 0});
  }

  void addVertex(const DL_VertexData& vertex) override {
    ++m_shapes.ranges.back().count;
    m_shapes.vertices.push_back({{vertex.x, vertex.y}, vertex.bulge});
  }

private:
  void endWhenStopped() {
    if (m_stop.stop_requested()) {
      m_stream.setstate(std::ios::eofbit);
    }
  }

  void addRound(double x, double y, double radius, double startDegrees, double sweepDegrees) {
    endWhenStopped();
    m_shapes.ranges.push_back({m_shapes.rounds.size(), 1});
    m_shapes.rounds.push_back({{x, y}, radius, base::radians(startDegrees), base::radians(sweepDegrees)});
  }

  PlainShapes& m_shapes;
  std::istream& m_stream;
  std::stop_token m_stop;
};

bool isRound(EntityKind kind) {
  return kind == EntityKind::Arc || kind == EntityKind::Circle;
}

bool isPlain(EntityKind kind) {
  return kind == EntityKind::Line || isRound(kind) || kind == EntityKind::LwPolyline || kind == EntityKind::Polyline;
}

PlainShapes readPlain(const std::vector<const Entity*>& entities, const std::stop_token& stop) {
  static std::mutex oneAtATime; // dxflib counts lines in a static variable
  const std::lock_guard lock(oneAtATime);
  PlainShapes shapes;
  std::istringstream stream(asDxf(entities));
  ShapeTaker taker(shapes, stream, stop);
  DL_Dxf().in(stream, &taker);
  if (shapes.ranges.size() != entities.size() && !stop.stop_requested()) {
    throw std::logic_error("entities were lost");
  }
  return shapes;
}

/// The flat entities have a plane of their own, whose X runs the other way where it is seen from below.
bool isSeenFromBelow(const Entity& entity) {
  const bool hasPlane = isRound(entity.kind) || entity.kind == EntityKind::LwPolyline ||
                        (entity.kind == EntityKind::Polyline && (entity.flags & kInSpace) == 0);
  return hasPlane && entity.extrusion[2] < 0;
}

Arc arcOf(const Round& round) {
  return geometry::arcAbout(round.center, round.radius, round.start, round.sweep);
}

bool isSane(const Point& point) {
  return std::abs(point.x()) <= kMostCoordinate && std::abs(point.y()) <= kMostCoordinate;
}

bool isSane(const EllipticArc& arc) {
  const Point center = arc.map * arc.arc.center();
  const Vector reach = arc.arc.radius() * arc.map.linear().cwiseAbs().rowwise().sum();
  return isSane(center + reach) && isSane(center - reach);
}

/// Puts entities where they are drawn, as pieces in mm.
class PieceMaker {
public:
  PieceMaker(const Selection& selection, std::stop_token stop) : m_selection(selection), m_stop(std::move(stop)) {}

  [[nodiscard]] ReadEntities make();

private:
  void readPlainEntities();
  void add(const PlacedEntity& placed, std::size_t number);
  void addPlain(const Entity& entity, std::size_t number, const Map& map);
  void addArc(const EllipticArc& arc);
  void addPolyline(const Entity& entity, std::span<const Vertex> vertices, const Map& map);
  void keepVertices(const Entity& entity, std::span<const Vertex> vertices, bool closed, const Map& map);
  void addSegment(const Entity& entity, const Vertex& start, const Vertex& end, const Map& map);
  void refuseBulge(const Entity& entity, double bulge, const Point& where);
  void addEllipse(const Entity& entity, const Map& map);
  void addSpline(const Entity& entity, const Map& map);
  void addFitted(bool followed, const Point& from, const Point& to, const Vector& shift);
  void finishPiece();
  void refusePlace(const PlacedEntity& placed);

  const Selection& m_selection;
  std::stop_token m_stop;
  std::vector<std::size_t> m_shapeOf; ///< number of the plain shape of each entity of the selection
  PlainShapes m_plain;
  geometry::ArcFitter m_fitter{geometry::kFitTolerance, kMostFittingSteps};
  std::vector<Vertex> m_vertices; ///< of the polyline in hand, those without length between them left out
  std::vector<Curve> m_chain;     ///< the piece in hand
  Point m_farthest{0, 0};         ///< of the entity in hand, where it is absurdly far away
  bool m_gaveUp = false;
  ReadEntities m_read;
};

ReadEntities PieceMaker::make() {
  readPlainEntities();
  for (std::size_t i = 0; i < m_selection.entities.size() && !m_stop.stop_requested(); ++i) {
    add(m_selection.entities[i], i);
    if (m_gaveUp) {
      m_read.problems.push_back(
          Problem(Code::CurvesTooMany, {{"most", kMostFittingSteps}}).onLine(m_selection.entities[i].entity->line));
      break;
    }
  }
  return std::move(m_read);
}

// An entity of a block is read once, however often it is drawn.
void PieceMaker::readPlainEntities() {
  std::vector<const Entity*> plain;
  std::unordered_map<const Entity*, std::size_t> ofBlocks;
  m_shapeOf.reserve(m_selection.entities.size());
  for (const auto& [entity, placement] : m_selection.entities) {
    std::size_t shape = plain.size();
    if (isPlain(entity->kind) && placement != 0) {
      shape = ofBlocks.try_emplace(entity, shape).first->second;
    }
    if (isPlain(entity->kind) && shape == plain.size()) {
      plain.push_back(entity);
    }
    m_shapeOf.push_back(shape);
  }
  m_plain = readPlain(plain, m_stop);
}

void PieceMaker::add(const PlacedEntity& placed, std::size_t number) {
  const Entity& entity = *placed.entity;
  Map map = m_selection.placements[placed.placement].toMillimetres;
  m_farthest.setZero();
  if (entity.kind == EntityKind::Ellipse) {
    addEllipse(entity, map);
  } else if (entity.kind == EntityKind::Spline) {
    addSpline(entity, map);
  } else {
    if (isSeenFromBelow(entity)) {
      map.linear().col(0) = -map.linear().col(0);
    }
    addPlain(entity, number, map);
  }
  if (m_farthest.isZero()) {
    finishPiece();
  } else {
    refusePlace(placed);
  }
}

void PieceMaker::addPlain(const Entity& entity, std::size_t number, const Map& map) {
  const PlainShapes::Range range = m_plain.ranges[m_shapeOf[number]];
  if (isRound(entity.kind)) {
    const Round& round = m_plain.rounds[range.first];
    if (round.radius > 0) {
      addArc({arcOf(round), map});
    } else {
      m_chain.emplace_back(Line{map * round.center, map * round.center});
    }
    return;
  }
  const std::span<const Vertex> vertices(m_plain.vertices.data() + range.first, range.count);
  for (const Vertex& vertex : vertices) {
    if (!isSane(map * vertex.point)) {
      m_farthest = map * vertex.point;
      return;
    }
  }
  if (entity.kind == EntityKind::Line) {
    m_chain.emplace_back(Line{map * vertices[0].point, map * vertices[1].point});
  } else {
    addPolyline(entity, vertices, map);
  }
}

void PieceMaker::addArc(const EllipticArc& arc) {
  if (!isSane(arc)) {
    m_farthest = arc.map * arc.arc.start;
  } else if (const std::optional<Arc> circular = geometry::asCircular(arc)) {
    m_chain.emplace_back(*circular);
  } else {
    const bool followed = geometry::follow(arc, m_fitter);
    addFitted(followed, arc.map * arc.arc.start, arc.map * geometry::endPoint(arc.arc), Vector::Zero());
  }
}

void PieceMaker::addPolyline(const Entity& entity, std::span<const Vertex> vertices, const Map& map) {
  const bool closed = (entity.flags & kClosed) != 0;
  const std::size_t repairs = m_read.repairs.size();
  keepVertices(entity, vertices, closed, map);
  if (m_vertices.size() == 1) { // a piece without length
    m_read.repairs.resize(repairs);
    m_chain.emplace_back(Line{map * m_vertices[0].point, map * m_vertices[0].point});
    return;
  }
  for (std::size_t i = 0; i + 1 < m_vertices.size(); ++i) {
    addSegment(entity, m_vertices[i], m_vertices[i + 1], map);
  }
  if (closed && !m_vertices.empty()) {
    addSegment(entity, m_vertices.back(), m_vertices.front(), map);
  }
}

// Of vertices without a length between them the first stays, and the bulge of the last leads on.
void PieceMaker::keepVertices(const Entity& entity, std::span<const Vertex> vertices, bool closed, const Map& map) {
  const auto drops = [&](const Vertex& a, const Vertex& b) {
    const double length = (map.linear() * (b.point - a.point)).norm();
    if (length < base::kZeroLength) {
      m_read.repairs.push_back(
          Problem(Code::ZeroLengthRemoved, {{"size_mm", length}}).at(map * a.point).onLine(entity.line));
    }
    return length < base::kZeroLength;
  };
  m_vertices.clear();
  for (const Vertex& vertex : vertices) {
    if (m_vertices.empty() || !drops(m_vertices.back(), vertex)) {
      m_vertices.push_back(vertex);
    } else {
      m_vertices.back().bulge = vertex.bulge;
    }
  }
  if (closed && m_vertices.size() > 1 && drops(m_vertices.back(), m_vertices.front())) {
    m_vertices.pop_back();
  }
}

// The bulge is the tangent of a quarter of the angle swept.
void PieceMaker::addSegment(const Entity& entity, const Vertex& start, const Vertex& end, const Map& map) {
  const Point from = map * start.point;
  const Point to = map * end.point;
  const double chord = (to - from).norm();
  const double bulge = std::abs(start.bulge);
  const double sweep = 4 * std::atan(start.bulge);
  if (bulge * chord / 2 < kStraight) {
    m_chain.emplace_back(Line{from, to});
  } else if (chord * (bulge + 1 / bulge) / 4 > kMostBulgeRadius) {
    refuseBulge(entity, start.bulge, from);
  } else if (geometry::keepsCircles(map.linear())) {
    m_chain.emplace_back(geometry::arcBetween(from, to, map.linear().determinant() < 0 ? -sweep : sweep));
  } else {
    const EllipticArc arc{geometry::arcBetween(start.point, end.point, sweep), map};
    addFitted(geometry::follow(arc, m_fitter), from, to, Vector::Zero());
  }
}

void PieceMaker::refuseBulge(const Entity& entity, double bulge, const Point& where) {
  m_read.problems.push_back(
      Problem(Code::DxfEntityValue, {{"entity", std::string(entity.type)}, {"what", "a bulge of"}, {"value", bulge}})
          .onLine(entity.line)
          .at(where));
  finishPiece();
}

void PieceMaker::addEllipse(const Entity& entity, const Map& map) {
  const EllipticArc own = readEllipse(entity);
  if (own.map.linear().col(0).isZero()) {
    m_read.problems.push_back(
        Problem(Code::DxfEntityValue,
                {{"entity", std::string(entity.type)}, {"what", "a major axis of"}, {"value", 0.0}})
            .onLine(entity.line));
    return;
  }
  addArc({own.arc, map * own.map});
}

// Seen from the first point on, so that directions have all digits.
void PieceMaker::addSpline(const Entity& entity, const Map& map) {
  base::Expected<std::vector<geometry::Bezier>> pieces = readSpline(entity);
  if (!pieces) {
    m_read.problems.push_back(pieces.error());
    return;
  }
  const Point origin = pieces->front().points.front().hnormalized();
  for (geometry::Bezier& piece : *pieces) {
    for (Eigen::Vector3d& h : piece.points) {
      const Point point = h.hnormalized();
      if (!isSane(map * point)) {
        m_farthest = map * point;
        return;
      }
      h.head<2>() = h.z() * (map.linear() * (point - origin));
    }
  }
  const Point from = map * origin;
  const Point to = from + geometry::stationAt(pieces->back(), 1).point;
  addFitted(geometry::follow(*pieces, m_fitter), from, to, from);
}

void PieceMaker::addFitted(bool followed, const Point& from, const Point& to, const Vector& shift) {
  const std::vector<Curve> chain = m_fitter.takeChain();
  m_gaveUp = m_gaveUp || !followed;
  const Eigen::Isometry2d motion(Eigen::Translation2d(shift.x(), shift.y()));
  for (const Curve& curve : chain) {
    m_chain.push_back(shift.isZero() ? curve : geometry::transformed(curve, motion));
  }
  if (chain.empty()) {
    m_chain.emplace_back(Line{from, to});
  }
}

void PieceMaker::finishPiece() {
  m_read.pieces.add(m_chain);
  m_chain.clear();
}

// Once for each INSERT of the drawing.
void PieceMaker::refusePlace(const PlacedEntity& placed) {
  m_chain.clear();
  const std::int64_t insert = m_selection.placements[placed.placement].line;
  const std::int64_t line = insert > 0 ? insert : placed.entity->line;
  const base::Problems& told = m_read.problems;
  if (told.empty() || told.back().code != Code::PlaceAbsurd || told.back().line != line) {
    m_read.problems.push_back(Problem(Code::PlaceAbsurd, {{"entity", std::string(placed.entity->type)},
                                                          {"distance_mm", m_farthest.norm()},
                                                          {"most_mm", kMostCoordinate}})
                                  .onLine(line));
  }
}

} // namespace

ReadEntities readEntities(const Selection& selection, const std::stop_token& stop) {
  return PieceMaker(selection, stop).make();
}

} // namespace arris::pattern
