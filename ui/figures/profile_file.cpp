#include "ui/figures/profile_file.h"

#include "core/base/window_thread.h"
#include "core/files/descriptor.h"
#include "core/files/profile_csv.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"
#include "ui/text/file_texts.h"

#include <cerrno>
#include <string>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;

base::Expected<ProfileCurves> curvesOfRecord(const fs::path& file, const ProfileColumns& columns, std::size_t rows) {
  if (rows == 0) {
    return base::Unexpected(base::Problem(base::Code::RecordMalformed,
                                          {{"file", file.string()}, {"reason", std::string("it has no rows")}}));
  }
  if (rows > kMostRowsOfProfile) {
    return base::Unexpected(files::systemProblem(base::Code::CannotRead, file, EFBIG));
  }
  return curvesOf(columns, nameOfFile(file));
}

// Row by row, since a record may be long.
ProfileReading readRun(const fs::path& file, const std::function<bool()>& wanted) {
  ProfileColumns columns;
  std::size_t rows = 0;
  const auto take = [&](const files::RunRow& run) {
    if (++rows <= kMostRowsOfProfile && wanted()) {
      append(columns, run.row);
    }
  };
  const auto record = files::readRecord(file, {take, {}});
  if (!record) {
    return {base::Unexpected(record.error()), {}};
  }
  return {curvesOfRecord(file, columns, rows), record->damage};
}

base::Expected<ProfileCurves> readTable(const fs::path& file) {
  return files::readFile(file)
      .and_then([&](const std::string& text) { return files::readProfile(text, file.string()); })
      .map([&](const std::vector<files::ProfileRow>& rows) { return curvesOf(columnsOf(rows), nameOfFile(file)); });
}

} // namespace

ProfileReading readProfileFile(const fs::path& file, const std::function<bool()>& wanted) {
  base::takesLong("readProfileFile");
  return files::isRecord(file) ? readRun(file, wanted) : ProfileReading{readTable(file), {}};
}

} // namespace arris::ui
