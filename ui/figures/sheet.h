#pragma once

#include "ui/figures/figure.h"
#include "ui/figures/style.h"

#include <QPainter>
#include <QRectF>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace arris::ui {

// What printed sheets are made of: parts with rows that flow from page to page. Lengths in units of figures.

/// Something that stays together on one page.
struct SheetRow {
  double height = 0;
  std::function<void(QPainter&, const QRectF&)> paint; ///< into a rectangle of the sheet's width and this height
};

/// A title with rows; title and head stand again on every page that the rows go on to.
struct SheetPart {
  QString title;
  std::optional<SheetRow> head = {};
  std::vector<SheetRow> rows = {};
};

/// A row and where it stands on its page, from the top of the part of the page that rows may take.
struct PlacedRow {
  double top = 0;
  SheetRow row;
};

/// The rows of each page, none of which takes more than `room`; a row that is higher than that stands alone. `titled`
/// makes the row of a title, for the part's first rows or for their continuation.
[[nodiscard]] std::vector<std::vector<PlacedRow>>
paginated(const std::vector<SheetPart>& parts, double room,
          const std::function<SheetRow(const QString& title, bool continued)>& titled);

/// A column of a table.
struct SheetColumn {
  QString head;
  double width = 0;
  Qt::Alignment alignment = Qt::AlignLeft;
};

/// A row of a table; what is too long for its column goes on in another line.
[[nodiscard]] SheetRow tableRow(const std::vector<SheetColumn>& columns, const std::vector<QString>& cells,
                                const FigureStyle& style);

/// The row with the heads of the columns.
[[nodiscard]] SheetRow tableHead(const std::vector<SheetColumn>& columns, const FigureStyle& style);

} // namespace arris::ui
