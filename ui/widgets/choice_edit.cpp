#include "ui/widgets/choice_edit.h"

#include "ui/widgets/touch_table.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace arris::ui {

ChoiceEdit::ChoiceEdit(const QString& name, const QString& caption, const QStringList& choices, QWidget* parent)
    : QWidget(parent), m_choices(new QComboBox) {
  auto* label = new QLabel(caption);
  label->setWordWrap(true);
  label->setBuddy(m_choices);
  makeTouchable(*m_choices);
  m_choices->setObjectName(name);
  m_choices->setAccessibleName(caption);
  m_choices->addItems(choices);
  m_choices->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_choices->setMinimumContentsLength(4); // the field is as wide as its column
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(label);
  column->addWidget(m_choices);
  connect(m_choices, &QComboBox::activated, this, &ChoiceEdit::picked);
}

void ChoiceEdit::setChosen(int index) {
  m_choices->setCurrentIndex(index);
}

int ChoiceEdit::chosen() const {
  return m_choices->currentIndex();
}

} // namespace arris::ui
