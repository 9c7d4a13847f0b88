#pragma once

#include "core/geometry/meetings.h"

#include <vector>

namespace arris::toolpath {

/// A stretch of a path, λ in mm.
struct Stretch {
  double from = 0;
  double to = 0;
};

/// A piece of path that keeps its distance as far as edges have not taken stretches of it away.
class FreeStretches {
public:
  /// `radius` is the distance to keep, mm.
  explicit FreeStretches(double radius) : m_radius(radius) {}

  /// Begins with a path that is all free.
  void begin(const geometry::Curve& path);

  /// Takes away where the path is nearer to the edge than the radius, by more than rounding.
  void block(const geometry::Curve& edge);

  [[nodiscard]] const std::vector<Stretch>& stretches() const {
    return m_free;
  }

  [[nodiscard]] bool empty() const {
    return m_free.empty();
  }

  /// From the start of the first to the end of the last.
  [[nodiscard]] Stretch hull() const {
    return {m_free.front().from, m_free.back().to};
  }

private:
  void take(double from, double to);

  double m_radius;
  geometry::Track m_path;
  std::vector<Stretch> m_free;
  std::vector<Stretch> m_left; ///< kept for its memory
};

} // namespace arris::toolpath
