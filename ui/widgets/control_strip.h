#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QButtonGroup;
class QPushButton;
class QVBoxLayout;

namespace arris::ui {

/// The strip beside every page: the pages to choose from, the lock of the screen, and FEED HOLD and STOP, enabled while
/// something moves or may begin to.
class ControlStrip : public QWidget {
  Q_OBJECT

public:
  static constexpr int kWidth = 112; ///< px

  explicit ControlStrip(MachineLink& machine, QWidget* parent = nullptr);

  void addPage(const QString& text, const QString& name);
  void showPage(int page);

  /// Only FEED HOLD and STOP answer while it is locked.
  void setLocked(bool locked);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void pageChosen(int page);
  void lockRequested(); ///< of the screen, to wipe it

private:
  QPushButton* addStop(const QString& text, const QString& name);
  void enableStops();
  void stopBesidePopup(const QEvent& event);

  MachineLink& m_machine;
  QVBoxLayout* m_layout;
  QButtonGroup* m_pages;
  QPushButton* m_lock;
  QPushButton* m_hold;
  QPushButton* m_stop;
};

} // namespace arris::ui
