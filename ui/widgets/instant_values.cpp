#include "ui/widgets/instant_values.h"

#include "ui/figures/profile_plot.h"
#include "ui/text/quantities.h"

#include <QFontMetrics>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

constexpr int kColumnGap = 8;
constexpr int kNameRoom = 4;

QString panelValueText(double value) {
  return std::isfinite(value) ? fixedLengthText(value, 2, QLocale()) : QStringLiteral("–");
}

} // namespace

InstantValues::InstantValues(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kColumnGap);
  grid->setVerticalSpacing(0);
  const QFontMetrics metrics(font());
  const int nameWidth = metrics.horizontalAdvance(QStringLiteral("t = 00000.000 s"));
  m_time = addLabel(0, 0, QStringLiteral("instant"));
  m_time->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_time->setFixedWidth(nameWidth);
  for (int column = 1; column <= static_cast<int>(kMostValues); ++column) {
    grid->setColumnMinimumWidth(column, metrics.horizontalAdvance(QStringLiteral("−0000.00")));
    m_heads.at(static_cast<std::size_t>(column - 1)) = addLabel(0, column, {});
  }
  for (int i = 0; i < static_cast<int>(kMostProfiles); ++i) {
    Row& row = m_rows.at(static_cast<std::size_t>(i));
    row.name = addLabel(i + 1, 0, {});
    row.name->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    row.name->setFixedWidth(nameWidth);
    for (int column = 1; column <= static_cast<int>(kMostValues); ++column) {
      const auto at = static_cast<std::size_t>(column - 1);
      row.values.at(at) = addLabel(i + 1, column, QStringLiteral("value_%1_%2").arg(i).arg(column - 1));
    }
  }
  setPanels(panelsOf(PlotContent::Speeds));
}

// What is not there leaves its place: a line above and one for the unit.
void InstantValues::setPanels(std::span<const Panel> panels) {
  m_panels.assign(panels.begin(), panels.end());
  for (std::size_t i = 0; i < kMostValues; ++i) {
    m_heads.at(i)->setText(i < panels.size() ? ProfilePlot::axisTitle(panels[i], false, lengthUnit())
                                             : QStringLiteral(" \n "));
  }
}

QLabel* InstantValues::addLabel(int row, int column, const QString& name) {
  auto* label = new QLabel(QStringLiteral(" ")); // an empty one would have no height
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  static_cast<QGridLayout*>(layout())->addWidget(label, row, column);
  return label;
}

void InstantValues::showValues(const std::vector<ProfileCurves>& profiles, std::optional<double> time) {
  m_time->setText(time ? QStringLiteral("t = %1 s").arg(fixedText(*time, 3, QLocale())) : QStringLiteral(" "));
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    showRow(m_rows.at(i), i < profiles.size() ? profiles[i] : ProfileCurves(), time);
  }
}

void InstantValues::showRow(const Row& row, const ProfileCurves& curves, std::optional<double> time) const {
  const bool known = time && !curves.panels.front().isEmpty();
  const QString name = row.name->fontMetrics().elidedText(curves.name, Qt::ElideMiddle, row.name->width() - kNameRoom);
  row.name->setText(known ? name : QStringLiteral(" "));
  for (std::size_t i = 0; i < kMostValues; ++i) {
    const bool isShown = known && i < m_panels.size();
    const double value = isShown ? curveValue(curveOf(curves, m_panels[i]), *time) : 0;
    row.values.at(i)->setText(isShown ? panelValueText(value) : QStringLiteral(" "));
  }
}

} // namespace arris::ui
