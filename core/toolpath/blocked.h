#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/meetings.h"

#include <vector>

namespace arris::toolpath {

/// A stretch of a path, λ in mm.
struct Stretch {
  double from = 0;
  double to = 0;
};

/// What stays of a piece of path as edges block stretches of it: those where the path is nearer to an edge than a given
/// distance.
class FreeStretches {
public:
  /// `radius` is the distance to keep, mm.
  explicit FreeStretches(double radius) : m_radius(radius) {}

  /// Begins with a path that is all free.
  void begin(const geometry::Curve& path);

  /// Takes away where the path is nearer to the edge than the radius, by more than rounding.
  void block(const geometry::Curve& edge);

  [[nodiscard]] bool empty() const {
    return m_free.empty();
  }

  /// A box that holds all that is free.
  [[nodiscard]] geometry::FlatBox box() const;

  /// Appends what is free, in order.
  void appendTo(std::vector<Stretch>& stretches) const;

private:
  void take(double from, double to);
  void measureHull();

  double m_radius;
  geometry::Track m_path;
  std::vector<Stretch> m_free; ///< in the parameter of the track
  std::vector<Stretch> m_left; ///< kept for its memory
  geometry::Point m_middle;    ///< of the path from the first free place to the last
  double m_reach = 0;          ///< along the path no point of that is farther from the middle
};

} // namespace arris::toolpath
