#include "ui/text/alarm_texts.h"

#include "core/control/alarms.h"
#include "ui/text/machine_texts.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStringList>

namespace arris::ui {
namespace {

/// The context of these texts for the translators.
struct AlarmTexts {
  Q_DECLARE_TR_FUNCTIONS(arris::ui::AlarmTexts)
};

QString recordOf(const files::Alarm& alarm) {
  for (const base::Value& value : alarm.values) {
    const auto* text = std::get_if<std::string>(&value.value);
    if (value.name == "record" && text != nullptr) {
      return QString::fromStdString(*text);
    }
  }
  return {};
}

QString timeAsOneLine(const files::Alarm& alarm, const QLocale& locale) {
  return alarmTimeText(alarm, locale).replace(QLatin1Char('\n'), QLatin1Char(' '));
}

} // namespace

QString alarmStateText(const PastAlarm& past) {
  return past.isActive             ? AlarmTexts::tr("active")
         : past.alarm.acknowledged ? AlarmTexts::tr("acknowledged")
                                   : AlarmTexts::tr("not\nacknowledged");
}

QString alarmTimeText(const files::Alarm& alarm, const QLocale& locale) {
  const QString text = QString::fromStdString(alarm.time);
  const QDateTime time = QDateTime::fromString(text, Qt::ISODate);
  return time.isValid() ? locale.toString(time.date(), QLocale::ShortFormat) + QLatin1Char('\n') +
                              time.time().toString(QStringLiteral("HH:mm:ss"))
                        : text;
}

QString alarmCodeText(const files::Alarm& alarm, const QLocale& locale) {
  const auto fault = control::faultOf(alarm);
  const QString figures = fault ? faultFigures(*fault, locale) : QString();
  const QString code = QString::fromStdString(alarm.code);
  return figures.isEmpty() ? code : code + QLatin1Char('\n') + figures;
}

QString alarmText(const files::Alarm& alarm, const QLocale& locale) {
  const auto fault = control::faultOf(alarm);
  return fault ? faultText(*fault, locale) : QString::fromStdString(alarm.text);
}

QString alarmInFull(const PastAlarm& past, const QLocale& locale) {
  const auto fault = control::faultOf(past.alarm);
  QStringList lines{alarmText(past.alarm, locale)};
  if (fault) {
    lines += AlarmTexts::tr("Cause: %1").arg(causeText(fault->fault));
    lines += AlarmTexts::tr("What to do: %1").arg(remedyText(fault->fault));
  }
  const QString state = alarmStateText(past).replace(QLatin1Char('\n'), QLatin1Char(' '));
  lines += QStringLiteral("%1 · %2 · %3")
               .arg(timeAsOneLine(past.alarm, locale), QString::fromStdString(past.alarm.code), state);
  if (const QString record = recordOf(past.alarm); !record.isEmpty()) {
    lines += AlarmTexts::tr("Record of the run: %1").arg(record);
  }
  return lines.join(QLatin1Char('\n'));
}

} // namespace arris::ui
