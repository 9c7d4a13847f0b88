#include "ui/text/machine_texts.h"

#include "ui/text/quantities.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <string_view>

namespace arris::ui {
namespace {

QString sentence(std::string_view english) {
  return QCoreApplication::translate("Fault", std::string(english).c_str());
}

// What the figure of a fault is; null where it has none.
const char* figureUnit(control::Fault fault) {
  switch (fault) {
  case control::Fault::FollowingError:
    return QT_TRANSLATE_NOOP("Fault", "%1 mm");
  case control::Fault::SetPointInconsistent:
    return QT_TRANSLATE_NOOP("Fault", "%1 mm/s²");
  case control::Fault::FeedbackLate:
    return QT_TRANSLATE_NOOP("Fault", "%1 ms");
  case control::Fault::SetPointLate:
    return QT_TRANSLATE_NOOP("Fault", "%1 periods");
  default:
    return nullptr;
  }
}

QString figureText(const control::FaultReport& fault, const QLocale& locale) {
  const char* unit = figureUnit(fault.fault);
  const bool isLength = unit != nullptr && std::string_view(unit).starts_with("%1 mm");
  return isLength ? lengthText(fault.value, 3, locale) : numberText(fault.value, 3, locale);
}

} // namespace

const std::vector<const char*>& faultSentences() {
  static const std::vector<const char*> kSentences = {
      QT_TRANSLATE_NOOP("Fault", "The emergency stop has tripped."),
      QT_TRANSLATE_NOOP("Fault", "Somebody pressed it, or its circuit is open."),
      QT_TRANSLATE_NOOP("Fault", "Make the machine safe, release the button, acknowledge."),
      QT_TRANSLATE_NOOP("Fault", "The encoder of {axis} gives no signal."),
      QT_TRANSLATE_NOOP("Fault", "A cable is broken or loose, or the encoder is dirty."),
      QT_TRANSLATE_NOOP("Fault", "Repair the encoder or its cable, acknowledge, home again."),
      QT_TRANSLATE_NOOP("Fault", "The axes report nothing any more."),
      QT_TRANSLATE_NOOP("Fault", "The connection to the drives is broken."),
      QT_TRANSLATE_NOOP("Fault", "Restore the connection, acknowledge, home again."),
      QT_TRANSLATE_NOOP(
          "Fault", "A set-point of {axis} was no number, or jumped by {value} mm/s² more than the axis can follow."),
      QT_TRANSLATE_NOOP("Fault", "A fault in Arris."),
      QT_TRANSLATE_NOOP("Fault", "Save a support bundle and report it. Acknowledge to go on."),
      QT_TRANSLATE_NOOP("Fault", "{axis} stands {value} mm away from its set-point."),
      QT_TRANSLATE_NOOP("Fault", "The axis is blocked, or its drive is too weak."),
      QT_TRANSLATE_NOOP("Fault", "Free the axis, check the drive, acknowledge."),
      QT_TRANSLATE_NOOP("Fault", "The drive of {axis} reports a fault."),
      QT_TRANSLATE_NOOP("Fault", "Overload, overheating, or a fault in the supply."),
      QT_TRANSLATE_NOOP("Fault", "Read the drive's display, clear its fault, acknowledge."),
      QT_TRANSLATE_NOOP("Fault", "The drive of {axis} is not ready."),
      QT_TRANSLATE_NOOP("Fault", "Its supply is off, or a safety circuit is open."),
      QT_TRANSLATE_NOOP("Fault", "Switch its supply on, close the safety circuit, acknowledge."),
      QT_TRANSLATE_NOOP("Fault", "{axis} has hit a limit switch."),
      QT_TRANSLATE_NOOP("Fault", "The axis ran past the end of its travel."),
      QT_TRANSLATE_NOOP("Fault", "Acknowledge, jog the axis back, home again."),
      QT_TRANSLATE_NOOP("Fault", "{axis} would leave its travel."),
      QT_TRANSLATE_NOOP("Fault", "The origin was moved, or the pattern lies too far out."),
      QT_TRANSLATE_NOOP("Fault", "Acknowledge, set the origin, load the job again."),
      QT_TRANSLATE_NOOP("Fault", "{axis} has not found its reference switch."),
      QT_TRANSLATE_NOOP("Fault", "The switch is broken, or the axis did not move."),
      QT_TRANSLATE_NOOP("Fault", "Check the switch and the axis, acknowledge, home again."),
      QT_TRANSLATE_NOOP("Fault", "The rotary buffers ran dry; the wheel was stopped on its path."),
      QT_TRANSLATE_NOOP("Fault", "The computer was too busy to supply the controller."),
      QT_TRANSLATE_NOOP("Fault", "Close other programs, acknowledge, resume the job."),
      QT_TRANSLATE_NOOP("Fault", "The axes report late, by {value} ms."),
      QT_TRANSLATE_NOOP("Fault", "The computer or the connection to the drives is overloaded."),
      QT_TRANSLATE_NOOP("Fault", "Close other programs, acknowledge, resume the job."),
      QT_TRANSLATE_NOOP("Fault", "The axes had no set-point for {value} periods."),
      QT_TRANSLATE_NOOP("Fault", "The computer was too busy to supply them in time."),
      QT_TRANSLATE_NOOP("Fault", "Close other programs, acknowledge, resume the job."),
      QT_TRANSLATE_NOOP("Fault", "The operator's side has not answered for half a second."),
      QT_TRANSLATE_NOOP("Fault", "The program hangs or has ended."),
      QT_TRANSLATE_NOOP("Fault", "Start Arris again, resume the job."),
      QT_TRANSLATE_NOOP("Fault", "The spindle has lost its speed on the glass."),
      QT_TRANSLATE_NOOP("Fault", "The wheel is overloaded or blocked, or the spindle's drive has a fault."),
      QT_TRANSLATE_NOOP("Fault", "Check wheel and spindle, acknowledge, resume the job."),
      QT_TRANSLATE_NOOP("Fault", "The coolant has stopped flowing on the glass."),
      QT_TRANSLATE_NOOP("Fault", "The tank is empty, or the pump or a filter is blocked."),
      QT_TRANSLATE_NOOP("Fault", "Restore the coolant, acknowledge, resume the job."),
      QT_TRANSLATE_NOOP("Fault", "The vacuum does not hold the glass."),
      QT_TRANSLATE_NOOP("Fault", "A cup leaks, or the pump is off."),
      QT_TRANSLATE_NOOP("Fault", "Check cups and pump, place the glass again, acknowledge."),
      QT_TRANSLATE_NOOP("Fault", "The spindle does not reach its speed."),
      QT_TRANSLATE_NOOP("Fault", "The spindle's drive is off or has a fault."),
      QT_TRANSLATE_NOOP("Fault", "Check the spindle, acknowledge, start again."),
      QT_TRANSLATE_NOOP("Fault", "The coolant does not flow."),
      QT_TRANSLATE_NOOP("Fault", "The tank is empty, a valve is closed, or the pump is off."),
      QT_TRANSLATE_NOOP("Fault", "Check the coolant, acknowledge, start again."),
  };
  return kSentences;
}

QString stateText(control::State state) {
  static constexpr std::array<const char*, control::kStateCount> kNames = {
      QT_TRANSLATE_NOOP("State", "Drives off"),  QT_TRANSLATE_NOOP("State", "Not homed"),
      QT_TRANSLATE_NOOP("State", "Homing"),      QT_TRANSLATE_NOOP("State", "Ready"),
      QT_TRANSLATE_NOOP("State", "Starting"),    QT_TRANSLATE_NOOP("State", "Running"),
      QT_TRANSLATE_NOOP("State", "Holding"),     QT_TRANSLATE_NOOP("State", "Held"),
      QT_TRANSLATE_NOOP("State", "Stepping"),    QT_TRANSLATE_NOOP("State", "Jogging"),
      QT_TRANSLATE_NOOP("State", "Positioning"), QT_TRANSLATE_NOOP("State", "Stopping"),
      QT_TRANSLATE_NOOP("State", "Fault"),       QT_TRANSLATE_NOOP("State", "Emergency stop")};
  return QCoreApplication::translate("State", kNames.at(static_cast<std::size_t>(state)));
}

QString jobStateText(control::JobState state) {
  static constexpr std::array<const char*, 8> kNames = {
      QT_TRANSLATE_NOOP("JobState", "Idle"),     QT_TRANSLATE_NOOP("JobState", "Queued"),
      QT_TRANSLATE_NOOP("JobState", "Released"), QT_TRANSLATE_NOOP("JobState", "Initialized"),
      QT_TRANSLATE_NOOP("JobState", "Running"),  QT_TRANSLATE_NOOP("JobState", "Interrupted"),
      QT_TRANSLATE_NOOP("JobState", "Aborted"),  QT_TRANSLATE_NOOP("JobState", "Ended")};
  return QCoreApplication::translate("JobState", kNames.at(static_cast<std::size_t>(state)));
}

QString servicesText(const control::Report& report) {
  const auto say = [](const char* text) { return QCoreApplication::translate("Services", text); };
  return QCoreApplication::translate("Services", "Spindle: %1\nCoolant: %2\nVacuum: %3")
      .arg(report.outputs.spindleSpeed == 0 ? say(QT_TRANSLATE_NOOP("Services", "off"))
           : report.inputs.spindleAtSpeed   ? say(QT_TRANSLATE_NOOP("Services", "at speed"))
                                            : say(QT_TRANSLATE_NOOP("Services", "comes up to speed")),
           report.inputs.coolantFlows ? say(QT_TRANSLATE_NOOP("Services", "flows"))
                                      : say(QT_TRANSLATE_NOOP("Services", "off")),
           report.inputs.vacuumHolds ? say(QT_TRANSLATE_NOOP("Services", "holds the glass"))
                                     : say(QT_TRANSLATE_NOOP("Services", "off")));
}

QString faultText(const control::FaultReport& fault, const QLocale& locale) {
  QString text = inShownUnits(sentence(control::info(fault.fault).text));
  text.replace(QStringLiteral("{axis}"), fault.axis >= 0 ? QString(QStringLiteral("XYZ").at(fault.axis))
                                                         : QCoreApplication::translate("Fault", "an axis"));
  text.replace(QStringLiteral("{value}"), figureText(fault, locale));
  return text;
}

QString faultFigures(const control::FaultReport& fault, const QLocale& locale) {
  QStringList figures;
  if (fault.axis >= 0) {
    figures += QString(QStringLiteral("XYZ").at(fault.axis));
  }
  if (const char* unit = figureUnit(fault.fault)) {
    figures += inShownUnits(QCoreApplication::translate("Fault", unit)).arg(figureText(fault, locale));
  }
  return figures.join(QStringLiteral(", "));
}

QString causeText(control::Fault fault) {
  return sentence(control::info(fault).cause);
}

QString remedyText(control::Fault fault) {
  return sentence(control::info(fault).remedy);
}

} // namespace arris::ui
