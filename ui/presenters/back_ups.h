#pragma once

#include "core/files/back_up.h"
#include "ui/presenters/machine_link.h"

#include <QString>
#include <QThreadPool>

#include <filesystem>
#include <functional>
#include <optional>

namespace arris::ui {

/// Saves and restores back-ups of the machine's state folder and saves support bundles, in the background, and says
/// what came of it. A back-up that has been opened is restored only once that is confirmed, and while nothing of the
/// machine is in use.
class BackUps : public QObject {
  Q_OBJECT

public:
  /// Refers to the machine.
  explicit BackUps(MachineLink& machine, QObject* parent = nullptr);
  ~BackUps() override; ///< waits for the work under way
  BackUps(const BackUps&) = delete;
  BackUps& operator=(const BackUps&) = delete;
  BackUps(BackUps&&) = delete;
  BackUps& operator=(BackUps&&) = delete;

  void saveBackUp(const std::filesystem::path& file);
  void saveSupportBundle(const std::filesystem::path& file);

  /// Reads a back-up and checks it; then it waits for `restore`.
  void open(const std::filesystem::path& file);

  /// Restores what was opened.
  void restore();

  /// What was opened is not restored.
  void giveUp();

  [[nodiscard]] bool isBusy() const {
    return m_tasks > 0;
  }

  /// A back-up can be opened, and what was opened be restored.
  [[nodiscard]] bool mayRestore() const {
    return !isBusy() && m_machine.allowed().restore;
  }

  /// The back-up that waits to be restored.
  [[nodiscard]] const std::optional<files::BackUp>& opened() const {
    return m_opened;
  }

  /// What came of the last of these, or what is asked; empty before the first.
  [[nodiscard]] const QString& message() const {
    return m_message;
  }

  /// The sign beside it.
  [[nodiscard]] std::optional<base::Severity> sign() const {
    return m_sign;
  }

  /// Where the last file was.
  [[nodiscard]] const QString& folder() const {
    return m_folder;
  }

  /// A name for a file of today: "arris-back-up-2031-05-06.tar.gz", in the folder that was chosen last.
  [[nodiscard]] QString suggested(const QString& what) const;

Q_SIGNALS:
  void changed();
  /// The files of the state folder are being replaced: whoever keeps them must not write them any more. False where
  /// they have not been replaced after all.
  void restoring(bool restores);
  /// They have been replaced.
  void restored();

private:
  void start(const std::function<std::function<void()>()>& work);
  void tell(const QString& message, std::optional<base::Severity> sign = std::nullopt);
  void tell(const base::Problem& problem);
  void takeSaved(const std::filesystem::path& file, const base::Expected<std::size_t>& count);
  void takeOpened(const base::Expected<files::BackUp>& backUp);
  void takeRestored(const base::Expected<std::optional<std::filesystem::path>>& before);

  MachineLink& m_machine;
  std::optional<files::BackUp> m_opened;
  QString m_message;
  std::optional<base::Severity> m_sign;
  QString m_folder; // where the last file was
  int m_tasks = 0;
  QThreadPool m_pool; // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
