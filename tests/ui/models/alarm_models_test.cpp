#include "tests/ui/support/locales.h"
#include "ui/models/alarm_model.h"
#include "ui/models/signal_model.h"
#include "ui/text/alarm_texts.h"
#include "ui/text/quantities.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

std::string cellOf(const QAbstractItemModel& model, int row, int column) {
  return model.index(row, column).data().toString().toStdString();
}

PastAlarm following(const std::string& time) {
  return {{time,
           "following-error",
           "Y stands 1.25 mm away from its set-point.",
           {{"axis", std::string("Y")}, {"value", 1.25}, {"record", std::string("run-7.arrisrun")}},
           true},
          false};
}

TEST(AlarmModel, ShowsWhatTheLogHoldsInTheWordsOfTheWindow) {
  AlarmModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const PastAlarm later{{"2031-05-06T07:08:10", "coolant-loss", "", {}, false}, true};
  model.setAlarms({later, following("2031-05-06T07:08:09")});
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cellOf(model, 0, AlarmModel::State), "active");
  EXPECT_FALSE(model.index(0, AlarmModel::State).data(Qt::DecorationRole).isNull());
  EXPECT_EQ(cellOf(model, 0, AlarmModel::Code), "coolant-loss");
  EXPECT_EQ(cellOf(model, 1, AlarmModel::State), "acknowledged");
  EXPECT_TRUE(model.index(1, AlarmModel::State).data(Qt::DecorationRole).isNull());
  EXPECT_EQ(cellOf(model, 1, AlarmModel::Time), "5/6/31\n07:08:09");
  EXPECT_EQ(cellOf(model, 1, AlarmModel::Code), "following-error\nY, 1.25 mm");
  EXPECT_EQ(cellOf(model, 1, AlarmModel::What), "Y stands 1.25 mm away from its set-point.");
  EXPECT_EQ(model.rowOf(later.alarm), 0);
  files::Alarm other = later.alarm;
  other.time = "2031-05-06T07:08:11";
  EXPECT_EQ(model.rowOf(other), -1);
}

TEST(AlarmModel, LeavesTheWordsOfAnAlarmThatItDoesNotKnow) {
  AlarmModel model;
  model.setAlarms({{{"some day", "of-a-later-arris", "Something <b>new</b>.", {}, false}, false}});
  EXPECT_EQ(cellOf(model, 0, AlarmModel::What), "Something <b>new</b>.");
  EXPECT_EQ(cellOf(model, 0, AlarmModel::Time), "some day");
  EXPECT_EQ(alarmInFull(model.alarm(0), test::kEnglish),
            QStringLiteral("Something <b>new</b>.\nsome day · of-a-later-arris · not acknowledged"));
}

TEST(AlarmTexts, HaveCauseRemedyTimeAndRecordInFull) {
  EXPECT_EQ(alarmInFull(following("2031-05-06T07:08:09"), test::kEnglish).toStdString(),
            "Y stands 1.25 mm away from its set-point.\n"
            "Cause: The axis is blocked, or its drive is too weak.\n"
            "What to do: Free the axis, check the drive, acknowledge.\n"
            "5/6/31 07:08:09 · following-error · acknowledged\n"
            "Record of the run: run-7.arrisrun");
}

TEST(AlarmTexts, HaveLengthsInInchesWhereTheWindowHas) {
  showLengthsIn(LengthUnit::Inch);
  const files::Alarm alarm = following("2031-05-06T07:08:09").alarm;
  EXPECT_EQ(alarmText(alarm, test::kEnglish), QStringLiteral("Y stands 0.0492 in away from its set-point."));
  EXPECT_EQ(alarmCodeText(alarm, test::kGerman), QStringLiteral("following-error\nY, 0,0492 in"));
  showLengthsIn(LengthUnit::Millimetre);
}

TEST(SignalModel, TellsOnlyWhatHasChanged) {
  SignalModel model({QStringLiteral("Axes"), QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")});
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  control::Report report;
  model.show(axisSignals(report, {0, 0, 0}));
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
  model.show(axisSignals(report, {0, 0, 0}));
  EXPECT_EQ(changed.count(), 0);
  report.inputs.limitHigh[1] = true;
  model.show(axisSignals(report, {0, 0, 0}));
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(reset.count(), 0);
  EXPECT_EQ(changed[0][0].toModelIndex().row(), 1);
  EXPECT_EQ(cellOf(model, 1, 2), "hit");
  EXPECT_EQ(cellOf(model, 1, 1), "free");
}

/// Turns one signal over, and says where it is to be seen.
struct Turned {
  const char* name;
  void (*turn)(control::Report& report);
};

SignalRows allSignals(const control::Report& report) {
  SignalRows rows = axisSignals(report, {0, 0, 0});
  for (const SignalRows& more : {inputSignals(report), outputSignals(report, true)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

TEST(Diagnosis, ShowsEverySignalInAWordAndNotTwoInOne) {
  const std::vector<Turned> turns = {{"emergency stop", [](control::Report& r) { r.inputs.emergencyStop = true; }},
                                     {"limit low", [](control::Report& r) { r.inputs.limitLow[0] = true; }},
                                     {"limit high", [](control::Report& r) { r.inputs.limitHigh[1] = true; }},
                                     {"reference", [](control::Report& r) { r.inputs.reference[2] = true; }},
                                     {"drive ready", [](control::Report& r) { r.inputs.driveReady[0] = true; }},
                                     {"drive fault", [](control::Report& r) { r.inputs.driveFault[1] = true; }},
                                     {"encoder", [](control::Report& r) { r.inputs.encoderLost[2] = true; }},
                                     {"spindle at speed", [](control::Report& r) { r.inputs.spindleAtSpeed = true; }},
                                     {"coolant flows", [](control::Report& r) { r.inputs.coolantFlows = true; }},
                                     {"vacuum", [](control::Report& r) { r.inputs.vacuumHolds = true; }},
                                     {"cycle start", [](control::Report& r) { r.inputs.cycleStart = true; }},
                                     {"hold", [](control::Report& r) { r.inputs.hold = true; }},
                                     {"stop", [](control::Report& r) { r.inputs.stop = true; }},
                                     {"jog enable", [](control::Report& r) { r.inputs.jogEnable = true; }},
                                     {"selector", [](control::Report& r) { r.inputs.overridePercent = 80; }},
                                     {"spindle", [](control::Report& r) { r.outputs.spindleSpeed = 6000; }},
                                     {"coolant", [](control::Report& r) { r.outputs.coolant = true; }},
                                     {"drive enable", [](control::Report& r) { r.outputs.driveEnable[0] = true; }}};
  const SignalRows before = allSignals({});
  for (const Turned& one : turns) {
    control::Report report;
    one.turn(report);
    const SignalRows after = allSignals(report);
    ASSERT_EQ(after.size(), before.size());
    int texts = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      for (std::size_t j = 0; j < after[i].cells.size(); ++j) {
        texts += after[i].cells[j].text != before[i].cells[j].text ? 1 : 0;
      }
    }
    EXPECT_EQ(texts, 1) << one.name;
  }
}

TEST(Diagnosis, MarksByItsShapeWhatIsAbnormal) {
  control::Report report;
  EXPECT_EQ(inputSignals(report)[0].cells[0].sign, SignalSign::Off);
  report.inputs.emergencyStop = true;
  EXPECT_EQ(inputSignals(report)[0].cells[0].sign, SignalSign::Abnormal);
  EXPECT_EQ(axisSignals(report, {0, 0, 0})[4].cells[0].sign, SignalSign::Off);
  report.outputs.driveEnable[0] = true; // power that does not come
  EXPECT_EQ(axisSignals(report, {0, 0, 0})[4].cells[0].sign, SignalSign::Abnormal);
  EXPECT_EQ(outputSignals(report, false)[2].cells[0].sign, SignalSign::Abnormal);
}

TEST(Diagnosis, CountsHoursMetresAndPanes) {
  const SignalRows rows = lifeFigures({"2030-12-28T00:00:00", 36000, 5400, 180, 1'234'560, 42});
  const std::vector<std::string> expected = {"10.0 h", "1.5 h", "0.1 h", "1234.6 m", "42", "12/28/30"};
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].cells.at(0).text.toStdString(), expected[i]);
  }
}

} // namespace
} // namespace arris::ui
