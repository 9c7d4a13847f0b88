#include "core/control/faults.h"

#include "core/base/problem.h"
#include "core/control/report.h"

namespace arris::control {

// The one table of faults.
const std::array<FaultInfo, kFaultCount>& allFaults() {
  using enum Fault;
  using enum StopCategory;
  static constexpr std::array<FaultInfo, kFaultCount> kTable = {{
      {EmergencyStop, "emergency-stop", Zero, false, false, "The emergency stop has tripped.",
       "Somebody pressed it, or its circuit is open.", "Make the machine safe, release the button, acknowledge."},
      {EncoderLost, "encoder-loss", Zero, false, true, "The encoder of {axis} gives no signal.",
       "A cable is broken or loose, or the encoder is dirty.",
       "Repair the encoder or its cable, acknowledge, home again."},
      {FeedbackLost, "lost-feedback", Zero, false, true, "The axes report nothing any more.",
       "The connection to the drives is broken.", "Restore the connection, acknowledge, home again."},
      {SetPointInconsistent, "inconsistent-set-point", Zero, false, false,
       "A set-point of {axis} was no number, or jumped by {value} mm/s² more than the axis can follow.",
       "A fault in Arris.", "Save a support bundle and report it. Acknowledge to go on."},
      {FollowingError, "following-error", One, false, false, "{axis} stands {value} mm away from its set-point.",
       "The axis is blocked, or its drive is too weak.", "Free the axis, check the drive, acknowledge."},
      {DriveFault, "drive-fault", One, false, false, "The drive of {axis} reports a fault.",
       "Overload, overheating, or a fault in the supply.", "Read the drive's display, clear its fault, acknowledge."},
      {DriveNotReady, "drive-not-ready", One, false, false, "The drive of {axis} is not ready.",
       "Its supply is off, or a safety circuit is open.",
       "Switch its supply on, close the safety circuit, acknowledge."},
      {LimitSwitch, "limit-switch", One, false, false, "{axis} has hit a limit switch.",
       "The axis ran past the end of its travel.", "Acknowledge, jog the axis back, home again."},
      {TravelLimit, "travel-limit", Two, false, false, "{axis} would leave its travel.",
       "The origin was moved, or the pattern lies too far out.", "Acknowledge, set the origin, load the job again."},
      {HomingFailed, "homing-failed", Two, false, true, "{axis} has not found its reference switch.",
       "The switch is broken, or the axis did not move.", "Check the switch and the axis, acknowledge, home again."},
      {BufferDry, "buffer-dry", Two, false, false, "The rotary buffers ran dry; the wheel was stopped on its path.",
       "The computer was too busy to supply the controller.", "Close other programs, acknowledge, resume the job."},
      {FeedbackLate, "late-feedback", Two, false, false, "The axes report late, by {value} ms.",
       "The computer or the connection to the drives is overloaded.",
       "Close other programs, acknowledge, resume the job."},
      {SetPointLate, "late-set-point", Two, false, false, "The axes had no set-point for {value} periods.",
       "The computer was too busy to supply them in time.", "Close other programs, acknowledge, resume the job."},
      {OperatorLost, "heartbeat-lost", Two, false, false, "The operator's side has not answered for half a second.",
       "The program hangs or has ended.", "Start Arris again, resume the job."},
      {SpindleLost, "spindle-loss", Two, true, false, "The spindle has lost its speed on the glass.",
       "The wheel is overloaded or blocked, or the spindle's drive has a fault.",
       "Check wheel and spindle, acknowledge, resume the job."},
      {CoolantLost, "coolant-loss", Two, true, false, "The coolant has stopped flowing on the glass.",
       "The tank is empty, or the pump or a filter is blocked.", "Restore the coolant, acknowledge, resume the job."},
      {VacuumLost, "vacuum-loss", Two, true, false, "The vacuum does not hold the glass.",
       "A cup leaks, or the pump is off.", "Check cups and pump, place the glass again, acknowledge."},
      {SpindleNotReady, "spindle-not-ready", Two, false, false, "The spindle does not reach its speed.",
       "The spindle's drive is off or has a fault.", "Check the spindle, acknowledge, start again."},
      {CoolantNotReady, "coolant-not-ready", Two, false, false, "The coolant does not flow.",
       "The tank is empty, a valve is closed, or the pump is off.", "Check the coolant, acknowledge, start again."},
  }};
  return kTable;
}

const FaultInfo& info(Fault fault) {
  return allFaults()[static_cast<std::size_t>(fault)];
}

std::string describe(const FaultReport& fault) {
  base::Problem values;
  const std::string_view axes = "XYZ";
  values.values = {{"axis", fault.axis >= 0 ? std::string(axes.substr(static_cast<std::size_t>(fault.axis), 1))
                                            : std::string("an axis")},
                   {"value", fault.value}};
  return base::fillIn(info(fault.fault).text, values);
}

} // namespace arris::control
