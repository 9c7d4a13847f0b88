#pragma once

#include "core/base/problem.h"

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace arris::files {

/// JSON text under construction: members one below the other, numbers and points on one line. Streams into one text
/// without a tree in between, so that a report of a hundred thousand corners stays small and quick. Numbers in the
/// shortest form that reads back as the same number, whatever the locale; what is no number becomes null. Bytes that
/// are no UTF-8 (of file and layer names) become U+FFFD.
class JsonWriter {
public:
  void openObject();                     ///< the outermost, or an element of an array
  void openObject(std::string_view key); ///< a member
  void openArray(std::string_view key);  ///< a member
  void close();                          ///< the object or array opened last

  void member(std::string_view key, double value);
  void member(std::string_view key, std::string_view value);
  void member(std::string_view key, const char* value);
  void member(std::string_view key, const base::Value& value);
  void member(std::string_view key, const Eigen::Vector2d& value);
  void member(std::string_view key, std::span<const double> values);
  void member(std::string_view key, std::span<const std::string> values);

  template <std::same_as<bool> Flag> void member(std::string_view key, Flag value) {
    rawMember(key, value ? "true" : "false");
  }

  template <std::integral Number>

  requires(!std::same_as<Number, bool>) void member(std::string_view key, Number value) {
    rawMember(key, std::to_string(value));
  }

  /// The whole text, once everything is closed.
  [[nodiscard]] std::string take();

private:
  void startElement();
  void startMember(std::string_view key);
  void rawMember(std::string_view key, std::string_view text);
  void open(char bracket);
  void number(double value);
  void quoted(std::string_view text);
  template <typename Values, typename Write> void line(const Values& values, Write write);

  std::string m_text;
  std::string m_open;  ///< closing brackets of what is open
  bool m_empty = true; ///< nothing yet in what was opened last
};

} // namespace arris::files
