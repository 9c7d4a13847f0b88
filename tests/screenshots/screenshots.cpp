// Takes pictures of every page in every language, light and dark, at two sizes and in five states of the machine:
// arris_screenshots FOLDER [LANGUAGE…]. The window is the real one, with simulated axes in real time.

#include "tests/support/scratch.h"
#include "ui/main_window.h"
#include "ui/run_window.h"
#include "ui/text/translators.h"

#include <QApplication>
#include <QDir>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>

#include <array>
#include <cstdio>
#include <functional>

namespace arris::ui {
namespace {

using control::State;
using files::Settings;

constexpr int kPatience = 120'000;                                // ms
constexpr std::array kSizes{QSize(1024, 768), QSize(1920, 1080)}; // px
constexpr double kSlowly = 0.1;                                   // feed override, so that the run lasts
constexpr int kOntoGlass = 4;                                     // segments before the wheel is on the glass

class Photographer {
public:
  Photographer(QString folder, QStringList languages)
      : m_folder(std::move(folder)), m_languages(std::move(languages)), m_window(setup(m_scratch)) {
    m_window.show();
  }

  bool takeAll() {
    takeState(QStringLiteral("empty"));
    m_window.openPattern(ARRIS_SOURCE_DIR "/resources/samples/triangle.dxf");
    const bool isWhole = succeeds("plan", waitFor([&] { return m_window.planner().curves() != nullptr; })) &&
                         succeeds("home", switchOn()) && succeeds("load", loadAndTake()) &&
                         succeeds("run", runAndTake());
    return isWhole && succeeds("write", m_failed == 0);
  }

private:
  static MachineSetup setup(const test::Scratch& scratch) {
    MachineSetup setup{{}, {scratch / "state"}, control::Pace::Real};
    setup.machine.setPointLead = 0.2; // a busy computer wakes the thread late
    return setup;
  }

  // What the pictures lack, for whoever looks for them.
  static bool succeeds(const char* what, bool isDone) {
    if (!isDone) {
      std::fprintf(stderr, "arris_screenshots: could not %s\n", what);
    }
    return isDone;
  }

  static bool waitFor(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kPatience);
  }

  bool becomes(State state) {
    return waitFor([&] { return m_window.machine().report().state == state; });
  }

  bool switchOn() {
    m_window.machine().enable();
    if (!waitFor([&] { return m_window.machine().allowed().home; })) {
      return false;
    }
    m_window.machine().home();
    return becomes(State::Idle);
  }

  bool loadAndTake() {
    m_window.machine().load(m_window.planner().plan(), 3);
    if (!waitFor([&] { return m_window.machine().allowed().start; })) {
      return false;
    }
    takeState(QStringLiteral("loaded"));
    return true;
  }

  bool runAndTake() {
    MachineLink& machine = m_window.machine();
    machine.start();
    if (!waitFor([&] { return machine.report().place.segment >= kOntoGlass; })) {
      return false;
    }
    machine.setOverride(kSlowly);
    const double slow = kSlowly * machine.loaded()->job.recipe.feedPerSecond();
    if (!waitFor([&] { return machine.report().speed <= slow + 1e-6; })) {
      return false;
    }
    takeState(QStringLiteral("running"));
    machine.hold();
    if (!becomes(State::Held)) {
      return false;
    }
    takeState(QStringLiteral("held"));
    machine.inject(control::SimulatedFault::DriveFault);
    if (!becomes(State::Faulted)) {
      return false;
    }
    takeState(QStringLiteral("fault"));
    return true;
  }

  void takeState(const QString& state) {
    for (const QString& language : m_languages) {
      for (const auto appearance : {Settings::Appearance::Light, Settings::Appearance::Dark}) {
        Settings settings = m_window.preferences().settings();
        settings.language = language.toStdString();
        settings.appearance = appearance;
        m_window.preferences().change(settings);
        QTest::qWait(1); // the window is made anew by then
        for (const QSize& size : kSizes) {
          m_window.resize(size);
          takePages(QStringLiteral("%1-%2-%3")
                        .arg(language, appearance == Settings::Appearance::Dark ? "dark" : "light",
                             QString::number(size.width())),
                    state);
        }
      }
    }
  }

  void takePages(const QString& folder, const QString& state) {
    const QDir place(m_folder + QLatin1Char('/') + folder);
    place.mkpath(QStringLiteral("."));
    for (QPushButton* page : m_window.findChildren<QPushButton*>(QRegularExpression(QStringLiteral("^page")))) {
      page->click();
      QTest::qWait(kSettle);
      const QString file = place.filePath(QStringLiteral("%1-%2.png").arg(page->objectName().mid(4).toLower(), state));
      m_failed += m_window.grab().save(file) ? 0 : 1;
    }
  }

  static constexpr int kSettle = 30; // ms: layouts settle in turns, reports arrive

  QString m_folder;
  QStringList m_languages;
  test::Scratch m_scratch;
  MainWindow m_window;
  int m_failed = 0;
};

} // namespace
} // namespace arris::ui

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  arris::ui::prepareApplication(application);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() < 2) {
    std::fputs("usage: arris_screenshots FOLDER [LANGUAGE...]\n", stderr);
    return 2;
  }
  const QStringList languages = arguments.size() > 2 ? arguments.mid(2) : arris::ui::spokenLanguages();
  return arris::ui::Photographer(arguments.at(1), languages).takeAll() ? 0 : 1;
}
