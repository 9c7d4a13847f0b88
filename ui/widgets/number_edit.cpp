#include "ui/widgets/number_edit.h"

#include "ui/text/job_texts.h"
#include "ui/text/number_input.h"
#include "ui/text/quantities.h"
#include "ui/widgets/signs.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QStyle>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kDecimals = 6;
constexpr int kLongestNumber = 24;
constexpr int kCaptionWidth = 216; // px; longer ones take two lines

// So that the lines of all fields are equally wide.
int widestUnit(const QFontMetrics& metrics) {
  int widest = 0;
  for (const recipe::NumberField& field : recipe::numberFields()) {
    widest = std::max(widest, metrics.horizontalAdvance(
                                  QString::fromUtf8(field.unit.data(), static_cast<qsizetype>(field.unit.size()))));
  }
  return widest + 1;
}

} // namespace

NumberEdit::NumberEdit(const recipe::NumberField& field, double most, double value, QWidget* parent)
    : QWidget(parent), m_field(field), m_most(std::min(most, field.most)), m_value(value), m_line(new QLineEdit),
      m_sign(new QAction(signIcon(base::Severity::Error), QString(), this)) {
  auto* caption = new QLabel(fieldText(field));
  caption->setBuddy(m_line);
  caption->setWordWrap(fontMetrics().horizontalAdvance(caption->text()) > kCaptionWidth);
  auto* unitLabel = new QLabel(unit());
  unitLabel->setMinimumWidth(widestUnit(fontMetrics()));
  m_line->setObjectName(QString::fromUtf8(field.key.data(), static_cast<qsizetype>(field.key.size())));
  m_line->setText(numberText(value, kDecimals, QLocale()));
  m_line->setMaxLength(kLongestNumber);
  m_line->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
  m_line->setAccessibleName(tr("%1, %2").arg(caption->text(), unit()));
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

void NumberEdit::read(const QString& text) {
  double value = m_value;
  showComplaint(complaintAbout(text, value));
  if (m_complaint.isEmpty() && value != m_value) {
    m_value = value;
    Q_EMIT valueChanged(value);
  }
}

QString NumberEdit::complaintAbout(const QString& text, double& value) const {
  const QString what = fieldText(m_field);
  const QString range = tr("from %1 to %2").arg(numberText(m_field.least, kDecimals, QLocale()), withUnit(m_most));
  const NumberInput input = readNumber(text, QLocale());
  switch (input.kind) {
  case NumberInput::Kind::Empty:
    return tr("%1: type a number %2.").arg(what, range);
  case NumberInput::Kind::NotANumber:
    return tr("%1 is not a number; type one %2.").arg(what, range);
  case NumberInput::Kind::Ambiguous:
    return tr("%1: “%2” can mean %3 or %4; type it that way.")
        .arg(what, text, numberText(input.value, kDecimals, QLocale()),
             numberText(input.grouped, kDecimals, QLocale()));
  case NumberInput::Kind::Number:
    break;
  }
  if (input.value < m_field.least || input.value > m_most) {
    return tr("%1 is out of range; it must be %2.").arg(what, range);
  }
  value = input.value;
  return {};
}

QString NumberEdit::unit() const {
  return QString::fromUtf8(m_field.unit.data(), static_cast<qsizetype>(m_field.unit.size()));
}

QString NumberEdit::withUnit(double value) const {
  return numberText(value, kDecimals, QLocale()) + QChar::Nbsp + unit();
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
