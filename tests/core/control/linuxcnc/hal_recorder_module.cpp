#include "tests/core/control/linuxcnc/hal_recorder.h"

#include <csignal> // which hal.h needs and does not include

extern "C" {
#include <hal.h>
}

#include <array>

namespace {

int component = -1;
hal_stream_t stream{};

} // namespace

extern "C" bool arrisBeginRecording() {
  constexpr int kSecondSamplerKey = 0x48534130 + 1;
  component = hal_init("arris-recorder");
  if (component < 0 || hal_stream_attach(&stream, component, kSecondSamplerKey, "fffffbb") != 0) {
    return false;
  }
  hal_ready(component);
  return true;
}

extern "C" bool arrisReadRecord(arris::test::HalSample& sample) {
  std::array<hal_stream_data, 7> data{};
  if (!hal_stream_readable(&stream) || hal_stream_read(&stream, data.data(), nullptr) != 0) {
    return false;
  }
  sample = {{data[0].f, data[1].f, data[2].f}, data[3].f, data[4].f, data[5].b, data[6].b};
  return true;
}

extern "C" void arrisEndRecording() {
  hal_stream_detach(&stream);
  hal_exit(component);
}
