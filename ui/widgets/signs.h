#pragma once

#include "core/base/problem.h"

#include <QIcon>

namespace arris::ui {

/// The sign of a severity as in the drawing: triangle with ! or circle with i.
[[nodiscard]] QIcon signIcon(base::Severity severity);

} // namespace arris::ui
