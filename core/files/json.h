#pragma once

#include "core/base/problem.h"
#include "core/files/json_writer.h"
#include "core/recipe/recipe.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

// What the JSON files of this folder share.

namespace arris::files {

using Json = nlohmann::ordered_json;

/// The object that a JSON text holds; JsonMalformed with line and column, also for a key that stands twice and for
/// nesting that no file of Arris has. `file` names it in the problems. Never throws, whatever the text.
[[nodiscard]] base::Expected<Json> parseJson(std::string_view text, std::string_view file);

/// The same of a file of the kind `key` ("arris_recipe") and of a version up to `known`, with what is wrong otherwise.
[[nodiscard]] base::Expected<Json> parseVersioned(std::string_view text, std::string_view key, int known,
                                                  std::string_view file);

/// Refuses an object that is no file of the kind `key` ("arris_recipe") or of a version after `known`.
[[nodiscard]] base::Expected<void> checkVersion(const Json& object, std::string_view key, int known,
                                                std::string_view file);

/// A value as it stands in the text, for messages: cut off where it is long.
[[nodiscard]] std::string shown(const Json& value);

/// The same without the quotes of a text, where they stand in the message.
[[nodiscard]] std::string bare(const Json& value);

/// Errors for a member of another type: `expected` says of which.
[[nodiscard]] base::Problem wrongType(std::string_view key, std::string expected, const Json& value);
[[nodiscard]] base::Problem notANumber(std::string_view key, std::string_view unit, const Json& value);

/// Every key in effect, without the version, as members of the object that is open.
void writeMembers(JsonWriter& json, const recipe::Recipe& recipe);
void writeMembers(JsonWriter& json, const recipe::Machine& machine);

/// Both as objects, "recipe" and "machine": what a job was planned with.
void writeSettings(JsonWriter& json, const recipe::Recipe& recipe, const recipe::Machine& machine);

/// The members of an object of an earlier `writeMembers`, over the defaults that stand in `recipe`; appends whatever is
/// wrong to `problems`. A member named `versionKey` is passed over.
void readMembers(const Json& object, std::string_view file, recipe::Recipe& recipe, base::Problems& problems,
                 std::string_view versionKey = {});
void readMembers(const Json& object, std::string_view file, recipe::Machine& machine, base::Problems& problems,
                 std::string_view versionKey = {});

/// The values of a problem, an event or an alarm as an object; a number that is not finite becomes null.
[[nodiscard]] Json valuesToJson(const std::vector<base::Value>& values);

/// And back: members that are neither numbers nor texts are left out.
[[nodiscard]] std::vector<base::Value> valuesFromJson(const Json& object);

/// On one line, bytes that are no UTF-8 as U+FFFD.
[[nodiscard]] std::string oneLine(const Json& value);

} // namespace arris::files
