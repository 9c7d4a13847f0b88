#include "tests/support/binary_dxf.h"

#include "core/base/numbers.h"

#include <cstdint>
#include <cstring>

namespace arris::test {
namespace {

template <typename T> void append(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

void appendCode(std::string& out, int code, BinaryCodes codes) {
  if (codes == BinaryCodes::TwoBytes) {
    append(out, static_cast<std::int16_t>(code));
  } else if (code < 255) {
    append(out, static_cast<std::uint8_t>(code));
  } else {
    append(out, std::uint8_t{255});
    append(out, static_cast<std::int16_t>(code));
  }
}

bool isIn(int code, int first, int last) {
  return code >= first && code <= last;
}

void appendValue(std::string& out, int code, std::string_view value) {
  const double real = base::parseNumber<double>(value).value_or(0);
  if (isIn(code, 10, 59) || isIn(code, 110, 149) || isIn(code, 210, 239) || isIn(code, 1010, 1059)) {
    append(out, real);
  } else if (isIn(code, 60, 79) || isIn(code, 170, 179) || isIn(code, 270, 289) || isIn(code, 1060, 1070)) {
    append(out, static_cast<std::int16_t>(real));
  } else if (isIn(code, 90, 99) || code == 1071) {
    append(out, static_cast<std::int32_t>(real));
  } else if (isIn(code, 160, 169)) {
    append(out, static_cast<std::int64_t>(real));
  } else if (isIn(code, 290, 299)) {
    append(out, static_cast<std::uint8_t>(real));
  } else if (isIn(code, 310, 319)) {
    append(out, static_cast<std::uint8_t>(value.size()));
    out.append(value);
  } else {
    out.append(value) += '\0';
  }
}

} // namespace

std::string asBinaryDxf(std::string_view text, BinaryCodes codes) {
  std::string out("AutoCAD Binary DXF\r\n\x1a\0", 22);
  const auto takeLine = [&text]() {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(line.size() + 1);
    return line;
  };
  while (!text.empty()) {
    const int code = base::parseNumber<int>(takeLine()).value_or(0);
    appendCode(out, code, codes);
    appendValue(out, code, takeLine());
  }
  return out;
}

} // namespace arris::test
