#pragma once

#include "core/recipe/recipe.h"

#include <filesystem>
#include <optional>

class QApplication;

namespace arris::ui {

/// Theme and language for the whole program: Qt's own texts too. Without a translation the texts are English.
void prepareApplication(QApplication& application);

/// Opens the window, with a pattern where one is given, and runs until it is closed. Returns the exit status.
int runWindow(QApplication& application, const std::optional<std::filesystem::path>& pattern,
              const recipe::Machine& machine = {});

} // namespace arris::ui
