#include "tests/ui/support/steps.h"

#include "core/base/numbers.h"
#include "tests/support/panes.h"

#include <cmath>

namespace arris::test {
namespace {

pattern::Pattern many() {
  std::vector<geometry::Point> corners;
  for (int i = 0; i < 40; ++i) {
    corners.emplace_back(500 * std::cos(i * base::kPi / 20), 320 * std::sin(i * base::kPi / 20));
  }
  return polygon(corners);
}

base::Expected<pattern::Pattern> paneNamed(const std::filesystem::path& file, const pattern::ImportOptions& options) {
  const std::string name = file.stem().string();
  if (name == "splashback") {
    return ui::plannerSteps()
        .read(ARRIS_SOURCE_DIR "/resources/samples/splashback.dxf", options, {})
        .map([](const ui::Import& import) { return import.pattern; });
  }
  if (name == "repaired") {
    pattern::Pattern pattern = triangle600();
    pattern.repairs = {base::Problem(base::Code::GapClosed, {{"size_mm", 0.02}}).at({600, 0})};
    return pattern;
  }
  if (name == "triangle") {
    return triangle600();
  }
  if (name == "rectangle") {
    return polygon({{0, 0}, {1000, 0}, {1000, 600}, {0, 600}});
  }
  if (name == "outside") {
    return polygon({{0, 0}, {1450, 0}, {1450, 700}});
  }
  if (name == "many") {
    return many();
  }
  return base::Unexpected(
      base::Problem(base::Code::CannotOpen, {{"file", file.string()}, {"reason", "No such file or directory"}}));
}

} // namespace

ui::PlannerSteps paneSteps() {
  ui::PlannerSteps steps = ui::plannerSteps();
  steps.read = [](const std::filesystem::path& file, const pattern::ImportOptions& options, const base::Monitor&) {
    return paneNamed(file, options).map([&](const pattern::Pattern& pattern) {
      return ui::Import{file, options, pattern, "0123456789abcdef"};
    });
  };
  return steps;
}

ui::MachineSetup fastMachine(const Scratch& folder) {
  return {{}, {folder / "state"}, control::Pace::Simulated};
}

} // namespace arris::test
