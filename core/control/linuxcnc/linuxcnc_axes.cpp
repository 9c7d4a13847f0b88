#include "core/control/linuxcnc/linuxcnc_axes.h"

#include "core/control/driver_module.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

namespace arris::control {
namespace {

constexpr auto kLongestWait = std::chrono::seconds(1);

/// Of a period: far more than the rounding of the session's time after a year.
constexpr double kPeriodRounding = 1e-3;

} // namespace

LinuxcncAxes::LinuxcncAxes(std::unique_ptr<HalComponent> hal) : m_hal(std::move(hal)) {
  apply({}); // a dead Arris may have left them on
}

std::string LinuxcncAxes::begin(double period) {
  const auto until = std::chrono::steady_clock::now() + kLongestWait;
  drain(); // what waits there is old
  m_samples = 0;
  while (m_samples < 3 || hal_stream_readable(&m_hal->streamer)) {
    if (std::chrono::steady_clock::now() > until) {
      return m_samples < 3 ? "the threads of the HAL session do not run"
                           : "the HAL session's streamer is not emptied, or somebody else fills it";
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    drain();
  }
  if (!(std::abs(m_spell - period) <= kPeriodRounding * period)) {
    return fmt::format("the HAL session's period is {:.6g} s, the machine's {:.6g} s", m_spell, period);
  }
  m_firstNumber = m_number + 1;
  m_feedback.tick = -1;
  return {};
}

Feedback LinuxcncAxes::read() {
  drain();
  readInputs();
  if (m_written > 0) {
    m_feedback.underruns = m_hal->underruns->s - m_underrunsBefore;
  }
  return m_feedback;
}

bool LinuxcncAxes::write(const Eigen::Vector3d& setPoint, const Outputs& outputs) {
  std::array<hal_stream_data, 4> element{};
  element[0].f = setPoint.x();
  element[1].f = setPoint.y();
  element[2].f = setPoint.z();
  element[3].f = m_firstNumber + static_cast<double>(m_written);
  if (hal_stream_write(&m_hal->streamer, element.data()) != 0) {
    return false;
  }
  if (m_written == 0) {
    m_underrunsBefore = m_hal->underruns->s;
  }
  ++m_written;
  apply(outputs);
  return true;
}

int LinuxcncAxes::queued() {
  drain();
  return static_cast<int>(m_written - (m_feedback.tick + 1));
}

// As many samples as there can be, not as many as keep coming.
void LinuxcncAxes::drain() {
  std::array<hal_stream_data, HAL_STREAM_MAX_PINS> sample{};
  for (int left = hal_stream_maxdepth(&m_hal->sampler); left > 0 && hal_stream_readable(&m_hal->sampler); --left) {
    hal_stream_read(&m_hal->sampler, sample.data(), nullptr);
    m_feedback.position = {sample[0].f, sample[1].f, sample[2].f};
    m_number = sample[3].f;
    m_feedback.tick = std::llround(m_number - m_firstNumber);
    m_spell = sample[4].f - m_time;
    m_time = sample[4].f;
    ++m_samples;
  }
}

void LinuxcncAxes::readInputs() {
  const HalPins& pins = m_hal->pins;
  Inputs& inputs = m_feedback.inputs;
  inputs.emergencyStop = pins.emergencyStop->b;
  for (std::size_t i = 0; i < kAxes; ++i) {
    inputs.limitLow[i] = pins.limitLow[i]->b;
    inputs.limitHigh[i] = pins.limitHigh[i]->b;
    inputs.reference[i] = pins.reference[i]->b;
    inputs.driveReady[i] = pins.driveReady[i]->b;
    inputs.driveFault[i] = pins.driveFault[i]->b;
    inputs.encoderLost[i] = pins.encoderLost[i]->b;
  }
  inputs.spindleAtSpeed = pins.spindleAtSpeed->b;
  inputs.coolantFlows = pins.coolantFlow->b;
  inputs.vacuumHolds = pins.vacuum->b;
  inputs.cycleStart = pins.cycleStart->b;
  inputs.hold = pins.hold->b;
  inputs.stop = pins.stop->b;
  inputs.jogEnable = pins.jogEnable->b;
  inputs.overridePercent = pins.overridePercent->s;
}

// The heartbeat changes once in a period of HAL's at most: two changes between two of its looks were none.
void LinuxcncAxes::apply(const Outputs& outputs) {
  HalPins& pins = m_hal->pins;
  for (std::size_t i = 0; i < kAxes; ++i) {
    pins.driveEnable[i]->b = outputs.driveEnable[i];
  }
  pins.spindleSpeed->f = outputs.spindleSpeed;
  pins.coolant->b = outputs.coolant;
  if (outputs.heartbeat != m_lastHeartbeat && m_samples != m_beatSample) {
    pins.heartbeat->b = !pins.heartbeat->b;
    m_beatSample = m_samples;
  }
  m_lastHeartbeat = outputs.heartbeat;
}

namespace {

AxisDriver* makeLinuxcncAxes(const char* version, const recipe::Machine& machine, std::string& reason) {
  if (std::strcmp(version, ARRIS_VERSION) != 0) {
    reason = "the module is of another version of Arris";
    return nullptr;
  }
  auto hal = HalComponent::open();
  if (!hal) {
    reason = hal.error();
    return nullptr;
  }
  auto axes = std::make_unique<LinuxcncAxes>(*std::move(hal));
  reason = axes->begin(machine.period);
  return reason.empty() ? axes.release() : nullptr;
}

} // namespace
} // namespace arris::control

extern "C" [[gnu::visibility("default")]] arris::control::AxisDriver*
arrisMakeLinuxcncAxes(const char* version, const arris::recipe::Machine& machine, char* reason, std::size_t size) {
  std::string words;
  arris::control::AxisDriver* axes = arris::control::makeLinuxcncAxes(version, machine, words);
  reason[words.copy(reason, size - 1)] = '\0';
  return axes;
}
