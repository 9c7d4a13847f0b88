#include "core/control/linuxcnc/hal_component.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace arris::control {
namespace {

constexpr int kStreamerKey = 0x48535430;
constexpr int kSamplerKey = 0x48534130;

/// x, y, z, number of the set-point; and what comes back: the same as measured, and the time in seconds.
constexpr const char* kStreamed = "ffff";
constexpr const char* kSampled = "fffff";

constexpr std::string_view kLockName = "arris-linuxcnc-axes";

std::string signalOf(std::string pin) {
  std::replace(pin.begin(), pin.end(), '.', '-');
  return pin;
}

std::string noSignal(const std::string& pin) {
  return "the HAL session has no signal " + signalOf(pin) + " that fits; compare its file with packaging/hal";
}

/// A value takes in HAL's memory only the room of its type.
void copyValue(hal_type_t type, const hal_data_u& from, hal_data_u& to) {
  if (type == HAL_BIT) {
    to.b = from.b;
  } else if (type == HAL_S32) {
    to.s = from.s;
  } else {
    to.f = from.f;
  }
}

/// HAL writes what fails to stderr; here it is answered.
class QuietHal {
public:
  QuietHal() : m_level(rtapi_get_msg_level()) {
    rtapi_set_msg_level(RTAPI_MSG_NONE);
  }

  QuietHal(const QuietHal&) = delete;
  QuietHal& operator=(const QuietHal&) = delete;
  QuietHal(QuietHal&&) = delete;
  QuietHal& operator=(QuietHal&&) = delete;

  ~QuietHal() {
    rtapi_set_msg_level(m_level);
  }

private:
  int m_level;
};

} // namespace

std::vector<HalPin> allPins(HalPins& pins) {
  std::vector<HalPin> all{
      {"arris.emergency-stop", HAL_BIT, HAL_IN, &pins.emergencyStop},
      {"arris.spindle-at-speed", HAL_BIT, HAL_IN, &pins.spindleAtSpeed},
      {"arris.coolant-flow", HAL_BIT, HAL_IN, &pins.coolantFlow},
      {"arris.vacuum", HAL_BIT, HAL_IN, &pins.vacuum},
      {"arris.cycle-start", HAL_BIT, HAL_IN, &pins.cycleStart},
      {"arris.hold", HAL_BIT, HAL_IN, &pins.hold},
      {"arris.stop", HAL_BIT, HAL_IN, &pins.stop},
      {"arris.jog-enable", HAL_BIT, HAL_IN, &pins.jogEnable},
      {"arris.override-percent", HAL_S32, HAL_IN, &pins.overridePercent},
      {"arris.spindle-speed", HAL_FLOAT, HAL_OUT, &pins.spindleSpeed},
      {"arris.coolant", HAL_BIT, HAL_OUT, &pins.coolant},
      {"arris.heartbeat", HAL_BIT, HAL_OUT, &pins.heartbeat},
  };
  for (std::size_t i = 0; i < kAxes; ++i) {
    const std::string axis = std::string("arris.") + "xyz"[i] + '.';
    all.push_back({axis + "limit-low", HAL_BIT, HAL_IN, &pins.limitLow[i]});
    all.push_back({axis + "limit-high", HAL_BIT, HAL_IN, &pins.limitHigh[i]});
    all.push_back({axis + "reference", HAL_BIT, HAL_IN, &pins.reference[i]});
    all.push_back({axis + "drive-ready", HAL_BIT, HAL_IN, &pins.driveReady[i]});
    all.push_back({axis + "drive-fault", HAL_BIT, HAL_IN, &pins.driveFault[i]});
    all.push_back({axis + "encoder-lost", HAL_BIT, HAL_IN, &pins.encoderLost[i]});
    all.push_back({axis + "drive-enable", HAL_BIT, HAL_OUT, &pins.driveEnable[i]});
  }
  return all;
}

tl::expected<std::unique_ptr<HalComponent>, std::string> HalComponent::open() {
  const QuietHal quiet;
  auto component = std::make_unique<HalComponent>();
  for (const auto step :
       {&HalComponent::lock, &HalComponent::makePins, &HalComponent::attachStreams, &HalComponent::findPins}) {
    if (std::string reason = (component.get()->*step)(); !reason.empty()) {
      return tl::unexpected(std::move(reason));
    }
  }
  return component;
}

HalComponent::~HalComponent() {
  const QuietHal quiet;
  if (m_streamerAttached) {
    hal_stream_detach(&streamer);
  }
  if (m_samplerAttached) {
    hal_stream_detach(&sampler);
  }
  if (m_component >= 0) {
    hal_exit(m_component);
  }
  if (m_lock >= 0) {
    ::close(m_lock);
  }
}

// The name of a socket outside the file system is free again as soon as its process has ended, however it ended.
HalComponent::Reason HalComponent::lock() {
  m_lock = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(kLockName.begin(), kLockName.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + kLockName.size());
  if (m_lock < 0 || ::bind(m_lock, reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    return "another Arris drives them already";
  }
  return {};
}

HalComponent::Reason HalComponent::makePins() {
  m_component = hal_init("arris");
  if (m_component < 0) { // a dead Arris has left one, with its pins
    m_component = hal_init(("arris-" + std::to_string(::getpid())).c_str());
    if (m_component < 0) {
      return "this user may not reach the HAL session";
    }
    hal_ready(m_component);
    return {};
  }
  HalPins unused;
  const std::vector<HalPin> all = allPins(unused);
  auto** places = static_cast<void**>(hal_malloc(static_cast<long>(all.size() * sizeof(void*))));
  if (places == nullptr) {
    return "HAL has no memory left";
  }
  for (const HalPin& pin : all) {
    const std::string signal = signalOf(pin.name);
    hal_type_t type = HAL_TYPE_UNSPECIFIED;
    hal_data_u* value = nullptr;
    if (hal_get_signal_value_by_name(signal.c_str(), &type, &value, nullptr) != 0) {
      return pin.name == all.front().name ? "no HAL session for Arris runs; start one with packaging/hal/start.sh"
                                          : noSignal(pin.name);
    }
    if (type != pin.type) {
      return noSignal(pin.name);
    }
    hal_data_u before{};
    copyValue(type, *value, before);
    if (hal_pin_new(pin.name.c_str(), pin.type, pin.direction, places++, m_component) != 0 ||
        hal_link(pin.name.c_str(), signal.c_str()) != 0) {
      return noSignal(pin.name);
    }
    if (pin.direction == HAL_IN) { // the first link to a signal that was set by hand would clear it
      copyValue(type, before, *value);
    }
  }
  hal_ready(m_component);
  return {};
}

HalComponent::Reason HalComponent::attachStreams() {
  m_streamerAttached = hal_stream_attach(&streamer, m_component, kStreamerKey, kStreamed) == 0;
  m_samplerAttached = hal_stream_attach(&sampler, m_component, kSamplerKey, kSampled) == 0;
  hal_type_t type = HAL_TYPE_UNSPECIFIED;
  hal_data_u* value = nullptr;
  if (!m_streamerAttached || !m_samplerAttached || hal_stream_element_count(&streamer) != 4 ||
      hal_stream_element_count(&sampler) > HAL_STREAM_MAX_PINS ||
      hal_get_pin_value_by_name("streamer.0.underruns", &type, &value, nullptr) != 0) {
    return "the HAL session lacks streamer cfg=ffff or sampler cfg=fffff; compare its file with packaging/hal";
  }
  underruns = value;
  return {};
}

HalComponent::Reason HalComponent::findPins() {
  for (const HalPin& pin : allPins(pins)) {
    hal_type_t type = HAL_TYPE_UNSPECIFIED;
    if (hal_get_pin_value_by_name(pin.name.c_str(), &type, pin.value, nullptr) != 0 || type != pin.type) {
      return "an Arris that died has left the HAL session unfinished; start it again with packaging/hal/start.sh";
    }
  }
  return {};
}

} // namespace arris::control
