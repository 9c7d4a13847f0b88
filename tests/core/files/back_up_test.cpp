// One file that holds what the operator has set, and its way back.

#include "core/files/back_up.h"
#include "core/files/counters.h"
#include "core/files/file_hash.h"
#include "core/files/whole_file.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <map>

namespace arris::files {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const BundleOrigin kOrigin{"2031-05-06T07:08:09", {{"qt", std::string("6.4.2")}}};

void putFile(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  ASSERT_TRUE(writeWholeFile(file, bytes));
}

std::string machineWith(double period) {
  recipe::Machine machine;
  machine.period = period;
  return writeMachine(machine);
}

void furnish(const fs::path& state) {
  recipe::Recipe recipe;
  recipe.feed = 1800;
  putFile(state / "settings.json", "{\"arris_settings\": 1, \"language\": \"de\"}\n");
  putFile(state / "machine.json", machineWith(0.002));
  putFile(state / "recipe.json", writeRecipe(recipe));
  putFile(state / "recipes/Tür.json", writeRecipe(recipe));
  putFile(state / "counters.json", writeCounters({"2030-01-01T00:00:00", 10, 5, 3, 1200, 2}));
  putFile(state / "alarms.jsonl", "{}\n");
  putFile(state / "resume.json", "{}\n");
  putFile(state / "recipes/.hidden.json", "no part of it");
  putFile(state / "recipes/notes.txt", "no part of it");
}

/// Every file of a folder with its bytes, back-ups aside.
std::map<std::string, std::string> contentsOf(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (entry.is_regular_file() && !name.starts_with("back-ups")) {
      content[name] = readFile(entry.path()).value_or("?");
    }
  }
  return content;
}

std::string refusal(const base::Expected<BackUp>& read) {
  return read ? "it was taken" : describe(read.error());
}

/// A back-up made by hand: with a sound manifest over whatever stands in it.
void writeByHand(const fs::path& archive, BundledFiles files, const std::string& kind = "back-up") {
  nlohmann::ordered_json manifest{
      {"arris_bundle", 1}, {"kind", kind}, {"made", "2031-05-06T07:08:09"}, {"arris", "0.1.0"}};
  manifest["files"] = nlohmann::ordered_json::object();
  for (const BundledFile& file : files) {
    manifest["files"][file.name] = fileHash(file.bytes);
  }
  files.insert(files.begin(),
               {"arris-bundle.json", manifest.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)});
  ASSERT_TRUE(writeBundle(archive, files));
}

TEST(BackUp, BringsAnEmptyFolderWhatTheOtherHad) {
  const test::Scratch scratch;
  furnish(scratch / "a");
  ASSERT_EQ(writeBackUp(scratch / "a", scratch / "kept.tar.gz", kOrigin), std::size_t{5});
  const auto backUp = readBackUp(scratch / "kept.tar.gz");
  ASSERT_TRUE(backUp) << describe(backUp.error());
  EXPECT_EQ(backUp->made, kOrigin.made);
  const auto restored = restoreBackUp(*backUp, scratch / "b", kOrigin);
  ASSERT_TRUE(restored) << describe(restored.error());
  EXPECT_FALSE(*restored);
  std::map<std::string, std::string> expected = contentsOf(scratch / "a");
  for (const char* name : {"alarms.jsonl", "resume.json", "recipes/.hidden.json", "recipes/notes.txt"}) {
    EXPECT_EQ(expected.erase(name), 1U);
  }
  EXPECT_EQ(contentsOf(scratch / "b"), expected);
}

TEST(BackUp, WhatIsReplacedIsKeptAsABackUpThatCanBeRestored) {
  const test::Scratch scratch;
  furnish(scratch / "a");
  furnish(scratch / "b");
  putFile(scratch / "b/machine.json", machineWith(0.004));
  putFile(scratch / "b/recipes/Only here.json", writeRecipe({}));
  const auto before = contentsOf(scratch / "b");
  ASSERT_TRUE(writeBackUp(scratch / "a", scratch / "kept.tar.gz", kOrigin));
  const auto restored = restoreBackUp(readBackUp(scratch / "kept.tar.gz").value(), scratch / "b", kOrigin);
  ASSERT_TRUE(restored && *restored);
  auto after = before;
  after["machine.json"] = machineWith(0.002);
  EXPECT_EQ(contentsOf(scratch / "b"), after); // what the back-up does not hold stays
  ASSERT_TRUE(restoreBackUp(readBackUp(**restored).value(), scratch / "b", kOrigin));
  EXPECT_EQ(contentsOf(scratch / "b"), before);
}

TEST(BackUp, OfNothingIsNotWritten) {
  const test::Scratch scratch;
  EXPECT_EQ(writeBackUp(scratch / "absent", scratch / "kept.tar.gz", kOrigin), std::size_t{0});
  EXPECT_FALSE(fs::exists(scratch / "kept.tar.gz"));
}

TEST(BackUp, NamesThatLeadElsewhereOrAreOfNoBackUpAreRefused) {
  const test::Scratch scratch;
  for (const char* name :
       {"../machine.json", "/etc/passwd", "recipes/../../machine.json", "recipes/a/b.json", "recipes/..json",
        "recipes/.json", "recipes/.hidden.json", "recipes\\a.json", "recipes/a\\b.json", "recipes/a\nb.json",
        "recipes/a.txt", "alarms.jsonl", "records/run-1.arrisrun", "resume.json", "Machine.json", "./machine.json",
        "recipes//a.json", "recipes/\xFF.json"}) {
    writeByHand(scratch / "a", {{name, writeRecipe({})}});
    EXPECT_THAT(refusal(readBackUp(scratch / "a")),
                testing::AnyOf(HasSubstr("is no part of a back-up"), HasSubstr("it does not say what it is")))
        << name;
  }
}

TEST(BackUp, EveryFileIsCheckedBeforeAnythingIsReplaced) {
  const test::Scratch scratch;
  for (const BundledFile& file :
       {BundledFile{"machine.json", "{\"arris_machine\": 1, \"period_s\": 99}"}, BundledFile{"recipe.json", "{"},
        BundledFile{"recipes/a.json", machineWith(0.001)}, BundledFile{"counters.json", "{\"arris_counters\": 1}"},
        BundledFile{"settings.json", "language=de"}}) {
    writeByHand(scratch / "a", {{"recipe.json", writeRecipe({})}, file});
    if (file.name == "recipe.json") {
      writeByHand(scratch / "a", {file});
    }
    EXPECT_THAT(refusal(readBackUp(scratch / "a")), HasSubstr(file.name + " is not valid"));
  }
}

TEST(BackUp, WhatDoesNotMatchItsFingerprintsIsRefused) {
  const test::Scratch scratch;
  furnish(scratch / "state");
  ASSERT_TRUE(writeBackUp(scratch / "state", scratch / "kept", kOrigin));
  const BundledFiles whole = readBundle(scratch / "kept").value();
  BundledFiles less = whole;
  less.pop_back();
  BundledFiles changed = whole;
  changed.back().bytes += ' ';
  for (const BundledFiles& files : {less, changed}) {
    ASSERT_TRUE(writeBundle(scratch / "a", files));
    EXPECT_THAT(refusal(readBackUp(scratch / "a")), HasSubstr("it is damaged or cut off"));
  }
  ASSERT_TRUE(writeBundle(scratch / "a", BundledFiles(whole.begin() + 1, whole.end())));
  EXPECT_THAT(refusal(readBackUp(scratch / "a")), HasSubstr("it does not say what it is"));
}

TEST(BackUp, CutOffAnywhereIsRefusedOrWhole) {
  const test::Scratch scratch;
  furnish(scratch / "state");
  ASSERT_TRUE(writeBackUp(scratch / "state", scratch / "kept", kOrigin));
  const std::string bytes = readFile(scratch / "kept").value();
  const BundledFiles whole = readBackUp(scratch / "kept")->files;
  int refused = 0;
  for (std::size_t length = 0; length < bytes.size(); length += 13) {
    ASSERT_TRUE(writeWholeFile(scratch / "cut", bytes.substr(0, length)));
    const auto read = readBackUp(scratch / "cut");
    ASSERT_TRUE(!read || read->files == whole) << length;
    refused += read ? 0 : 1;
  }
  EXPECT_GT(refused, 40); // all but the padding at the end
}

TEST(BackUp, AnotherKindOrANewerVersionIsToldAsSuch) {
  const test::Scratch scratch;
  furnish(scratch / "state");
  ASSERT_TRUE(writeSupportBundle(scratch / "state", scratch / "support", kOrigin));
  EXPECT_THAT(refusal(readBackUp(scratch / "support")), HasSubstr("it is a support bundle"));
  ASSERT_TRUE(writeBundle(scratch / "newer", {{"arris-bundle.json", "{\"arris_bundle\": 2}"}}));
  EXPECT_THAT(refusal(readBackUp(scratch / "newer")), HasSubstr("newer Arris"));
}

TEST(BackUp, IsRestoredWhollyOrNotAtAll) {
  const test::Scratch scratch;
  furnish(scratch / "a");
  ASSERT_TRUE(writeBackUp(scratch / "a", scratch / "kept", kOrigin));
  const BackUp backUp = readBackUp(scratch / "kept").value();
  furnish(scratch / "b");
  putFile(scratch / "b/machine.json", machineWith(0.004));
  fs::remove(scratch / "b/recipes/Tür.json");
  fs::create_directories(scratch / "b/recipes/Tür.json"); // a folder in the way of the last file
  const auto before = contentsOf(scratch / "b");
  const auto restored = restoreBackUp(backUp, scratch / "b", kOrigin);
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().code, base::Code::CannotWrite);
  EXPECT_EQ(contentsOf(scratch / "b"), before);
}

TEST(SupportBundle, HasTheLatestRecordsAndNamesWhatItLacks) {
  const test::Scratch scratch;
  furnish(scratch / "state");
  for (int i = 1; i <= 5; ++i) {
    const fs::path record = scratch / ("state/records/run-" + std::to_string(i) + ".arrisrun").c_str();
    putFile(record, std::to_string(i));
    fs::last_write_time(record, fs::file_time_type::clock::now() + std::chrono::hours(i));
  }
  fs::create_directories(scratch / "other");
  fs::remove(scratch / "state/resume.json");
  fs::create_directories(scratch / "state/resume.json"); // cannot be read
  ASSERT_TRUE(writeSupportBundle(scratch / "state", scratch / "support", kOrigin));
  const auto files = readBundle(scratch / "support");
  ASSERT_TRUE(files);
  std::vector<std::string> names;
  for (const BundledFile& file : *files) {
    names.push_back(file.name);
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("arris-bundle.json", "settings.json", "machine.json", "recipe.json",
                                                   "counters.json", "recipes/Tür.json", "alarms.jsonl",
                                                   "records/run-5.arrisrun", "records/run-4.arrisrun",
                                                   "records/run-3.arrisrun"));
  const auto manifest = nlohmann::json::parse(files->front().bytes);
  EXPECT_EQ(manifest["left_out"], nlohmann::json({"resume.json"}));
  EXPECT_EQ(manifest["system"]["qt"], "6.4.2");
  EXPECT_TRUE(manifest["arris"].is_string());
}

TEST(SupportBundle, OfAnEmptyFolderTellsTheVersionsAllTheSame) {
  const test::Scratch scratch;
  ASSERT_EQ(writeSupportBundle(scratch / "absent", scratch / "support", kOrigin), std::size_t{0});
  EXPECT_EQ(readBundle(scratch / "support")->size(), 1U);
}

} // namespace
} // namespace arris::files
