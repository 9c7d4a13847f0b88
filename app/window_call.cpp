#include "app/command_line.h"
#include "app/folders.h"
#include "app/messages.h"
#include "ui/run_window.h"

#include <QApplication>
#include <QtGlobal>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace arris::app {
namespace {

constexpr const char* kNoDisplay = "no display was found, so the window cannot open; without one, plan and look at the "
                                   "drawing: arris plan PATTERN --preview FILE.svg (see: arris help)";

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// Qt ends the process with a long text when it cannot reach the display; here it does with one line.
void endOnFatal(QtMsgType type, const QMessageLogContext&, const QString&) {
  if (type == QtFatalMsg) {
    complain(kNoDisplay);
    std::_Exit(static_cast<int>(ExitStatus::SystemFailure));
  }
}

} // namespace

ExitStatus openWindow(const Arguments& arguments) {
  CLI::App call("The window.", "arris");
  std::string pattern;
  call.add_option("PATTERN", pattern, "A drawing (DXF, ASCII or binary) to open")->type_name("");
  std::filesystem::path stateFolder;
  call.add_option("--state-dir", stateFolder, "Folder of records, alarms and the resume point")->type_name("DIR");
  std::string axes;
  call.add_option("--axes", axes, "Which axes move at this start (simulated, linuxcnc); else those of the settings")
      ->check(CLI::IsMember({"simulated", "linuxcnc"}))
      ->type_name("WORD");
  if (const auto status = read(call, arguments)) {
    return *status;
  }
  if (!isSet("DISPLAY") && !isSet("WAYLAND_DISPLAY") && !isSet("QT_QPA_PLATFORM")) {
    complain(kNoDisplay);
    return ExitStatus::SystemFailure;
  }
  const files::StateFolder folder{stateFolder.empty() ? defaultStateFolder() : stateFolder};
  if (const std::string scale = ui::scaleFactor(folder); !scale.empty()) {
    qputenv("QT_SCALE_FACTOR", QByteArray::fromStdString(scale));
  }
  int count = 1;
  char name[] = "arris";
  char* programArguments[] = {name, nullptr};
  const QtMessageHandler before = qInstallMessageHandler(endOnFatal);
  QApplication application(count, programArguments);
  qInstallMessageHandler(before);
  const auto file = pattern.empty() ? std::nullopt : std::optional<std::filesystem::path>(pattern);
  ui::MachineSetup setup{{}, folder, control::Pace::Real};
  if (!axes.empty()) {
    setup.axes = files::axesNamed(axes);
  }
  setup.moduleFolders = moduleFolders();
  return ui::runWindow(application, setup, file) == 0 ? ExitStatus::Done : ExitStatus::InternalError;
}

} // namespace arris::app
