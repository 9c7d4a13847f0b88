#include "ui/text/problem_texts.h"

#include "ui/text/quantities.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kValueDigits = 6;

// Words of core in the language of the window; whatever else a value says, as it is.
QString wordsText(const QString& words) {
  for (const char* word : problemWords()) {
    QString pattern = QRegularExpression::escape(QString::fromUtf8(word));
    pattern.replace(QStringLiteral("\\{\\}"), QStringLiteral("(.+)"));
    const auto match = QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(words);
    if (match.hasMatch()) {
      QString text = QCoreApplication::translate("ProblemWord", word);
      for (int i = 1; i <= match.lastCapturedIndex(); ++i) {
        text.replace(text.indexOf(QStringLiteral("{}")), 2, match.captured(i));
      }
      return text;
    }
  }
  return words;
}

// A figure as the table's own function writes it, up to six significant digits, but in the operator's numbers.
QString valueText(const base::Value& value, QLocale locale, LengthUnit unit) {
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  if (const auto* number = std::get_if<double>(&value.value)) {
    const bool isLength = QString::fromStdString(value.name).endsWith(QLatin1String("_mm"));
    return locale.toString(isLength ? shownLength(*number, unit) : *number, 'g', kValueDigits);
  }
  if (const auto* count = std::get_if<std::int64_t>(&value.value)) {
    return locale.toString(static_cast<qlonglong>(*count));
  }
  return wordsText(QString::fromStdString(std::get<std::string>(value.value)));
}

} // namespace

const std::vector<const char*>& problemTemplates() {
  // One for each code, in the order of the enumeration.
  static const std::vector<const char*> kTemplates = {
      QT_TRANSLATE_NOOP("Problem", "{file} cannot be opened: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{file} cannot be read: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{file} cannot be written: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{file} is not valid JSON: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{file} has no \"{key}\": it is not such a file."),
      QT_TRANSLATE_NOOP("Problem",
                        "{file} was written by a newer Arris (\"{key}\": {version}); this one reads up to {known}."),
      QT_TRANSLATE_NOOP("Problem", "{file} has a key \"{key}\" that Arris does not know; it is ignored."),
      QT_TRANSLATE_NOOP("Problem", "{name} must be {expected}, not {value}."),
      QT_TRANSLATE_NOOP("Problem", "{name} must be a number in {unit}, not \"{value}\"."),
      QT_TRANSLATE_NOOP("Problem", "{name} is {value} {unit}; it must be from {least} to {most} {unit}."),
      QT_TRANSLATE_NOOP("Problem", "{name} is {value} {unit}; the machine allows {most} {unit} at most."),
      QT_TRANSLATE_NOOP("Problem", "{name} is \"{value}\"; it must be one of: {choices}."),
      QT_TRANSLATE_NOOP("Problem", "{file} is not a profile of Arris: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{file} is not the record of a run: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{file} is not whole: {reason} at byte {byte}. What can be read is used."),
      QT_TRANSLATE_NOOP("Problem", "{file} is damaged and has no effect; it was kept as {aside}."),
      QT_TRANSLATE_NOOP("Problem", "{file} is damaged and was kept as {kept}; hours and metres are counted from zero."),
      QT_TRANSLATE_NOOP("Problem", "{file} is not a back-up that can be restored: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "The pattern file is empty."),
      QT_TRANSLATE_NOOP("Problem", "The binary DXF file is damaged: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "This is not a DXF file: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "The lines end in carriage returns alone; save the file with LF or CR LF."),
      QT_TRANSLATE_NOOP("Problem", "A group code is expected here, not {found}."),
      QT_TRANSLATE_NOOP("Problem", "Group {group} must hold a finite number, not {found}."),
      QT_TRANSLATE_NOOP("Problem",
                        "Group {group} holds {found}, which is absurd for a pane of glass (more than {most})."),
      QT_TRANSLATE_NOOP("Problem", "The file ends early: {reason}. It was cut off."),
      QT_TRANSLATE_NOOP("Problem", "The sections of the file are broken: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{entity} announces {announced} {what} but has {found}."),
      QT_TRANSLATE_NOOP("Problem", "{entity} lacks group {group} ({what})."),
      QT_TRANSLATE_NOOP("Problem", "{entity} has {what} {value}, which cannot be."),
      QT_TRANSLATE_NOOP("Problem",
                        "Block {block} is defined twice, first on line {first}; give one of them another name."),
      QT_TRANSLATE_NOOP("Problem", "The file does not say its unit; millimetres are assumed."),
      QT_TRANSLATE_NOOP("Problem", "The file gives its unit as number {number}, which is not mm, cm, m, inch or foot; "
                                   "say the unit with --units."),
      QT_TRANSLATE_NOOP("Problem", "{count} × {entity} not read yet; the contour would lack it."),
      QT_TRANSLATE_NOOP("Problem", "{count} × {entity} not flat in a plane parallel to the XY plane."),
      QT_TRANSLATE_NOOP("Problem",
                        "{count} × INSERT of block {entity}, which the file does not have; explode it before saving."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "Block {block} inserts itself here, or blocks are nested more than {most} deep; explode it before saving."),
      QT_TRANSLATE_NOOP(
          "Problem", "INSERT of block {entity} would make more than {most} pieces of the drawing; draw fewer copies."),
      QT_TRANSLATE_NOOP("Problem", "The SPLINE is no curve: {reason}."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "From here on the curves of the drawing are too long or too many to follow with arcs ({most} steps)."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "{entity} lies {distance_mm} mm away, which is absurd for a pane of glass (more than {most_mm} mm)."),
      QT_TRANSLATE_NOOP("Problem", "{count} × {entity} passed over: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "{count} more of {code} are not listed."),
      QT_TRANSLATE_NOOP("Problem", "A doubled piece of {size_mm} mm was removed."),
      QT_TRANSLATE_NOOP("Problem", "A piece without length ({size_mm} mm) was removed."),
      QT_TRANSLATE_NOOP("Problem", "A gap of {size_mm} mm was closed."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "The contour is open here: the next free end is {gap_mm} mm away (up to {tolerance_mm} mm are joined)."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "A single piece, its ends {length_mm} mm apart, belongs to no contour; it may lie on top of another."),
      QT_TRANSLATE_NOOP("Problem", "{count} pieces meet here; a contour cannot branch."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "A piece ends here on another one, between that one's ends; a contour cannot branch. Remove one of them."),
      QT_TRANSLATE_NOOP("Problem", "The drawing has no closed contour."),
      QT_TRANSLATE_NOOP("Problem", "The contour encloses no area."),
      QT_TRANSLATE_NOOP("Problem", "The contour crosses or touches itself here."),
      QT_TRANSLATE_NOOP("Problem",
                        "Contours {first} and {second} cross or touch here; move them apart in the drawing."),
      QT_TRANSLATE_NOOP("Problem", "From here on so many contours lie over or within each other that they cannot be "
                                   "checked (more than {most} comparisons); draw fewer."),
      QT_TRANSLATE_NOOP("Problem",
                        "The {count} joints from here on look like the chords of a curve but stay corners: they are "
                        "joined from a smoothing tolerance of {needed_mm} mm on (now {tolerance_mm} mm)."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "The contour turns back on itself here, in a tip of {angle_deg}°; that is a mistake of the drawing."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of "
          "glass would stay. Take a wheel of at most {largest_mm} mm, or accept that this stays unground."),
      QT_TRANSLATE_NOOP("Problem", "The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour "
                                   "here; up to {left_mm} mm of glass stay. A wheel of at most {largest_mm} mm would."),
      QT_TRANSLATE_NOOP("Problem", "The wheel of {wheel_mm} mm radius does not reach this contour of {length_mm} mm at "
                                   "all. Take a wheel of less than {largest_mm} mm, or accept that it stays unground."),
      QT_TRANSLATE_NOOP("Problem", "This contour of {length_mm} mm stays unground: the wheel of {wheel_mm} mm radius "
                                   "does not reach it. A wheel of less than {largest_mm} mm would."),
      QT_TRANSLATE_NOOP("Problem", "The wheel of {wheel_mm} mm radius reaches no contour at all."),
      QT_TRANSLATE_NOOP("Problem", "Corner {corner} is concave: the wheel leaves {fillet_mm} mm of glass before it, "
                                   "and {unground_mm} mm of its edges are not ground."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "Corner {corner}: a transition would touch other glass here; the wheel rolls round the corner instead."),
      QT_TRANSLATE_NOOP("Problem",
                        "A size correction of {correction_mm} mm would change the shape of the contour here."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "Corner {corner}: the wheel lifts by {lift_mm} mm, less than the {depth_mm} mm of glass at the tip."),
      QT_TRANSLATE_NOOP("Problem", "Corner {corner} takes {time_s} s."),
      QT_TRANSLATE_NOOP(
          "Problem", "The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has "
                     "{distance_mm} mm. Start on a longer edge away from sharp corners, or change the lead's radius."),
      QT_TRANSLATE_NOOP("Problem", "The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the "
                                   "glass and has {distance_mm} mm. What it would grind from here stays unground."),
      QT_TRANSLATE_NOOP("Problem", "The overlap is {used_mm} mm, a quarter of the contour, instead of {wanted_mm} mm."),
      QT_TRANSLATE_NOOP("Problem", "The wheel path leaves the travel of the machine by {excess_mm} mm: {what}."),
      QT_TRANSLATE_NOOP("Problem", "The wheel's lower face would be {height_mm} mm above the table while grinding; it "
                                   "must stay {least_mm} mm above."),
      QT_TRANSLATE_NOOP("Problem", "At the park position the wheel's lower face would be {height_mm} mm above the "
                                   "table, over or beside the glass; it must be {least_mm} mm above."),
      QT_TRANSLATE_NOOP("Problem", "The {what} height of {height_mm} mm is outside the travel of 0 to {most_mm} mm."),
      QT_TRANSLATE_NOOP("Problem",
                        "The grinding height of {height_mm} mm is above the clearance height of {clearance_mm} mm."),
      QT_TRANSLATE_NOOP(
          "Problem",
          "The machine's greatest speed of the {axis} axis is below the feed; it limits the speed on the contour."),
      QT_TRANSLATE_NOOP("Problem", "Internal error: {reason}."),
      QT_TRANSLATE_NOOP("Problem", "It was given up before it was done."),
      QT_TRANSLATE_NOOP("Problem", "The job that was broken off is of another pattern or an earlier state of it: "
                                   "{file} had the fingerprint {was}, now it has {is}."),
      QT_TRANSLATE_NOOP(
          "Problem", "The job that was broken off was planned for another machine: {key} was {was}, now it is {is}."),
      QT_TRANSLATE_NOOP("Problem", "The place where the job was broken off (segment {segment}, {lambda_mm} mm) is not "
                                   "on the job as it is planned now."),
      QT_TRANSLATE_NOOP("Problem", "Axes through LinuxCNC are not available: {reason}."),
  };
  return kTemplates;
}

const std::vector<const char*>& problemWords() {
  // The first that fits is taken, so "group {}" stands after all that begins alike.
  static const std::vector<const char*> kWords = {
      QT_TRANSLATE_NOOP("ProblemWord", "No such file or directory"),
      QT_TRANSLATE_NOOP("ProblemWord", "Permission denied"),
      QT_TRANSLATE_NOOP("ProblemWord", "Is a directory"),
      QT_TRANSLATE_NOOP("ProblemWord", "Input/output error"),
      QT_TRANSLATE_NOOP("ProblemWord", "File too large"),
      QT_TRANSLATE_NOOP("ProblemWord", "it does not begin like one"),
      QT_TRANSLATE_NOOP("ProblemWord", "its header is damaged"),
      QT_TRANSLATE_NOOP("ProblemWord", "it breaks off"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is damaged"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is no archive of Arris"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is damaged or cut off"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is larger than a back-up can be"),
      QT_TRANSLATE_NOOP("ProblemWord", "it does not say what it is"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is a support bundle"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} is no plain file"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} stands there twice"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} is no part of a back-up"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} is not valid"),
      QT_TRANSLATE_NOOP("ProblemWord", "the file is empty"),
      QT_TRANSLATE_NOOP("ProblemWord", "it has no rows"),
      QT_TRANSLATE_NOOP("ProblemWord", "the time does not increase"),
      QT_TRANSLATE_NOOP("ProblemWord", "the column {} is missing"),
      QT_TRANSLATE_NOOP("ProblemWord", "the column {} stands twice"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} fields instead of {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "distance_mm must be empty where corner is 0"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} must be a finite number, not {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} must be a whole number from 0 on, not {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} is no phase"),
      QT_TRANSLATE_NOOP("ProblemWord", "it holds NUL bytes"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is a DWG drawing; save it as DXF"),
      QT_TRANSLATE_NOOP("ProblemWord", "it is UTF-16 text; save it as ASCII DXF"),
      QT_TRANSLATE_NOOP("ProblemWord", "it begins with {} and not with a group code"),
      QT_TRANSLATE_NOOP("ProblemWord", "an empty line"),
      QT_TRANSLATE_NOOP("ProblemWord", "the last group code has no value"),
      QT_TRANSLATE_NOOP("ProblemWord", "there is no EOF"),
      QT_TRANSLATE_NOOP("ProblemWord", "there is no EOF; the last POLYLINE has no SEQEND"),
      QT_TRANSLATE_NOOP("ProblemWord", "there is no EOF, and section {} has no ENDSEC"),
      QT_TRANSLATE_NOOP("ProblemWord", "section {} has no ENDSEC before the next SECTION"),
      QT_TRANSLATE_NOOP("ProblemWord", "section {} has no ENDSEC before EOF"),
      QT_TRANSLATE_NOOP("ProblemWord", "ENDSEC without a SECTION"),
      QT_TRANSLATE_NOOP("ProblemWord", "the section has no name"),
      QT_TRANSLATE_NOOP("ProblemWord", "the POLYLINE of line {} has no SEQEND"),
      QT_TRANSLATE_NOOP("ProblemWord", "the POLYLINE of line {} has no SEQEND before {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} without a POLYLINE before it"),
      QT_TRANSLATE_NOOP("ProblemWord", "knots"),
      QT_TRANSLATE_NOOP("ProblemWord", "control points"),
      QT_TRANSLATE_NOOP("ProblemWord", "fit points"),
      QT_TRANSLATE_NOOP("ProblemWord", "X of its major axis"),
      QT_TRANSLATE_NOOP("ProblemWord", "Y of its major axis"),
      QT_TRANSLATE_NOOP("ProblemWord", "ratio of its axes"),
      QT_TRANSLATE_NOOP("ProblemWord", "a ratio of axes of"),
      QT_TRANSLATE_NOOP("ProblemWord", "name of the block"),
      QT_TRANSLATE_NOOP("ProblemWord", "a major axis of"),
      QT_TRANSLATE_NOOP("ProblemWord", "layer {} is not chosen"),
      QT_TRANSLATE_NOOP("ProblemWord", "block {} has no ENDBLK"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} stands outside of any block"),
      QT_TRANSLATE_NOOP("ProblemWord", "ENDBLK without a BLOCK"),
      QT_TRANSLATE_NOOP("ProblemWord", "its first line is broken"),
      QT_TRANSLATE_NOOP("ProblemWord", "byte {} begins no group"),
      QT_TRANSLATE_NOOP("ProblemWord", "it ends within the group at byte {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "its degree is {}; up to {} are read"),
      QT_TRANSLATE_NOOP("ProblemWord", "it has {} control points and needs {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "it has {} knots and needs {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "its knots fall from {} to {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "its knots are all the same"),
      QT_TRANSLATE_NOOP("ProblemWord", "it has {} weights and needs {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "it has a weight of {}, which is not positive"),
      QT_TRANSLATE_NOOP("ProblemWord", "its weights reach from {} to {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "it breaks apart"),
      QT_TRANSLATE_NOOP("ProblemWord", "group {} belongs to no entity"),
      QT_TRANSLATE_NOOP("ProblemWord", "group {} stands outside of any section"),
      QT_TRANSLATE_NOOP("ProblemWord", "{} stands outside of any section"),
      QT_TRANSLATE_NOOP("ProblemWord", "group {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "twice"),
      QT_TRANSLATE_NOOP("ProblemWord", "X of its start"),
      QT_TRANSLATE_NOOP("ProblemWord", "Y of its start"),
      QT_TRANSLATE_NOOP("ProblemWord", "X of its end"),
      QT_TRANSLATE_NOOP("ProblemWord", "Y of its end"),
      QT_TRANSLATE_NOOP("ProblemWord", "X of its centre"),
      QT_TRANSLATE_NOOP("ProblemWord", "Y of its centre"),
      QT_TRANSLATE_NOOP("ProblemWord", "radius"),
      QT_TRANSLATE_NOOP("ProblemWord", "start angle"),
      QT_TRANSLATE_NOOP("ProblemWord", "end angle"),
      QT_TRANSLATE_NOOP("ProblemWord", "the radius"),
      QT_TRANSLATE_NOOP("ProblemWord", "a bulge of"),
      QT_TRANSLATE_NOOP("ProblemWord", "vertices"),
      QT_TRANSLATE_NOOP("ProblemWord", "on layer {}, which is never plotted"),
      QT_TRANSLATE_NOOP("ProblemWord", "layer {} is frozen"),
      QT_TRANSLATE_NOOP("ProblemWord", "layer {} is off"),
      QT_TRANSLATE_NOOP("ProblemWord", "in paper space"),
      QT_TRANSLATE_NOOP("ProblemWord", "no part of a contour"),
      QT_TRANSLATE_NOOP("ProblemWord", "invisible"),
      QT_TRANSLATE_NOOP("ProblemWord", "go down"),
      QT_TRANSLATE_NOOP("ProblemWord", "come up"),
      QT_TRANSLATE_NOOP("ProblemWord", "lead in"),
      QT_TRANSLATE_NOOP("ProblemWord", "lead out"),
      QT_TRANSLATE_NOOP("ProblemWord", "the lead-in"),
      QT_TRANSLATE_NOOP("ProblemWord", "the lead-out"),
      QT_TRANSLATE_NOOP("ProblemWord", "the transition at corner {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "the roll round corner {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "the way along the contour"),
      QT_TRANSLATE_NOOP("ProblemWord", "clearance"),
      QT_TRANSLATE_NOOP("ProblemWord", "grinding"),
      QT_TRANSLATE_NOOP("ProblemWord",
                        "this Arris was built without them; install linuxcnc-uspace-dev and build it again"),
      QT_TRANSLATE_NOOP("ProblemWord", "install linuxcnc-uspace; {}"),
      QT_TRANSLATE_NOOP("ProblemWord", "the module is of another version of Arris"),
      QT_TRANSLATE_NOOP("ProblemWord", "another Arris drives them already"),
      QT_TRANSLATE_NOOP("ProblemWord", "this user may not reach the HAL session"),
      QT_TRANSLATE_NOOP("ProblemWord", "HAL has no memory left"),
      QT_TRANSLATE_NOOP("ProblemWord", "no HAL session for Arris runs; start one with packaging/hal/start.sh"),
      QT_TRANSLATE_NOOP("ProblemWord",
                        "the HAL session has no signal {} that fits; compare its file with packaging/hal"),
      QT_TRANSLATE_NOOP(
          "ProblemWord",
          "the HAL session lacks streamer cfg=ffff or sampler cfg=fffff; compare its file with packaging/hal"),
      QT_TRANSLATE_NOOP(
          "ProblemWord",
          "an Arris that died has left the HAL session unfinished; start it again with packaging/hal/start.sh"),
      QT_TRANSLATE_NOOP("ProblemWord", "the threads of the HAL session do not run"),
      QT_TRANSLATE_NOOP("ProblemWord", "the HAL session's streamer is not emptied, or somebody else fills it"),
      QT_TRANSLATE_NOOP("ProblemWord", "the HAL session's period is {} s, the machine's {} s"),
  };
  return kWords;
}

QString problemText(const base::Problem& problem, const QLocale& locale, LengthUnit unit) {
  const auto row = static_cast<std::size_t>(problem.code);
  const QString text = inShownUnits(QCoreApplication::translate("Problem", problemTemplates().at(row)), unit);
  QString result;
  qsizetype done = 0;
  for (qsizetype open = text.indexOf('{'); open >= 0; open = text.indexOf('{', open + 1)) {
    const qsizetype close = text.indexOf('}', open);
    const std::string name = text.mid(open + 1, close - open - 1).toStdString();
    const auto value = std::find_if(problem.values.begin(), problem.values.end(),
                                    [&](const base::Value& candidate) { return candidate.name == name; });
    if (close > open && value != problem.values.end()) {
      result += text.mid(done, open - done) + valueText(*value, locale, unit);
      done = close + 1;
    }
  }
  return result + text.mid(done);
}

QString placeText(const base::Problem& problem, const QLocale& locale, LengthUnit unit) {
  const QString x = problem.where ? fixedLengthText(problem.where->x(), 1, locale, unit) : QString();
  const QString y = problem.where ? fixedLengthText(problem.where->y(), 1, locale, unit) : QString();
  QString text;
  if (problem.line && problem.where) {
    text = QCoreApplication::translate("Problem", "(line %1 of the file, at X %2, Y %3 mm)")
               .arg(QString::number(*problem.line), x, y);
  } else if (problem.line) {
    text = QCoreApplication::translate("Problem", "(line %1 of the file)").arg(*problem.line);
  } else if (problem.where) {
    text = QCoreApplication::translate("Problem", "(at X %1, Y %2 mm)").arg(x, y);
  }
  return inShownUnits(text, unit).replace(QLatin1Char(' '), QChar::Nbsp);
}

QString severityText(base::Severity severity) {
  switch (severity) {
  case base::Severity::Error:
    return QCoreApplication::translate("Problem", "Error");
  case base::Severity::Warning:
    return QCoreApplication::translate("Problem", "Warning");
  case base::Severity::Note:
    return QCoreApplication::translate("Problem", "Note");
  }
  return {};
}

} // namespace arris::ui
