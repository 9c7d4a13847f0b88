#pragma once

#include <functional>
#include <stop_token>

namespace arris::base {

/// The stages of work that takes long, from a file to what is shown of its profile, in their order.
enum class Stage { Reading, Joining, WheelPath, Speeds, Profile };
inline constexpr int kStageCount = 5;

/// Accompanies work that may take long; one that is empty asks for nothing and is told nothing.
struct Monitor {
  /// Once a stop is requested the work ends soon, with an error `Cancelled` where it yields problems; whatever else it
  /// yields then is of no use. A stop that comes too late to shorten the work may go unnoticed.
  std::stop_token stop = {};

  /// As each stage begins, in the thread of the work; must not throw.
  std::function<void(Stage)> begins = {};

  void begin(Stage stage) const {
    if (begins) {
      begins(stage);
    }
  }
};

} // namespace arris::base
