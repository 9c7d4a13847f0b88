#include "ui/widgets/theme.h"

#include "ui/figures/style.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

namespace arris::ui {
namespace {

constexpr int kControlTextHeight = 15; // px

// Of the window; what figures are drawn in stands in figures/style.
struct Greys {
  QRgb window, text, field, alternate, faint, button, pressed, chosen, chosenText, strip, line, lightLine, disabled,
      disabledChosen, head, strong, wrong, wrongField;
};

constexpr Greys kLight{0xe4e6e8, 0x1f2428, 0xffffff, 0xf4f5f6, 0x6b747b, 0xf4f5f6, 0xcdd2d5, 0x44525c, 0xffffff,
                       0xcdd2d5, 0x8a9298, 0xb4babe, 0x70797f, 0xd6dadd, 0xeceeef, 0x1f2428, 0xb3261e, 0xfdf3f2};
constexpr Greys kDark{0x24292d, 0xe6e9eb, 0x181c1f, 0x2b3136, 0x9aa3a9, 0x343b41, 0x4a545c, 0xc3ccd2, 0x181c1f,
                      0x31383d, 0x7d878e, 0x4a545c, 0x8c969d, 0x4a545c, 0x2f363b, 0xffffff, 0xff8a80, 0x3a2322};

QPalette paletteOf(const Greys& greys) {
  QPalette palette;
  palette.setColor(QPalette::Window, greys.window);
  palette.setColor(QPalette::WindowText, greys.text);
  palette.setColor(QPalette::Base, greys.field);
  palette.setColor(QPalette::AlternateBase, greys.alternate);
  palette.setColor(QPalette::Text, greys.text);
  palette.setColor(QPalette::PlaceholderText, greys.faint);
  palette.setColor(QPalette::Button, greys.button);
  palette.setColor(QPalette::ButtonText, greys.text);
  palette.setColor(QPalette::ToolTipBase, greys.alternate);
  palette.setColor(QPalette::ToolTipText, greys.text);
  palette.setColor(QPalette::Highlight, greys.chosen);
  palette.setColor(QPalette::HighlightedText, greys.chosenText);
  palette.setColor(QPalette::Light, greys.alternate);
  palette.setColor(QPalette::Mid, greys.lightLine);
  palette.setColor(QPalette::Dark, greys.line);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, greys.disabled);
  }
  return palette;
}

// The style sheet names the greys with an @.
QString styled(QString sheet, const Greys& greys) {
  const std::pair<const char*, QRgb> names[] = {
      {"@disabledChosen", greys.disabledChosen},
      {"@disabled", greys.disabled},
      {"@chosenText", greys.chosenText},
      {"@chosen", greys.chosen},
      {"@lightLine", greys.lightLine},
      {"@line", greys.line},
      {"@wrongField", greys.wrongField},
      {"@wrong", greys.wrong},
      {"@window", greys.window},
      {"@text", greys.text},
      {"@field", greys.field},
      {"@alternate", greys.alternate},
      {"@button", greys.button},
      {"@pressed", greys.pressed},
      {"@strip", greys.strip},
      {"@head", greys.head},
      {"@strong", greys.strong},
  };
  sheet.replace(QLatin1String("@down"), QLatin1String(appearance() == Appearance::Dark ? "down-dark" : "down"));
  sheet.replace(QLatin1String("@check"), QLatin1String(appearance() == Appearance::Dark ? "check-dark" : "check"));
  for (const auto& [name, colour] : names) {
    sheet.replace(QLatin1String(name), QColor(colour).name());
  }
  return sheet;
}

constexpr const char* kStyleSheet = R"(
QPushButton, QToolButton {
  min-height: 44px; min-width: 44px; padding: 0 10px;
  border: 1px solid @line; border-radius: 4px; background: @button;
}
QPushButton:pressed, QToolButton:pressed { background: @pressed; }
QPushButton:checked, QToolButton:checked { background: @chosen; color: @chosenText; }
QPushButton:disabled, QToolButton:disabled { color: @disabled; border-color: @lightLine; }
QPushButton:checked:disabled, QToolButton:checked:disabled { background: @disabledChosen; }
QPushButton:focus, QToolButton:focus { padding: 0 8px; }
QToolButton[sign="true"], QPushButton[sign="true"] { padding: 0; }
QPushButton[segment="true"] { padding: 0 4px; }
QPushButton[segment="true"]:focus { padding: 0 2px; }
QCheckBox { min-height: 44px; spacing: 6px; border: 2px solid transparent; }
QCheckBox::indicator { width: 26px; height: 26px; border: 2px solid @line; border-radius: 4px; background: @field; }
QCheckBox::indicator:checked { image: url(:/signs/@check.svg); }
QCheckBox:focus { border: 2px solid @strong; }
QLineEdit {
  min-height: 40px; padding: 0 8px; font-size: 18px;
  border: 2px solid @line; border-radius: 4px; background: @field;
}
QPushButton:focus, QToolButton:focus, QLineEdit:focus, QAbstractItemView:focus, QGraphicsView:focus {
  border: 3px solid @strong;
}
QLineEdit:focus { min-height: 38px; padding: 0 7px; }
QLineEdit QToolButton { min-height: 0; min-width: 0; padding: 0; border: none; background: none; }
QLineEdit[invalid="true"] { border-color: @wrong; background: @wrongField; }
QLabel#complaint { border: 2px solid @wrong; border-radius: 4px; background: @wrongField; }
QPushButton#stop, QPushButton#feedHold, QPushButton#cycleStart { min-height: 64px; }
QPushButton#stop, QPushButton#feedHold { padding: 0 2px; }
QPushButton#patternOpen, QPushButton#patternCancel { min-height: 64px; }
QPushButton#patternOpen { font-weight: bold; }
QPushButton#stop { font-weight: bold; font-size: 20px; border: 3px solid @strong; background: @field; }
QPushButton#feedHold, QPushButton#cycleStart, QPushButton#resume { font-weight: bold; border: 2px solid @strong; }
QPushButton#stop:disabled, QPushButton#feedHold:disabled, QPushButton#cycleStart:disabled, QPushButton#resume:disabled {
  border-color: @lightLine;
}
QPushButton#stop:pressed { background: @pressed; }
QWidget#banner { background: @strip; }
QComboBox {
  min-height: 44px; padding: 0 10px; border: 1px solid @line; border-radius: 4px; background: @button;
}
QComboBox:focus { border: 3px solid @strong; }
QComboBox::drop-down { width: 34px; border: none; }
QComboBox::down-arrow { image: url(:/signs/@down.svg); width: 20px; }
QComboBox QAbstractItemView { selection-background-color: @chosen; selection-color: @chosenText; }
QComboBox QAbstractItemView::item { min-height: 44px; }
QFrame#keypad, QFrame#panel { border: 2px solid @line; border-radius: 6px; background: @alternate; }
QWidget#cover { background: @strip; }
QGroupBox { border: 1px solid @lightLine; border-radius: 4px; margin-top: 10px; padding-top: 10px; }
QGroupBox::title { subcontrol-origin: margin; left: 10px; }
QTabBar::tab {
  min-height: 44px; min-width: 44px; padding: 0 14px;
  border: 1px solid @line; border-bottom: none; background: @button;
}
QTabBar::tab:selected { background: @chosen; color: @chosenText; font-weight: bold; }
QTabBar::tab:focus { border: 3px solid @strong; }
QTabWidget::pane { border: 1px solid @lightLine; background: @alternate; }
QTableView { font-size: 14px; }
QHeaderView { font-size: 13px; }
QTableView, QListView, QGraphicsView { border: 1px solid @lightLine; background: @field; }
QHeaderView::section {
  padding: 3px 2px; border: none; border-right: 1px solid @lightLine; border-bottom: 1px solid @line; background: @head;
}
QScrollBar:vertical { width: 24px; background: @head; }
QScrollBar:horizontal { height: 24px; background: @head; }
QScrollBar::handle { background: @line; min-height: 44px; min-width: 44px; border-radius: 4px; margin: 3px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QSplitter::handle { background: @strip; }
QProgressBar { border: 1px solid @line; border-radius: 3px; background: @field; }
QProgressBar::chunk { background: @chosen; }
)";

} // namespace

void applyTheme(QApplication& application) {
  const Greys& greys = appearance() == Appearance::Dark ? kDark : kLight;
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(paletteOf(greys));
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(kControlTextHeight);
  QApplication::setFont(font);
  application.setStyleSheet(styled(QString::fromLatin1(kStyleSheet), greys));
}

Unstyled::Unstyled() : m_styleSheet(qApp->styleSheet()) {
  qApp->setStyleSheet({});
}

Unstyled::~Unstyled() {
  qApp->setStyleSheet(m_styleSheet);
}

} // namespace arris::ui
