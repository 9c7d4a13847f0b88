#include "core/files/set_aside.h"
#include "core/files/whole_file.h"
#include "tests/support/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

namespace arris::test {
namespace {

void put(const std::filesystem::path& file, std::string_view text) {
  ASSERT_TRUE(files::writeWholeFile(file, text));
}

std::string reasonOf(const base::Problem& problem) {
  const auto reason = std::find_if(problem.values.begin(), problem.values.end(),
                                   [](const base::Value& value) { return value.name == "reason"; });
  return reason != problem.values.end() ? std::get<std::string>(reason->value) : std::string();
}

TEST(SetAside, EveryDamagedFileKeepsItsBytesUnderANameOfItsOwn) {
  const Scratch scratch;
  const std::filesystem::path file = scratch / "settings.json";
  const std::vector<std::pair<std::string, std::string>> rounds = {
      {"first", "settings.json.damaged"}, {"second", "settings.json.2.damaged"}, {"third", "settings.json.3.damaged"}};
  for (const auto& [text, name] : rounds) {
    put(file, text);
    const auto aside = files::setAside(file);
    ASSERT_TRUE(aside);
    EXPECT_EQ(aside->filename(), name);
    EXPECT_EQ(aside->parent_path(), file.parent_path());
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  for (const auto& [text, name] : rounds) {
    EXPECT_EQ(files::readFile(scratch / name.c_str()), text);
  }
}

TEST(SetAside, ALinkGoesAsideAndWhatItLeadsToStays) {
  const Scratch scratch;
  put(scratch / "elsewhere.json", "kept");
  std::filesystem::create_symlink(scratch / "elsewhere.json", scratch / "counters.json");
  const auto aside = files::setAside(scratch / "counters.json");
  ASSERT_TRUE(aside);
  EXPECT_TRUE(std::filesystem::is_symlink(*aside));
  EXPECT_EQ(files::readFile(scratch / "elsewhere.json"), "kept");
}

TEST(SetAside, WhereThereIsNoFileTheReasonIsTold) {
  const Scratch scratch;
  const auto aside = files::setAside(scratch / "absent.json");
  ASSERT_FALSE(aside);
  EXPECT_EQ(aside.error().code, base::Code::CannotWrite);
  EXPECT_EQ(reasonOf(aside.error()), "No such file or directory");
}

} // namespace
} // namespace arris::test
