#pragma once

#include <Eigen/Core>

#include <vector>

namespace arris::test {

/// What HAL did in one period.
struct HalSample {
  Eigen::Vector3d measured{0, 0, 0}; ///< mm, of the encoders
  double number = 0;                 ///< of the set-point, as the driver counts
  double time = 0;                   ///< s, HAL's own
  bool chainOk = false;              ///< the latch
  bool enabled = false;              ///< the drive of X has power
};

/// Reads every period of the session's second stream, without a gap as long as it is read every minute. In a module of
/// its own, since LinuxCNC's library must be unloaded before it is used for another session.
class HalRecorder {
public:
  HalRecorder();
  ~HalRecorder();
  HalRecorder(const HalRecorder&) = delete;
  HalRecorder& operator=(const HalRecorder&) = delete;
  HalRecorder(HalRecorder&&) = delete;
  HalRecorder& operator=(HalRecorder&&) = delete;

  /// What has happened since the last call.
  std::vector<HalSample> take();

private:
  void* m_module;
};

/// What the module exports, each by the name of its type.
using arrisBeginRecording = bool();
using arrisReadRecord = bool(HalSample& sample); ///< false where there is no more for now
using arrisEndRecording = void();

} // namespace arris::test
