#include "ui/presenters/back_ups.h"

#include "core/files/wall_clock.h"
#include "ui/text/file_texts.h"
#include "ui/text/problem_texts.h"

#include <QDate>
#include <QDir>
#include <QLocale>
#include <QSysInfo>

#include <algorithm>
#include <utility>

namespace arris::ui {
namespace {

files::BundleOrigin originOfNow() {
  return {files::wallClock(),
          {{"qt", std::string(qVersion())},
           {"system", QSysInfo::prettyProductName().toStdString()},
           {"kernel", (QSysInfo::kernelType() + QLatin1Char(' ') + QSysInfo::kernelVersion()).toStdString()},
           {"processor", QSysInfo::currentCpuArchitecture().toStdString()},
           {"language", QLocale().name().toStdString()}}};
}

} // namespace

BackUps::BackUps(MachineLink& machine, QObject* parent)
    : QObject(parent), m_machine(machine), m_folder(QDir::homePath()) {
  m_pool.setMaxThreadCount(1);
}

BackUps::~BackUps() {
  m_pool.waitForDone();
}

// `work` runs in the background and gives what is to be done with its result here.
void BackUps::start(const std::function<std::function<void()>()>& work) {
  ++m_tasks;
  m_pool.start([this, work] {
    QMetaObject::invokeMethod(
        this,
        [this, finish = work()] {
          --m_tasks;
          finish();
        },
        Qt::QueuedConnection);
  });
  Q_EMIT changed();
}

void BackUps::tell(const QString& message, std::optional<base::Severity> sign) {
  m_message = message;
  m_sign = sign;
  Q_EMIT changed();
}

void BackUps::tell(const base::Problem& problem) {
  tell(problemText(problem, QLocale()), base::Severity::Error);
}

QString BackUps::suggested(const QString& what) const {
  return QDir(m_folder).filePath(QStringLiteral("%1-%2.tar.gz").arg(what, QDate::currentDate().toString(Qt::ISODate)));
}

void BackUps::saveBackUp(const std::filesystem::path& file) {
  m_folder = folderOfFile(file);
  start([this, file, root = m_machine.folder().root] {
    return [this, file, count = files::writeBackUp(root, file, originOfNow())] { takeSaved(file, count); };
  });
}

void BackUps::saveSupportBundle(const std::filesystem::path& file) {
  m_folder = folderOfFile(file);
  start([this, file, root = m_machine.folder().root] {
    return [this, file, count = files::writeSupportBundle(root, file, originOfNow())] {
      if (count) {
        tell(tr("Saved: %1. It has what help needs; nothing is sent to anybody.").arg(nameOfFile(file)));
      } else {
        tell(count.error());
      }
    };
  });
}

void BackUps::takeSaved(const std::filesystem::path& file, const base::Expected<std::size_t>& count) {
  if (!count) {
    tell(count.error());
  } else if (*count == 0) {
    tell(tr("There is nothing to back up yet: no settings, machine, recipes or counters have been kept so far."),
         base::Severity::Warning);
  } else {
    tell(tr("Saved: %1. Files in it: %2.").arg(nameOfFile(file)).arg(*count));
  }
}

void BackUps::open(const std::filesystem::path& file) {
  if (!mayRestore()) {
    return;
  }
  m_folder = folderOfFile(file);
  m_opened.reset();
  start([this, file] { return [this, backUp = files::readBackUp(file)] { takeOpened(backUp); }; });
}

void BackUps::takeOpened(const base::Expected<files::BackUp>& backUp) {
  if (!backUp) {
    tell(backUp.error());
    return;
  }
  m_opened = *backUp;
  QString made = QString::fromStdString(backUp->made);
  made.replace(QLatin1Char('T'), QLatin1Char(' '));
  tell(tr("Restore the back-up of %1? Its files (%2) replace settings, machine, recipes and counters of the same "
          "names. What is there now is kept as a back-up.")
           .arg(made)
           .arg(backUp->files.size()),
       base::Severity::Warning);
}

void BackUps::giveUp() {
  if (m_opened) {
    m_opened.reset();
    tell(tr("Nothing was changed."));
  }
}

// The counters would be overwritten by what has been counted meanwhile.
void BackUps::restore() {
  if (!m_opened || !mayRestore()) {
    return;
  }
  Q_EMIT restoring(true);
  m_machine.setCounting(false);
  start([this, backUp = *std::exchange(m_opened, std::nullopt), root = m_machine.folder().root] {
    return [this, before = files::restoreBackUp(backUp, root, originOfNow())] { takeRestored(before); };
  });
}

void BackUps::takeRestored(const base::Expected<std::optional<std::filesystem::path>>& before) {
  m_machine.setCounting(true);
  if (!before) {
    Q_EMIT restoring(false);
    tell(problemText(before.error(), QLocale()) + QLatin1Char(' ') + tr("Nothing was changed."), base::Severity::Error);
    return;
  }
  const QString kept =
      *before ? QLatin1Char(' ') + tr("What was there before is in %1.").arg(nameOfFile(**before)) : QString();
  tell(tr("Restored. Close Arris and start it again: then it takes effect.") + kept, base::Severity::Warning);
  Q_EMIT restored();
}

} // namespace arris::ui
