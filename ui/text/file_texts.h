#pragma once

#include <QString>

#include <filesystem>

namespace arris::ui {

/// "pane.dxf" of its path.
[[nodiscard]] QString nameOfFile(const std::filesystem::path& file);

/// The folder that a file is in, whole.
[[nodiscard]] QString folderOfFile(const std::filesystem::path& file);

/// So that a path, which has no spaces, may break after each of its folders.
[[nodiscard]] QString breakableAtFolders(QString text);

} // namespace arris::ui
