#pragma once

#include "ui/presenters/machine_link.h"

#include <filesystem>
#include <optional>

class QApplication;

namespace arris::ui {

/// Name and theme for the whole program.
void prepareApplication(QApplication& application);

/// Opens the window in the language of the system, with a pattern where one is given, and runs until it is closed.
/// Returns the exit status.
int runWindow(QApplication& application, const MachineSetup& setup,
              const std::optional<std::filesystem::path>& pattern);

} // namespace arris::ui
