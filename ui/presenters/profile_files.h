#pragma once

#include "ui/figures/profile_file.h"
#include "ui/presenters/planner.h"

#include <QByteArray>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>

namespace arris::ui {

/// How a profile is read; replaced in tests only.
using ReadProfileFile =
    std::function<ProfileReading(const std::filesystem::path& file, const std::function<bool()>& wanted)>;

/// What was opened last.
struct OpenedProfile {
  std::filesystem::path file;
  CurvesPointer curves;  ///< under the name of the file
  base::Problems damage; ///< of a record that is not whole
};

/// Reads exported profiles and records of runs in the background, keeps what was opened last, and writes profiles and
/// pictures of them. Of openings the latest wins: what an earlier one yields after it is dropped. All functions are
/// called from, and all signals arrive in, the thread of the object.
class ProfileFiles : public QObject {
  Q_OBJECT

public:
  explicit ProfileFiles(ReadProfileFile read = readProfileFile, QObject* parent = nullptr);
  ~ProfileFiles() override; ///< waits for the work under way
  ProfileFiles(const ProfileFiles&) = delete;
  ProfileFiles& operator=(const ProfileFiles&) = delete;
  ProfileFiles(ProfileFiles&&) = delete;
  ProfileFiles& operator=(ProfileFiles&&) = delete;

  void open(const std::filesystem::path& file);

  /// What is being opened is no longer wanted.
  void abandon();

  /// What was opened is no longer kept, nor what is being opened wanted.
  void close();

  /// The latest that could be opened; nothing before, and once it was closed.
  [[nodiscard]] const std::optional<OpenedProfile>& lastOpened() const {
    return m_opened;
  }

  /// Writes the bytes, whole or not at all.
  void save(const std::filesystem::path& file, const QByteArray& bytes);

  /// The same for bytes that take long to make; `make` is called in another thread.
  void save(const std::filesystem::path& file, std::function<QByteArray()> make);

  /// Writes the profile of a planned job as CSV, a row for each period, whole or not at all. For jobs that can be
  /// ground.
  void exportPlanned(const PlanPointer& plan, const std::filesystem::path& file);

  /// The same for the record of a run.
  void exportRecord(const std::filesystem::path& record, const std::filesystem::path& file);

  /// Something asked for is not done yet.
  [[nodiscard]] bool isBusy() const {
    return m_tasks > 0;
  }

Q_SIGNALS:
  void busyChanged(bool busy);
  /// The curves of the file that was asked for last, under its name; with `damage` where it is a record that is not
  /// whole.
  void opened(const arris::ui::CurvesPointer& curves, const arris::base::Problems& damage);
  void saved(const std::filesystem::path& file);
  /// The file could not be opened or written.
  void failed(const arris::base::Problem& problem);

private:
  void start(const std::function<void()>& work);
  template <typename Call> void deliver(Call call);
  void read(quint64 number, const std::filesystem::path& file);
  void write(const std::filesystem::path& file, const std::function<base::Expected<void>()>& produce);
  void finished();

  ReadProfileFile m_read;
  std::optional<OpenedProfile> m_opened;
  std::atomic<quint64> m_latest = 0;
  std::atomic<bool> m_ends = false; // what is being exported is given up
  int m_tasks = 0;
  QThreadPool m_pool; // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
