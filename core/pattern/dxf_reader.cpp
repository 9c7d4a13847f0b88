#include "core/pattern/dxf_reader.h"

#include "core/base/numbers.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <cmath>
#include <mutex>
#include <sstream>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using geometry::Curve;
using geometry::Line;
using geometry::Point;

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

/// The entity as dxflib needs it: the groups of its geometry alone.
void appendEntity(std::string& out, const Entity& entity) {
  const auto begin = [&out](std::string_view type) { out.append("0\n").append(type).append("\n"); };
  begin(entity.type);
  if (entity.kind == EntityKind::LwPolyline) {
    out.append("90\n").append(std::to_string(entity.vertices)).append("\n");
  }
  EntityKind kind = entity.kind;
  Group group;
  for (GroupCursor cursor(entity.body); cursor.next(group);) {
    if (group.code == 0) {
      begin(group.value);
      kind = kindOf(group.value);
    } else if (isGeometry(kind, group.code)) {
      out.append(std::to_string(group.code)).append("\n");
      appendReal(out, group.value);
      out += '\n';
    }
  }
}

std::string asDxf(const std::vector<Entity>& entities) {
  std::string out;
  for (const Entity& entity : entities) {
    appendEntity(out, entity);
  }
  return out += "0\nEOF\n";
}

/// Takes the entities as dxflib gives them: one call, or one polyline with its vertices, for each entity of the list.
class PieceMaker : public DL_CreationAdapter {
public:
  PieceMaker(const std::vector<Entity>& entities, double scale) : m_entity(entities.begin()), m_scale(scale) {}

  void addLine(const DL_LineData& line) override {
    m_read.pieces.emplace_back(Line{{m_scale * line.x1, m_scale * line.y1}, {m_scale * line.x2, m_scale * line.y2}});
    ++m_entity;
  }

  void addArc(const DL_ArcData& arc) override {
    // Equal angles are the whole circle, as CAD systems draw it.
    const double sweep = std::fmod(arc.angle2 - arc.angle1, 360);
    addArcPiece(arc.cx, arc.cy, arc.radius, arc.angle1, sweep > 0 ? sweep : sweep + 360);
  }

  void addCircle(const DL_CircleData& circle) override {
    addArcPiece(circle.cx, circle.cy, circle.radius, -90, 360);
  }

  void addPolyline(const DL_PolylineData&) override {
    m_vertices.clear();
  }

  void addVertex(const DL_VertexData& vertex) override {
    m_vertices.push_back(vertex);
  }

  void endEntity() override {
    addPolylinePieces();
    ++m_entity;
  }

  [[nodiscard]] ReadEntities takeRead() {
    return std::move(m_read);
  }

private:
  void addArcPiece(double x, double y, double radius, double startDegrees, double sweepDegrees) {
    const Point center(m_scale * x, m_scale * y);
    if (radius == 0) {
      m_read.pieces.emplace_back(Line{center, center});
    } else {
      m_read.pieces.emplace_back(
          geometry::arcAbout(center, m_scale * radius, base::radians(startDegrees), base::radians(sweepDegrees)));
    }
    ++m_entity;
  }

  void addPolylinePieces() {
    for (std::size_t i = 0; i + 1 < m_vertices.size(); ++i) {
      addSegment(m_vertices[i], m_vertices[i + 1]);
    }
    if ((m_entity->flags & kClosed) != 0 || m_vertices.size() == 1) { // a single vertex is a piece without length
      addSegment(m_vertices.back(), m_vertices.front());
    }
  }

  // The bulge is the tangent of a quarter of the angle swept.
  void addSegment(const DL_VertexData& start, const DL_VertexData& end) {
    const Point from(m_scale * start.x, m_scale * start.y);
    const Point to(m_scale * end.x, m_scale * end.y);
    const double chord = (to - from).norm();
    const double bulge = std::abs(start.bulge);
    if (bulge * chord / 2 < kStraight) {
      m_read.pieces.emplace_back(Line{from, to});
    } else if (chord * (bulge + 1 / bulge) / 4 > kMostBulgeRadius) {
      m_read.problems.push_back(
          Problem(Code::DxfEntityValue,
                  {{"entity", std::string(m_entity->type)}, {"what", "a bulge of"}, {"value", start.bulge}})
              .onLine(m_entity->line)
              .at(from));
    } else {
      m_read.pieces.emplace_back(geometry::arcBetween(from, to, 4 * std::atan(start.bulge)));
    }
  }

  std::vector<Entity>::const_iterator m_entity;
  double m_scale;
  std::vector<DL_VertexData> m_vertices;
  ReadEntities m_read;
};

} // namespace

ReadEntities readEntities(const std::vector<Entity>& entities, double scale) {
  static std::mutex oneAtATime; // dxflib counts lines in a static variable
  const std::lock_guard lock(oneAtATime);
  std::istringstream stream(asDxf(entities));
  PieceMaker maker(entities, scale);
  DL_Dxf().in(stream, &maker);
  return maker.takeRead();
}

} // namespace arris::pattern
