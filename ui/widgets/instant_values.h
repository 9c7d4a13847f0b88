#pragma once

#include "ui/figures/profile.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QLabel;

namespace arris::ui {

/// The values of up to two profiles at one time, in a table whose places do not move.
class InstantValues : public QWidget {
  Q_OBJECT

public:
  explicit InstantValues(QWidget* parent = nullptr);

  /// Every place is empty without a time.
  void showValues(const std::vector<ProfileCurves>& profiles, std::optional<double> time);

private:
  static constexpr std::size_t kMostProfiles = 2;

  struct Row {
    QLabel* name = nullptr;
    std::array<QLabel*, kPanelCount> values{};
  };

  QLabel* addLabel(int row, int column, const QString& name);
  static void showRow(const Row& row, const ProfileCurves& curves, std::optional<double> time);

  QLabel* m_time;
  std::array<Row, kMostProfiles> m_rows;
};

} // namespace arris::ui
