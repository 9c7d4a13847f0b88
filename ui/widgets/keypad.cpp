#include "ui/widgets/keypad.h"

#include "ui/widgets/control_strip.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kKeyWidth = 72;  // px
constexpr int kKeyHeight = 56; // px
constexpr int kComplaintLines = 3;
constexpr int kKeypadGap = 8;
constexpr int kKeypadWidth = 344;

KeypadOpens& opensWhen() {
  static KeypadOpens when = KeypadOpens::OnTouch;
  return when;
}

} // namespace

void setKeypadOpens(KeypadOpens when) {
  opensWhen() = when;
}

KeypadOpens keypadOpens() {
  return opensWhen();
}

void Keypad::openFor(NumberEdit& edit) {
  delete edit.window()->findChild<Keypad*>();
  auto* keypad = new Keypad(edit);
  keypad->place();
  keypad->show();
  keypad->raise();
  keypad->m_line->setFocus();
}

Keypad::Keypad(NumberEdit& edit)
    : QFrame(edit.window()), m_edit(&edit), m_field(&edit), m_line(new QLineEdit(edit.line()->text())),
      m_complaint(new QLabel) {
  setObjectName(QStringLiteral("keypad"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFixedWidth(kKeypadWidth);
  auto* what = new QLabel(edit.spec().what);
  what->setWordWrap(true);
  QFont bold = font();
  bold.setBold(true);
  what->setFont(bold);
  auto* range = new QLabel(edit.rangeText());
  range->setObjectName(QStringLiteral("keypadRange"));
  m_line->setObjectName(QStringLiteral("keypadLine"));
  m_line->setMaxLength(edit.line()->maxLength());
  m_line->setAccessibleName(edit.line()->accessibleName());
  m_line->selectAll();
  m_complaint->setWordWrap(true);
  m_complaint->setObjectName(QStringLiteral("keypadComplaint"));
  m_complaint->setMinimumHeight(kComplaintLines * fontMetrics().lineSpacing());
  m_complaint->setAlignment(Qt::AlignTop);
  auto* grid = new QGridLayout;
  grid->setSpacing(kKeypadGap);
  addKeys(*grid);
  auto* column = new QVBoxLayout(this);
  column->addWidget(what);
  column->addWidget(range);
  column->addWidget(m_line);
  column->addWidget(m_complaint);
  column->addLayout(grid);
  connect(m_line, &QLineEdit::returnPressed, this, &Keypad::accept);
  connect(m_line, &QLineEdit::textChanged, this, &Keypad::showComplaint);
  connect(m_edit, &QObject::destroyed, this, &QWidget::close);
  m_edit->installEventFilter(this);
  window()->installEventFilter(this);
}

QPushButton* Keypad::addKey(QGridLayout& grid, const QString& text, const QString& name, int row, int column,
                            const std::function<void()>& act) {
  auto* key = new QPushButton(text);
  key->setObjectName(name);
  key->setProperty("sign", true);
  key->setMinimumSize(kKeyWidth, kKeyHeight);
  key->setFocusPolicy(Qt::NoFocus); // the number keeps it
  connect(key, &QPushButton::clicked, this, act);
  grid.addWidget(key, row, column);
  return key;
}

void Keypad::addKeys(QGridLayout& grid) {
  const auto type = [this](const QString& text) { return [this, text] { m_line->insert(text); }; };
  for (int digit = 0; digit < 10; ++digit) {
    const QString text = QString::number(digit);
    const int row = digit == 0 ? 3 : (9 - digit) / 3;
    const int column = digit == 0 ? 0 : (digit - 1) % 3;
    addKey(grid, text, QStringLiteral("key") + text, row, column, type(text));
  }
  const QString point = QLocale().decimalPoint();
  addKey(grid, point, QStringLiteral("keyPoint"), 3, 1, type(point));
  QPushButton* sign = addKey(grid, QStringLiteral("±"), QStringLiteral("keySign"), 3, 2, [this] { changeSign(); });
  sign->setEnabled(m_edit->spec().least < 0);
  addKey(grid, QStringLiteral("⌫"), QStringLiteral("keyBack"), 0, 3, [this] { m_line->backspace(); });
  addKey(grid, QStringLiteral("C"), QStringLiteral("keyClear"), 1, 3, [this] { m_line->clear(); });
  addKey(grid, tr("Cancel"), QStringLiteral("keyCancel"), 2, 3, [this] { close(); });
  addKey(grid, tr("OK"), QStringLiteral("keyOk"), 3, 3, [this] { accept(); });
}

void Keypad::changeSign() {
  const QString text = m_line->text();
  m_line->setText(text.startsWith(QLatin1Char('-')) ? text.mid(1) : QLatin1Char('-') + text);
}

void Keypad::showComplaint() {
  m_complaint->setText(m_edit && !m_line->text().isEmpty() ? m_edit->complaintAbout(m_line->text()) : QString());
}

void Keypad::accept() {
  if (m_edit == nullptr) {
    return;
  }
  if (const QString complaint = m_edit->complaintAbout(m_line->text()); !complaint.isEmpty()) {
    m_complaint->setText(complaint);
    return;
  }
  m_edit->line()->setText(m_line->text());
  close();
}

void Keypad::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
  } else {
    QFrame::keyPressEvent(event);
  }
}

// The page with the field goes away, or the window has another size.
bool Keypad::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_field && event->type() == QEvent::Hide) {
    close();
  } else if (watched == window() && event->type() == QEvent::Resize && m_edit) {
    place();
  }
  return QFrame::eventFilter(watched, event);
}

// Beside the field, where there is room for it.
void Keypad::place() {
  adjustSize();
  const QWidget* around = window();
  const QPoint field = m_edit->mapTo(around, QPoint(m_edit->width() + kKeypadGap, 0));
  const int right = around->width() - ControlStrip::kWidth - width();
  move(std::clamp(field.x(), 0, std::max(right, 0)),
       std::clamp(field.y(), 0, std::max(around->height() - height(), 0)));
}

} // namespace arris::ui
