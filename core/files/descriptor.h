#pragma once

#include "core/base/problem.h"

#include <csignal>
#include <filesystem>
#include <utility>

// What the writers and readers of this folder share of the system.

namespace arris::files {

/// An open file; closed at the end.
class Descriptor {
public:
  explicit Descriptor(int number = -1) : m_number(number) {}

  ~Descriptor() {
    close();
  }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}

  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(m_number, other.m_number);
    return *this;
  }

  [[nodiscard]] int number() const {
    return m_number;
  }

  [[nodiscard]] bool isOpen() const {
    return m_number >= 0;
  }

  /// False with errno: network file systems report a full disk only here.
  bool close();

private:
  int m_number;
};

/// A file size limit or a closed pipe would end the process by a signal; while this lives each is an error like others.
/// The signals go to the thread that writes, so they wait while blocked and are taken away before they would be let
/// through.
class WriteSignalsBlocked {
public:
  WriteSignalsBlocked();
  ~WriteSignalsBlocked();
  WriteSignalsBlocked(const WriteSignalsBlocked&) = delete;
  WriteSignalsBlocked& operator=(const WriteSignalsBlocked&) = delete;
  WriteSignalsBlocked(WriteSignalsBlocked&&) = delete;
  WriteSignalsBlocked& operator=(WriteSignalsBlocked&&) = delete;

private:
  sigset_t m_signals{};
  sigset_t m_before{};
};

/// CannotOpen, CannotRead or CannotWrite with what `error` (of errno) means, in English whatever the locale.
[[nodiscard]] base::Problem systemProblem(base::Code code, const std::filesystem::path& file, int error);

} // namespace arris::files
