#pragma once

#include <string>
#include <string_view>

namespace arris::test {

enum class BinaryCodes { OneByte, TwoBytes };

/// The groups of a DXF text as a binary DXF file. With codes of one byte it is what releases up to 12 write.
[[nodiscard]] std::string asBinaryDxf(std::string_view text, BinaryCodes codes);

} // namespace arris::test
