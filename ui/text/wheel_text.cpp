#include "ui/text/wheel_text.h"

#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>

namespace arris::ui {
namespace {

QString wheelWords(const char* text) {
  return inShownUnits(QCoreApplication::translate("Wheel", text));
}

QString wheelPhaseText(const job::Sample& sample) {
  const QString phase = phaseText(sample.phase);
  return sample.corner == 0
             ? phase
             : wheelWords(QT_TRANSLATE_NOOP("Wheel", "%1, corner %2")).arg(phase, QString::number(sample.corner));
}

} // namespace

QString wheelText(const job::Sample& sample, double duration, const QLocale& locale) {
  const auto length = [&](double value, int decimals) { return fixedLengthText(value, decimals, locale); };
  const Eigen::Vector3d& at = sample.setPoint.position;
  const QString place = wheelWords(QT_TRANSLATE_NOOP("Wheel", "Planned: X %1  Y %2  Z %3 mm"))
                            .arg(length(at.x(), 2), length(at.y(), 2), length(at.z(), 2));
  const QString time = wheelWords(QT_TRANSLATE_NOOP("Wheel", "%1 s of %2"))
                           .arg(fixedText(sample.setPoint.time, 2, locale), durationText(duration, locale));
  const QString speed = wheelWords(QT_TRANSLATE_NOOP("Wheel", "%1 mm/s")).arg(length(sample.speed, 1));
  const QString dot = QStringLiteral(" · ");
  QString text = place + dot + time + QLatin1Char('\n') + wheelPhaseText(sample) + dot + speed;
  if (sample.corner != 0) {
    text += dot + wheelWords(QT_TRANSLATE_NOOP("Wheel", "%1 mm to the corner")).arg(length(sample.distance, 1));
  }
  return text;
}

} // namespace arris::ui
