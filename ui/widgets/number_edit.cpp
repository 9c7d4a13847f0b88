#include "ui/widgets/number_edit.h"

#include "core/recipe/fields.h"
#include "ui/text/job_texts.h"
#include "ui/text/number_input.h"
#include "ui/text/quantities.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/signs.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

constexpr int kDecimals = 6;
constexpr int kLongestNumber = 24;
constexpr int kCaptionWidth = 216; // px; longer ones take two lines

constexpr int kRangeDecimals = 4; // of what is converted

// So that the lines of all fields are equally wide.
int widestUnit(const QFontMetrics& metrics) {
  int widest = 0;
  for (const recipe::NumberField& field : recipe::numberFields()) {
    widest = std::max(widest, metrics.horizontalAdvance(toQString(field.unit)));
  }
  return widest + 1;
}

// Inwards, so that what is told to be allowed is.
double rounded(double value, double (*inwards)(double)) {
  const double unit = std::pow(10, kRangeDecimals);
  return inwards(value * unit) / unit;
}

} // namespace

NumberEdit::NumberEdit(NumberSpec spec, double value, QWidget* parent)
    : QWidget(parent), m_spec(std::move(spec)), m_value(value), m_line(new QLineEdit),
      m_sign(new QAction(signIcon(base::Severity::Error), QString(), this)) {
  auto* caption = new QLabel(m_spec.caption.isEmpty() ? m_spec.what : m_spec.caption);
  caption->setBuddy(m_line);
  caption->setWordWrap(fontMetrics().horizontalAdvance(caption->text()) > kCaptionWidth);
  auto* unitLabel = new QLabel(unitText());
  unitLabel->setMinimumWidth(widestUnit(fontMetrics()));
  m_line->installEventFilter(this);
  m_line->setObjectName(m_spec.name);
  m_line->setText(textOf(value));
  m_line->setMaxLength(kLongestNumber);
  m_line->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
  m_line->setAccessibleName(tr("%1, %2").arg(m_spec.what, unitText()));
  m_line->addAction(m_sign, QLineEdit::TrailingPosition);
  m_sign->setVisible(false);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(6);
  layout->setVerticalSpacing(0);
  layout->addWidget(caption, 0, 0, 1, 2);
  layout->addWidget(m_line, 1, 0);
  layout->addWidget(unitLabel, 1, 1);
  connect(m_line, &QLineEdit::textChanged, this, &NumberEdit::read);
}

void NumberEdit::setValue(double value) {
  if (value == m_value && m_complaint.isEmpty()) {
    return;
  }
  m_value = value;
  const QSignalBlocker silent(m_line);
  m_line->setText(textOf(value));
  showComplaint({});
}

// A finger's tap comes as a click that the system or Qt has made of it.
bool NumberEdit::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonRelease && m_line->isEnabled()) {
    const auto* click = static_cast<QMouseEvent*>(event);
    const bool isTouch =
        click->pointerType() == QPointingDevice::PointerType::Finger || click->source() != Qt::MouseEventNotSynthesized;
    if (isTouch || keypadOpens() == KeypadOpens::OnEveryTap) {
      Keypad::openFor(*this);
    }
  }
  return QWidget::eventFilter(watched, event);
}

void NumberEdit::read(const QString& text) {
  double value = m_value;
  showComplaint(complaintAbout(text, value));
  if (m_complaint.isEmpty() && value != m_value) {
    m_value = value;
    Q_EMIT valueChanged(value);
  }
}

QString NumberEdit::complaintAbout(const QString& text) const {
  double value = 0;
  return complaintAbout(text, value);
}

QString NumberEdit::complaintAbout(const QString& text, double& value) const {
  const NumberInput input = readNumber(text, QLocale());
  switch (input.kind) {
  case NumberInput::Kind::Empty:
    return tr("%1: type a number %2.").arg(m_spec.what, rangeText());
  case NumberInput::Kind::NotANumber:
    return tr("%1 is not a number; type one %2.").arg(m_spec.what, rangeText());
  case NumberInput::Kind::Ambiguous:
    return tr("%1: “%2” can mean %3 or %4; type it that way.")
        .arg(m_spec.what, text, numberText(input.value, kDecimals, QLocale()),
             numberText(input.grouped, kDecimals, QLocale()));
  case NumberInput::Kind::Number:
    break;
  }
  const double typed = isLength() ? lengthFromShown(input.value) : input.value;
  if (typed < m_spec.least || typed > m_spec.most) {
    return tr("%1 is out of range; it must be %2.").arg(m_spec.what, rangeText());
  }
  value = typed;
  return {};
}

QString NumberEdit::textOf(double value) const {
  return numberText(isLength() ? shownLength(value) : value, kDecimals, QLocale());
}

bool NumberEdit::isLength() const {
  return m_spec.unit.startsWith(QLatin1String("mm"));
}

QString NumberEdit::rangeText() const {
  const bool converts = isLength() && lengthUnit() != LengthUnit::Millimetre;
  const double least = converts ? rounded(shownLength(m_spec.least), std::ceil) : m_spec.least;
  const double most = converts ? rounded(shownLength(m_spec.most), std::floor) : m_spec.most;
  return tr("from %1 to %2")
      .arg(numberText(least, kDecimals, QLocale()), numberText(most, kDecimals, QLocale()) + QChar::Nbsp + unitText());
}

QString NumberEdit::unitText() const {
  return inShownUnits(m_spec.unit);
}

void NumberEdit::showComplaint(const QString& complaint) {
  if (complaint == m_complaint) {
    return;
  }
  m_complaint = complaint;
  m_sign->setVisible(!complaint.isEmpty());
  m_line->setProperty("invalid", !complaint.isEmpty());
  m_line->style()->unpolish(m_line); // the style sheet asks for the property
  m_line->style()->polish(m_line);
  Q_EMIT complaintChanged();
}

} // namespace arris::ui
