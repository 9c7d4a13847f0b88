#pragma once

#include "core/job/job.h"
#include "core/recipe/fields.h"

#include <QString>
#include <QStringList>

#include <string_view>
#include <vector>

namespace arris::ui {

// The words of core in the language of the window.

/// A text of core as it is: a key, a unit.
[[nodiscard]] inline QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// What a field of the recipe is: "Wheel radius".
[[nodiscard]] QString fieldText(const recipe::NumberField& field);

/// What a choice of the recipe is, and its words in the order of the field's.
struct ChoiceTexts {
  QString caption;
  QStringList words;
};

[[nodiscard]] ChoiceTexts choiceTexts(const recipe::ChoiceField& field);

/// The English names of the fields as the translators get them; core's table has no others.
[[nodiscard]] const std::vector<const char*>& fieldNames();

/// The same for the machine: `what` of its fields.
[[nodiscard]] QString machineFieldText(std::string_view what);
[[nodiscard]] const std::vector<const char*>& machineFieldNames();

[[nodiscard]] QString phaseText(job::Phase phase);
[[nodiscard]] QString cornerKindText(toolpath::CornerKind kind);
[[nodiscard]] QString treatmentText(toolpath::Treatment treatment);

/// What is under way while a pattern is planned, and how far that is: "Laying the wheel path… (3 of 5)".
[[nodiscard]] QString stageText(base::Stage stage);

/// Why the corner is treated so, in a sentence.
[[nodiscard]] QString reasonText(toolpath::Reason reason);

/// What limits the transition speed: "by the angle".
[[nodiscard]] QString limitedByText(toolpath::LimitedBy limit);

} // namespace arris::ui
