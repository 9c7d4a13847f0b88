#include "core/files/whole_file.h"
#include "tests/support/scratch.h"
#include "ui/presenters/preferences.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

using files::Settings;

std::string textOf(const std::filesystem::path& file) {
  return files::readFile(file).value_or("");
}

class PreferencesTest : public testing::Test {
protected:
  void put(const std::filesystem::path& file, std::string_view text) const {
    std::filesystem::create_directories(m_folder.root);
    ASSERT_TRUE(files::writeWholeFile(file, text));
  }

  test::Scratch m_scratch;
  files::StateFolder m_folder{m_scratch / "state"};
};

TEST_F(PreferencesTest, AreThereAgainTheNextTime) {
  {
    Preferences preferences(m_folder);
    EXPECT_TRUE(preferences.takeProblems().empty());
    Settings settings;
    settings.language = "zh_CN";
    settings.lengthUnit = Settings::LengthUnit::Inch;
    settings.appearance = Settings::Appearance::Dark;
    settings.scale = 150;
    preferences.change(settings);
    preferences.noteOpened("/panes/Tür \"1\".dxf");
    recipe::Machine machine;
    machine.travel = {3000, 6000, 200};
    preferences.setMachine(machine);
    EXPECT_EQ(preferences.machine(), recipe::Machine()); // from the next start
    recipe::Recipe recipe;
    recipe.thickness = 19;
    preferences.keepRecipe(recipe);
  }
  Preferences preferences(m_folder);
  EXPECT_TRUE(preferences.takeProblems().empty());
  EXPECT_EQ(preferences.settings().language, "zh_CN");
  EXPECT_EQ(preferences.settings().lengthUnit, Settings::LengthUnit::Inch);
  EXPECT_EQ(preferences.settings().appearance, Settings::Appearance::Dark);
  EXPECT_EQ(preferences.settings().scale, 150);
  EXPECT_EQ(preferences.settings().recent, std::vector<std::string>{"/panes/Tür \"1\".dxf"});
  EXPECT_EQ(preferences.machine().travel, Eigen::Vector3d(3000, 6000, 200));
  EXPECT_EQ(preferences.lastRecipe().thickness, 19);
}

TEST_F(PreferencesTest, SetADamagedFileAsideAndGoOnWithDefaults) {
  for (const auto& file : {m_folder.settings(), m_folder.machine(), m_folder.recipe()}) {
    for (const std::string text :
         {"", "{", "[1]", "{\"arris_settings\": 99}", "{\"arris_settings\": 1, \"scale_percent\": -3}",
          "{\"arris_machine\": 1, \"period_s\": 1e99}", "\xff\xfe\0bytes"}) {
      put(file, text);
      Preferences preferences(m_folder);
      const base::Problems problems = preferences.takeProblems();
      ASSERT_FALSE(problems.empty()) << file << text;
      EXPECT_EQ(problems.back().code, base::Code::FileSetAside);
      EXPECT_EQ(preferences.settings(), Settings());
      EXPECT_EQ(preferences.machine(), recipe::Machine());
      EXPECT_FALSE(std::filesystem::exists(file));
      const std::string aside = std::get<std::string>(problems.back().values.at(1).value);
      EXPECT_EQ(textOf(aside), text); // nothing is lost
    }
  }
}

TEST_F(PreferencesTest, KeepTheTenPatternsOpenedLast) {
  Preferences preferences(m_folder);
  for (int i = 0; i < 15; ++i) {
    preferences.noteOpened("/panes/" + std::to_string(i % 12) + ".dxf");
  }
  const std::vector<std::string>& recent = preferences.settings().recent;
  ASSERT_EQ(recent.size(), files::kMostRecent);
  EXPECT_EQ(recent.front(), "/panes/2.dxf");
  EXPECT_EQ(std::count(recent.begin(), recent.end(), "/panes/1.dxf"), 1);
}

TEST_F(PreferencesTest, KeepThePathFromWhichAPatternIsFoundFromAnywhere) {
  Preferences preferences(m_folder);
  preferences.noteOpened("pane.dxf");
  EXPECT_EQ(preferences.settings().recent.front(), (std::filesystem::current_path() / "pane.dxf").string());
}

TEST_F(PreferencesTest, OpenTheEngineeringValuesOnlyWithTheCode) {
  {
    Preferences preferences(m_folder);
    EXPECT_TRUE(preferences.isOpen());
    preferences.lock();
    EXPECT_TRUE(preferences.isOpen()); // no code: nothing to lock with
    preferences.setCode("1234");
    EXPECT_TRUE(preferences.isOpen());
    preferences.lock();
    EXPECT_FALSE(preferences.isOpen());
  }
  EXPECT_EQ(textOf(m_folder.settings()).find("1234\""), std::string::npos);
  Preferences preferences(m_folder);
  QSignalSpy changes(&preferences, &Preferences::openChanged);
  EXPECT_FALSE(preferences.isOpen());
  EXPECT_FALSE(preferences.open("1243"));
  EXPECT_FALSE(preferences.open(""));
  EXPECT_EQ(changes.count(), 0);
  EXPECT_TRUE(preferences.open("1234"));
  EXPECT_EQ(changes.count(), 1);
  preferences.setCode({});
  EXPECT_TRUE(Preferences(m_folder).isOpen());
}

TEST_F(PreferencesTest, TakesOnlyFourToEightDigitsForACode) {
  EXPECT_TRUE(Preferences::isCode("0000"));
  EXPECT_TRUE(Preferences::isCode("12345678"));
  for (const char* text : {"", "123", "123456789", "12a4", "１２３４", "-123"}) {
    EXPECT_FALSE(Preferences::isCode(QString::fromUtf8(text))) << text;
  }
}

TEST_F(PreferencesTest, TellWhatCouldNotBeWritten) {
  put(m_folder.root / "file", "x");
  Preferences preferences({m_folder.root / "file" / "state"});
  QSignalSpy problems(&preferences, &Preferences::problemsArose);
  Settings settings;
  settings.language = "de";
  preferences.change(settings);
  EXPECT_EQ(problems.count(), 1);
  EXPECT_EQ(preferences.takeProblems().front().code, base::Code::CannotWrite);
  EXPECT_EQ(preferences.settings().language, "de"); // in effect all the same
}

} // namespace
} // namespace arris::ui
