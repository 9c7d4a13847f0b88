#pragma once

#include "core/recipe/fields.h"

#include <QLineEdit>
#include <QWidget>

namespace arris::ui {

/// A field for one number of the recipe: caption with unit, and a line to type in. Decimal comma and point are both
/// taken. What cannot be taken is marked and explained in words, and the value before stays.
class NumberEdit : public QWidget {
  Q_OBJECT

public:
  /// `most`: the greatest value allowed here; the machine's may be below the field's own.
  NumberEdit(const recipe::NumberField& field, double most, double value, QWidget* parent = nullptr);

  [[nodiscard]] const recipe::NumberField& field() const {
    return m_field;
  }

  [[nodiscard]] double value() const {
    return m_value;
  }

  /// What is wrong with the text, in words; empty where nothing is.
  [[nodiscard]] const QString& complaint() const {
    return m_complaint;
  }

  [[nodiscard]] QLineEdit* line() const {
    return m_line;
  }

Q_SIGNALS:
  void valueChanged(double value);
  void complaintChanged();

private:
  void read(const QString& text);
  [[nodiscard]] QString complaintAbout(const QString& text, double& value) const;
  void showComplaint(const QString& complaint);
  [[nodiscard]] QString unit() const;
  [[nodiscard]] QString withUnit(double value) const;

  recipe::NumberField m_field;
  double m_most;
  double m_value;
  QString m_complaint;
  QLineEdit* m_line;
  QAction* m_sign;
};

} // namespace arris::ui
