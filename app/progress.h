#pragma once

#include <string_view>

namespace arris::app {

/// A line on the terminal that says what is being done, and is gone when this object is. Nothing where stderr is no
/// terminal.
class Progress {
public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;

  void show(std::string_view what) const;

  /// `fraction` from 0 to 1 of it is done; cheap to call often.
  void show(std::string_view what, double fraction);

private:
  bool m_onTerminal;
  int m_percent = -1;
};

} // namespace arris::app
