#include "core/control/driver_module.h"

#include <dlfcn.h>

#include <array>
#include <string>

namespace arris::control {
namespace {

base::Unexpected notAvailable(std::string reason) {
  return base::Unexpected(base::Problem(base::Code::DriverNotAvailable, {{"reason", std::move(reason)}}));
}

std::filesystem::path moduleIn(const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    std::error_code ignored;
    if (std::filesystem::exists(folder / kLinuxcncModule, ignored)) {
      return folder / kLinuxcncModule;
    }
  }
  return {};
}

} // namespace

base::Expected<std::unique_ptr<AxisDriver>> linuxcncAxes(const recipe::Machine& machine,
                                                         const std::vector<std::filesystem::path>& folders) {
  const std::filesystem::path file = moduleIn(folders);
  if (file.empty()) {
    return notAvailable("this Arris was built without them; install linuxcnc-uspace-dev and build it again");
  }
  // Never unloaded: the driver's code must outlive the driver.
  void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    return notAvailable(std::string("install linuxcnc-uspace; ") + dlerror());
  }
  auto* make = reinterpret_cast<MakeAxisDriver*>(dlsym(module, kMakeLinuxcncAxes));
  if (make == nullptr) {
    return notAvailable("the module is of another version of Arris");
  }
  std::array<char, 256> reason{};
  std::unique_ptr<AxisDriver> driver(make(ARRIS_VERSION, machine, reason.data(), reason.size()));
  if (!driver) {
    return notAvailable(reason.data());
  }
  return driver;
}

} // namespace arris::control
