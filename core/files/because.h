#pragma once

#include "core/toolpath/toolpath.h"

#include <string>
#include <string_view>
#include <vector>

namespace arris::files {

/// Why a corner is treated as it is: a code, one English sentence, and the figures that decide.
struct Because {
  std::string_view code;
  std::string text;
  std::vector<base::Value> figures;
};

/// `recipe` is the one that the corner was planned with.
[[nodiscard]] Because because(const toolpath::Corner& corner, const recipe::Recipe& recipe);

} // namespace arris::files
