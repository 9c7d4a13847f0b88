#pragma once

#include "core/files/json.h"

namespace arris::files {

/// Takes the members of an object that must have all that it is asked for, and gathers what is wrong: what is absent,
/// of another type, not finite or outside its range. Whatever was wrong has a value without meaning.
class JsonMembers {
public:
  /// Object and problems must outlive this.
  JsonMembers(const Json& object, base::Problems& problems) : m_object(object), m_problems(problems) {}

  [[nodiscard]] double number(std::string_view key, double least, double most, std::string_view unit);
  [[nodiscard]] Eigen::Vector3d vector(std::string_view key, double least, double most, std::string_view unit);
  [[nodiscard]] int count(std::string_view key, int least, int most);
  [[nodiscard]] std::string text(std::string_view key);
  [[nodiscard]] bool flag(std::string_view key);
  /// A fingerprint as `fileHash` makes it.
  [[nodiscard]] std::string hash(std::string_view key);
  /// An empty one where it is wrong.
  [[nodiscard]] const Json& object(std::string_view key);

private:
  const Json* find(std::string_view key, std::string_view expected, bool (*fits)(const Json&));

  const Json& m_object;
  base::Problems& m_problems;
};

} // namespace arris::files
