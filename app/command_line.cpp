#include "app/command_line.h"

#include "app/messages.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace arris::app {
namespace {

struct Call {
  std::string_view name;
  std::string_view usage;
  std::string_view what;
  ExitStatus (*run)(const Arguments&);
};

constexpr std::array kCalls{
    Call{"plan", "plan PATTERN [options] [outputs]", "from a pattern to the wheel path, its profile and G-code", plan},
    Call{"inspect", "inspect PATTERN [options]", "what is in a pattern: contours, repairs, problems", inspect},
    Call{"run", "run PATTERN [options] [outputs]", "the same through the controller, on simulated axes", runJob},
    Call{"plot", "plot PROFILE.csv|RECORD ... -o FILE", "a picture of profiles and records of runs", plot},
    Call{"help", "help [CALL]", "this page, or the options of a call", help},
};

const Call* findCall(std::string_view name) {
  const auto* const call = std::find_if(kCalls.begin(), kCalls.end(), [&](const Call& c) { return c.name == name; });
  return call == kCalls.end() ? nullptr : call;
}

void printCalls() {
  constexpr std::string_view kLine = "  arris {:<40} {}\n";
  fmt::print("Arris {}: man-machine interface of a three-axis CNC glass-edge grinder\n\n", ARRIS_VERSION);
  fmt::print(kLine, "[PATTERN] [--axes simulated|linuxcnc]",
             "opens the window, on the axes of its settings or on these");
  for (const Call& call : kCalls) {
    fmt::print(kLine, call.usage, call.what);
  }
  fmt::print(kLine, "--version", "the version");
}

bool namesAFile(const CLI::Option* option) {
  return option->get_positional() || option->get_type_name().starts_with("FILE");
}

} // namespace

std::optional<ExitStatus> read(CLI::App& call, const Arguments& arguments) {
  try {
    call.parse(Arguments(arguments.rbegin(), arguments.rend()));
    for (const CLI::Option* option : call.get_options(namesAFile)) {
      const std::vector<std::string>& files = option->results();
      if (std::find(files.begin(), files.end(), "") != files.end()) {
        complain(fmt::format("{}: the name of the file is empty (see: arris help)", option->get_name()));
        return ExitStatus::WrongUsage;
      }
    }
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", call.help());
    return ExitStatus::Done;
  } catch (const CLI::ParseError& error) {
    complain(fmt::format("{} (see: arris help)", error.what()));
    return ExitStatus::WrongUsage;
  }
}

ExitStatus help(const Arguments& arguments) {
  if (arguments.empty()) {
    printCalls();
    return ExitStatus::Done;
  }
  const Call* const call = findCall(arguments.front());
  if (call == nullptr || arguments.size() > 1) {
    complain(fmt::format("there is no call \"{}\" (see: arris help)", fmt::join(arguments, " ")));
    return ExitStatus::WrongUsage;
  }
  return call->name == "help" ? help({}) : call->run({"--help"});
}

ExitStatus run(const Arguments& arguments) {
  if (arguments.empty()) {
    return openWindow(arguments);
  }
  const std::string& first = arguments.front();
  if (const Call* const call = findCall(first)) {
    return call->run(Arguments(arguments.begin() + 1, arguments.end()));
  }
  if (first == "--version") {
    fmt::print("Arris {}\n", ARRIS_VERSION);
    return ExitStatus::Done;
  }
  if (first == "--help" || first == "-h") {
    return help({});
  }
  return openWindow(arguments);
}

} // namespace arris::app
