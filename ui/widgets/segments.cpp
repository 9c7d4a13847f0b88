#include "ui/widgets/segments.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>

namespace arris::ui {

Segments::Segments(const std::vector<std::pair<QString, QString>>& buttons, int chosen, QWidget* parent)
    : QWidget(parent) {
  auto* group = new QButtonGroup(this);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (const auto& [name, text] : buttons) {
    auto* button = new QPushButton(text);
    const auto index = static_cast<int>(group->buttons().size());
    button->setObjectName(name);
    button->setCheckable(true);
    button->setChecked(index == chosen);
    const bool isSign = text.size() == 1;
    button->setProperty(isSign ? "sign" : "segment", true);
    group->addButton(button, index);
    row->addWidget(button, isSign ? 0 : 1);
  }
  connect(group, &QButtonGroup::idClicked, this, &Segments::picked);
}

} // namespace arris::ui
