#include "ui/presenters/profile_files.h"

#include "core/files/profile_csv.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"

#include <utility>

namespace arris::ui {

ProfileFiles::ProfileFiles(ReadProfileFile read, QObject* parent) : QObject(parent), m_read(std::move(read)) {
  m_pool.setMaxThreadCount(1);
}

ProfileFiles::~ProfileFiles() {
  abandon();
  m_ends = true;
  m_pool.waitForDone();
}

void ProfileFiles::open(const std::filesystem::path& file) {
  start([this, number = ++m_latest, file] { read(number, file); });
}

void ProfileFiles::abandon() {
  ++m_latest;
}

void ProfileFiles::close() {
  abandon();
  m_opened.reset();
}

void ProfileFiles::save(const std::filesystem::path& file, const QByteArray& bytes) {
  save(file, [bytes] { return bytes; });
}

void ProfileFiles::save(const std::filesystem::path& file, std::function<QByteArray()> make) {
  write(file, [file, make = std::move(make)] { return files::writeWholeFile(file, make().toStdString()); });
}

void ProfileFiles::exportPlanned(const PlanPointer& plan, const std::filesystem::path& file) {
  write(file, [this, plan, file] {
    return files::writeWholeFile(file, [&](files::Output& output) {
      files::writeProfile(plan->job, output, [&](double /*share*/) {
        if (m_ends) {
          output.abandon();
        }
      });
    });
  });
}

void ProfileFiles::exportRecord(const std::filesystem::path& record, const std::filesystem::path& file) {
  write(file, [record, file] { return files::writeProfileFile(record, file); });
}

void ProfileFiles::write(const std::filesystem::path& file, const std::function<base::Expected<void>()>& produce) {
  start([this, file, produce] {
    if (const auto written = produce(); !written) {
      deliver([this, problem = written.error()] { Q_EMIT failed(problem); });
    } else {
      deliver([this, file] { Q_EMIT saved(file); });
    }
  });
}

void ProfileFiles::start(const std::function<void()>& work) {
  if (m_tasks++ == 0) {
    Q_EMIT busyChanged(true);
  }
  m_pool.start([this, work] {
    work();
    deliver([this] { finished(); });
  });
}

template <typename Call> void ProfileFiles::deliver(Call call) {
  QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
}

// In the worker's thread: of the object it reads only the request number and what never changes.
void ProfileFiles::read(quint64 number, const std::filesystem::path& file) {
  const auto wanted = [this, number] { return m_latest == number; };
  if (!wanted()) {
    return;
  }
  ProfileReading reading = m_read(file, wanted);
  if (!reading.curves) {
    deliver([this, wanted, problem = reading.curves.error()] {
      if (wanted()) {
        Q_EMIT failed(problem);
      }
    });
    return;
  }
  auto curves = std::make_shared<const ProfileCurves>(*std::move(reading.curves));
  deliver([this, wanted, file, curves, damage = std::move(reading.damage)] {
    if (wanted()) {
      m_opened = OpenedProfile{file, curves, damage};
      Q_EMIT opened(curves, damage);
    }
  });
}

void ProfileFiles::finished() {
  if (--m_tasks == 0) {
    Q_EMIT busyChanged(false);
  }
}

} // namespace arris::ui
