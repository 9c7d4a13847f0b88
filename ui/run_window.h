#pragma once

#include "ui/presenters/machine_link.h"

#include <filesystem>
#include <optional>
#include <string>

class QApplication;

namespace arris::ui {

/// What Qt is to be told as QT_SCALE_FACTOR before there is an application: "1.5" by the settings of the state folder;
/// empty where they ask for no scale or cannot be read (the window tells that).
[[nodiscard]] std::string scaleFactor(const files::StateFolder& folder);

/// Name and theme for the whole program.
void prepareApplication(QApplication& application);

/// Opens the window in the language of the system, with a pattern where one is given, and runs until it is closed.
/// Returns the exit status.
int runWindow(QApplication& application, const MachineSetup& setup,
              const std::optional<std::filesystem::path>& pattern);

} // namespace arris::ui
