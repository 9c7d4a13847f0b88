#include "tests/core/control/linuxcnc/hal_recorder.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

namespace arris::test {

HalRecorder::HalRecorder() : m_module(dlopen(ARRIS_HAL_RECORDER, RTLD_NOW | RTLD_LOCAL)) {
  auto* begin = reinterpret_cast<arrisBeginRecording*>(dlsym(m_module, "arrisBeginRecording"));
  EXPECT_TRUE(begin());
  take();
}

HalRecorder::~HalRecorder() {
  reinterpret_cast<arrisEndRecording*>(dlsym(m_module, "arrisEndRecording"))();
  dlclose(m_module);
}

std::vector<HalSample> HalRecorder::take() {
  auto* read = reinterpret_cast<arrisReadRecord*>(dlsym(m_module, "arrisReadRecord"));
  std::vector<HalSample> samples;
  for (HalSample sample; read(sample);) {
    samples.push_back(sample);
  }
  return samples;
}

} // namespace arris::test
