#include "ui/widgets/sign_button.h"

namespace arris::ui {

QPushButton* makeSignButton(const QString& sign, const QString& name, const QString& what) {
  auto* button = new QPushButton(sign);
  button->setObjectName(name);
  button->setToolTip(what);
  button->setAccessibleName(what);
  button->setProperty("sign", true);
  return button;
}

} // namespace arris::ui
