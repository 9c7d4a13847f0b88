#include "core/pattern/group_cursor.h"

#include "core/base/numbers.h"
#include "core/base/utf8.h"

#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;

constexpr int kLeastGroupCode = -5;
constexpr int kMostGroupCode = 1071;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && isBlank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::optional<int> groupCode(std::string_view text) {
  const std::optional<int> code = base::parseNumber<int>(text);
  return code && *code >= kLeastGroupCode && *code <= kMostGroupCode ? code : std::nullopt;
}

} // namespace

std::string_view GroupCursor::takeLine() {
  const std::string_view rest = m_text.substr(m_offset);
  const std::size_t end = rest.find('\n');
  m_offset += end == std::string_view::npos ? rest.size() : end + 1;
  ++m_line;
  return trimmed(rest.substr(0, end));
}

bool GroupCursor::fail(Problem problem) {
  m_problem = std::move(problem).onLine(m_line);
  m_offset = m_text.size();
  return false;
}

bool GroupCursor::next(Group& group) {
  if (m_offset == m_text.size()) {
    return false;
  }
  const std::string_view codeText = takeLine();
  const std::optional<int> code = groupCode(codeText);
  if (!code) {
    const bool onlyBlanksLeft =
        codeText.empty() && m_text.find_first_not_of(" \t\r\n", m_offset) == std::string_view::npos;
    const std::string found = codeText.empty() ? "an empty line" : quoted(codeText);
    return !onlyBlanksLeft && fail(Problem(Code::DxfGroupCode, {{"found", found}}));
  }
  if (m_offset == m_text.size()) {
    return fail(Problem(Code::DxfTruncated, {{"reason", "the last group code has no value"}}));
  }
  group.code = *code;
  group.value = takeLine();
  group.line = m_line;
  return true;
}

std::optional<double> finiteNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  const std::optional<double> number = base::parseNumber<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> wholeNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  return base::parseNumber<std::int64_t>(text);
}

std::string readable(std::string_view bytes) {
  const bool utf8 = base::isUtf8(bytes);
  std::string result;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F || (!utf8 && byte >= 0x80 && byte < 0xA0)) {
      result += '?';
    } else if (utf8 || byte < 0x80) {
      result += c;
    } else {
      result += static_cast<char>(0xC0U | (byte >> 6U));
      result += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return result;
}

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kMostBytes = 40;
  std::string_view shown = bytes.substr(0, kMostBytes);
  if (base::isUtf8(bytes)) {
    while (!base::isUtf8(shown)) { // never cut a character in two
      shown.remove_suffix(1);
    }
  }
  return '"' + readable(shown) + (shown.size() < bytes.size() ? "…" : "") + '"';
}

} // namespace arris::pattern
