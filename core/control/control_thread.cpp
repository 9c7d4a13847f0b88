#include "core/control/control_thread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ctime>

namespace arris::control {

namespace {

constexpr int kNoScheduling = 1;
constexpr int kNoLockedMemory = 2;
constexpr int kKnown = 4;

/// Above all that is not for the machine.
constexpr int kPriority = 80;

/// Axes that take no set-point for so long have stopped, s.
constexpr double kStalled = 0.2;

constexpr long kSecond = 1'000'000'000; // ns

// Once, before the loop.
int askForRealTime() {
  int notAllowed = kKnown;
  const sched_param priority{kPriority};
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) != 0) {
    notAllowed |= kNoScheduling;
  }
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    notAllowed |= kNoLockedMemory;
  }
  return notAllowed;
}

timespec later(timespec time, double seconds) {
  time.tv_nsec += std::lround(seconds * static_cast<double>(kSecond));
  time.tv_sec += time.tv_nsec / kSecond;
  time.tv_nsec %= kSecond;
  return time;
}

double between(const timespec& from, const timespec& to) {
  return static_cast<double>(to.tv_sec - from.tv_sec) +
         static_cast<double>(to.tv_nsec - from.tv_nsec) / static_cast<double>(kSecond);
}

} // namespace

ControlThread::ControlThread(Controller& controller, AxisDriver& driver, double period)
    : m_controller(controller), m_driver(driver), m_period(period), m_worstLead(controller.leadPeriods()),
      m_thread([this] { run(); }) {}

ControlThread::~ControlThread() {
  m_ends = true;
  m_thread.join();
}

Timing ControlThread::timing() const {
  return {m_lateWakeUps, m_worstLead, m_worstLateness};
}

std::string ControlThread::shortcomings() const {
  std::string result;
  const int notAllowed = m_notAllowed;
  if ((notAllowed & kNoScheduling) != 0) {
    result += "real-time scheduling is not allowed (ulimit -r)";
  }
  if ((notAllowed & kNoLockedMemory) != 0) {
    result += result.empty() ? "" : ", ";
    result += "memory cannot be locked (ulimit -l)";
  }
  return result;
}

void ControlThread::run() {
  m_notAllowed = askForRealTime();
  timespec next{};
  clock_gettime(CLOCK_MONOTONIC, &next);
  bool isFirst = true;
  double sinceTaken = 0;
  while (!m_ends) {
    const int left = m_driver.queued();
    if (!isFirst) {
      m_worstLead = std::min(m_worstLead.load(), left);
    }
    isFirst = false;
    supply();
    sinceTaken = left < m_controller.leadPeriods() ? 0 : sinceTaken + m_period;
    if (sinceTaken > kStalled) { // the axes take nothing: the controller has to see it all the same
      const Cycle& cycle = m_controller.advance(m_driver.read());
      static_cast<void>(m_driver.write(cycle.setPoint, cycle.outputs));
    }
    next = later(next, m_period);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr) == EINTR) {
    }
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const double lateness = between(next, now);
    if (lateness > m_period) {
      ++m_lateWakeUps;
      next = now; // set-points that were due are made up for by the lead
    }
    m_worstLateness = std::max(m_worstLateness.load(), lateness);
  }
  m_driver.write(m_driver.read().position, Outputs{});
}

// As many set-points as the axes have taken since.
void ControlThread::supply() {
  while (m_driver.queued() < m_controller.leadPeriods() && !m_ends) {
    const Cycle& cycle = m_controller.advance(m_driver.read());
    if (!m_driver.write(cycle.setPoint, cycle.outputs)) {
      return;
    }
  }
}

} // namespace arris::control
