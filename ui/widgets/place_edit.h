#pragma once

#include <QWidget>

#include <Eigen/Core>

#include <array>
#include <optional>

class QCheckBox;

namespace arris::ui {

class NumberEdit;

/// A field for a place on the table that may be left to the program.
class PlaceEdit : public QWidget {
  Q_OBJECT

public:
  /// `left`: what it means that no place is given. `farthest`: mm, of X and Y either way.
  PlaceEdit(const QString& name, const QString& caption, const QString& left, double farthest,
            QWidget* parent = nullptr);

  void setPlace(const std::optional<Eigen::Vector2d>& place); ///< mm; without saying so

  /// What X and Y begin with when they are given.
  void setDefault(const Eigen::Vector2d& place);

  /// X and Y.
  [[nodiscard]] const std::array<NumberEdit*, 2>& numbers() const {
    return m_numbers;
  }

Q_SIGNALS:
  void placeChanged(const std::optional<Eigen::Vector2d>& place); ///< by a person

private:
  void showNumbers(const Eigen::Vector2d& place);
  void showGiven();
  void tell();

  QCheckBox* m_left;
  std::array<NumberEdit*, 2> m_numbers{};
};

} // namespace arris::ui
