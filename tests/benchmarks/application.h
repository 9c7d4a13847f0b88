#pragma once

#include <QApplication>

#include <string>

namespace arris {

/// Figures and widgets need an application; no display.
inline void needApplication() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  static int count = 1;
  static std::string name = "arris_benchmarks";
  static char* arguments = name.data();
  static const QApplication kApplication(count, &arguments);
}

} // namespace arris
