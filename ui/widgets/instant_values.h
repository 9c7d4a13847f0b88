#pragma once

#include "ui/figures/profile.h"

#include <QWidget>

#include <array>
#include <optional>
#include <span>
#include <vector>

class QLabel;

namespace arris::ui {

/// The values of up to two profiles at one time, in a table whose places do not move; lengths as the window shows them.
class InstantValues : public QWidget {
  Q_OBJECT

public:
  explicit InstantValues(QWidget* parent = nullptr);

  /// What the columns are from now on, at most `kMostValues`; the values follow with `showValues`.
  void setPanels(std::span<const Panel> panels);

  /// Every place is empty without a time.
  void showValues(const std::vector<ProfileCurves>& profiles, std::optional<double> time);

  static constexpr std::size_t kMostValues = 6;

private:
  static constexpr std::size_t kMostProfiles = 2;

  struct Row {
    QLabel* name = nullptr;
    std::array<QLabel*, kMostValues> values{};
  };

  QLabel* addLabel(int row, int column, const QString& name);
  void showRow(const Row& row, const ProfileCurves& curves, std::optional<double> time) const;

  std::vector<Panel> m_panels;
  QLabel* m_time;
  std::array<QLabel*, kMostValues> m_heads{};
  std::array<Row, kMostProfiles> m_rows;
};

} // namespace arris::ui
