#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace arris::control {

/// How the axes are brought to rest (IEC 60204-1): drives off at once; braked and then drives off; braked with the
/// drives kept on.
enum class StopCategory { Zero, One, Two };

enum class Fault {
  EmergencyStop,
  EncoderLost,
  FeedbackLost,
  SetPointInconsistent,
  FollowingError,
  DriveFault,
  DriveNotReady,
  LimitSwitch,
  TravelLimit,
  HomingFailed,
  BufferDry,
  FeedbackLate,
  SetPointLate,
  OperatorLost,
  SpindleLost,
  CoolantLost,
  VacuumLost,
  SpindleNotReady,
  CoolantNotReady,
};
inline constexpr int kFaultCount = 19;

/// A row of the table of faults.
struct FaultInfo {
  Fault fault;
  std::string_view name; ///< kebab-case, of records and alarm log (contract)
  StopCategory category;
  bool raises;             ///< the wheel is raised off the glass once it is at rest
  bool losesPlace;         ///< the axes must be homed again
  std::string_view text;   ///< what it is; {axis} and {value} where they apply
  std::string_view cause;  ///< what mostly causes it
  std::string_view remedy; ///< what to do
};

[[nodiscard]] const FaultInfo& info(Fault fault);

/// Every row, in the order of the enumeration.
[[nodiscard]] const std::array<FaultInfo, kFaultCount>& allFaults();

/// A set of faults.
class Faults {
public:
  void add(Fault fault) {
    m_bits |= bit(fault);
  }

  void clear() {
    m_bits = 0;
  }

  [[nodiscard]] bool has(Fault fault) const {
    return (m_bits & bit(fault)) != 0;
  }

  [[nodiscard]] bool any() const {
    return m_bits != 0;
  }

  bool operator==(const Faults&) const = default;

private:
  [[nodiscard]] static std::uint32_t bit(Fault fault) {
    return std::uint32_t{1} << static_cast<unsigned>(fault);
  }

  std::uint32_t m_bits = 0;
};

} // namespace arris::control
