#include "core/motion/reachability.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace arris::motion {
namespace {

/// start·x₀ + end·x₁ ≤ limit.
struct HalfPlane {
  double start, end, limit;
};

using HalfPlanes = std::array<HalfPlane, 12>;

HalfPlanes halfPlanes(const ReachProblem& p) {
  HalfPlanes planes{};
  std::size_t n = 0;
  for (const ReachProblem::Row& row : p.rows) {
    planes[n++] = {row.start, row.end, row.limit};
    planes[n++] = {-row.start, -row.end, row.limit};
  }
  planes[n++] = {1, 0, p.startMost};
  planes[n++] = {0, 1, p.endMost};
  planes[n++] = {-1, 0, 0};
  planes[n++] = {0, -1, 0};
  return planes;
}

bool holds(const HalfPlane& plane, double start, double end) {
  const double value = plane.start * start + plane.end * end;
  const double scale = std::abs(plane.start * start) + std::abs(plane.end * end) + plane.limit;
  return value <= plane.limit + 1e-13 * scale;
}

// Rarely needed: the greatest of the corners of the polygon.
ReachResult greatestCorner(const ReachProblem& problem) {
  const HalfPlanes planes = halfPlanes(problem);
  ReachResult best;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const double det = planes[i].start * planes[j].end - planes[j].start * planes[i].end;
      if (det == 0) {
        continue;
      }
      const double start = (planes[i].limit * planes[j].end - planes[j].limit * planes[i].end) / det;
      const double end = (planes[i].start * planes[j].limit - planes[j].start * planes[i].limit) / det;
      const bool better = start > best.start || (start == best.start && end > best.end);
      if (better &&
          std::all_of(planes.begin(), planes.end(), [=](const HalfPlane& plane) { return holds(plane, start, end); })) {
        best = {start, std::max(0.0, end)};
      }
    }
  }
  return best;
}

} // namespace

// Over x₁ the greatest x₀ is a concave function, so x₁ = endMost is best where what binds there does not fall.
ReachResult greatestStart(const ReachProblem& problem) {
  const double end = problem.endMost;
  double most = problem.startMost;
  bool falls = false;
  double least = 0;
  for (const ReachProblem::Row& row : problem.rows) {
    if (row.start == 0) {
      falls = falls || std::abs(row.end * end) > row.limit;
      continue;
    }
    const double scale = 1 / row.start;
    const double middle = -row.end * end * scale;
    const double half = row.limit * std::abs(scale);
    least = std::max(least, middle - half);
    if (middle + half < most) {
      most = middle + half;
      falls = row.end * row.start > 0;
    }
  }
  return falls || least > most ? greatestCorner(problem) : ReachResult{most, end};
}

} // namespace arris::motion
