#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

/// Says what is under way and offers to end it. What is done at once does not make it flicker: it is shown only when
/// something has been under way for a moment.
class BusyRow : public QWidget {
  Q_OBJECT

public:
  explicit BusyRow(QWidget* parent = nullptr);

  void setBusy(bool busy);
  void setText(const QString& what);

Q_SIGNALS:
  /// It is to be seen now, or no longer.
  void shownChanged(bool shown);
  void cancelled();

private:
  QLabel* m_text;
  QPushButton* m_cancel;
  QTimer m_delay;
};

} // namespace arris::ui
