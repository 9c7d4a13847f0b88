#pragma once

#include "ui/figures/profile_file.h"
#include "ui/presenters/planner.h"

#include <QByteArray>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <filesystem>
#include <functional>

namespace arris::ui {

/// How a profile is read; replaced in tests only.
using ReadProfileFile =
    std::function<ProfileReading(const std::filesystem::path& file, const std::function<bool()>& wanted)>;

/// Reads exported profiles and records of runs in the background, and writes pictures of them. Of openings the latest
/// wins: what an earlier one yields after it is dropped. All functions are called from, and all signals arrive in, the
/// thread of the object.
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

  /// Writes the bytes, whole or not at all.
  void save(const std::filesystem::path& file, const QByteArray& bytes);

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
  void finished();

  ReadProfileFile m_read;
  std::atomic<quint64> m_latest = 0;
  int m_tasks = 0;
  QThreadPool m_pool; // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
