#include "ui/widgets/theme.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

namespace arris::ui {
namespace {

constexpr int kControlTextHeight = 15; // px

QPalette greys() {
  QPalette palette;
  palette.setColor(QPalette::Window, QColor(0xe4e6e8));
  palette.setColor(QPalette::WindowText, QColor(0x1f2428));
  palette.setColor(QPalette::Base, QColor(0xffffff));
  palette.setColor(QPalette::AlternateBase, QColor(0xf4f5f6));
  palette.setColor(QPalette::Text, QColor(0x1f2428));
  palette.setColor(QPalette::PlaceholderText, QColor(0x6b747b));
  palette.setColor(QPalette::Button, QColor(0xf4f5f6));
  palette.setColor(QPalette::ButtonText, QColor(0x1f2428));
  palette.setColor(QPalette::Highlight, QColor(0x44525c));
  palette.setColor(QPalette::HighlightedText, QColor(0xffffff));
  palette.setColor(QPalette::Mid, QColor(0xb4babe));
  palette.setColor(QPalette::Dark, QColor(0x8a9298));
  return palette;
}

constexpr const char* kStyleSheet = R"(
QPushButton, QToolButton {
  min-height: 44px; min-width: 44px; padding: 0 10px;
  border: 1px solid #8a9298; border-radius: 4px; background: #f4f5f6;
}
QPushButton:pressed, QToolButton:pressed { background: #cdd2d5; }
QPushButton:checked, QToolButton:checked { background: #44525c; color: #ffffff; }
QPushButton:disabled, QToolButton:disabled { color: #8a9298; border-color: #c6cbce; }
QPushButton:checked:disabled, QToolButton:checked:disabled { background: #d6dadd; }
QToolButton[sign="true"], QPushButton[sign="true"] { padding: 0; }
QCheckBox { min-height: 44px; spacing: 6px; border: 2px solid transparent; }
QCheckBox::indicator { width: 26px; height: 26px; border: 2px solid #8a9298; border-radius: 4px; background: #ffffff; }
QCheckBox::indicator:checked { image: url(:/signs/check.svg); }
QCheckBox:focus { border: 2px solid #1f2428; }
QLineEdit {
  min-height: 40px; padding: 0 8px; font-size: 18px;
  border: 2px solid #8a9298; border-radius: 4px; background: #ffffff;
}
QPushButton:focus, QToolButton:focus, QLineEdit:focus, QAbstractItemView:focus, QGraphicsView:focus {
  border: 3px solid #1f2428;
}
QLineEdit:focus { min-height: 38px; padding: 0 7px; }
QLineEdit QToolButton { min-height: 0; min-width: 0; padding: 0; border: none; background: none; }
QLineEdit[invalid="true"] { border-color: #b3261e; background: #fdf3f2; }
QLabel#complaint { border: 2px solid #b3261e; border-radius: 4px; background: #fdf3f2; }
QPushButton#stop, QPushButton#feedHold, QPushButton#cycleStart { min-height: 64px; }
QPushButton#stop, QPushButton#feedHold { padding: 0 2px; }
QPushButton#stop { font-weight: bold; font-size: 20px; border: 3px solid #1f2428; background: #ffffff; }
QPushButton#feedHold, QPushButton#cycleStart, QPushButton#resume { font-weight: bold; border: 2px solid #1f2428; }
QPushButton#stop:disabled, QPushButton#feedHold:disabled, QPushButton#cycleStart:disabled, QPushButton#resume:disabled {
  border-color: #c6cbce;
}
QPushButton#stop:pressed { background: #cdd2d5; }
QWidget#banner { background: #cdd2d5; }
QGroupBox { border: 1px solid #b4babe; border-radius: 4px; margin-top: 10px; padding-top: 10px; }
QGroupBox::title { subcontrol-origin: margin; left: 10px; }
QTabBar::tab {
  min-height: 44px; min-width: 44px; padding: 0 14px;
  border: 1px solid #b4babe; border-bottom: none; background: #d6dadd;
}
QTabBar::tab:selected { background: #f4f5f6; font-weight: bold; }
QTabBar::tab:focus { border: 3px solid #1f2428; }
QTabWidget::pane { border: 1px solid #b4babe; background: #f4f5f6; }
QTableView { font-size: 14px; }
QHeaderView { font-size: 13px; }
QTableView, QListView, QGraphicsView { border: 1px solid #b4babe; background: #ffffff; }
QHeaderView::section {
  padding: 3px 2px; border: none; border-right: 1px solid #d6dadd; border-bottom: 1px solid #8a9298; background: #eceeef;
}
QScrollBar:vertical { width: 24px; background: #eceeef; }
QScrollBar:horizontal { height: 24px; background: #eceeef; }
QScrollBar::handle { background: #a9b0b5; min-height: 44px; min-width: 44px; border-radius: 4px; margin: 3px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QSplitter::handle { background: #cdd2d5; }
QProgressBar { border: 1px solid #8a9298; border-radius: 3px; background: #ffffff; }
QProgressBar::chunk { background: #44525c; }
)";

} // namespace

void applyTheme(QApplication& application) {
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(greys());
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(kControlTextHeight);
  QApplication::setFont(font);
  application.setStyleSheet(QString::fromLatin1(kStyleSheet));
}

} // namespace arris::ui
