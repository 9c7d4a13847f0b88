#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <string_view>

namespace arris::base {

inline constexpr double kPi = std::numbers::pi;

[[nodiscard]] constexpr double radians(double degrees) {
  return degrees * (kPi / 180);
}

[[nodiscard]] constexpr double degrees(double radians) {
  return radians * (180 / kPi);
}

template <std::floating_point T> [[nodiscard]] constexpr T squared(T x) {
  return x * x;
}

/// The number that the whole of `text` spells with a decimal point, in every locale; nothing for anything else
/// ("", " 1", "1 ", "1,5", "+1", "0x1p3"). "nan" and "inf" are read as such: whoever needs a finite number checks it.
template <typename T> [[nodiscard]] std::optional<T> parseNumber(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

} // namespace arris::base
