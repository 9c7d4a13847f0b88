#include "ui/presenters/pattern_lists.h"

#include "core/files/descriptor.h"
#include "core/files/whole_file.h"

#include <QDir>
#include <QFile>

#include <algorithm>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFirstSample = "balustrade.dxf";

bool isFileThere(const fs::path& file) {
  std::error_code failure;
  return fs::is_regular_file(file, failure); // reading a pipe would not end
}

base::Expected<void> unpackMissing(const QFileInfo& sample, const fs::path& to) {
  std::error_code failure;
  if (fs::exists(to, failure)) {
    return {};
  }
  QFile packed(sample.filePath());
  packed.open(QIODevice::ReadOnly);
  return files::writeWholeFile(to, packed.readAll().toStdString());
}

} // namespace

std::vector<fs::path> stillThere(const std::vector<std::string>& files) {
  std::vector<fs::path> there(files.begin(), files.end());
  there.erase(std::remove_if(there.begin(), there.end(), [](const fs::path& file) { return !isFileThere(file); }),
              there.end());
  return there;
}

ShelfListing listRecent(const std::vector<std::string>& files) {
  ShelfListing listing;
  for (const fs::path& file : stillThere(files)) {
    listing.entries.push_back({file, false});
  }
  return listing;
}

ShelfListing listFolder(const fs::path& place) {
  ShelfListing listing;
  listing.folder = QDir::cleanPath(QDir(QString::fromStdString(place.string())).absolutePath()).toStdString();
  if (isFileThere(listing.folder)) {
    listing.chosen = listing.folder;
    listing.folder = listing.folder.parent_path();
  }
  std::error_code failure;
  if (const fs::directory_iterator readable(listing.folder, failure); failure) {
    listing.problem = files::systemProblem(base::Code::CannotOpen, listing.folder, failure.value());
  }
  const QDir folder(QString::fromStdString(listing.folder.string()));
  for (const QFileInfo& entry :
       folder.entryInfoList({QStringLiteral("*.dxf")}, QDir::AllDirs | QDir::Files | QDir::NoDotAndDotDot,
                            QDir::DirsFirst | QDir::Name | QDir::IgnoreCase | QDir::LocaleAware)) {
    listing.entries.push_back({entry.filePath().toStdString(), entry.isDir()});
  }
  const ShelfEntry typed{listing.chosen, false};
  if (!typed.path.empty() &&
      std::find(listing.entries.begin(), listing.entries.end(), typed) == listing.entries.end()) {
    listing.entries.push_back(typed);
  }
  return listing;
}

ShelfListing listSamples(const files::StateFolder& state) {
  ShelfListing listing;
  std::error_code failure;
  fs::create_directories(state.samples(), failure); // where that fails the writes tell why
  for (const QFileInfo& sample : QDir(QStringLiteral(":/samples")).entryInfoList(QDir::Files, QDir::Name)) {
    const fs::path file = state.samples() / sample.fileName().toStdString();
    if (const auto written = unpackMissing(sample, file); !written) {
      listing.problem = written.error();
    } else {
      listing.entries.push_back({file, false});
    }
  }
  return listing;
}

base::Expected<fs::path> firstSample(const files::StateFolder& state) {
  const ShelfListing samples = listSamples(state);
  const ShelfEntry first{state.samples() / kFirstSample, false};
  if (std::find(samples.entries.begin(), samples.entries.end(), first) == samples.entries.end()) {
    return base::Unexpected(*samples.problem);
  }
  return first.path;
}

} // namespace arris::ui
