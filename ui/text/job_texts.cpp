#include "ui/text/job_texts.h"

#include <QCoreApplication>

#include <array>

namespace arris::ui {

const std::vector<const char*>& fieldNames() {
  static const std::vector<const char*> kNames = {
      QT_TRANSLATE_NOOP("Recipe", "Wheel radius"),
      QT_TRANSLATE_NOOP("Recipe", "Thickness of the wheel"),
      QT_TRANSLATE_NOOP("Recipe", "Fine adjustment of the grinding height"),
      QT_TRANSLATE_NOOP("Recipe", "Normal grinding depth"),
      QT_TRANSLATE_NOOP("Recipe", "Thickness of the glass"),
      QT_TRANSLATE_NOOP("Recipe", "Underside of the glass above the table"),
      QT_TRANSLATE_NOOP("Recipe", "Wheel's lower face above the glass when traversing"),
      QT_TRANSLATE_NOOP("Recipe", "Feed"),
      QT_TRANSLATE_NOOP("Recipe", "Acceleration of the X axis"),
      QT_TRANSLATE_NOOP("Recipe", "Acceleration of the Y axis"),
      QT_TRANSLATE_NOOP("Recipe", "Acceleration of the Z axis"),
      QT_TRANSLATE_NOOP("Recipe", "Spindle speed"),
      QT_TRANSLATE_NOOP("Recipe", "Transition speed at sharp corners"),
      QT_TRANSLATE_NOOP("Recipe", "Size correction (positive leaves the pane larger)"),
      QT_TRANSLATE_NOOP("Recipe", "Radius of the lead-in and lead-out"),
      QT_TRANSLATE_NOOP("Recipe", "Overlap past the start"),
      QT_TRANSLATE_NOOP("Recipe", "Rotation of the pattern"),
      QT_TRANSLATE_NOOP("Recipe", "Gaps up to this are closed"),
      QT_TRANSLATE_NOOP("Recipe", "Tolerance of fitting chopped curves"),
  };
  return kNames;
}

QString fieldText(const recipe::NumberField& field) {
  return QCoreApplication::translate("Recipe", std::string(field.what).c_str());
}

ChoiceTexts choiceTexts(const recipe::ChoiceField& field) {
  const auto say = [](const char* text) { return QCoreApplication::translate("Recipe", text); };
  if (field.key == "acceleration_rule") {
    return {say(QT_TRANSLATE_NOOP("Recipe", "Accelerations bind")),
            {say(QT_TRANSLATE_NOOP("Recipe", "each axis")), say(QT_TRANSLATE_NOOP("Recipe", "X and Y together"))}};
  }
  if (field.key == "direction") {
    return {say(QT_TRANSLATE_NOOP("Recipe", "Direction round the pane")),
            {say(QT_TRANSLATE_NOOP("Recipe", "clockwise")), say(QT_TRANSLATE_NOOP("Recipe", "counter-clockwise"))}};
  }
  if (field.key == "mirror") {
    return {say(QT_TRANSLATE_NOOP("Recipe", "Mirror the pattern")),
            {say(QT_TRANSLATE_NOOP("Recipe", "no")), say(QT_TRANSLATE_NOOP("Recipe", "left to right (X)")),
             say(QT_TRANSLATE_NOOP("Recipe", "top to bottom (Y)"))}};
  }
  return {say(QT_TRANSLATE_NOOP("Recipe", "Unit of the drawing")),
          {QStringLiteral("mm"), QStringLiteral("cm"), QStringLiteral("m"), say(QT_TRANSLATE_NOOP("Recipe", "inch")),
           say(QT_TRANSLATE_NOOP("Recipe", "foot"))}};
}

const std::vector<const char*>& machineFieldNames() {
  static const std::vector<const char*> kNames = {
      QT_TRANSLATE_NOOP("Machine", "Feed of plunges"),
      QT_TRANSLATE_NOOP("Machine", "Servo period"),
      QT_TRANSLATE_NOOP("Machine", "Homing: speed towards the switch"),
      QT_TRANSLATE_NOOP("Machine", "Homing: speed off the switch"),
      QT_TRANSLATE_NOOP("Machine", "Fastest jog"),
      QT_TRANSLATE_NOOP("Machine", "Set-points ahead of time"),
      QT_TRANSLATE_NOOP("Machine", "Greatest following error"),
      QT_TRANSLATE_NOOP("Machine", "Backing off in a hold"),
      QT_TRANSLATE_NOOP("Machine", "At rest before backing off"),
      QT_TRANSLATE_NOOP("Machine", "Longest wait for spindle and coolant"),
      QT_TRANSLATE_NOOP("Machine", "Travel of the axes"),
      QT_TRANSLATE_NOOP("Machine", "Greatest speeds of the axes"),
      QT_TRANSLATE_NOOP("Machine", "Greatest accelerations of the axes"),
      QT_TRANSLATE_NOOP("Machine", "Park position"),
      QT_TRANSLATE_NOOP("Machine", "Reference switches"),
      QT_TRANSLATE_NOOP("Machine", "Jog only while the panel's jog enable is held"),
  };
  return kNames;
}

QString machineFieldText(std::string_view what) {
  return QCoreApplication::translate("Machine", std::string(what).c_str());
}

QString phaseText(job::Phase phase) {
  static constexpr std::array<const char*, job::kPhaseCount> kNames = {
      QT_TRANSLATE_NOOP("Phase", "Approach"),   QT_TRANSLATE_NOOP("Phase", "Plunge"),
      QT_TRANSLATE_NOOP("Phase", "Lead-in"),    QT_TRANSLATE_NOOP("Phase", "Cruise"),
      QT_TRANSLATE_NOOP("Phase", "Decelerate"), QT_TRANSLATE_NOOP("Phase", "Transition"),
      QT_TRANSLATE_NOOP("Phase", "Roll"),       QT_TRANSLATE_NOOP("Phase", "Stop"),
      QT_TRANSLATE_NOOP("Phase", "Accelerate"), QT_TRANSLATE_NOOP("Phase", "Lead-out"),
      QT_TRANSLATE_NOOP("Phase", "Retract"),    QT_TRANSLATE_NOOP("Phase", "Traverse"),
  };
  return QCoreApplication::translate("Phase", kNames.at(static_cast<std::size_t>(phase)));
}

QString cornerKindText(toolpath::CornerKind kind) {
  switch (kind) {
  case toolpath::CornerKind::Sharp:
    return QCoreApplication::translate("Corner", "sharp");
  case toolpath::CornerKind::Blunt:
    return QCoreApplication::translate("Corner", "blunt");
  case toolpath::CornerKind::Concave:
    return QCoreApplication::translate("Corner", "concave");
  }
  return {};
}

QString treatmentText(toolpath::Treatment treatment) {
  switch (treatment) {
  case toolpath::Treatment::Transition:
    return QCoreApplication::translate("Corner", "transition");
  case toolpath::Treatment::Roll:
    return QCoreApplication::translate("Corner", "roll");
  case toolpath::Treatment::Arc:
    return QCoreApplication::translate("Corner", "arc");
  case toolpath::Treatment::Stop:
    return QCoreApplication::translate("Corner", "exact stop");
  }
  return {};
}

QString reasonText(toolpath::Reason reason) {
  switch (reason) {
  case toolpath::Reason::SharpWithRelief:
    return QCoreApplication::translate("Corner", "Sharp: on a transition path the wheel lifts clear of the tip.");
  case toolpath::Reason::SharpWithoutRelief:
    return QCoreApplication::translate(
        "Corner", "Sharp, but the wheel cannot lift clear of the tip: it takes the transition path all the same.");
  case toolpath::Reason::BluntWithoutRelief:
    return QCoreApplication::translate("Corner", "Blunt, so not fragile: the wheel rolls round the corner.");
  case toolpath::Reason::TransitionBlocked:
    return QCoreApplication::translate(
        "Corner", "Other glass is in the way of a transition path: the wheel rolls round the corner.");
  case toolpath::Reason::ConcaveShallow:
    return QCoreApplication::translate("Corner", "Concave, but shallow: an arc takes the place of the path's kink.");
  case toolpath::Reason::ConcaveDeep:
    return QCoreApplication::translate("Corner", "Concave: the wheel stops where it touches both edges.");
  }
  return {};
}

QString limitedByText(toolpath::LimitedBy limit) {
  switch (limit) {
  case toolpath::LimitedBy::Angle:
    return QCoreApplication::translate("Corner", "from the angle");
  case toolpath::LimitedBy::AxisX:
    return QCoreApplication::translate("Corner", "limited by the X axis");
  case toolpath::LimitedBy::AxisY:
    return QCoreApplication::translate("Corner", "limited by the Y axis");
  case toolpath::LimitedBy::CornerSpeed:
    return QCoreApplication::translate("Corner", "scaled by the corner speed");
  }
  return {};
}

QString stageText(base::Stage stage) {
  static constexpr std::array<const char*, base::kStageCount> kStages{
      QT_TRANSLATE_NOOP("Stage", "Reading the drawing…"), QT_TRANSLATE_NOOP("Stage", "Joining and fitting…"),
      QT_TRANSLATE_NOOP("Stage", "Laying the wheel path…"), QT_TRANSLATE_NOOP("Stage", "Planning the speeds…"),
      QT_TRANSLATE_NOOP("Stage", "Computing the profile…")};
  const auto index = static_cast<std::size_t>(stage);
  //: What is under way, its number, and how many there are.
  return QCoreApplication::translate("Stage", "%1 (%2 of %3)")
      .arg(QCoreApplication::translate("Stage", kStages.at(index)))
      .arg(index + 1)
      .arg(base::kStageCount);
}

} // namespace arris::ui
