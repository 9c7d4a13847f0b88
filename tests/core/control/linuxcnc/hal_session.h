#pragma once

#include <string>
#include <vector>

namespace arris::test {

/// A HAL session for a test, of a file in packaging/hal, ended with the object. A second stream of the sampler records
/// what the first one gives to Arris (hal_recorder.h).
class HalSession {
public:
  explicit HalSession(const std::string& name);
  ~HalSession();
  HalSession(const HalSession&) = delete;
  HalSession& operator=(const HalSession&) = delete;
  HalSession(HalSession&&) = delete;
  HalSession& operator=(HalSession&&) = delete;

  [[nodiscard]] bool runs() const {
    return m_runs;
  }

private:
  bool m_runs = false;
};

/// Runs halcmd with these arguments; what it said on stdout.
std::string halcmd(const std::string& arguments);

} // namespace arris::test
