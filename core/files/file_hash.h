#pragma once

#include <string>
#include <string_view>

namespace arris::files {

/// A fingerprint of a file's bytes, 16 hexadecimal digits (FNV-1a, 64 bits): tells whether a pattern is still the one
/// that was planned. No protection against forgery.
[[nodiscard]] std::string fileHash(std::string_view bytes);

/// Whether a text has the form of such a fingerprint.
[[nodiscard]] bool isFileHash(std::string_view text);

} // namespace arris::files
