#include "tests/core/control/linuxcnc/hal_recorder.h"

#include <gtest/gtest.h>

#include <csignal> // which hal.h needs and does not include

extern "C" {
#include <hal.h>
}

#include <array>

namespace arris::test {

struct HalRecorder::Stream {
  int component = -1;
  hal_stream_t stream{};
};

HalRecorder::HalRecorder() : m_stream(std::make_unique<Stream>()) {
  constexpr int kSecondSamplerKey = 0x48534130 + 1;
  m_stream->component = hal_init("arris-recorder");
  EXPECT_GT(m_stream->component, 0);
  EXPECT_EQ(hal_stream_attach(&m_stream->stream, m_stream->component, kSecondSamplerKey, "fffffbb"), 0);
  hal_ready(m_stream->component);
  take();
}

HalRecorder::~HalRecorder() {
  hal_stream_detach(&m_stream->stream);
  hal_exit(m_stream->component);
}

std::vector<HalSample> HalRecorder::take() {
  std::vector<HalSample> samples;
  std::array<hal_stream_data, 7> data{};
  while (hal_stream_readable(&m_stream->stream)) {
    hal_stream_read(&m_stream->stream, data.data(), nullptr);
    samples.push_back({{data[0].f, data[1].f, data[2].f}, data[3].f, data[4].f, data[5].b, data[6].b});
  }
  return samples;
}

} // namespace arris::test
