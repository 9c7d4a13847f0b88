#include "core/files/record_folder.h"

#include "core/files/descriptor.h"
#include "core/files/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

namespace arris::files {
namespace {

namespace fs = std::filesystem;
using base::Code;
using base::Expected;
using base::Unexpected;

constexpr std::string_view kRecordBeginning = "run-";

struct RecordFile {
  fs::path path;
  fs::file_time_type changed;
  std::uintmax_t size = 0;
};

// A folder that is not there yet has no records.
Expected<std::vector<RecordFile>> recordsIn(const fs::path& folder) {
  std::vector<RecordFile> records;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code gone; // another program may delete it meanwhile
    if (name.starts_with(kRecordBeginning) && name.ends_with(kRecordEnding) &&
        entry->symlink_status(gone).type() == fs::file_type::regular) {
      RecordFile record{entry->path(), entry->last_write_time(gone), 0};
      record.size = gone ? 0 : entry->file_size(gone);
      if (!gone) {
        records.push_back(std::move(record));
      }
    }
  }
  if (error && error != std::errc::no_such_file_or_directory) {
    return Unexpected(systemProblem(Code::CannotRead, folder, error.value()));
  }
  return records;
}

} // namespace

fs::path newRecordFile(const fs::path& folder, std::string_view startTime) {
  std::string name = fmt::format("{}{}", kRecordBeginning, startTime);
  constexpr std::string_view kAllowed = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-.";
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return kAllowed.find(c) == std::string_view::npos; }, '-');
  fs::path file = folder / fmt::format("{}{}", name, kRecordEnding);
  std::error_code none;
  for (int number = 2; fs::exists(fs::symlink_status(file, none)); ++number) {
    file = folder / fmt::format("{}-{}{}", name, number, kRecordEnding);
  }
  return file;
}

Expected<void> dropOldRecords(const fs::path& folder, std::size_t most, std::uintmax_t mostBytes) {
  auto records = recordsIn(folder);
  if (!records) {
    return Unexpected(records.error());
  }
  std::sort(records->begin(), records->end(), [](const RecordFile& a, const RecordFile& b) {
    return std::tie(a.changed, a.path) > std::tie(b.changed, b.path); // newest first
  });
  Expected<void> result;
  std::size_t count = 0;
  std::uintmax_t bytes = 0;
  for (const RecordFile& record : *records) {
    ++count;
    bytes += record.size;
    std::error_code error;
    if (count > 1 && (count > most || bytes > mostBytes) && !fs::remove(record.path, error) && error && result) {
      result = Unexpected(systemProblem(Code::CannotWrite, record.path, error.value()));
    }
  }
  return result;
}

} // namespace arris::files
