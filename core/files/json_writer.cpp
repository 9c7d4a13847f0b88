#include "core/files/json_writer.h"

#include "core/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

namespace arris::files {

void JsonWriter::openObject() {
  startElement();
  open('{');
}

void JsonWriter::openObject(std::string_view key) {
  startMember(key);
  open('{');
}

void JsonWriter::openArray(std::string_view key) {
  startMember(key);
  open('[');
}

void JsonWriter::open(char bracket) {
  m_text += bracket;
  m_open += bracket == '{' ? '}' : ']';
  m_empty = true;
}

void JsonWriter::close() {
  const char bracket = m_open.back();
  m_open.pop_back();
  if (!m_empty) {
    m_text += '\n';
    m_text.append(2 * m_open.size(), ' ');
  }
  m_text += bracket;
  m_empty = false;
}

void JsonWriter::member(std::string_view key, double value) {
  startMember(key);
  number(value);
}

void JsonWriter::member(std::string_view key, std::string_view value) {
  startMember(key);
  quoted(value);
}

void JsonWriter::member(std::string_view key, const char* value) {
  member(key, std::string_view(value));
}

void JsonWriter::member(std::string_view key, const base::Value& value) {
  std::visit([&](const auto& v) { this->member(key, v); }, value.value);
}

void JsonWriter::member(std::string_view key, const Eigen::Vector2d& value) {
  member(key, std::span<const double>(value.data(), 2));
}

void JsonWriter::member(std::string_view key, std::span<const double> values) {
  startMember(key);
  line(values, [this](double value) { number(value); });
}

void JsonWriter::member(std::string_view key, std::span<const std::string> values) {
  startMember(key);
  line(values, [this](const std::string& value) { quoted(value); });
}

std::string JsonWriter::take() {
  assert(m_open.empty());
  m_text += '\n';
  return std::exchange(m_text, {});
}

void JsonWriter::startElement() {
  if (m_open.empty()) {
    return;
  }
  m_text += m_empty ? "\n" : ",\n";
  m_text.append(2 * m_open.size(), ' ');
  m_empty = false;
}

void JsonWriter::startMember(std::string_view key) {
  startElement();
  quoted(key);
  m_text += ": ";
}

void JsonWriter::rawMember(std::string_view key, std::string_view text) {
  startMember(key);
  m_text += text;
}

void JsonWriter::number(double value) {
  if (std::isfinite(value)) {
    fmt::format_to(std::back_inserter(m_text), "{}", value + 0.0); // no negative zero
  } else {
    m_text += "null";
  }
}

void JsonWriter::quoted(std::string_view text) {
  m_text += '"';
  while (!text.empty()) {
    const std::size_t length = base::utf8SequenceLength(text);
    const char c = text.front();
    if (length == 0) {
      m_text += "\xEF\xBF\xBD"; // U+FFFD
    } else if (c == '"' || c == '\\') {
      m_text += '\\';
      m_text += c;
    } else if (length == 1 && c < ' ') {
      fmt::format_to(std::back_inserter(m_text), "\\u{:04x}", static_cast<int>(c));
    } else {
      m_text += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  m_text += '"';
}

template <typename Values, typename Write> void JsonWriter::line(const Values& values, Write write) {
  m_text += '[';
  const char* separator = "";
  for (const auto& value : values) {
    m_text += separator;
    write(value);
    separator = ", ";
  }
  m_text += ']';
}

} // namespace arris::files
