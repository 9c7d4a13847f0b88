#pragma once

#include <QLineEdit>
#include <QWidget>

namespace arris::ui {

/// A number that somebody types.
struct NumberSpec {
  QString name; ///< of the line, for programs: "wheel_radius_mm"
  QString what; ///< what it is, in the operator's language
  QString unit; ///< of the value: "mm", "mm/min", "r/min"; what is in mm is shown and typed in the unit of lengths
  double least = 0;
  double most = 0;
  QString caption = {}; ///< above the line, where it is to be shorter than `what`
};

/// A field for one number: caption with unit, and a line to type in. Decimal comma and point are both taken. What
/// cannot be taken is marked and explained in words, and the value before stays.
class NumberEdit : public QWidget {
  Q_OBJECT

public:
  NumberEdit(NumberSpec spec, double value, QWidget* parent = nullptr);

  [[nodiscard]] const NumberSpec& spec() const {
    return m_spec;
  }

  /// In the unit of the spec.
  [[nodiscard]] double value() const {
    return m_value;
  }

  /// Shows another value, one that is allowed here, without saying that it has changed. A text that means the same
  /// already stays as it was typed; a wrong one goes.
  void setValue(double value);

  /// What is wrong with the text, in words; empty where nothing is.
  [[nodiscard]] const QString& complaint() const {
    return m_complaint;
  }

  [[nodiscard]] QLineEdit* line() const {
    return m_line;
  }

  /// What would be wrong with a text, in words.
  [[nodiscard]] QString complaintAbout(const QString& text) const;

  /// What is allowed: "from 0.5 to 500 mm".
  [[nodiscard]] QString rangeText() const;

  /// The unit as shown.
  [[nodiscard]] QString unitText() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void valueChanged(double value);
  void complaintChanged();

private:
  void read(const QString& text);
  QString complaintAbout(const QString& text, double& value) const;
  void showComplaint(const QString& complaint);
  [[nodiscard]] bool isLength() const;
  [[nodiscard]] QString textOf(double value) const;

  NumberSpec m_spec;
  double m_value;
  QString m_complaint;
  QLineEdit* m_line;
  QAction* m_sign;
};

} // namespace arris::ui
