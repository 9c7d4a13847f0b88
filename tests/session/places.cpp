// Tells where a hand finds the buttons of the window: arris_places WIDTH HEIGHT prints a line "page.button x y" for
// each one in sight, and "dialog.button x y" for those of the dialog for patterns, in pixels from the upper left corner
// of the window or the dialog. It lays out the real window without a display, so whoever drives one needs no fixed
// places.

#include "tests/support/scratch.h"
#include "ui/main_window.h"
#include "ui/pages/pattern_dialog.h"
#include "ui/run_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTest>

#include <cstdio>

namespace {

constexpr int kSettle = 50; // ms: layouts settle in turns

void printPlaces(const std::string& part, const QWidget& window) {
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    const bool isTapped = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget);
    if (isTapped && widget->isVisible() && !widget->objectName().isEmpty()) {
      const QPoint place = widget->mapTo(&window, widget->rect().center());
      std::printf("%s.%s %d %d\n", part.c_str(), qPrintable(widget->objectName()), place.x(), place.y());
    }
  }
}

} // namespace

int main(int argc, char** argv) {
  using namespace arris;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  if (argc != 3) {
    std::fputs("usage: arris_places WIDTH HEIGHT\n", stderr);
    return 2;
  }
  ui::prepareApplication(application);
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  const test::Scratch scratch;
  ui::MainWindow window({{}, {scratch / "state"}, control::Pace::Simulated});
  window.resize(std::atoi(argv[1]), std::atoi(argv[2]));
  window.show();
  for (auto* page : window.findChildren<QAbstractButton*>(QRegularExpression(QStringLiteral("^page")))) {
    page->click();
    QTest::qWait(kSettle);
    printPlaces(page->objectName().toStdString(), window);
  }
  window.findChild<QAbstractButton*>(QStringLiteral("open"))->click();
  QTest::qWait(kSettle);
  const auto* dialog = window.findChild<ui::PatternDialog*>();
  dialog->findChild<QAbstractButton*>(QStringLiteral("patternsFolder"))->click();
  QTest::qWait(kSettle);
  printPlaces("dialog", *dialog);
  return 0;
}
