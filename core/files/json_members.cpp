#include "core/files/json_members.h"

#include "core/files/file_hash.h"
#include "core/recipe/fields.h"

#include <fmt/format.h>

#include <algorithm>

namespace arris::files {
namespace {

bool isThreeNumbers(const Json& value) {
  const auto isNumber = [](const Json& element) { return element.is_number(); };
  return value.is_array() && value.size() == 3 && std::all_of(value.begin(), value.end(), isNumber);
}

} // namespace

const Json* JsonMembers::find(std::string_view key, std::string_view expected, bool (*fits)(const Json&)) {
  const auto member = m_object.find(key);
  if (member == m_object.end()) {
    m_problems.push_back(base::Problem(
        base::Code::ValueWrongType,
        {{"name", std::string(key)}, {"expected", std::string(expected)}, {"value", std::string("absent")}}));
    return nullptr;
  }
  if (!fits(*member)) {
    m_problems.push_back(wrongType(key, std::string(expected), *member));
    return nullptr;
  }
  return &*member;
}

double JsonMembers::number(std::string_view key, double least, double most, std::string_view unit) {
  const Json* member = find(key, fmt::format("a number in {}", unit), [](const Json& v) { return v.is_number(); });
  if (!member) {
    return 0;
  }
  const auto value = member->get<double>();
  if (auto problem = recipe::checkRange(key, value, least, most, unit)) {
    m_problems.push_back(*std::move(problem));
  }
  return value;
}

Eigen::Vector3d JsonMembers::vector(std::string_view key, double least, double most, std::string_view unit) {
  Eigen::Vector3d result(0, 0, 0);
  if (const Json* member = find(key, fmt::format("[x, y, z] in {}", unit), isThreeNumbers)) {
    for (int i = 0; i < 3; ++i) {
      result[i] = (*member)[static_cast<std::size_t>(i)].get<double>();
      if (auto problem = recipe::checkRange(key, result[i], least, most, unit)) {
        m_problems.push_back(*std::move(problem));
      }
    }
  }
  return result;
}

int JsonMembers::count(std::string_view key, int least, int most) {
  const std::string expected = fmt::format("a whole number from {} to {}", least, most);
  const Json* member = find(key, expected, [](const Json& v) { return v.is_number_integer(); });
  // As a double, since JSON has whole numbers beyond those of the machine.
  if (member && (member->get<double>() < least || member->get<double>() > most)) {
    m_problems.push_back(wrongType(key, expected, *member));
    return least;
  }
  return member ? member->get<int>() : least;
}

std::string JsonMembers::text(std::string_view key) {
  const Json* member = find(key, "a text", [](const Json& v) { return v.is_string(); });
  return member ? member->get<std::string>() : std::string();
}

bool JsonMembers::flag(std::string_view key) {
  const Json* member = find(key, "true or false", [](const Json& v) { return v.is_boolean(); });
  return member && member->get<bool>();
}

std::string JsonMembers::hash(std::string_view key) {
  const auto isHash = [](const Json& v) { return v.is_string() && isFileHash(v.get<std::string>()); };
  const Json* member = find(key, "a fingerprint of 16 digits", isHash);
  return member ? member->get<std::string>() : std::string();
}

const Json& JsonMembers::object(std::string_view key) {
  static const Json kEmpty = Json::object();
  const Json* member = find(key, "an object", [](const Json& v) { return v.is_object(); });
  return member ? *member : kEmpty;
}

} // namespace arris::files
