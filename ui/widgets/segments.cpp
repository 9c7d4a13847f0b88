#include "ui/widgets/segments.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>

namespace arris::ui {

Segments::Segments(const std::vector<std::pair<QString, QString>>& buttons, int chosen, QWidget* parent)
    : QWidget(parent), m_group(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (const auto& [name, text] : buttons) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setCheckable(true);
    m_group->addButton(button, static_cast<int>(m_group->buttons().size()));
    row->addWidget(button, 1);
  }
  choose(chosen);
  connect(m_group, &QButtonGroup::idClicked, this, &Segments::picked);
}

void Segments::choose(int index) {
  if (QAbstractButton* button = m_group->button(index)) {
    button->setChecked(true);
  }
}

int Segments::chosen() const {
  return m_group->checkedId();
}

} // namespace arris::ui
