#include "core/files/back_up.h"

#include "core/base/window_thread.h"
#include "core/files/counters.h"
#include "core/files/file_hash.h"
#include "core/files/json_members.h"
#include "core/files/recipe_folder.h"
#include "core/files/record_folder.h"
#include "core/files/run_record.h"
#include "core/files/settings_json.h"
#include "core/files/state_folder.h"
#include "core/files/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace arris::files {
namespace {

namespace fs = std::filesystem;
using base::Code;
using base::Expected;
using base::Problem;
using base::Unexpected;

constexpr std::string_view kManifestName = "arris-bundle.json";
constexpr std::string_view kManifestKey = "arris_bundle";
constexpr int kManifestVersion = 1;
constexpr std::string_view kBackUpKind = "back-up";
constexpr std::string_view kSupportKind = "support";

// Names within an archive are those within the state folder.
const StateFolder kInside;
const std::array<std::string, 4> kSettingsFiles{kInside.settings().string(), kInside.machine().string(),
                                                kInside.recipe().string(), kInside.counters().string()};
const std::string kRecipesFolder = kInside.recipes().string() + '/';

constexpr std::size_t kRecordsOfSupport = 3;
constexpr std::uintmax_t kLargestRecordOfSupport = 50'000'000; // bytes

bool isRecipeFile(std::string_view name) {
  if (!name.starts_with(kRecipesFolder) || !name.ends_with(kRecipeEnding)) {
    return false;
  }
  name.remove_prefix(kRecipesFolder.size());
  return name.size() > kRecipeEnding.size() && isRecipeName(name.substr(0, name.size() - kRecipeEnding.size()));
}

bool isOfBackUp(std::string_view name) {
  return std::find(kSettingsFiles.begin(), kSettingsFiles.end(), name) != kSettingsFiles.end() || isRecipeFile(name);
}

// Files of the folder that are of a back-up, sorted so that the same folder gives the same back-up.
Expected<std::vector<std::string>> namesOfBackUp(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const std::string& name : kSettingsFiles) {
    if (fs::is_regular_file(folder / name, error)) {
      names.push_back(name);
    }
  }
  const fs::path recipes = StateFolder{folder}.recipes();
  if (!fs::is_directory(recipes, error)) {
    return names;
  }
  std::vector<std::string> found;
  for (fs::directory_iterator entry(recipes, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::string name = kRecipesFolder + entry->path().filename().string();
    std::error_code gone;
    if (isRecipeFile(name) && entry->is_regular_file(gone)) {
      found.push_back(std::move(name));
    }
  }
  if (error) {
    return Unexpected(systemProblem(Code::CannotRead, recipes, error.value()));
  }
  std::sort(found.begin(), found.end());
  names.insert(names.end(), found.begin(), found.end());
  return names;
}

Expected<BundledFiles> filesNamed(const fs::path& folder, const std::vector<std::string>& names) {
  BundledFiles files;
  for (const std::string& name : names) {
    auto bytes = readFile(folder / name);
    if (!bytes) {
      return Unexpected(bytes.error());
    }
    files.push_back({name, *std::move(bytes)});
  }
  return files;
}

Expected<BundledFiles> filesOfBackUp(const fs::path& folder) {
  return namesOfBackUp(folder).and_then(
      [&](const std::vector<std::string>& names) { return filesNamed(folder, names); });
}

BundledFile manifestOf(std::string_view kind, const BundledFiles& files, const BundleOrigin& origin,
                       const std::vector<std::string>& leftOut = {}) {
  JsonWriter json;
  json.openObject();
  json.member(kManifestKey, kManifestVersion);
  json.member("kind", kind);
  json.member("made", origin.made);
  json.member("arris", ARRIS_VERSION);
  json.openObject("system");
  for (const base::Value& value : origin.system) {
    json.member(value.name, value);
  }
  json.close();
  json.openObject("files");
  for (const BundledFile& file : files) {
    json.member(file.name, fileHash(file.bytes));
  }
  json.close();
  if (!leftOut.empty()) {
    json.member("left_out", leftOut);
  }
  json.close();
  return {std::string(kManifestName), json.take()};
}

Expected<std::size_t> writeWithManifest(const fs::path& archive, BundledFile manifest, BundledFiles files) {
  const std::size_t count = files.size();
  files.insert(files.begin(), std::move(manifest));
  return writeBundle(archive, files).map([count] { return count; });
}

// The latest first.
std::vector<std::string> latestRecords(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, std::string>> records;
  std::error_code error;
  for (fs::directory_iterator entry(StateFolder{folder}.records(), error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code gone;
    const fs::file_time_type changed = entry->last_write_time(gone);
    if (entry->path().extension() == kRecordEnding && entry->is_regular_file(gone) && !gone) {
      records.emplace_back(changed, (kInside.records() / entry->path().filename()).string());
    }
  }
  std::sort(records.rbegin(), records.rend());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(records.size(), kRecordsOfSupport); ++i) {
    names.push_back(records[i].second);
  }
  return names;
}

// Everything of use to whoever helps; what is too large or cannot be read goes into `leftOut`.
BundledFiles filesOfSupport(const fs::path& folder, std::vector<std::string>& leftOut) {
  std::vector<std::string> names;
  if (const auto settings = namesOfBackUp(folder)) {
    names = *settings;
  } else {
    leftOut.push_back(kRecipesFolder);
  }
  std::error_code error;
  for (const fs::path& name : {kInside.alarmLog(), kInside.resumePoint()}) {
    if (fs::exists(folder / name, error)) {
      names.push_back(name.string());
    }
  }
  const std::vector<std::string> records = latestRecords(folder);
  names.insert(names.end(), records.begin(), records.end());
  BundledFiles files;
  for (const std::string& name : names) {
    const std::uintmax_t size = fs::file_size(folder / name, error);
    auto bytes = !error && size <= kLargestRecordOfSupport ? readFile(folder / name)
                                                           : Expected<std::string>(Unexpected(Problem()));
    if (bytes) {
      files.push_back({name, *std::move(bytes)});
    } else {
      leftOut.push_back(name);
    }
  }
  return files;
}

base::Problems problemsIn(const BundledFile& file) {
  if (file.name == kInside.machine()) {
    return readMachine(file.bytes, file.name).problems;
  }
  if (file.name == kInside.counters()) {
    return readCounters(file.bytes, file.name).problems;
  }
  if (file.name == kInside.settings()) {
    return readSettingsFile(file.bytes, file.name).problems;
  }
  return readRecipe(file.bytes, file.name).problems;
}

/// Checks what an archive holds against what it says of itself.
class BackUpCheck {
public:
  explicit BackUpCheck(const fs::path& archive) : m_archive(archive) {}

  Expected<BackUp> check(BundledFiles files) {
    const auto manifest =
        std::find_if(files.begin(), files.end(), [](const BundledFile& file) { return file.name == kManifestName; });
    if (manifest == files.end()) {
      return malformed("it does not say what it is");
    }
    const auto object = parseJson(manifest->bytes, kManifestName);
    if (!object) {
      return malformed("it does not say what it is");
    }
    if (const auto version = checkVersion(*object, kManifestKey, kManifestVersion, m_archive.string()); !version) {
      return Unexpected(version.error());
    }
    files.erase(manifest);
    base::Problems problems;
    JsonMembers members(*object, problems);
    BackUp backUp{members.text("made"), members.text("arris"), {}};
    const std::string kind = members.text("kind");
    const Json& hashes = members.object("files");
    if (kind == kSupportKind) {
      return malformed("it is a support bundle");
    }
    if (kind != kBackUpKind || !problems.empty()) {
      return malformed("it does not say what it is");
    }
    if (hashes.size() != files.size()) {
      return malformed("it is damaged or cut off");
    }
    for (const BundledFile& file : files) {
      if (const auto sound = checkFile(file, hashes); !sound) {
        return Unexpected(sound.error());
      }
    }
    backUp.files = std::move(files);
    return backUp;
  }

private:
  [[nodiscard]] Unexpected malformed(std::string reason) const {
    return Unexpected(malformedBundle(m_archive, std::move(reason)));
  }

  [[nodiscard]] Expected<void> checkFile(const BundledFile& file, const Json& hashes) const {
    if (!isOfBackUp(file.name)) {
      return malformed(fmt::format("{} is no part of a back-up", bare(Json(file.name))));
    }
    const auto hash = hashes.find(file.name);
    if (hash == hashes.end() || !hash->is_string() || hash->get<std::string>() != fileHash(file.bytes)) {
      return malformed("it is damaged or cut off");
    }
    for (const Problem& problem : problemsIn(file)) {
      if (base::severityOf(problem) == base::Severity::Error) {
        return malformed(fmt::format("{} is not valid", file.name));
      }
    }
    return {};
  }

  const fs::path& m_archive;
};

/// Replaces files by others so that either all are replaced or none: everything is on the disk beside them before the
/// first takes its place, and what has been replaced can be put back without further room.
class Replacement {
public:
  Replacement() = default;
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  Replacement(Replacement&&) = delete;
  Replacement& operator=(Replacement&&) = delete;

  ~Replacement() {
    std::error_code none;
    for (const Step& step : m_steps) {
      fs::remove(step.fresh, none);
      fs::remove(step.old, none);
    }
  }

  Expected<void> prepare(const fs::path& file, std::string_view bytes) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error); // a link stays one
    if (error) {
      return failure(file, error);
    }
    Step step{target, target, target, fs::exists(target, error)};
    step.fresh += ".restoring";
    step.old += ".replaced";
    m_steps.push_back(step);
    if (step.hadOne && !fs::is_regular_file(target, error)) {
      return Unexpected(systemProblem(Code::CannotWrite, file, EISDIR));
    }
    if (step.hadOne && !fs::copy_file(target, step.old, fs::copy_options::overwrite_existing, error)) {
      return failure(file, error);
    }
    return writeWholeFile(step.fresh, bytes);
  }

  Expected<void> commit() {
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
      std::error_code error;
      fs::rename(m_steps[i].fresh, m_steps[i].target, error);
      if (error) {
        undo(i);
        return failure(m_steps[i].target, error);
      }
    }
    return {};
  }

private:
  struct Step {
    fs::path target, fresh, old;
    bool hadOne = false;
  };

  static Unexpected failure(const fs::path& file, const std::error_code& error) {
    return Unexpected(systemProblem(Code::CannotWrite, file, error.value()));
  }

  // The first so many, the last of them first.
  void undo(std::size_t count) {
    std::error_code none;
    while (count-- > 0) {
      const Step& step = m_steps[count];
      if (step.hadOne) {
        fs::rename(step.old, step.target, none);
      } else {
        fs::remove(step.target, none);
      }
    }
  }

  std::vector<Step> m_steps;
};

Expected<void> replaceFiles(const BundledFiles& files, const fs::path& folder) {
  Replacement replacement;
  for (const BundledFile& file : files) {
    if (auto prepared = replacement.prepare(folder / file.name, file.bytes); !prepared) {
      return prepared;
    }
  }
  return replacement.commit();
}

// A name that is not taken yet.
fs::path newBackUpFile(const fs::path& folder, std::string_view made) {
  std::string name(made);
  std::replace(name.begin(), name.end(), ':', '-');
  fs::path file = folder / fmt::format("before-restore-{}.tar.gz", name);
  std::error_code none;
  for (int number = 2; fs::exists(fs::symlink_status(file, none)); ++number) {
    file = folder / fmt::format("before-restore-{}-{}.tar.gz", name, number);
  }
  return file;
}

} // namespace

Expected<std::size_t> writeBackUp(const fs::path& stateFolder, const fs::path& archive, const BundleOrigin& origin) {
  base::takesLong("writeBackUp");
  return filesOfBackUp(stateFolder).and_then([&](const BundledFiles& files) -> Expected<std::size_t> {
    return files.empty() ? Expected<std::size_t>(0)
                         : writeWithManifest(archive, manifestOf(kBackUpKind, files, origin), files);
  });
}

Expected<std::size_t> writeSupportBundle(const fs::path& stateFolder, const fs::path& archive,
                                         const BundleOrigin& origin) {
  base::takesLong("writeSupportBundle");
  std::vector<std::string> leftOut;
  const BundledFiles files = filesOfSupport(stateFolder, leftOut);
  return writeWithManifest(archive, manifestOf(kSupportKind, files, origin, leftOut), files);
}

Expected<BackUp> readBackUp(const fs::path& archive, const BundleLimits& limits) {
  base::takesLong("readBackUp");
  return readBundle(archive, limits).and_then([&](BundledFiles files) {
    return BackUpCheck(archive).check(std::move(files));
  });
}

Expected<std::optional<fs::path>> restoreBackUp(const BackUp& backUp, const fs::path& stateFolder,
                                                const BundleOrigin& now) {
  base::takesLong("restoreBackUp");
  const fs::path kept = StateFolder{stateFolder}.backUps();
  std::error_code error;
  for (const fs::path& folder : {kept, StateFolder{stateFolder}.recipes()}) {
    fs::create_directories(folder, error);
    if (error) {
      return Unexpected(systemProblem(Code::CannotWrite, folder, error.value()));
    }
  }
  const fs::path before = newBackUpFile(kept, now.made);
  const auto count = writeBackUp(stateFolder, before, now);
  if (!count) {
    return Unexpected(count.error());
  }
  return replaceFiles(backUp.files, stateFolder).map([&] { return *count > 0 ? std::optional(before) : std::nullopt; });
}

} // namespace arris::files
