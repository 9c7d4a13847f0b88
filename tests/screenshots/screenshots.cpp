// Takes pictures of every page in every language, light and dark, at two sizes and in five states of the machine, and
// of every part of the pages and what opens beside them with a job loaded: arris_screenshots FOLDER [LANGUAGE…]. The
// window is the real one, with simulated axes in real time.

#include "tests/support/scratch.h"
#include "tests/ui/support/page_parts.h"
#include "ui/main_window.h"
#include "ui/run_window.h"
#include "ui/text/translators.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/wipe_cover.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
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
    m_place = QDir(m_folder + QLatin1Char('/') + folder);
    m_place.mkpath(QStringLiteral("."));
    for (QPushButton* page : m_window.findChildren<QPushButton*>(QRegularExpression(QStringLiteral("^page")))) {
      page->click();
      take(page->objectName().mid(4).toLower() + QLatin1Char('-') + state);
    }
    if (state == QLatin1String("loaded")) {
      takeParts();
      takeCorner();
      takeMoreValues();
      takeBeside();
    } else if (state == QLatin1String("running")) {
      m_window.close();
      takeDialog(QStringLiteral("job-close"));
    }
  }

  void take(const QString& name) {
    QTest::qWait(kSettle);
    m_failed += m_window.grab().save(m_place.filePath(name + QStringLiteral(".png"))) ? 0 : 1;
  }

  void tap(const char* name) {
    m_window.findChild<QAbstractButton*>(QLatin1String(name))->click();
  }

  void takeParts() {
    for (const test::PagePart& part : test::kPageParts) {
      if (part.part != nullptr) {
        tap(part.page);
        tap(part.part);
        take(QStringLiteral("%1-%2").arg(QLatin1String(part.page).mid(4), QLatin1String(part.part)).toLower());
      }
    }
  }

  void takeCorner() {
    tap("pageJob");
    auto* corners = m_window.findChild<QTableView*>(QStringLiteral("corners"));
    QTest::mouseClick(corners->viewport(), Qt::LeftButton, {},
                      corners->visualRect(corners->model()->index(1, 1)).center());
    take(QStringLiteral("job-corner"));
    corners->setCurrentIndex({});
    tap("fit");
  }

  void takeMoreValues() {
    tap("showMore");
    const auto* heading = m_window.findChild<QLabel*>(QStringLiteral("moreHeading"));
    const QString first = heading->text();
    int page = 1;
    do {
      take(QStringLiteral("job-more-%1").arg(page++));
      tap("moreOn");
    } while (heading->text() != first);
    tap("showGrinding");
  }

  void takeBeside() {
    tap("pageJob");
    tap("open");
    takeDialog(QStringLiteral("job-patterns"));
    tap("recipes");
    takeDialog(QStringLiteral("job-recipes"));
    setKeypadOpens(KeypadOpens::OnEveryTap);
    QTest::mouseClick(m_window.findChild<QLineEdit*>(QStringLiteral("depth_mm")), Qt::LeftButton);
    setKeypadOpens(KeypadOpens::OnTouch);
    take(QStringLiteral("job-keypad"));
    delete m_window.findChild<Keypad*>();
    tap("lockScreen");
    take(QStringLiteral("job-locked"));
    auto* cover = m_window.findChild<WipeCover*>();
    cover->hide();
    Q_EMIT cover->ended();
  }

  // The dialog as it lies over the window.
  void takeDialog(const QString& name) {
    QTest::qWait(kSettle);
    QPixmap picture = m_window.grab();
    QPainter painter(&picture);
    for (QDialog* dialog : m_window.findChildren<QDialog*>()) {
      if (dialog->isVisible()) {
        painter.drawPixmap(dialog->frameGeometry().topLeft() - m_window.geometry().topLeft(), dialog->grab());
        dialog->close();
      }
    }
    painter.end();
    m_failed += picture.save(m_place.filePath(name + QStringLiteral(".png"))) ? 0 : 1;
  }

  static constexpr int kSettle = 30; // ms: layouts settle in turns, reports arrive

  QString m_folder;
  QStringList m_languages;
  QDir m_place; ///< of the language, appearance and size
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
