#include "core/pattern/dxf_entities.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;

struct TypeName {
  std::string_view name;
  EntityKind kind;
};

// The kinds that are read stand first: they are the common ones.
constexpr auto kTypes = std::to_array<TypeName>({
    {"LINE", EntityKind::Line},
    {"VERTEX", EntityKind::Vertex},
    {"ARC", EntityKind::Arc},
    {"CIRCLE", EntityKind::Circle},
    {"LWPOLYLINE", EntityKind::LwPolyline},
    {"POLYLINE", EntityKind::Polyline},
    {"SEQEND", EntityKind::SequenceEnd},
    {"TEXT", EntityKind::NeverPartOfContour},
    {"MTEXT", EntityKind::NeverPartOfContour},
    {"RTEXT", EntityKind::NeverPartOfContour},
    {"ARCALIGNEDTEXT", EntityKind::NeverPartOfContour},
    {"ATTDEF", EntityKind::NeverPartOfContour},
    {"ATTRIB", EntityKind::NeverPartOfContour},
    {"SHAPE", EntityKind::NeverPartOfContour}, // a letter of a symbol font
    {"DIMENSION", EntityKind::NeverPartOfContour},
    {"ARC_DIMENSION", EntityKind::NeverPartOfContour},
    {"LARGE_RADIAL_DIMENSION", EntityKind::NeverPartOfContour},
    {"LEADER", EntityKind::NeverPartOfContour},
    {"MULTILEADER", EntityKind::NeverPartOfContour},
    {"MLEADER", EntityKind::NeverPartOfContour},
    {"TOLERANCE", EntityKind::NeverPartOfContour},
    {"POINT", EntityKind::NeverPartOfContour},
    {"HATCH", EntityKind::NeverPartOfContour},
    {"MPOLYGON", EntityKind::NeverPartOfContour},
    {"SOLID", EntityKind::NeverPartOfContour},
    {"TRACE", EntityKind::NeverPartOfContour},
    {"IMAGE", EntityKind::NeverPartOfContour},
    {"WIPEOUT", EntityKind::NeverPartOfContour},
    {"PDFUNDERLAY", EntityKind::NeverPartOfContour},
    {"DGNUNDERLAY", EntityKind::NeverPartOfContour},
    {"DWFUNDERLAY", EntityKind::NeverPartOfContour},
    {"OLEFRAME", EntityKind::NeverPartOfContour},
    {"OLE2FRAME", EntityKind::NeverPartOfContour},
    {"ACAD_TABLE", EntityKind::NeverPartOfContour},
    {"VIEWPORT", EntityKind::NeverPartOfContour},
    {"XLINE", EntityKind::NeverPartOfContour},
    {"RAY", EntityKind::NeverPartOfContour},
    {"LIGHT", EntityKind::NeverPartOfContour},
    {"CAMERA", EntityKind::NeverPartOfContour},
    {"GEOPOSITIONMARKER", EntityKind::NeverPartOfContour},
});

struct RequiredGroup {
  int code;
  std::string_view what;
};

constexpr auto kOfLine = std::to_array<RequiredGroup>(
    {{10, "X of its start"}, {20, "Y of its start"}, {11, "X of its end"}, {21, "Y of its end"}});
constexpr auto kOfArc = std::to_array<RequiredGroup>(
    {{10, "X of its centre"}, {20, "Y of its centre"}, {40, "radius"}, {50, "start angle"}, {51, "end angle"}});
constexpr auto kOfCircle =
    std::to_array<RequiredGroup>({{10, "X of its centre"}, {20, "Y of its centre"}, {40, "radius"}});
constexpr auto kOfVertex = std::to_array<RequiredGroup>({{10, "X"}, {20, "Y"}});

std::span<const RequiredGroup> required(EntityKind kind) {
  switch (kind) {
  case EntityKind::Line:
    return kOfLine;
  case EntityKind::Arc:
    return kOfArc;
  case EntityKind::Circle:
    return kOfCircle;
  case EntityKind::LwPolyline:
  case EntityKind::Vertex:
    return kOfVertex;
  default:
    return {};
  }
}

constexpr std::int64_t kMeshFace = 128; // a vertex of a mesh that names other vertices and has no place

bool isReal(int code) {
  return (code >= 10 && code <= 59) || (code >= 140 && code <= 149) || (code >= 210 && code <= 239);
}

bool isInteger(int code) {
  return (code >= 60 && code <= 79) || (code >= 90 && code <= 99) || (code >= 170 && code <= 179);
}

bool hasPlace(EntityKind kind) {
  return kind != EntityKind::NeverPartOfContour && kind != EntityKind::SequenceEnd && kind != EntityKind::NotRead;
}

Problem lacks(const Entity& entity, const RequiredGroup& group) {
  return Problem(
      Code::DxfEntityIncomplete,
      {{"entity", std::string(entity.type)}, {"group", std::int64_t{group.code}}, {"what", std::string(group.what)}});
}

Problem twice(const Entity& entity, int code) {
  return Problem(Code::DxfEntityValue,
                 {{"entity", std::string(entity.type)}, {"what", "group " + std::to_string(code)}, {"value", "twice"}});
}

constexpr std::uint64_t bit(int code) {
  return std::uint64_t{1} << static_cast<unsigned>(code);
}

} // namespace

EntityKind kindOf(std::string_view type) {
  const auto isIt = [type](const TypeName& known) { return known.name == type; };
  const TypeName* found = std::find_if(kTypes.begin(), kTypes.end(), isIt);
  return found != kTypes.end() ? found->kind : EntityKind::NotRead;
}

EntityCheck::EntityCheck(const Group& group, double mostCoordinate) : m_mostCoordinate(mostCoordinate) {
  m_entity.kind = kindOf(group.value);
  m_entity.type = group.value;
  m_entity.line = group.line;
}

std::optional<Problem> EntityCheck::take(const Group& group) {
  if (group.code == 8) {
    m_entity.layer = group.value;
    return std::nullopt;
  }
  // What can never be part of a contour is passed over whatever its numbers.
  if (m_entity.kind == EntityKind::NeverPartOfContour || m_entity.kind == EntityKind::SequenceEnd) {
    if (group.code == 67) {
      m_entity.paperSpace = group.value == "1";
    }
    return std::nullopt;
  }
  if (isReal(group.code)) {
    return takeReal(group);
  }
  return isInteger(group.code) ? takeInteger(group) : std::nullopt;
}

std::optional<Problem> EntityCheck::takeReal(const Group& group) {
  const std::optional<double> number = finiteNumber(group.value);
  if (!number) {
    return Problem(Code::DxfNumber, {{"group", std::int64_t{group.code}}, {"found", quoted(group.value)}});
  }
  const bool radius = group.code == 40 && (m_entity.kind == EntityKind::Arc || m_entity.kind == EntityKind::Circle);
  if (hasPlace(m_entity.kind) && (group.code < 40 || radius) && std::abs(*number) > m_mostCoordinate) {
    return Problem(Code::DxfCoordinateAbsurd,
                   {{"group", std::int64_t{group.code}}, {"found", *number}, {"most", m_mostCoordinate}});
  }
  // An arc of radius 0 is what filleting with radius 0 leaves: a piece without length. A circle of radius 0 is nothing.
  if (radius && (*number < 0 || (*number == 0 && m_entity.kind == EntityKind::Circle))) {
    return Problem(Code::DxfEntityValue,
                   {{"entity", std::string(m_entity.type)}, {"what", "the radius"}, {"value", *number}});
  }
  if (group.code == 30 && m_entity.kind == EntityKind::Vertex) {
    m_entity.heights = {*number, *number};
  } else if ((group.code == 30 || group.code == 31) && m_entity.kind == EntityKind::Line) {
    m_entity.heights.at(static_cast<std::size_t>(group.code - 30)) = *number;
  } else if (group.code >= 210 && group.code <= 230 && group.code % 10 == 0) {
    m_entity.extrusion.at(static_cast<std::size_t>(group.code / 10 - 21)) = *number;
  }
  return noteSeen(group);
}

std::optional<Problem> EntityCheck::takeInteger(const Group& group) {
  const std::optional<std::int64_t> number = wholeNumber(group.value);
  if (!number) {
    return Problem(Code::DxfNumber, {{"group", std::int64_t{group.code}}, {"found", quoted(group.value)}});
  }
  switch (group.code) {
  case 60:
    m_entity.invisible = *number == 1;
    break;
  case 67:
    m_entity.paperSpace = *number == 1;
    break;
  case 70:
    m_entity.flags = *number;
    break;
  case 90:
    if (m_entity.kind == EntityKind::LwPolyline) {
      m_announcedVertices = *number;
    }
    break;
  default:
    break;
  }
  return std::nullopt;
}

std::optional<Problem> EntityCheck::noteSeen(const Group& group) {
  if (group.code >= 60 || !hasPlace(m_entity.kind)) {
    return std::nullopt;
  }
  if (m_entity.kind == EntityKind::LwPolyline) {
    return noteVertex(group.code);
  }
  if ((m_seen & bit(group.code)) != 0) { // the name of an entity between them was lost
    return twice(m_entity, group.code);
  }
  m_seen |= bit(group.code);
  return std::nullopt;
}

std::optional<Problem> EntityCheck::noteVertex(int code) {
  if (code == 10) {
    if (m_ordinates != m_entity.vertices) {
      return lacks(m_entity, kOfVertex[1]);
    }
    ++m_entity.vertices;
  } else if (code == 20) {
    if (m_ordinates == m_entity.vertices) {
      return twice(m_entity, code);
    }
    ++m_ordinates;
  }
  m_seen |= bit(code);
  return std::nullopt;
}

std::optional<Problem> EntityCheck::finish() const {
  if (m_entity.kind == EntityKind::Vertex && (m_entity.flags & kMeshFace) != 0) {
    return std::nullopt;
  }
  for (const RequiredGroup& group : required(m_entity.kind)) {
    if ((m_seen & bit(group.code)) == 0) {
      return lacks(m_entity, group).onLine(m_entity.line);
    }
  }
  if (m_ordinates != m_entity.vertices) {
    return lacks(m_entity, kOfVertex[1]).onLine(m_entity.line);
  }
  if (m_announcedVertices.value_or(m_entity.vertices) != m_entity.vertices) {
    return Problem(Code::DxfVertexCount, {{"entity", std::string(m_entity.type)},
                                          {"announced", *m_announcedVertices},
                                          {"what", "vertices"},
                                          {"found", m_entity.vertices}})
        .onLine(m_entity.line);
  }
  return std::nullopt;
}

} // namespace arris::pattern
