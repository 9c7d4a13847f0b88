#pragma once

#include "core/geometry/curve.h"
#include "core/geometry/spline.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arris::test {

/// The spline that is one Bézier curve: degree + 1 points.
[[nodiscard]] geometry::Spline bezier(std::vector<geometry::Point> points, std::vector<double> weights = {});

/// Builds the text of a small DXF drawing. Numbers have 17 digits, so nothing is lost.
class DxfText {
public:
  /// The numbers of what is added from here on have this many decimals.
  DxfText& decimals(int count);
  DxfText& insUnits(int number);
  DxfText& measurement(int number);
  /// A layer table with this entry; a negative colour switches the layer off, flag 1 freezes it.
  DxfText& layer(std::string_view name, int color, int flags);

  /// Lines as LINE; arcs as ARC or, where they are full, as CIRCLE (always counter-clockwise, as DXF has them).
  DxfText& add(const geometry::Curve& curve, std::string_view layer = "0");
  DxfText& add(const std::vector<geometry::Curve>& curves);
  /// A closed chain as one LWPOLYLINE with bulges.
  DxfText& addPolyline(const std::vector<geometry::Curve>& closedChain);
  DxfText& add(const geometry::Spline& spline);
  /// The entities of `content` as a block.
  DxfText& block(std::string_view name, const DxfText& content);
  DxfText& insert(std::string_view block, const geometry::Point& at, const geometry::Vector& scale, double degrees = 0);
  /// Any groups, each "code value" on a line of its own: "0 TEXT\n8 0".
  DxfText& addGroups(std::string_view groups);

  /// A block with these entities, each group "code value" on a line of its own.
  DxfText& addBlock(std::string_view name, const geometry::Point& base, std::string_view groups);

  [[nodiscard]] std::string text() const;

  /// The groups "code value" of a point, the code of its X being `code`.
  [[nodiscard]] std::string pointGroups(int code, const geometry::Point& p) const;

private:
  [[nodiscard]] std::string number(double x) const;
  [[nodiscard]] std::string arcGroups(const geometry::Arc& arc, std::string_view layer) const;

  std::optional<int> m_decimals;
  std::string m_header;
  std::string m_layers;
  std::string m_blocks;
  std::string m_entities;
};

/// The groups of `groups`, one "code value" on each line, as DXF: code and value on lines of their own.
[[nodiscard]] std::string asGroups(std::string_view groups);

/// The groups "code value" of a polyline of these corners on a layer, as LWPOLYLINE.
[[nodiscard]] std::string polylineGroups(const std::vector<geometry::Point>& corners, bool closed,
                                         std::string_view layer = "0");

/// Line of the file, from 1, on which `needle` first begins.
[[nodiscard]] std::int64_t lineOf(std::string_view text, std::string_view needle);

} // namespace arris::test
