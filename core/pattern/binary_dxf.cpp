#include "core/pattern/binary_dxf.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using base::Unexpected;

constexpr std::string_view kSentinel("AutoCAD Binary DXF\r\n\x1a\0", 22);

enum class ValueType { Text, Real, Int16, Int32, Int64, Byte, Chunk };

struct CodeRange {
  int first;
  int last;
  ValueType type;
};

// Every other code holds text.
constexpr auto kRanges = std::to_array<CodeRange>({
    {10, 59, ValueType::Real},      {60, 79, ValueType::Int16},    {90, 99, ValueType::Int32},
    {110, 149, ValueType::Real},    {160, 169, ValueType::Int64},  {170, 179, ValueType::Int16},
    {210, 239, ValueType::Real},    {270, 289, ValueType::Int16},  {290, 299, ValueType::Byte},
    {310, 319, ValueType::Chunk},   {370, 389, ValueType::Int16},  {400, 409, ValueType::Int16},
    {420, 429, ValueType::Int32},   {440, 459, ValueType::Int32},  {460, 469, ValueType::Real},
    {1004, 1004, ValueType::Chunk}, {1010, 1059, ValueType::Real}, {1060, 1070, ValueType::Int16},
    {1071, 1071, ValueType::Int32},
});

ValueType typeOf(int code) {
  for (const CodeRange& range : kRanges) {
    if (code >= range.first && code <= range.last) {
      return range.type;
    }
  }
  return ValueType::Text;
}

/// Takes numbers (least byte first) and texts from the front of the bytes; nothing where they are too few.
class BinaryGroups {
public:
  explicit BinaryGroups(std::string_view bytes)
      : m_rest(bytes.substr(kSentinel.size())),
        m_twoBytes(m_rest.size() > 1 && m_rest[1] == '\0' && m_rest[0] == '\0') {
    constexpr std::string_view kCommentFirst("\xE7\x03", 2); // group 999 with a code of two bytes
    m_twoBytes = m_twoBytes || m_rest.starts_with(kCommentFirst);
  }

  [[nodiscard]] bool atEnd() const {
    return m_rest.empty();
  }

  [[nodiscard]] std::size_t left() const {
    return m_rest.size();
  }

  std::optional<int> takeCode() {
    constexpr std::uint8_t kLongCode = 255;
    if (m_twoBytes) {
      return take<std::int16_t>();
    }
    const std::optional<std::uint8_t> code = take<std::uint8_t>();
    return code == kLongCode ? std::optional<int>(take<std::int16_t>()) : std::optional<int>(code);
  }

  /// Appends the value as text; false where the bytes end before it does.
  bool appendValue(ValueType type, std::string& out) {
    switch (type) {
    case ValueType::Text:
      return appendText(out);
    case ValueType::Real:
      return append(take<double>(), out);
    case ValueType::Int16:
      return append(take<std::int16_t>(), out);
    case ValueType::Int32:
      return append(take<std::int32_t>(), out);
    case ValueType::Int64:
      return append(take<std::int64_t>(), out);
    case ValueType::Byte:
      return append(take<std::uint8_t>(), out);
    case ValueType::Chunk:
      return appendChunk(out);
    }
    return false;
  }

private:
  template <typename T> std::optional<T> take() {
    static_assert(std::endian::native == std::endian::little);
    if (m_rest.size() < sizeof(T)) {
      return std::nullopt;
    }
    T value{};
    std::memcpy(&value, m_rest.data(), sizeof(T));
    m_rest.remove_prefix(sizeof(T));
    return value;
  }

  template <typename T> static bool append(std::optional<T> number, std::string& out) {
    if (number) {
      fmt::format_to(std::back_inserter(out), "{}", *number); // the shortest text that reads back the same
    }
    return number.has_value();
  }

  // A line end within a text would part it in two groups.
  bool appendText(std::string& out) {
    const std::size_t end = m_rest.find('\0');
    if (end == std::string_view::npos) {
      return false;
    }
    for (const char c : m_rest.substr(0, end)) {
      out += c == '\n' || c == '\r' ? ' ' : c;
    }
    m_rest.remove_prefix(end + 1);
    return true;
  }

  bool appendChunk(std::string& out) {
    const std::optional<std::uint8_t> size = take<std::uint8_t>();
    if (!size || m_rest.size() < *size) {
      return false;
    }
    for (const char c : m_rest.substr(0, *size)) {
      fmt::format_to(std::back_inserter(out), "{:02X}", static_cast<std::uint8_t>(c));
    }
    m_rest.remove_prefix(*size);
    return true;
  }

  std::string_view m_rest;
  bool m_twoBytes;
};

Unexpected damaged(std::string reason) {
  return Unexpected(Problem(Code::DxfBinary, {{"reason", std::move(reason)}}));
}

} // namespace

bool isBinaryDxf(std::string_view bytes) {
  constexpr std::string_view kName = "AutoCAD Binary DXF";
  return bytes.starts_with(kName);
}

base::Expected<std::string> textOfBinaryDxf(std::string_view bytes) {
  constexpr int kMostCode = 1071;
  if (!bytes.starts_with(kSentinel)) {
    return damaged("its first line is broken");
  }
  BinaryGroups groups(bytes);
  std::string text;
  text.reserve(2 * bytes.size());
  while (!groups.atEnd()) {
    const std::size_t at = bytes.size() - groups.left();
    const std::optional<int> code = groups.takeCode();
    if (code && (*code < 0 || *code > kMostCode)) {
      return damaged(fmt::format("byte {} begins no group", at));
    }
    const std::size_t begin = text.size();
    fmt::format_to(std::back_inserter(text), "{}\n", code.value_or(0));
    if (!code || !groups.appendValue(typeOf(*code), text)) {
      return damaged(fmt::format("it ends within the group at byte {}", at));
    }
    text += '\n';
    if (std::string_view(text).substr(begin) == "0\nEOF\n") {
      return text;
    }
  }
  return damaged("there is no EOF");
}

} // namespace arris::pattern
