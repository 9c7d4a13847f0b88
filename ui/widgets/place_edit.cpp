#include "ui/widgets/place_edit.h"

#include "ui/widgets/number_edit.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr double kPlaceFraction = 1000; // of a mm

} // namespace

PlaceEdit::PlaceEdit(const QString& name, const QString& caption, const QString& left, double farthest, QWidget* parent)
    : QWidget(parent), m_left(new QCheckBox(left)) {
  auto* label = new QLabel(caption);
  label->setWordWrap(true);
  m_left->setObjectName(name);
  m_left->setChecked(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(label);
  column->addWidget(m_left);
  for (std::size_t axis = 0; axis < m_numbers.size(); ++axis) {
    const QString letter(QStringLiteral("XY").at(static_cast<int>(axis)));
    const NumberSpec spec{
        name + letter, QStringLiteral("%1, %2").arg(caption, letter), QStringLiteral("mm"), -farthest, farthest,
        letter};
    auto* number = new NumberEdit(spec, 0);
    m_numbers.at(axis) = number;
    column->addWidget(number);
    connect(number, &NumberEdit::valueChanged, this, &PlaceEdit::tell);
  }
  connect(m_left, &QCheckBox::toggled, this, &PlaceEdit::tell);
  showGiven();
}

void PlaceEdit::setPlace(const std::optional<Eigen::Vector2d>& place) {
  const QSignalBlocker silent(m_left);
  m_left->setChecked(!place);
  if (place) {
    showNumbers(*place);
  }
  showGiven();
}

void PlaceEdit::setDefault(const Eigen::Vector2d& place) {
  if (m_left->isChecked()) {
    showNumbers((place * kPlaceFraction).array().round() / kPlaceFraction);
  }
}

// A field that has this value already keeps its text, also a wrong one.
void PlaceEdit::showNumbers(const Eigen::Vector2d& place) {
  for (std::size_t axis = 0; axis < m_numbers.size(); ++axis) {
    if (m_numbers.at(axis)->value() != place[static_cast<int>(axis)]) {
      m_numbers.at(axis)->setValue(place[static_cast<int>(axis)]);
    }
  }
}

void PlaceEdit::showGiven() {
  for (NumberEdit* number : m_numbers) {
    number->setEnabled(!m_left->isChecked());
  }
}

void PlaceEdit::tell() {
  showGiven();
  Q_EMIT placeChanged(m_left->isChecked()
                          ? std::nullopt
                          : std::optional(Eigen::Vector2d(m_numbers[0]->value(), m_numbers[1]->value())));
}

} // namespace arris::ui
