#pragma once

#include "ui/presenters/pattern_lists.h"
#include "ui/presenters/planner.h"

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

namespace arris::ui {

/// How a pattern is read; replaced in tests only.
using ReadPattern = decltype(PlannerSteps::read);

/// A pattern as it is before it is opened. Never changed once made.
struct PatternPreview {
  std::uintmax_t bytes = 0;             ///< of the file; 0 where that is not known
  std::shared_ptr<const Import> import; ///< null: the file could not be read
  Drawing drawing;                      ///< with every problem, also why it could not be read

  /// Something would be seen of it.
  [[nodiscard]] bool canBeOpened() const {
    return import && !(import->pattern.contours.empty() && import->pattern.loose.empty());
  }
};

using PreviewPointer = std::shared_ptr<const PatternPreview>;

enum class ShelfList { Recent, Samples, Folder };

/// The patterns that the operator can open, in three lists, and one of them looked at. Lists and files are read in the
/// background; of each the latest request wins: what an earlier one has under way is given up. Nothing of the present
/// job changes until a pattern is chosen. All functions are called from, and all signals arrive in, the thread of the
/// object.
class PatternShelf : public QObject {
  Q_OBJECT

public:
  explicit PatternShelf(files::StateFolder state, ReadPattern read = plannerSteps().read, QObject* parent = nullptr);
  ~PatternShelf() override; ///< waits until the work under way has given up
  PatternShelf(const PatternShelf&) = delete;
  PatternShelf& operator=(const PatternShelf&) = delete;
  PatternShelf(PatternShelf&&) = delete;
  PatternShelf& operator=(PatternShelf&&) = delete;

  /// Somebody begins to choose: from the list of last time, among these recent ones; patterns are read with `options`.
  void begin(const std::vector<std::string>& recent, const pattern::ImportOptions& options);

  void showList(ShelfList list);

  /// The list of a folder; for a file that of the folder that it is in.
  void showFolder(const std::filesystem::path& place);
  void goUp(); ///< to the folder that the one which is shown lies in

  /// The folder begins where this was opened, unless it is a sample.
  void noteOpened(const std::filesystem::path& file);

  [[nodiscard]] ShelfList list() const {
    return m_list;
  }

  /// Of the list that is shown; the one before until it is there.
  [[nodiscard]] const ShelfListing& listing() const {
    return m_listing;
  }

  void look(const std::filesystem::path& file);

  /// Nothing is looked at any more.
  void lookAway();

  [[nodiscard]] const std::filesystem::path& looked() const {
    return m_looked;
  }

  /// What is looked at; null until it was read.
  [[nodiscard]] const PreviewPointer& preview() const {
    return m_preview;
  }

  [[nodiscard]] bool isReading() const {
    return m_isReading;
  }

  /// There is something to choose: what is looked at can be opened, or is still being read.
  [[nodiscard]] bool canChoose() const;

  /// Chooses what is looked at; what is still being read, as soon as it is seen that it can be opened.
  void choose();

Q_SIGNALS:
  void listed();      ///< see `listing`
  void lookChanged(); ///< see `looked` and `preview`
  void chosen(const std::filesystem::path& file);

private:
  void startListing(const std::function<ShelfListing()>& make);
  void lookAt(const std::filesystem::path& file);
  void show(PreviewPointer preview);

  files::StateFolder m_state;
  ReadPattern m_read;
  std::vector<std::string> m_recent;
  pattern::ImportOptions m_options;
  std::filesystem::path m_folder; // where the list of a folder begins
  ShelfList m_list = ShelfList::Recent;
  ShelfListing m_listing;
  std::filesystem::path m_looked;
  PreviewPointer m_preview;
  bool m_isReading = false;
  bool m_choosesWhenRead = false;
  std::atomic<quint64> m_latestListing = 0;
  std::stop_source m_stopLooking;
  QThreadPool m_lister; // one thread each; last, so that they end before what they use
  QThreadPool m_reader;
};

} // namespace arris::ui
