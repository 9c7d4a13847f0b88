#pragma once

#include "core/geometry/curve.h"

#include <array>
#include <cstddef>

namespace arris::geometry {

/// A line or an arc seen from its middle, with a parameter that makes it rational: s = (2/κ) tan(κ(λ − length/2)/2), on
/// a line λ − length/2. It rises with λ and covers the whole line, or the whole circle but for the point opposite to
/// the middle: so all is found without angles, for every curvature from 0 on.
class Track {
public:
  Track() = default;
  explicit Track(const Curve& lineOrArc);

  [[nodiscard]] double length() const {
    return m_length;
  }

  [[nodiscard]] const Point& middle() const {
    return m_middle;
  }

  /// Unit direction of travel in the middle.
  [[nodiscard]] const Vector& tangent() const {
    return m_tangent;
  }

  [[nodiscard]] double curvature() const {
    return m_curvature;
  }

  /// s at the end; at the start it is the negative of that.
  [[nodiscard]] double end() const {
    return m_end;
  }

  [[nodiscard]] Point at(double s) const {
    const double bend = m_curvature * s / 2;
    return m_middle + (s / (1 + bend * bend)) * (m_tangent + bend * leftOf(m_tangent));
  }

  /// λ from the start: exactly 0 and the length at the ends.
  [[nodiscard]] double lambda(double s) const;

  /// Up to two values of s, in no order, also outside the track.
  struct Meetings {
    std::array<double, 2> s{};
    std::size_t count = 0;
  };

  /// Where the track, prolonged at both ends, meets a circle; none where it runs along it.
  [[nodiscard]] Meetings meetCircle(const Point& center, double radius) const;

  /// The same with the straight line through a point; `normal` is a unit vector.
  [[nodiscard]] Meetings meetLine(const Point& through, const Vector& normal) const;

  /// The same with a whole line or circle that a curve is part of.
  [[nodiscard]] Meetings meetWhole(const Curve& lineOrArc) const;

  /// The same with the whole circle of an arc moved to its left by `distance`, also past its centre. Exact for the
  /// largest radii too, whose centre no number can tell.
  [[nodiscard]] Meetings meetBeside(const Arc& arc, double distance) const;

private:
  [[nodiscard]] Meetings meetThrough(const Point& through, const Vector& normal, double curvature) const;

  Point m_middle{0, 0};
  Vector m_tangent{1, 0}; ///< unit, at the middle
  double m_curvature = 0;
  double m_length = 0;
  double m_end = 0;
};

} // namespace arris::geometry
