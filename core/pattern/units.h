#pragma once

#include "core/pattern/pattern.h"

#include <cstdint>
#include <optional>

namespace arris::pattern {

struct FoundUnits {
  recipe::Units units = recipe::Units::Millimetre;
  UnitsFrom from = UnitsFrom::Assumed;
  std::optional<base::Problem> problem; ///< a note where the unit is assumed, an error where Arris does not know it
};

/// The unit of a drawing: what the user says, else $INSUNITS unless it is 0 ("without unit"), else $MEASUREMENT, else
/// millimetres.
[[nodiscard]] FoundUnits findUnits(std::optional<recipe::Units> option, std::optional<std::int64_t> insUnits,
                                   std::optional<std::int64_t> measurement);

} // namespace arris::pattern
