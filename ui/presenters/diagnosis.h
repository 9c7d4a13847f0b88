#pragma once

#include "core/control/report.h"
#include "core/control/timing.h"
#include "core/files/counters.h"

#include <QString>

#include <optional>
#include <vector>

namespace arris::ui {

/// The shape beside a signal: a ring, a full disc, a triangle with !.
enum class SignalSign { None, Off, On, Abnormal };
inline constexpr int kSignalSigns = 4;

/// A signal or figure in words.
struct SignalCell {
  QString text;
  SignalSign sign = SignalSign::None;
  bool operator==(const SignalCell&) const = default;
};

struct SignalRow {
  QString name;
  std::vector<SignalCell> cells;
  bool operator==(const SignalRow&) const = default;
};

using SignalRows = std::vector<SignalRow>;

/// What goes in and out for each axis, and its following error now and at worst (mm): a cell for X, Y and Z.
[[nodiscard]] SignalRows axisSignals(const control::Report& report, const Eigen::Vector3d& worstFollowingError);

/// What comes in from machine and panel.
[[nodiscard]] SignalRows inputSignals(const control::Report& report);

/// What goes out to the machine. `beats`: the controller has gone on since it was looked at last.
[[nodiscard]] SignalRows outputSignals(const control::Report& report, bool beats);

/// How the controller fares; without `timing` in simulated time.
[[nodiscard]] SignalRows controlFigures(const control::Report& report, const std::optional<control::Timing>& timing);

/// What the machine has done in its life.
[[nodiscard]] SignalRows lifeFigures(const files::Counters& counters);

} // namespace arris::ui
