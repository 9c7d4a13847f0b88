#include "core/control/driver_module.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>

#include <fstream>

namespace arris::control {
namespace {

using testing::HasSubstr;

std::string reasonWith(const std::vector<std::filesystem::path>& folders) {
  const auto axes = linuxcncAxes({}, folders);
  EXPECT_FALSE(axes);
  EXPECT_EQ(axes.error().code, base::Code::DriverNotAvailable);
  return base::describe(axes.error());
}

TEST(DriverModule, SaysWhatToInstallWhereItIsMissing) {
  const test::Scratch scratch;
  for (const auto& folders : {std::vector<std::filesystem::path>{}, {scratch / "."}, {scratch / "no such folder"}}) {
    EXPECT_THAT(reasonWith(folders), HasSubstr("install linuxcnc-uspace-dev"));
  }
}

TEST(DriverModule, SaysWhyItCannotBeLoaded) {
  const test::Scratch scratch;
  std::ofstream(scratch / kLinuxcncModule) << "no module";
  EXPECT_THAT(reasonWith({scratch / "no such folder", scratch / "."}), HasSubstr("install linuxcnc-uspace"));
}

} // namespace
} // namespace arris::control
