#include "ui/figures/preview_figure.h"

#include "ui/figures/corner_labels.h"
#include "ui/figures/drawing_legend.h"
#include "ui/figures/drawing_painter.h"
#include "ui/figures/finding_rows.h"
#include "ui/figures/polyline.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace arris::ui {
namespace {

// In units of figures (0.1 mm on paper).
constexpr double kPageMargin = 100;
constexpr double kRulerRoom = 105;  // left of the frame: numbers and the axis title
constexpr double kAxisRoom = 90;    // below the frame
constexpr double kInnerMargin = 95; // between frame and drawing: room for the corners' numbers
constexpr double kLegendRowHeight = 38;
constexpr double kTitleRowHeight = 54;
constexpr double kLegendColumn = 440;
constexpr double kLocatorHeight = 175;
constexpr double kBlockPadding = 22;
constexpr double kLeastTickSpacing = 130;
constexpr double kScaleRoom = 800; // of the title: scale and locator stand there
constexpr double kRowLeft = 80;
constexpr double kMostRowLines = 10;

/// The scales that draughtsmen use: 1:1, 1:1.25, 1:1.5, … times powers of ten.
double roundScale(double millimetresPerMillimetre) {
  constexpr std::array kSteps{1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 10.0};
  const double decade = std::pow(10, std::floor(std::log10(millimetresPerMillimetre)));
  for (const double step : kSteps) {
    if (step * decade >= millimetresPerMillimetre * (1 - 1e-9)) {
      return step * decade;
    }
  }
  return 10 * decade;
}

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least) {
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= least) {
      return step * decade;
    }
  }
  return 10 * decade;
}

geometry::Box shownBox(const Drawing& drawing) {
  geometry::Box box = drawing.box;
  if (box.isEmpty()) {
    box = geometry::Box(geometry::Point(0, 0), geometry::Point(100, 100));
  }
  if (box.sizes().maxCoeff() < 1e-3) { // a single place
    box.extend(box.min() - geometry::Vector(10, 10)).extend(box.max() + geometry::Vector(10, 10));
  }
  return box;
}

/// A row of words about findings with the height that it needs.
struct BlockRow {
  FindingRow finding;
  double height = 0;
};

/// Where everything stands on a page.
struct PageLayout {
  QRectF page, frame, block;
  std::size_t legendColumns = 1;
  double upperHeight = 0, legendHeight = 0; // of the parts of the block
  std::vector<BlockRow> rows;
  std::size_t unshown = 0; ///< rows that there is no room for
  double scale = 1;        ///< 1 : scale
  QTransform toPage;
};

// As many rows as there is room for; the last line says how many there are more.
void addRows(PageLayout& layout, const Drawing& drawing, const FigureStyle& style) {
  const QFontMetricsF metrics(style.font(kTextHeight));
  const QRectF room(0, 0, layout.page.width() - kRowLeft - kBlockPadding, layout.page.height());
  const double line = metrics.lineSpacing();
  double lines = 0;
  const std::vector<FindingRow> rows = findingRows(drawing, style.locale);
  for (const FindingRow& row : rows) {
    const double own =
        std::max(1.0, std::round(metrics.boundingRect(room, Qt::TextWordWrap, row.words).height() / line));
    lines += own;
    const bool isLast = layout.rows.size() + 1 == rows.size();
    if (lines + (isLast ? 0 : 1) > kMostRowLines) {
      break;
    }
    layout.rows.push_back({row, kLegendRowHeight + (own - 1) * line});
  }
  layout.unshown = rows.size() - layout.rows.size();
}

PageLayout layOut(const QSizeF& page, const Drawing& drawing, const PreviewTitle& title, const FigureStyle& style) {
  PageLayout layout;
  layout.page = QRectF(QPointF(), page).adjusted(kPageMargin, kPageMargin, -kPageMargin, -kPageMargin);
  layout.legendColumns = static_cast<std::size_t>((layout.page.width() - 2 * kBlockPadding) / kLegendColumn);
  const std::size_t legendRows = (legendOf(drawing).size() + layout.legendColumns - 1) / layout.legendColumns;
  layout.upperHeight = kTitleRowHeight + kLegendRowHeight * static_cast<double>(title.lines.size());
  if (drawing.travel) {
    layout.upperHeight = std::max(layout.upperHeight, kLocatorHeight);
  }
  layout.legendHeight = kLegendRowHeight * static_cast<double>(legendRows);
  addRows(layout, drawing, style);
  double block = layout.upperHeight + layout.legendHeight + 3 * kBlockPadding;
  for (const BlockRow& row : layout.rows) {
    block += row.height;
  }
  block += layout.unshown > 0 ? kLegendRowHeight : 0;
  layout.block = QRectF(layout.page.left(), layout.page.bottom() - block, layout.page.width(), block);
  layout.frame = QRectF(layout.page.topLeft() + QPointF(kRulerRoom, 0),
                        QPointF(layout.page.right(), layout.block.top() - kAxisRoom));

  const geometry::Box box = shownBox(drawing);
  const geometry::Vector size = box.sizes() * kUnitsPerMillimetre;
  layout.scale = roundScale(std::max(size.x() / (layout.frame.width() - 2 * kInnerMargin),
                                     size.y() / (layout.frame.height() - 2 * kInnerMargin)));
  const double perMillimetre = kUnitsPerMillimetre / layout.scale;
  const QPointF middle = toQt(box.center());
  layout.toPage = QTransform::fromTranslate(layout.frame.center().x(), layout.frame.center().y());
  layout.toPage.scale(perMillimetre, -perMillimetre);
  layout.toPage.translate(-middle.x(), -middle.y());
  return layout;
}

class PreviewPage {
  Q_DECLARE_TR_FUNCTIONS(PreviewPage)

public:
  PreviewPage(QPainter& painter, const QSizeF& page, const Drawing& drawing, const PreviewTitle& title)
      : m_painter(painter), m_drawing(drawing), m_title(title), m_layout(layOut(page, drawing, title, m_style)) {}

  void paint();

private:
  void paintGrid();
  void paintAxes();
  void paintTitle();
  void paintFindings(double top);
  void paintLegend(const QPointF& topLeft);
  void paintLocator(const QRectF& area);
  void text(const QRectF& box, int flags, const QString& words, double height = kTextHeight, bool bold = false,
            const QColor& color = Palette().ink);

  QPainter& m_painter;
  const Drawing& m_drawing;
  const PreviewTitle& m_title;
  FigureStyle m_style;
  PageLayout m_layout;
};

void PreviewPage::text(const QRectF& box, int flags, const QString& words, double height, bool bold,
                       const QColor& color) {
  m_painter.setPen(color);
  m_painter.setFont(m_style.font(height, bold));
  m_painter.drawText(box, flags | Qt::TextDontClip, words);
}

void PreviewPage::paint() {
  m_painter.fillRect(m_layout.frame, m_style.palette.paper);
  paintGrid();
  paintDrawing(m_painter, m_drawing, m_layout.toPage, m_layout.frame, m_style);
  const auto labels = placeCornerLabels(m_drawing, m_layout.toPage, m_layout.frame.adjusted(15, 15, -15, -15), m_style);
  paintCornerLabels(m_painter, labels, 0, m_style);
  paintAxes();
  paintTitle();
}

void PreviewPage::paintGrid() {
  const double step = roundStep(kLeastTickSpacing / kUnitsPerMillimetre * m_layout.scale);
  const QRectF shown = m_layout.toPage.inverted().mapRect(m_layout.frame);
  const QLocale& locale = m_style.locale;
  const int decimals = step < 1 ? static_cast<int>(std::ceil(-std::log10(step))) : 0;
  for (double x = std::ceil(shown.left() / step) * step; x <= shown.right(); x += step) {
    const double at = m_layout.toPage.map(QPointF(x, 0)).x();
    m_painter.setPen(m_style.pen(m_style.palette.grid, kThinLine));
    m_painter.drawLine(QPointF(at, m_layout.frame.top()), QPointF(at, m_layout.frame.bottom()));
    text(QRectF(at, m_layout.frame.bottom() + 8, 0, 30), Qt::AlignHCenter | Qt::AlignTop,
         fixedText(x, decimals, locale), kSmallTextHeight);
  }
  for (double y = std::ceil(shown.top() / step) * step; y <= shown.bottom(); y += step) {
    const double at = m_layout.toPage.map(QPointF(0, y)).y();
    m_painter.setPen(m_style.pen(m_style.palette.grid, kThinLine));
    m_painter.drawLine(QPointF(m_layout.frame.left(), at), QPointF(m_layout.frame.right(), at));
    text(QRectF(m_layout.frame.left() - 10, at, 0, 0), Qt::AlignRight | Qt::AlignVCenter,
         fixedText(y, decimals, locale), kSmallTextHeight);
  }
}

void PreviewPage::paintAxes() {
  m_painter.setPen(m_style.pen(m_style.palette.ink, kLine));
  m_painter.setBrush(Qt::NoBrush);
  m_painter.drawRect(m_layout.frame);
  const QString place = m_drawing.travel ? tr("on the table") : tr("of the drawing");
  text(QRectF(m_layout.frame.left(), m_layout.frame.bottom() + 40, m_layout.frame.width(), 40),
       Qt::AlignHCenter | Qt::AlignTop, tr("X %1, mm").arg(place));
  m_painter.save();
  m_painter.translate(m_layout.page.left() + 14, m_layout.frame.center().y());
  m_painter.rotate(-90);
  text(QRectF(0, 0, 0, 0), Qt::AlignCenter, tr("Y %1, mm").arg(place));
  m_painter.restore();
}

void PreviewPage::paintTitle() {
  m_painter.setPen(m_style.pen(m_style.palette.ink, kLine));
  m_painter.setBrush(Qt::NoBrush);
  m_painter.drawRect(m_layout.block);
  const QRectF inner = m_layout.block.adjusted(kBlockPadding, kBlockPadding, -kBlockPadding, -kBlockPadding);
  const QString scale = tr("Scale 1 : %1").arg(numberText(m_layout.scale, 4, m_style.locale));
  double top = inner.top();
  const QString file = QFontMetricsF(m_style.font(kTitleHeight, true))
                           .elidedText(m_title.file, Qt::ElideMiddle, inner.width() - kScaleRoom);
  text(QRectF(inner.left(), top, 0, kTitleRowHeight), Qt::AlignLeft | Qt::AlignTop, file, kTitleHeight, true);
  top += kTitleRowHeight;
  for (const QString& line : m_title.lines) {
    text(QRectF(inner.left(), top, 0, kLegendRowHeight), Qt::AlignLeft | Qt::AlignVCenter, line);
    top += kLegendRowHeight;
  }
  double right = inner.right();
  if (m_drawing.travel) {
    const geometry::Vector travel = m_drawing.travel->sizes();
    const double width = std::min(kLocatorHeight * travel.x() / travel.y(), 2 * kLocatorHeight);
    paintLocator(QRectF(right - width, inner.top(), width, kLocatorHeight));
    right -= width + kBlockPadding;
  }
  text(QRectF(right, inner.top(), 0, kTitleRowHeight), Qt::AlignRight | Qt::AlignTop, scale, kTextHeight, true);

  const double rule = inner.top() + m_layout.upperHeight + kBlockPadding / 2;
  m_painter.setPen(m_style.pen(m_style.palette.grid, kThinLine));
  m_painter.drawLine(QPointF(m_layout.block.left(), rule), QPointF(m_layout.block.right(), rule));
  paintLegend(QPointF(inner.left(), rule + kBlockPadding / 2));
  paintFindings(rule + m_layout.legendHeight + kBlockPadding);
}

void PreviewPage::paintFindings(double top) {
  const double left = m_layout.block.left();
  const double width = m_layout.block.width() - kRowLeft - kBlockPadding;
  for (const BlockRow& row : m_layout.rows) {
    paintSign(m_painter, QPointF(left + 45, top + kLegendRowHeight / 2), row.finding.severity, m_style);
    text(QRectF(left + kRowLeft, top, width, row.height), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
         row.finding.words);
    top += row.height;
  }
  if (m_layout.unshown > 0) {
    text(QRectF(left + kRowLeft, top, 0, kLegendRowHeight), Qt::AlignLeft | Qt::AlignVCenter,
         tr("… and %1 more kinds of findings").arg(m_layout.unshown));
  }
}

void PreviewPage::paintLegend(const QPointF& topLeft) {
  const std::vector<LegendEntry> entries = legendOf(m_drawing);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = i / m_layout.legendColumns;
    const double x = topLeft.x() + kLegendColumn * static_cast<double>(i % m_layout.legendColumns);
    const double y = topLeft.y() + kLegendRowHeight * (static_cast<double>(row) + 0.5);
    entries[i].sample(m_painter, QPointF(x, y), m_style);
    text(QRectF(x + kLegendSample + 15, y, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, entries[i].words, kSmallTextHeight);
  }
}

// The table with the pane on it, small.
void PreviewPage::paintLocator(const QRectF& area) {
  const geometry::Box& travel = *m_drawing.travel;
  const double scale = std::min(area.width() / travel.sizes().x(), area.height() / travel.sizes().y());
  QTransform toArea = QTransform::fromTranslate(area.right() - travel.sizes().x() * scale, area.bottom());
  toArea.scale(scale, -scale);
  m_painter.setPen(m_style.pen(m_style.palette.faint, kThinLine));
  m_painter.setBrush(Qt::NoBrush);
  m_painter.drawRect(toArea.mapRect(QRectF(toQt(travel.min()), toQt(travel.max()))));
  for (const pattern::Contour& contour : m_drawing.contours) {
    const QPolygonF outline = clippedArea(flattened(contour.curves, toArea, 1), area);
    m_painter.setBrush(contour.kind == pattern::ContourKind::Outline ? m_style.palette.glass : m_style.palette.paper);
    m_painter.drawPolygon(outline);
  }
}

} // namespace

Figure previewFigure(Drawing drawing, PreviewTitle title) {
  Figure figure;
  figure.title = title.file;
  // The page that shows it larger; else the one that has its shape.
  const geometry::Vector size = shownBox(drawing).sizes();
  const double lying = layOut(kA4Landscape, drawing, title, {}).scale;
  const double standing = layOut(kA4Portrait, drawing, title, {}).scale;
  const bool stands = standing != lying ? standing < lying : size.y() > size.x();
  figure.page = stands ? kA4Portrait : kA4Landscape;
  figure.paint = [page = figure.page, drawing = std::move(drawing), title = std::move(title)](QCPPainter& painter) {
    PreviewPage(painter, page, drawing, title).paint();
  };
  return figure;
}

} // namespace arris::ui
