#pragma once

#include "core/base/problem.h"

#include <string>
#include <string_view>

namespace arris::pattern {

/// Whether the bytes say of themselves that they are a binary DXF file.
[[nodiscard]] bool isBinaryDxf(std::string_view bytes);

/// The same groups as text, code and value each on a line of its own; numbers lose nothing. Group codes of one byte
/// (up to release 12) and of two are told apart by the first group. What follows EOF is left out. `DxfBinary` where the
/// file ends within a group or holds a code that there is not.
[[nodiscard]] base::Expected<std::string> textOfBinaryDxf(std::string_view bytes);

} // namespace arris::pattern
