#include "tests/support/mutation.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace arris::test {
namespace {

constexpr std::array<std::string_view, 16> kExtremes{
    "0",     "-1",   "1e308", "-1e308", "1e-320", "1e999", "2147483648", "-9223372036854775809",
    "0.001", "null", "true",  "[]",     "{}",     "\"\"",  "NaN",        "99999999999999999999999999"};

constexpr std::size_t kDeep = 100'000; ///< brackets

std::size_t upTo(Dice& dice, std::size_t most) {
  return static_cast<std::size_t>(dice.between(0, static_cast<double>(most) + 0.999));
}

void replaceNumber(std::string& bytes, Dice& dice) {
  constexpr std::string_view kDigits = "-0123456789.e+";
  const std::size_t from = bytes.find_first_of("0123456789", upTo(dice, bytes.size()));
  if (from != std::string::npos) {
    const std::size_t to = std::min(bytes.find_first_not_of(kDigits, from), bytes.size());
    bytes.replace(from, to - from, kExtremes.at(upTo(dice, kExtremes.size() - 1)));
  }
}

void change(std::string& bytes, Dice& dice) {
  const std::size_t at = upTo(dice, bytes.size() - 1);
  const std::size_t length = upTo(dice, std::min<std::size_t>(bytes.size() - at, 40));
  switch (upTo(dice, 19)) {
  case 0:
    bytes.resize(at);
    break;
  case 1:
  case 2:
    bytes.erase(at, length);
    break;
  case 3:
  case 4:
    bytes.insert(at, bytes.substr(at, length));
    break;
  case 5:
  case 6: {
    const std::string taken = bytes.substr(at, length);
    bytes.erase(at, length);
    bytes.insert(upTo(dice, bytes.size()), taken);
    break;
  }
  case 7:
    bytes.insert(at, dice.chance(0.05) ? kDeep : 1, dice.chance(0.5) ? '[' : '{');
    break;
  case 8:
  case 9:
  case 10:
    bytes[at] = static_cast<char>(upTo(dice, 255));
    break;
  default:
    replaceNumber(bytes, dice);
  }
}

} // namespace

std::string mutated(std::string bytes, Dice& dice) {
  for (std::size_t i = upTo(dice, 3) + 1; i > 0 && !bytes.empty(); --i) {
    change(bytes, dice);
  }
  return bytes;
}

} // namespace arris::test
