#include "tests/support/fine_grid_optimum.h"

#include <algorithm>
#include <cmath>

namespace arris::test {
namespace {

/// The path seen from one side of a grid point, and what bounds λ̇² there by itself.
struct Node {
  Eigen::Vector2d first, second;
  double most = 0;
};

struct Grid {
  std::vector<double> steps; ///< to the next node
  std::vector<Node> nodes;   ///< two for each step: at its beginning, at its end
};

Node nodeAt(const motion::Segment& segment, double lambda, double towards, const motion::AxisLimits& limits) {
  const motion::Evaluation here = motion::evaluate(segment, lambda);
  const motion::Evaluation inside = motion::evaluate(segment, lambda + towards);
  Node node{here.first.head<2>(), here.second.head<2>(), std::pow(std::min(segment.feed, segment.speedCap), 2)};
  for (int i = 0; i < 2; ++i) {
    node.most = std::min(node.most, std::pow(limits.speed[i] / std::abs(node.first[i]), 2));
    if (inside.first[i] * inside.second[i] <= 0 && node.second[i] != 0) {
      node.most = std::min(node.most, limits.acceleration[i] / std::abs(node.second[i]));
    }
  }
  return node;
}

Grid gridOf(const std::vector<motion::Segment>& track, std::size_t first, std::size_t last,
            const motion::AxisLimits& limits, double step) {
  Grid grid;
  for (std::size_t s = first; s < last; ++s) {
    const double length = motion::parameterLength(track[s]);
    const auto* arc = std::get_if<geometry::Arc>(&track[s].shape);
    const double finest = arc ? std::min(step, arc->radius() / 1000) : step;
    const int count = static_cast<int>(std::ceil(length / finest));
    for (int i = 0; i < count; ++i) {
      const double from = length * i / count;
      const double to = length * (i + 1) / count;
      grid.steps.push_back(to - from);
      grid.nodes.push_back(nodeAt(track[s], from, (to - from) / 2, limits));
      grid.nodes.push_back(nodeAt(track[s], to, (from - to) / 2, limits));
    }
  }
  return grid;
}

struct Range {
  double least = -1e300, most = 1e300;
};

Range rangeAt(const Node& node, double x, const Eigen::Vector3d& acceleration) {
  Range range;
  for (int i = 0; i < 2; ++i) {
    if (std::abs(node.first[i]) < 1e-9) {
      continue;
    }
    const double middle = -node.second[i] * x / node.first[i];
    const double half = acceleration[i] / std::abs(node.first[i]);
    range.least = std::max(range.least, middle - half);
    range.most = std::min(range.most, middle + half);
  }
  return range;
}

// The greatest x at the beginning of a step from which it can be brought down to `next` at its end.
double greatest(const Node& node, double step, double next, const Eigen::Vector3d& acceleration) {
  const auto possible = [&](double x) {
    const Range range = rangeAt(node, x, acceleration);
    return range.least <= range.most && x + 2 * step * range.least <= next;
  };
  if (possible(node.most)) {
    return node.most;
  }
  double low = 0;
  double high = node.most;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (possible(middle) ? low : high) = middle;
  }
  return low;
}

} // namespace

double fineGridOptimum(const std::vector<motion::Segment>& track, std::size_t first, std::size_t last,
                       const motion::AxisLimits& limits, double step) {
  const Grid grid = gridOf(track, first, last, limits, step);
  const std::size_t steps = grid.steps.size();
  std::vector<double> most(steps + 1, 0); // K² at the grid points
  for (std::size_t i = steps; i-- > 0;) {
    const double next = std::min(most[i + 1], grid.nodes[2 * i + 1].most);
    most[i] = greatest(grid.nodes[2 * i], grid.steps[i], next, limits.acceleration);
    if (i > 0) {
      most[i] = std::min(most[i], grid.nodes[2 * i - 1].most);
    }
  }
  double x = 0;
  double time = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double reach = x + 2 * grid.steps[i] * rangeAt(grid.nodes[2 * i], x, limits.acceleration).most;
    const double next = std::clamp(reach, 0.0, std::min(most[i + 1], grid.nodes[2 * i + 1].most));
    time += 2 * grid.steps[i] / (std::sqrt(x) + std::sqrt(next));
    x = next;
  }
  return time;
}

} // namespace arris::test
