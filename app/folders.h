#pragma once

#include <filesystem>

namespace arris::app {

/// Where records, alarms and the resume point are kept unless another folder is named.
[[nodiscard]] std::filesystem::path defaultStateFolder();

} // namespace arris::app
