#include "core/control/driver_module.h"

#include <dlfcn.h>

#include <array>
#include <string>
#include <utility>

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

struct CloseModule {
  void operator()(void* module) const {
    dlclose(module);
  }
};

using Module = std::unique_ptr<void, CloseModule>;

/// A driver and the module that its code is in. The module goes with it, and LinuxCNC's library with the module: that
/// one keeps places of memory that are no longer its own when it is used a second time.
class LoadedAxes final : public AxisDriver {
public:
  LoadedAxes(Module module, std::unique_ptr<AxisDriver> axes) : m_module(std::move(module)), m_axes(std::move(axes)) {}

  [[nodiscard]] Feedback read() override {
    return m_axes->read();
  }

  bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) override {
    return m_axes->write(setPoint, outputs);
  }

  [[nodiscard]] int queued() override {
    return m_axes->queued();
  }

private:
  Module m_module; ///< goes last
  std::unique_ptr<AxisDriver> m_axes;
};

} // namespace

base::Expected<std::unique_ptr<AxisDriver>> linuxcncAxes(const recipe::Machine& machine,
                                                         const std::vector<std::filesystem::path>& folders) {
  const std::filesystem::path file = moduleIn(folders);
  if (file.empty()) {
    return notAvailable("this Arris was built without them; install linuxcnc-uspace-dev and build it again");
  }
  Module module(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!module) {
    return notAvailable(std::string("install linuxcnc-uspace; ") + dlerror());
  }
  auto* make = reinterpret_cast<MakeAxisDriver*>(dlsym(module.get(), kMakeLinuxcncAxes));
  if (make == nullptr) {
    return notAvailable("the module is of another version of Arris");
  }
  std::array<char, 256> reason{};
  std::unique_ptr<AxisDriver> driver(make(ARRIS_VERSION, machine, reason.data(), reason.size()));
  if (!driver) {
    return notAvailable(reason.data());
  }
  return std::make_unique<LoadedAxes>(std::move(module), std::move(driver));
}

} // namespace arris::control
