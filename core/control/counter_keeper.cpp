#include "core/control/counter_keeper.h"

#include "core/files/set_aside.h"
#include "core/files/whole_file.h"

#include <algorithm>
#include <utility>

namespace arris::control {
namespace {

// A step back and forth goes over what has been ground already.
bool goesAlongGlass(const Report& report) {
  const bool works = report.state == State::Running || report.state == State::Holding;
  return works && report.isInMotion && report.kind == program::Kind::Job && motion::isAlongContour(report.move);
}

} // namespace

CounterKeeper::CounterKeeper(std::filesystem::path file, double period, std::string now)
    : m_file(std::move(file)), m_period(period) {
  m_before.since = std::move(now);
  m_writer.emplace(m_file);
  std::error_code none;
  if (std::filesystem::exists(m_file, none)) {
    read();
  }
  m_written = m_before;
}

CounterKeeper::~CounterKeeper() {
  write();
}

void CounterKeeper::read() {
  const auto text = files::readFile(m_file);
  if (!text) { // perhaps it can be read another time
    m_damage = text.error();
    m_writer.reset();
    return;
  }
  const files::Read<files::Counters> counters = files::readCounters(*text, m_file.filename().string());
  if (!base::hasErrors(counters.problems)) {
    m_before = counters.value;
    return;
  }
  if (const auto kept = files::setAside(m_file); kept) {
    m_damage = base::Problem(base::Code::CountersDamaged, {{"file", m_file.string()}, {"kept", kept->string()}});
  } else {
    m_damage = kept.error();
    m_writer.reset();
  }
}

void CounterKeeper::add(const Report& report) {
  const bool isFirst = m_tick < 0;
  const std::int64_t periods = isFirst ? 1 : std::max<std::int64_t>(0, report.tick - m_tick);
  const bool isAlong = goesAlongGlass(report);
  m_drivesOn += report.drivesReady ? periods : 0;
  m_spindleOn += report.outputs.spindleSpeed > 0 ? periods : 0;
  m_grinding += isAlong ? periods : 0;
  m_ground += isAlong && m_wasAlong ? std::max(0.0, report.path - m_path) : 0;
  m_panes += isFirst ? 0 : std::max<std::int64_t>(0, report.jobsEnded - m_jobsEnded);
  m_tick = report.tick;
  m_wasAlong = isAlong;
  m_path = report.path;
  m_jobsEnded = report.jobsEnded;
  if (m_tick >= m_dueTick) {
    m_dueTick = m_tick + static_cast<std::int64_t>(kCountersEvery / m_period);
    write();
  }
}

files::Counters CounterKeeper::counters() const {
  files::Counters now = m_before;
  now.drivesOn += static_cast<double>(m_drivesOn) * m_period;
  now.spindleOn += static_cast<double>(m_spindleOn) * m_period;
  now.grinding += static_cast<double>(m_grinding) * m_period;
  now.ground += m_ground;
  now.panes += m_panes;
  return now;
}

void CounterKeeper::write() {
  const files::Counters now = counters();
  if (!m_writer || now == m_written) {
    return;
  }
  std::error_code none; // whatever it is the writer meets it again
  std::filesystem::create_directories(m_file.parent_path(), none);
  m_writer->write(files::writeCounters(now));
  m_written = now;
}

std::optional<base::Problem> CounterKeeper::takeFailure() {
  return m_writer ? m_writer->failure() : std::nullopt;
}

} // namespace arris::control
