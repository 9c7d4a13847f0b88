#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace arris::control {

/// What can go wrong with the simulated machine. All last until they are cleared, late feedback for 0.5 s.
enum class SimulatedFault {
  DriveFault,    ///< of an axis: its drive tells it and goes off
  EncoderLoss,   ///< of an axis: told, and the reading stays as it was; the axis goes on following
  StuckAxis,     ///< of an axis: it moves no more; nothing tells so
  SpindleLoss,   ///< the spindle coasts down
  CoolantLoss,   ///< the pump stops
  VacuumLoss,    ///< the glass is no longer held
  EmergencyStop, ///< drives, spindle and coolant go off
  LateFeedback,  ///< what is read is 100 ms old
  LostFeedback   ///< what is read stays what was read last
};

struct SimulatedFaultName {
  std::string_view name; ///< of the command line
  SimulatedFault fault;
};

inline constexpr std::array kSimulatedFaultNames{
    SimulatedFaultName{"drive-fault", SimulatedFault::DriveFault},
    SimulatedFaultName{"encoder-loss", SimulatedFault::EncoderLoss},
    SimulatedFaultName{"stuck-axis", SimulatedFault::StuckAxis},
    SimulatedFaultName{"spindle-loss", SimulatedFault::SpindleLoss},
    SimulatedFaultName{"coolant-loss", SimulatedFault::CoolantLoss},
    SimulatedFaultName{"vacuum-loss", SimulatedFault::VacuumLoss},
    SimulatedFaultName{"emergency-stop", SimulatedFault::EmergencyStop},
    SimulatedFaultName{"late-feedback", SimulatedFault::LateFeedback},
    SimulatedFaultName{"lost-feedback", SimulatedFault::LostFeedback},
};

/// Nothing for any other name.
[[nodiscard]] constexpr std::optional<SimulatedFault> faultNamed(std::string_view name) {
  for (const SimulatedFaultName& named : kSimulatedFaultNames) {
    if (named.name == name) {
      return named.fault;
    }
  }
  return std::nullopt;
}

} // namespace arris::control
