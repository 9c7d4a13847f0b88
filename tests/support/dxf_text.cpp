#include "tests/support/dxf_text.h"

#include "core/base/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace arris::test {
geometry::Spline bezier(std::vector<geometry::Point> points, std::vector<double> weights) {
  geometry::Spline spline;
  spline.degree = static_cast<int>(points.size()) - 1;
  spline.knots.assign(points.size(), 0);
  spline.knots.insert(spline.knots.end(), points.size(), 1);
  spline.points = std::move(points);
  spline.weights = std::move(weights);
  return spline;
}

std::string asGroups(std::string_view groups) {
  std::string text;
  while (!groups.empty()) {
    const std::string_view line = groups.substr(0, groups.find('\n'));
    groups.remove_prefix(std::min(line.size() + 1, groups.size()));
    const std::size_t space = std::min(line.find(' '), line.size());
    text.append(line.substr(0, space)).append("\n");
    text.append(line.substr(std::min(space + 1, line.size()))).append("\n");
  }
  return text;
}

std::string DxfText::number(double x) const {
  return m_decimals ? fmt::format("{:.{}f}", x, *m_decimals) : fmt::format("{}", x); // the shortest that reads back
}

std::string DxfText::pointGroups(int code, const geometry::Point& p) const {
  return fmt::format("{} {}\n{} {}\n", code, number(p.x()), code + 10, number(p.y()));
}

std::string DxfText::arcGroups(const geometry::Arc& arc, std::string_view layer) const {
  const geometry::Point center = arc.center();
  const auto angleOf = [&](const geometry::Point& p) {
    return base::degrees(std::atan2(p.y() - center.y(), p.x() - center.x()));
  };
  const std::string place = fmt::format("8 {}\n{}40 {}\n", layer, pointGroups(10, center), number(arc.radius()));
  if (std::abs(arc.sweep()) > 2 * base::kPi - 1e-9) {
    return "0 CIRCLE\n" + place;
  }
  double from = angleOf(arc.start);
  double to = angleOf(geometry::endPoint(arc));
  if (arc.curvature < 0) {
    std::swap(from, to);
  }
  return fmt::format("0 ARC\n{}50 {}\n51 {}\n", place, number(from), number(to));
}

DxfText& DxfText::decimals(int count) {
  m_decimals = count;
  return *this;
}

DxfText& DxfText::insUnits(int number) {
  m_header += asGroups(fmt::format("9 $INSUNITS\n70 {}", number));
  return *this;
}

DxfText& DxfText::measurement(int number) {
  m_header += asGroups(fmt::format("9 $MEASUREMENT\n70 {}", number));
  return *this;
}

DxfText& DxfText::layer(std::string_view name, int color, int flags) {
  m_layers += asGroups(fmt::format("0 LAYER\n2 {}\n70 {}\n62 {}", name, flags, color));
  return *this;
}

DxfText& DxfText::add(const geometry::Curve& curve, std::string_view layer) {
  if (const auto* line = std::get_if<geometry::Line>(&curve)) {
    return addGroups(fmt::format("0 LINE\n8 {}\n{}30 0.0\n{}31 0.0\n", layer, pointGroups(10, line->from),
                                 pointGroups(11, line->to)));
  }
  return addGroups(arcGroups(std::get<geometry::Arc>(curve), layer));
}

DxfText& DxfText::add(const std::vector<geometry::Curve>& curves) {
  for (const geometry::Curve& curve : curves) {
    add(curve);
  }
  return *this;
}

DxfText& DxfText::addPolyline(const std::vector<geometry::Curve>& closedChain) {
  addGroups(fmt::format("0 LWPOLYLINE\n8 0\n90 {}\n70 1", closedChain.size()));
  for (const geometry::Curve& curve : closedChain) {
    addGroups(pointGroups(10, geometry::startPoint(curve)));
    if (const auto* arc = std::get_if<geometry::Arc>(&curve)) {
      addGroups("42 " + number(std::tan(arc->sweep() / 4)));
    }
  }
  return *this;
}

DxfText& DxfText::add(const geometry::Spline& spline) {
  const bool closed = spline.points.front() == spline.points.back();
  const int flags = 8 + (closed ? 1 : 0) + (spline.weights.empty() ? 0 : 4); // planar, closed, rational
  addGroups(fmt::format("0 SPLINE\n8 0\n70 {}\n71 {}\n72 {}\n73 {}\n74 0", flags, spline.degree, spline.knots.size(),
                        spline.points.size()));
  for (const double knot : spline.knots) {
    addGroups("40 " + number(knot));
  }
  for (const double weight : spline.weights) {
    addGroups("41 " + number(weight));
  }
  for (const geometry::Point& point : spline.points) {
    addGroups(pointGroups(10, point) + "30 0.0");
  }
  return *this;
}

DxfText& DxfText::block(std::string_view name, const DxfText& content) {
  m_blocks += asGroups(fmt::format("0 BLOCK\n8 0\n2 {0}\n70 0\n10 0.0\n20 0.0\n30 0.0\n3 {0}", name)) +
              content.m_entities + asGroups("0 ENDBLK\n8 0");
  return *this;
}

DxfText& DxfText::insert(std::string_view block, const geometry::Point& at, const geometry::Vector& scale,
                         double degrees) {
  return addGroups(fmt::format("0 INSERT\n8 0\n2 {}\n{}30 0.0\n41 {}\n42 {}\n43 1.0\n50 {}", block, pointGroups(10, at),
                               number(scale.x()), number(scale.y()), number(degrees)));
}

DxfText& DxfText::addGroups(std::string_view groups) {
  m_entities += asGroups(groups);
  return *this;
}

DxfText& DxfText::addBlock(std::string_view name, const geometry::Point& base, std::string_view groups) {
  m_blocks += asGroups(fmt::format("0 BLOCK\n8 0\n2 {}\n70 0\n{}", name, pointGroups(10, base)));
  m_blocks += asGroups(groups) + asGroups("0 ENDBLK");
  return *this;
}

std::string DxfText::text() const {
  std::string text;
  const auto section = [&text](std::string_view name, const std::string& content) {
    text += asGroups(fmt::format("0 SECTION\n2 {}", name)) + content + asGroups("0 ENDSEC");
  };
  if (!m_header.empty()) {
    section("HEADER", m_header);
  }
  if (!m_layers.empty()) {
    section("TABLES", asGroups("0 TABLE\n2 LAYER") + m_layers + asGroups("0 ENDTAB"));
  }
  if (!m_blocks.empty()) {
    section("BLOCKS", m_blocks);
  }
  section("ENTITIES", m_entities);
  return text + asGroups("0 EOF");
}

std::string polylineGroups(const std::vector<geometry::Point>& corners, bool closed, std::string_view layer) {
  std::string groups = fmt::format("0 LWPOLYLINE\n8 {}\n90 {}\n70 {}\n", layer, corners.size(), closed ? 1 : 0);
  for (const geometry::Point& corner : corners) {
    groups += DxfText().pointGroups(10, corner);
  }
  return groups;
}

std::int64_t lineOf(std::string_view text, std::string_view needle) {
  const std::size_t place = text.find(needle);
  return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
}

} // namespace arris::test
