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
    {"ELLIPSE", EntityKind::Ellipse},
    {"SPLINE", EntityKind::Spline},
    {"INSERT", EntityKind::Insert},
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
constexpr auto kOfEllipse = std::to_array<RequiredGroup>({{10, "X of its centre"},
                                                          {20, "Y of its centre"},
                                                          {11, "X of its major axis"},
                                                          {21, "Y of its major axis"},
                                                          {40, "ratio of its axes"}});
constexpr auto kOfInsert = std::to_array<RequiredGroup>({{2, "name of the block"}, {10, "X"}, {20, "Y"}});
constexpr auto kOfVertex = std::to_array<RequiredGroup>({{10, "X"}, {20, "Y"}});

std::span<const RequiredGroup> required(EntityKind kind) {
  switch (kind) {
  case EntityKind::Line:
    return kOfLine;
  case EntityKind::Arc:
    return kOfArc;
  case EntityKind::Circle:
    return kOfCircle;
  case EntityKind::Ellipse:
    return kOfEllipse;
  case EntityKind::Insert:
    return kOfInsert;
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

Problem announcesAnother(const Entity& entity, std::int64_t announced, std::string what, std::int64_t found) {
  return Problem(Code::DxfVertexCount, {{"entity", std::string(entity.type)},
                                        {"announced", announced},
                                        {"what", std::move(what)},
                                        {"found", found}})
      .onLine(entity.line);
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
  if (group.code == 2 && m_entity.kind == EntityKind::Insert) {
    m_seen |= bit(group.code);
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
  if (group.code == 40 && m_entity.kind == EntityKind::Ellipse && *number <= 0) {
    return Problem(Code::DxfEntityValue,
                   {{"entity", std::string(m_entity.type)}, {"what", "a ratio of axes of"}, {"value", *number}});
  }
  if (group.code == 30 || group.code == 31) {
    noteHeight(group.code, *number);
  } else if (group.code >= 210 && group.code <= 230 && group.code % 10 == 0) {
    m_entity.extrusion.at(static_cast<std::size_t>(group.code / 10 - 21)) = *number;
  }
  return noteSeen(group);
}

void EntityCheck::noteHeight(int code, double height) {
  auto& [lowest, highest] = m_entity.heights;
  switch (m_entity.kind) {
  case EntityKind::Vertex:
    lowest = height;
    highest = height;
    break;
  case EntityKind::Line:
    (code == 30 ? lowest : highest) = height;
    break;
  case EntityKind::Ellipse:
    highest = code == 31 ? height : highest;
    break;
  case EntityKind::Spline: {
    const bool isFirst = (m_seen & (bit(30) | bit(31))) == 0;
    lowest = isFirst ? height : std::min(lowest, height);
    highest = isFirst ? height : std::max(highest, height);
    break;
  }
  default:
    break;
  }
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
  case 72:
    m_spline.announcedKnots = *number;
    break;
  case 73:
    m_spline.announcedControls = *number;
    break;
  case 74:
    m_spline.announcedFits = *number;
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
  if (m_entity.kind == EntityKind::Spline) {
    return noteSplineGroup(group.code);
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

std::optional<Problem> EntityCheck::noteSplineGroup(int code) {
  const auto next = [this](std::array<std::int64_t, 2>& points, std::size_t ordinate) -> std::optional<Problem> {
    if (points[0] != points[1] + static_cast<std::int64_t>(ordinate)) {
      return ordinate == 0 ? lacks(m_entity, kOfVertex[1]) : twice(m_entity, 20);
    }
    ++points.at(ordinate);
    m_entity.vertices += ordinate == 0 ? 1 : 0;
    return std::nullopt;
  };
  const bool repeats = code == 30 || code == 31 || code == 40 || code == 41;
  if (code == 10 || code == 20) {
    return next(m_spline.controls, code == 10 ? 0 : 1);
  }
  if (code == 11 || code == 21) {
    return next(m_spline.fits, code == 11 ? 0 : 1);
  }
  m_spline.knots += code == 40 ? 1 : 0;
  m_spline.weights += code == 41 ? 1 : 0;
  if (!repeats && (m_seen & bit(code)) != 0) {
    return twice(m_entity, code);
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
  if (m_entity.kind == EntityKind::Spline) {
    return finishSpline();
  }
  if (m_ordinates != m_entity.vertices) {
    return lacks(m_entity, kOfVertex[1]).onLine(m_entity.line);
  }
  if (m_announcedVertices.value_or(m_entity.vertices) != m_entity.vertices) {
    return announcesAnother(m_entity, *m_announcedVertices, "vertices", m_entity.vertices);
  }
  return std::nullopt;
}

// A count that is not there announces nothing.
std::optional<Problem> EntityCheck::finishSpline() const {
  const SplineCounts& n = m_spline;
  if (n.controls[0] != n.controls[1] || n.fits[0] != n.fits[1]) {
    return lacks(m_entity, kOfVertex[1]).onLine(m_entity.line);
  }
  if (n.controls[0] + n.fits[0] == 0) {
    return lacks(m_entity, kOfVertex[0]).onLine(m_entity.line);
  }
  if (n.announcedKnots.value_or(n.knots) != n.knots) {
    return announcesAnother(m_entity, *n.announcedKnots, "knots", n.knots);
  }
  if (n.announcedControls.value_or(n.controls[0]) != n.controls[0]) {
    return announcesAnother(m_entity, *n.announcedControls, "control points", n.controls[0]);
  }
  if (n.announcedFits.value_or(n.fits[0]) != n.fits[0]) {
    return announcesAnother(m_entity, *n.announcedFits, "fit points", n.fits[0]);
  }
  return std::nullopt;
}

} // namespace arris::pattern
