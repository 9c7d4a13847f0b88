#pragma once

#include <QStringList>
#include <QWidget>

class QComboBox;

namespace arris::ui {

/// A field for one of some choices, with its caption above.
class ChoiceEdit : public QWidget {
  Q_OBJECT

public:
  ChoiceEdit(const QString& name, const QString& caption, const QStringList& choices, QWidget* parent = nullptr);

  void setChosen(int index); ///< without saying so

  [[nodiscard]] int chosen() const;

Q_SIGNALS:
  void picked(int index); ///< by a person

private:
  QComboBox* m_choices;
};

} // namespace arris::ui
