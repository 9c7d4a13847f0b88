#pragma once

#include "core/control/axis_driver.h"
#include "core/control/simulated_axis.h"
#include "core/control/simulated_fault.h"
#include "core/control/simulated_services.h"

#include <atomic>
#include <functional>
#include <vector>

namespace arris::control {

/// Whose time the simulated machine keeps: the clock's, or that of the set-points written, as fast as they come.
enum class Pace { Real, Simulated };

enum class Button { CycleStart, Hold, Stop, JogEnable };

inline constexpr double kEncoderSteps = 1e4; ///< of the simulated encoders in a millimetre

/// Seconds of the steady clock.
[[nodiscard]] double steadySeconds();

/// The simulated machine: three axes with drives, encoders and switches, spindle, coolant, vacuum and panel. It takes
/// set-point k at the time of the first write + the lead + k periods; the lead is the machine's in whole periods, one
/// at least. Where no set-point is left it keeps to the last one and counts an underrun. A drive is ready 50 ms after
/// it was enabled and follows from then on; when it goes off the axis brakes by friction. Faults and buttons show at
/// once, all else as it was at the end of the last period. `read`, `write`, `queued` and `place` are for one thread,
/// faults and panel for any.
class SimulatedAxes final : public AxisDriver {
public:
  /// Off and at rest at `standsAt` (table, mm), where the encoders read `encodersStartAt`. `seconds` is the clock of
  /// the real pace.
  SimulatedAxes(const recipe::Machine& machine, Pace pace, const Eigen::Vector3d& standsAt,
                const Eigen::Vector3d& encodersStartAt = Eigen::Vector3d::Zero(),
                std::function<double()> seconds = steadySeconds);

  [[nodiscard]] Feedback read() override;
  bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) override;
  [[nodiscard]] int queued() override;

  /// `axis` matters for the faults of an axis only.
  void inject(SimulatedFault fault, int axis = 0);
  void clearFaults();
  void press(Button button, bool down);
  void turnOverride(int percent);

  /// Where the axes truly are, table coordinates, mm.
  [[nodiscard]] Eigen::Vector3d place() const;

private:
  void takeWhatIsDue();
  void takeNext();
  void passPeriod();
  void keepReport();
  [[nodiscard]] Feedback report() const;
  [[nodiscard]] bool has(SimulatedFault fault, int axis = 0) const;
  [[nodiscard]] bool isDown(Button button) const;

  std::atomic<std::uint32_t> m_faults = 0, m_buttons = 0; ///< a bit for each
  std::atomic<int> m_overridePercent = 0;

  double m_period;
  int m_lead; ///< periods
  Pace m_pace;
  std::function<double()> m_seconds;

  std::array<SimulatedAxis, kAxes> m_axes;
  std::array<DelayedSignal, kAxes> m_driveReady;
  SimulatedSpindle m_spindle;
  DelayedSignal m_coolant;
  Eigen::Vector3d m_encoderZero; ///< where the encoders read 0, table coordinates
  Eigen::Vector3d m_measured;
  Eigen::Vector3d m_setPoint{0, 0, 0}; ///< the last one taken
  Outputs m_outputs;

  std::vector<Eigen::Vector3d> m_queue; ///< a ring
  std::size_t m_first = 0, m_free = 0;
  int m_queued = 0;
  double m_startTime = 0; ///< of the clock, at the first write
  bool m_started = false;
  std::int64_t m_taken = 0, m_underruns = 0;

  std::vector<Feedback> m_past; ///< a ring of the latest reports, as far back as late feedback is late
  std::size_t m_oldest = 0;
  Feedback m_lastRead;
  int m_latePeriods = 0;
};

} // namespace arris::control
