#pragma once

#include <filesystem>
#include <vector>

namespace arris::app {

/// Where records, alarms and the resume point are kept unless another folder is named.
[[nodiscard]] std::filesystem::path defaultStateFolder();

/// Where modules that are loaded at run time may lie: beside the program, or as they are installed.
[[nodiscard]] std::vector<std::filesystem::path> moduleFolders();

} // namespace arris::app
