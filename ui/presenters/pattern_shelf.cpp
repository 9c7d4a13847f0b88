#include "ui/presenters/pattern_shelf.h"

#include <QDir>

#include <utility>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;

PreviewPointer previewOf(const fs::path& file, const ReadPattern& read, const pattern::ImportOptions& options,
                         const std::stop_token& stop) {
  auto preview = std::make_shared<PatternPreview>();
  std::error_code failure;
  const std::uintmax_t bytes = fs::file_size(file, failure);
  preview->bytes = failure ? 0 : bytes;
  if (base::Expected<Import> import = read(file, options, {stop, {}})) {
    preview->import = std::make_shared<const Import>(*std::move(import));
    preview->drawing = drawingOf(preview->import->pattern);
  } else {
    preview->drawing.problems = {import.error()};
  }
  return preview;
}

} // namespace

PatternShelf::PatternShelf(files::StateFolder state, ReadPattern read, QObject* parent)
    : QObject(parent), m_state(std::move(state)), m_read(std::move(read)), m_folder(QDir::homePath().toStdString()) {
  m_lister.setMaxThreadCount(1);
  m_reader.setMaxThreadCount(1);
}

PatternShelf::~PatternShelf() {
  ++m_latestListing;
  m_stopLooking.request_stop();
  m_lister.waitForDone();
  m_reader.waitForDone();
}

void PatternShelf::begin(const std::vector<std::string>& recent, const pattern::ImportOptions& options) {
  m_recent = recent;
  m_options = options;
  lookAway();
  showList(m_list);
}

void PatternShelf::showList(ShelfList list) {
  m_list = list;
  switch (list) {
  case ShelfList::Recent:
    startListing([recent = m_recent] { return listRecent(recent); });
    break;
  case ShelfList::Samples:
    startListing([state = m_state] { return listSamples(state); });
    break;
  case ShelfList::Folder:
    startListing([folder = m_folder] { return listFolder(folder); });
    break;
  }
}

void PatternShelf::showFolder(const fs::path& place) {
  m_list = ShelfList::Folder;
  startListing([place] { return listFolder(place); });
}

void PatternShelf::goUp() {
  m_list = ShelfList::Folder;
  startListing([below = m_listing.folder] {
    ShelfListing listing = listFolder(below.parent_path());
    listing.chosen = below;
    return listing;
  });
}

void PatternShelf::noteOpened(const fs::path& file) {
  std::error_code failure;
  const fs::path folder = fs::absolute(file, failure).parent_path();
  if (!failure && folder != fs::absolute(m_state.samples(), failure)) {
    m_folder = folder;
  }
}

void PatternShelf::startListing(const std::function<ShelfListing()>& make) {
  m_lister.start([this, number = ++m_latestListing, make] {
    if (number != m_latestListing) {
      return;
    }
    auto made = std::make_shared<const ShelfListing>(make());
    const auto take = [this, number, made] {
      if (number == m_latestListing) {
        m_listing = *made;
        if (m_list == ShelfList::Folder && !made->problem) {
          m_folder = made->folder;
        }
        Q_EMIT listed();
      }
    };
    QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
  });
}

void PatternShelf::look(const fs::path& file) {
  lookAt(file);
  m_isReading = true;
  m_reader.start([this, stop = m_stopLooking.get_token(), file, options = m_options] {
    if (stop.stop_requested()) {
      return;
    }
    const PreviewPointer preview = previewOf(file, m_read, options, stop);
    const auto take = [this, stop, preview] {
      if (!stop.stop_requested()) {
        show(preview);
      }
    };
    QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
  });
  Q_EMIT lookChanged();
}

void PatternShelf::lookAway() {
  lookAt({});
  Q_EMIT lookChanged();
}

// What was looked at before is given up.
void PatternShelf::lookAt(const fs::path& file) {
  m_stopLooking.request_stop();
  m_stopLooking = std::stop_source();
  m_looked = file;
  m_preview.reset();
  m_isReading = false;
  m_choosesWhenRead = false;
}

void PatternShelf::show(PreviewPointer preview) {
  m_preview = std::move(preview);
  m_isReading = false;
  Q_EMIT lookChanged();
  if (std::exchange(m_choosesWhenRead, false)) {
    choose();
  }
}

bool PatternShelf::canChoose() const {
  return m_isReading || (m_preview && m_preview->canBeOpened());
}

void PatternShelf::choose() {
  if (m_isReading) {
    m_choosesWhenRead = true;
  } else if (canChoose()) {
    const fs::path file = m_looked; // whoever hears of it may look away
    Q_EMIT chosen(file);
  }
}

} // namespace arris::ui
