#include "ui/figures/sheet.h"

#include <QFontMetricsF>

#include <algorithm>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kCellPadding = 12;
constexpr double kSheetPartGap = 40;
constexpr double kLinePadding = 12; // of a row, above and below its text together

double cellsHeight(const std::vector<SheetColumn>& columns, const std::vector<QString>& cells, const QFont& font) {
  const QFontMetricsF metrics(font);
  double height = metrics.lineSpacing();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const QRectF room(0, 0, columns[i].width - 2 * kCellPadding, 1e6);
    height = std::max(height, metrics.boundingRect(room, Qt::TextWordWrap, cells[i]).height());
  }
  return height + kLinePadding;
}

SheetRow rowOf(const std::vector<SheetColumn>& columns, const std::vector<QString>& cells, const FigureStyle& style,
               bool isHead) {
  const QFont font = style.font(kSmallTextHeight, isHead);
  const auto paint = [=](QPainter& painter, const QRectF& box) {
    painter.setFont(font);
    painter.setPen(style.palette.ink);
    double left = box.left();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const QRectF cell(left + kCellPadding, box.top(), columns[i].width - 2 * kCellPadding, box.height());
      const int flags = static_cast<int>(columns[i].alignment) | (isHead ? Qt::AlignBottom : Qt::AlignVCenter);
      painter.drawText(cell, flags | Qt::TextWordWrap | Qt::TextDontClip, cells[i]);
      left += columns[i].width;
    }
    painter.setPen(style.pen(isHead ? style.palette.ink : style.palette.grid, kThinLine));
    painter.drawLine(box.bottomLeft(), QPointF(left, box.bottom()));
  };
  return {cellsHeight(columns, cells, font), paint};
}

// Puts row after row and begins a page where one is full.
class Pages {
public:
  explicit Pages(double room) : m_room(room), m_pages(1) {}

  [[nodiscard]] bool hasRoom(double height) const {
    return m_top + height <= m_room;
  }

  [[nodiscard]] bool isFresh() const {
    return m_pages.back().empty();
  }

  void turn() {
    m_pages.emplace_back();
    m_top = 0;
  }

  void add(const SheetRow& row) {
    m_pages.back().push_back({m_top, row});
    m_top += row.height;
  }

  void skip(double height) {
    m_top += height;
  }

  [[nodiscard]] std::vector<std::vector<PlacedRow>> pages() && {
    return std::move(m_pages);
  }

private:
  double m_room;
  double m_top = 0;
  std::vector<std::vector<PlacedRow>> m_pages;
};

} // namespace

std::vector<std::vector<PlacedRow>>
paginated(const std::vector<SheetPart>& parts, double room,
          const std::function<SheetRow(const QString& title, bool continued)>& titled) {
  Pages pages(room);
  for (const SheetPart& part : parts) {
    const auto begin = [&](bool continued) {
      if (!part.title.isEmpty()) {
        pages.add(titled(part.title, continued));
      }
      if (part.head) {
        pages.add(*part.head);
      }
    };
    double first = (part.title.isEmpty() ? 0 : titled(part.title, false).height) + (part.head ? part.head->height : 0);
    first += part.rows.empty() ? 0 : part.rows.front().height;
    if (!pages.isFresh()) { // a title does not stand alone at the foot of a page
      pages.hasRoom(kSheetPartGap + first) ? pages.skip(kSheetPartGap) : pages.turn();
    }
    begin(false);
    for (const SheetRow& row : part.rows) {
      if (&row != &part.rows.front() && !pages.hasRoom(row.height)) {
        pages.turn();
        begin(true);
      }
      pages.add(row);
    }
  }
  return std::move(pages).pages();
}

SheetRow tableRow(const std::vector<SheetColumn>& columns, const std::vector<QString>& cells,
                  const FigureStyle& style) {
  return rowOf(columns, cells, style, false);
}

SheetRow tableHead(const std::vector<SheetColumn>& columns, const FigureStyle& style) {
  std::vector<QString> heads;
  for (const SheetColumn& column : columns) {
    heads.push_back(column.head);
  }
  return rowOf(columns, heads, style, true);
}

} // namespace arris::ui
