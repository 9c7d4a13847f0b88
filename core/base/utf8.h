#pragma once

#include <cstddef>
#include <string_view>

namespace arris::base {

/// Bytes of the UTF-8 sequence at the start of `bytes`, which are not empty; 0 where there is none.
[[nodiscard]] std::size_t utf8SequenceLength(std::string_view bytes);

[[nodiscard]] bool isUtf8(std::string_view bytes);

} // namespace arris::base
