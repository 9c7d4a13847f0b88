#include "core/files/gcode_text.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace arris::files {
namespace {

using geometry::Arc;
using geometry::Parabola;
using geometry::Point;

constexpr double kUnitsPerMillimetre = 1e6;

/// An arc that bulges less than this over its chord is written as the chord, mm: its ends could coincide after
/// rounding, which makes it a full circle, and controllers (LinuxCNC below 1e-6 rad) take a tiny sweep for one.
constexpr double kFlatBulge = 1e-4;

/// An arc of a larger radius than this is written as chords, mm: controllers lose its centre's digits.
constexpr double kLargestRadius = 1e5;

/// How far those chords stay from the arc, mm.
constexpr double kChordBulge = 2e-4;

/// An arc that sweeps more than this is written in halves, rad, so that rounding cannot make a full circle a point.
constexpr double kLargestSweep = 1.5 * base::kPi;

/// LinuxCNC takes lines of up to 255 characters.
constexpr std::size_t kLongestComment = 200;

std::int64_t rounded(double value) {
  return std::llround(value * kUnitsPerMillimetre);
}

double bulgeOf(const Arc& arc) {
  return (1 - std::cos(std::min(std::abs(arc.sweep()) / 2, base::kPi))) * arc.radius();
}

} // namespace

void GCodeText::line(std::string_view text) {
  m_text.append(text);
  m_text.push_back('\n');
}

void GCodeText::comment(std::string_view text) {
  m_text.push_back('(');
  std::size_t length = 0;
  for (const char c : text) {
    const bool continuesACharacter = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; // of UTF-8
    if (continuesACharacter || ++length > kLongestComment) {
      continue;
    }
    if (c == '(' || c == ')') {
      m_text.push_back(c == '(' ? '[' : ']');
    } else {
      m_text.push_back(c >= ' ' && c <= '~' ? c : '?');
    }
  }
  line(")");
}

void GCodeText::rapidTo(const Point& point) {
  const Micro x = rounded(point.x());
  const Micro y = rounded(point.y());
  if (x == m_x && y == m_y) {
    return;
  }
  m_text.append(std::string_view("G0"));
  place(x, y);
  line("");
}

void GCodeText::rapidToHeight(double z) {
  if (rounded(z) == m_z) {
    return;
  }
  m_z = rounded(z);
  m_text.append(std::string_view("G0"));
  word('Z', *m_z);
  line("");
}

void GCodeText::feedToHeight(double z, double feed) {
  if (rounded(z) == m_z) {
    return;
  }
  m_z = rounded(z);
  m_text.append(std::string_view("G1"));
  word('Z', *m_z);
  endBlock(feed);
}

void GCodeText::lineTo(const Point& point, double feed) {
  const Micro x = rounded(point.x());
  const Micro y = rounded(point.y());
  if (x == m_x && y == m_y) {
    return;
  }
  m_text.append(std::string_view("G1"));
  place(x, y);
  endBlock(feed);
}

void GCodeText::arc(const Arc& arc, double feed) {
  if (bulgeOf(arc) <= kFlatBulge) {
    lineTo(geometry::endPoint(arc), feed);
  } else if (arc.radius() > kLargestRadius) {
    const int count = static_cast<int>(std::ceil(arc.length / std::sqrt(8 * kChordBulge * arc.radius())));
    for (int i = 1; i <= count; ++i) {
      lineTo(geometry::pointAt(arc, arc.length * i / count), feed);
    }
  } else if (std::abs(arc.sweep()) > kLargestSweep) {
    arcBlock(std::get<Arc>(geometry::part(arc, 0, arc.length / 2)), feed);
    arcBlock(std::get<Arc>(geometry::part(arc, arc.length / 2, arc.length)), feed);
  } else {
    arcBlock(arc, feed);
  }
}

void GCodeText::arcBlock(const Arc& arc, double feed) {
  const Point end = geometry::endPoint(arc);
  const Micro i = rounded(arc.center().x()) - *m_x;
  const Micro j = rounded(arc.center().y()) - *m_y;
  m_text.append(std::string_view(arc.curvature > 0 ? "G3" : "G2"));
  place(rounded(end.x()), rounded(end.y()));
  word('I', i);
  word('J', j);
  endBlock(feed);
}

void GCodeText::spline(const Parabola& parabola, double feed) {
  const Micro i = rounded(parabola.q.x()) - *m_x;
  const Micro j = rounded(parabola.q.y()) - *m_y;
  m_text.append(std::string_view("G5.1"));
  place(rounded(parabola.c.x()), rounded(parabola.c.y()));
  word('I', i);
  word('J', j);
  endBlock(feed);
}

std::string GCodeText::take() {
  return fmt::to_string(m_text);
}

void GCodeText::place(Micro x, Micro y) {
  m_x = x;
  m_y = y;
  word('X', x);
  word('Y', y);
}

void GCodeText::endBlock(double feed) {
  word('F', rounded(feed));
  line("");
}

// The decimals that are zero at the end are left out.
void GCodeText::word(char letter, Micro value) {
  constexpr auto kUnits = static_cast<Micro>(kUnitsPerMillimetre);
  const Micro size = std::abs(value);
  auto out = fmt::format_to(std::back_inserter(m_text), " {}{}{}", letter, value < 0 ? "-" : "", size / kUnits);
  Micro decimals = size % kUnits;
  if (decimals == 0) {
    return;
  }
  int digits = 6;
  for (; decimals % 10 == 0; --digits) {
    decimals /= 10;
  }
  fmt::format_to(out, ".{:0{}}", decimals, digits);
}

} // namespace arris::files
