#include "ui/presenters/diagnosis.h"

#include "ui/text/quantities.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <array>
#include <cmath>

namespace arris::ui {
namespace {

constexpr int kFollowingDecimals = 3;
constexpr double kMetre = 1000; // mm

/// The context of these texts for the translators.
struct Diagnosis {
  Q_DECLARE_TR_FUNCTIONS(arris::ui::Diagnosis)
};

using AxisFlags = std::array<bool, control::kAxes>;

SignalCell flag(bool on, const QString& yes, const QString& no, SignalSign whenOn = SignalSign::On) {
  return {on ? yes : no, on ? whenOn : SignalSign::Off};
}

SignalRow axesRow(const QString& name, const AxisFlags& flags, const QString& yes, const QString& no,
                  SignalSign whenOn = SignalSign::On) {
  SignalRow row{name, {}};
  for (const bool on : flags) {
    row.cells.push_back(flag(on, yes, no, whenOn));
  }
  return row;
}

SignalRow lengthsRow(const QString& name, const Eigen::Vector3d& lengths) {
  SignalRow row{name, {}};
  for (const double length : lengths) {
    row.cells.push_back({fixedLengthText(length, kFollowingDecimals, QLocale())});
  }
  return row;
}

// Not ready is abnormal where the drive is to have power.
SignalRow readyRow(const control::Report& report) {
  SignalRow row{Diagnosis::tr("Drive ready"), {}};
  for (std::size_t i = 0; i < control::kAxes; ++i) {
    SignalCell cell = flag(report.inputs.driveReady[i], Diagnosis::tr("ready"), Diagnosis::tr("off"));
    if (!report.inputs.driveReady[i] && report.outputs.driveEnable[i]) {
      cell.sign = SignalSign::Abnormal;
    }
    row.cells.push_back(cell);
  }
  return row;
}

SignalRow button(const QString& name, bool isPressed) {
  return {name, {flag(isPressed, Diagnosis::tr("pressed"), Diagnosis::tr("released"))}};
}

QString hoursText(double seconds) {
  return Diagnosis::tr("%1 h").arg(fixedText(seconds / 3600, 1, QLocale()));
}

} // namespace

SignalRows axisSignals(const control::Report& report, const Eigen::Vector3d& worstFollowingError) {
  const control::Inputs& in = report.inputs;
  const QString hit = Diagnosis::tr("hit");
  const QString free = Diagnosis::tr("free");
  const QString on = Diagnosis::tr("on");
  const QString off = Diagnosis::tr("off");
  return {axesRow(Diagnosis::tr("Limit switch, low end"), in.limitLow, hit, free, SignalSign::Abnormal),
          axesRow(Diagnosis::tr("Limit switch, high end"), in.limitHigh, hit, free, SignalSign::Abnormal),
          axesRow(Diagnosis::tr("Reference switch"), in.reference, on, off),
          axesRow(Diagnosis::tr("Drive enable (output)"), report.outputs.driveEnable, on, off),
          readyRow(report),
          axesRow(Diagnosis::tr("Drive fault"), in.driveFault, Diagnosis::tr("fault"), Diagnosis::tr("none"),
                  SignalSign::Abnormal),
          axesRow(Diagnosis::tr("Encoder"), in.encoderLost, Diagnosis::tr("lost"), Diagnosis::tr("fine"),
                  SignalSign::Abnormal),
          lengthsRow(inShownUnits(Diagnosis::tr("Following error, mm")), report.followingError),
          lengthsRow(inShownUnits(Diagnosis::tr("At worst since the start, mm")), worstFollowingError)};
}

SignalRows inputSignals(const control::Report& report) {
  const control::Inputs& in = report.inputs;
  return {
      {Diagnosis::tr("Emergency stop"),
       {flag(in.emergencyStop, Diagnosis::tr("tripped"), Diagnosis::tr("released"), SignalSign::Abnormal)}},
      {Diagnosis::tr("Spindle"), {flag(in.spindleAtSpeed, Diagnosis::tr("at speed"), Diagnosis::tr("not at speed"))}},
      {Diagnosis::tr("Coolant"), {flag(in.coolantFlows, Diagnosis::tr("flows"), Diagnosis::tr("does not flow"))}},
      {Diagnosis::tr("Vacuum"), {flag(in.vacuumHolds, Diagnosis::tr("holds"), Diagnosis::tr("does not hold"))}},
      button(Diagnosis::tr("Button cycle start"), in.cycleStart),
      button(Diagnosis::tr("Button feed hold"), in.hold),
      button(Diagnosis::tr("Button stop"), in.stop),
      button(Diagnosis::tr("Button jog enable"), in.jogEnable),
      {Diagnosis::tr("Override selector"),
       {{in.overridePercent == 0 ? Diagnosis::tr("none") : Diagnosis::tr("%1 %").arg(in.overridePercent)}}}};
}

SignalRows outputSignals(const control::Report& report, bool beats) {
  const control::Outputs& out = report.outputs;
  const QString off = Diagnosis::tr("off");
  return {{Diagnosis::tr("Spindle"),
           {flag(out.spindleSpeed > 0,
                 Diagnosis::tr("%1 r/min").arg(fixedText(std::round(out.spindleSpeed), 0, QLocale())), off)}},
          {Diagnosis::tr("Coolant"), {flag(out.coolant, Diagnosis::tr("on"), off)}},
          {Diagnosis::tr("Heartbeat"),
           {{beats ? Diagnosis::tr("beats") : Diagnosis::tr("stands still"),
             beats ? SignalSign::On : SignalSign::Abnormal}}}};
}

SignalRows controlFigures(const control::Report& report, const std::optional<control::Timing>& timing) {
  const QString none = QStringLiteral("–");
  const auto count = [](std::int64_t number) { return QString::number(number); };
  return {
      {Diagnosis::tr("Least lead, periods"), {{timing ? count(timing->worstLead) : none}}},
      {Diagnosis::tr("Late wake-ups"), {{timing ? count(timing->lateWakeUps) : none}}},
      {Diagnosis::tr("Latest wake-up, ms"), {{timing ? fixedText(1000 * timing->worstLateness, 2, QLocale()) : none}}},
      {Diagnosis::tr("Buffered pairs"), {{count(report.pairsBuffered)}}},
      {Diagnosis::tr("Lost reports"), {{count(report.lost)}}},
      {Diagnosis::tr("Refused commands"), {{count(report.refused)}}}};
}

SignalRows lifeFigures(const files::Counters& counters) {
  const QDateTime since = QDateTime::fromString(QString::fromStdString(counters.since), Qt::ISODate);
  return {{Diagnosis::tr("Drives on"), {{hoursText(counters.drivesOn)}}},
          {Diagnosis::tr("Spindle on"), {{hoursText(counters.spindleOn)}}},
          {Diagnosis::tr("Grinding"), {{hoursText(counters.grinding)}}},
          {Diagnosis::tr("Ground"), {{Diagnosis::tr("%1 m").arg(fixedText(counters.ground / kMetre, 1, QLocale()))}}},
          {Diagnosis::tr("Panes ground"), {{QString::number(counters.panes)}}},
          {Diagnosis::tr("Counted since"),
           {{since.isValid() ? QLocale().toString(since.date(), QLocale::ShortFormat) : QStringLiteral("–")}}}};
}

} // namespace arris::ui
