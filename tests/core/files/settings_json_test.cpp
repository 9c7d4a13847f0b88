#include "core/files/settings_json.h"

#include <gmock/gmock.h>

namespace arris::files {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Axes = files::Axes;

TEST(SettingsFile, GivesBackWhatWasWritten) {
  Settings settings;
  settings.language = "de";
  settings.lengthUnit = Settings::LengthUnit::Inch;
  settings.appearance = Settings::Appearance::Dark;
  settings.scale = 150;
  settings.keypad = Settings::Keypad::Always;
  settings.axes = Axes::Linuxcnc;
  settings.code = "salt:0123";
  settings.recent = {"/a/pane.dxf", "b.dxf"};
  for (const Settings& written : {settings, Settings()}) {
    const Read<Settings> read = readSettingsFile(writeSettingsFile(written), "settings.json");
    EXPECT_THAT(read.problems, IsEmpty());
    EXPECT_EQ(read.value, written);
  }
}

TEST(SettingsFile, NamesTheAxesByAWord) {
  Settings settings;
  EXPECT_THAT(writeSettingsFile(settings), HasSubstr(R"("axes": "simulated")"));
  settings.axes = Axes::Linuxcnc;
  EXPECT_THAT(writeSettingsFile(settings), HasSubstr(R"("axes": "linuxcnc")"));
}

TEST(SettingsFile, WithoutAWordOnTheAxesHasSimulatedOnes) {
  const Read<Settings> read = readSettingsFile(R"({"arris_settings": 1, "language": "it"})", "settings.json");
  EXPECT_THAT(read.problems, IsEmpty());
  EXPECT_EQ(read.value.axes, Axes::Simulated);
}

TEST(SettingsFile, RefusesAxesThatItDoesNotKnow) {
  for (const char* axes : {R"("real")", R"("LinuxCNC")", R"("")", "1", "true", "null", R"(["linuxcnc"])"}) {
    const std::string text = std::string(R"({"arris_settings": 1, "axes": )") + axes + "}";
    const Read<Settings> read = readSettingsFile(text, "settings.json");
    ASSERT_THAT(read.problems, SizeIs(1)) << axes;
    EXPECT_TRUE(hasErrors(read.problems)) << axes;
    EXPECT_THAT(base::describe(read.problems.front()), HasSubstr("simulated, linuxcnc")) << axes;
    EXPECT_EQ(read.value.axes, Axes::Simulated) << axes;
  }
}

} // namespace
} // namespace arris::files
