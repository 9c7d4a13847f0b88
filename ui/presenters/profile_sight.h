#pragma once

#include <cstddef>
#include <optional>
#include <utility>

namespace arris::ui {

/// What of the profiles is looked at. It outlives the page, which is made anew in another language or appearance.
struct ProfileSight {
  enum Content { Speeds, Positions, Path, ContentCount };

  Content content = Speeds;
  bool isOverPlan = true;                         ///< an open file: over the planned profile
  std::optional<std::size_t> pass;                ///< through a corner, counted from 0, that was gone to
  std::optional<double> instant;                  ///< s, that is pointed at
  std::optional<std::pair<double, double>> times; ///< s, from and to; none: all of the work
};

} // namespace arris::ui
