#pragma once

#include "ui/widgets/number_edit.h"

#include <QFrame>
#include <QPointer>

#include <functional>

class QGridLayout;
class QLabel;
class QPushButton;

namespace arris::ui {

/// When a tap on a number field brings up the keypad: a finger's always does.
enum class KeypadOpens { OnTouch, OnEveryTap };
void setKeypadOpens(KeypadOpens when); ///< of the whole process
[[nodiscard]] KeypadOpens keypadOpens();

/// Keys on the screen for one number: what it is, its unit and range, and keys for gloves. It lies over the page, never
/// over the strip with FEED HOLD and STOP. The field gets the number when it is accepted; a number that cannot be taken
/// is explained, and the keypad stays.
class Keypad : public QFrame {
  Q_OBJECT

public:
  /// Opens over the window of the field; one that is open already closes.
  static void openFor(NumberEdit& edit);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  explicit Keypad(NumberEdit& edit);

  void addKeys(QGridLayout& grid);
  QPushButton* addKey(QGridLayout& grid, const QString& text, const QString& name, int row, int column,
                      const std::function<void()>& act);
  void changeSign();
  void accept();
  void showComplaint();
  void place();

  QPointer<NumberEdit> m_edit;
  const QObject* m_field; // the same, to be compared with also while it ends
  QLineEdit* m_line;
  QLabel* m_complaint;
};

} // namespace arris::ui
