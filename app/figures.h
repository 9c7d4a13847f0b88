#pragma once

#include "core/base/problem.h"
#include "ui/figures/figure.h"

#include <QApplication>

#include <filesystem>

namespace arris::app {

/// What Qt needs to draw without a screen. One at a time, as long as figures are drawn.
class Offscreen {
public:
  Offscreen();

private:
  int m_count = 1;
  char m_name[6] = "arris";
  char* m_arguments[2] = {m_name, nullptr};
  QApplication m_application;
};

/// Writes a figure in the format that the file's ending names (checked before), whole or not at all.
[[nodiscard]] base::Expected<void> writeFigure(const ui::Figure& figure, const std::filesystem::path& file);

} // namespace arris::app
