#pragma once

#include "core/base/problem.h"
#include "core/files/json_writer.h"
#include "core/recipe/recipe.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

// What the JSON files of this folder share.

namespace arris::files {

using Json = nlohmann::ordered_json;

/// The object that a JSON text holds; JsonMalformed with line and column, also for a key that stands twice and for
/// nesting that no file of Arris has. `file` names it in the problems. Never throws, whatever the text.
[[nodiscard]] base::Expected<Json> parseJson(std::string_view text, std::string_view file);

/// Refuses an object that is no file of the kind `key` ("arris_recipe") or of a version after `known`.
[[nodiscard]] base::Expected<void> checkVersion(const Json& object, std::string_view key, int known,
                                                std::string_view file);

/// A value as it stands in the text, for messages: cut off where it is long.
[[nodiscard]] std::string shown(const Json& value);

/// Every key in effect, without the version, as members of the object that is open.
void writeMembers(JsonWriter& json, const recipe::Recipe& recipe);
void writeMembers(JsonWriter& json, const recipe::Machine& machine);

} // namespace arris::files
