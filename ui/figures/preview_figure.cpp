#include "ui/figures/preview_figure.h"

#include "ui/figures/corner_labels.h"
#include "ui/figures/drawing_legend.h"
#include "ui/figures/drawing_painter.h"
#include "ui/figures/polyline.h"
#include "ui/text/problem_texts.h"
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
constexpr int kMostProblemRows = 6;

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

class PreviewPage {
  Q_DECLARE_TR_FUNCTIONS(PreviewPage)

public:
  PreviewPage(QPainter& painter, const QSizeF& page, const Drawing& drawing, const PreviewTitle& title)
      : m_painter(painter), m_drawing(drawing), m_title(title),
        m_page(kPageMargin, kPageMargin, page.width() - 2 * kPageMargin, page.height() - 2 * kPageMargin) {
    layOut();
  }

  void paint();

private:
  void layOut();
  void paintGrid();
  void paintAxes();
  void paintTitle();
  void paintProblemRows(double top);
  void paintLegend(const QPointF& topLeft);
  void paintLocator(const QRectF& area);
  void text(const QRectF& box, int flags, const QString& words, double height = kTextHeight, bool bold = false,
            const QColor& color = Palette().ink);
  [[nodiscard]] std::vector<const base::Problem*> sortedProblems() const;
  [[nodiscard]] int problemRows() const;

  QPainter& m_painter;
  const Drawing& m_drawing;
  const PreviewTitle& m_title;
  FigureStyle m_style;
  QRectF m_page, m_frame, m_block;
  std::size_t m_legendColumns = 1;
  double m_upperHeight = 0, m_legendHeight = 0; // of the parts of the block
  double m_scale = 1;                           ///< 1 : m_scale
  QTransform m_toPage;
};

void PreviewPage::layOut() {
  m_legendColumns = static_cast<std::size_t>((m_page.width() - 2 * kBlockPadding) / kLegendColumn);
  const std::size_t legendRows = (legendOf(m_drawing).size() + m_legendColumns - 1) / m_legendColumns;
  m_upperHeight = kTitleRowHeight + kLegendRowHeight * static_cast<double>(m_title.lines.size());
  if (m_drawing.travel) {
    m_upperHeight = std::max(m_upperHeight, kLocatorHeight);
  }
  m_legendHeight = kLegendRowHeight * static_cast<double>(legendRows);
  const double block = m_upperHeight + m_legendHeight + kLegendRowHeight * problemRows() + 3 * kBlockPadding;
  m_block = QRectF(m_page.left(), m_page.bottom() - block, m_page.width(), block);
  m_frame = QRectF(m_page.topLeft() + QPointF(kRulerRoom, 0), QPointF(m_page.right(), m_block.top() - kAxisRoom));

  const geometry::Box box = shownBox(m_drawing);
  const geometry::Vector size = box.sizes() * kUnitsPerMillimetre;
  m_scale = roundScale(
      std::max(size.x() / (m_frame.width() - 2 * kInnerMargin), size.y() / (m_frame.height() - 2 * kInnerMargin)));
  const double perMillimetre = kUnitsPerMillimetre / m_scale;
  const QPointF middle = toQt(box.center());
  m_toPage = QTransform::fromTranslate(m_frame.center().x(), m_frame.center().y());
  m_toPage.scale(perMillimetre, -perMillimetre);
  m_toPage.translate(-middle.x(), -middle.y());
}

void PreviewPage::text(const QRectF& box, int flags, const QString& words, double height, bool bold,
                       const QColor& color) {
  m_painter.setPen(color);
  m_painter.setFont(m_style.font(height, bold));
  m_painter.drawText(box, flags | Qt::TextDontClip, words);
}

void PreviewPage::paint() {
  m_painter.fillRect(m_frame, m_style.palette.paper);
  paintGrid();
  paintDrawing(m_painter, m_drawing, m_toPage, m_frame, m_style);
  const auto labels = placeCornerLabels(m_drawing, m_toPage, m_frame.adjusted(15, 15, -15, -15), m_style);
  paintCornerLabels(m_painter, labels, 0, m_style);
  paintAxes();
  paintTitle();
}

void PreviewPage::paintGrid() {
  const double step = roundStep(kLeastTickSpacing / kUnitsPerMillimetre * m_scale);
  const QRectF shown = m_toPage.inverted().mapRect(m_frame);
  const QLocale& locale = m_style.locale;
  const int decimals = step < 1 ? static_cast<int>(std::ceil(-std::log10(step))) : 0;
  for (double x = std::ceil(shown.left() / step) * step; x <= shown.right(); x += step) {
    const double at = m_toPage.map(QPointF(x, 0)).x();
    m_painter.setPen(m_style.pen(m_style.palette.grid, kThinLine));
    m_painter.drawLine(QPointF(at, m_frame.top()), QPointF(at, m_frame.bottom()));
    text(QRectF(at, m_frame.bottom() + 8, 0, 30), Qt::AlignHCenter | Qt::AlignTop, fixedText(x, decimals, locale),
         kSmallTextHeight);
  }
  for (double y = std::ceil(shown.top() / step) * step; y <= shown.bottom(); y += step) {
    const double at = m_toPage.map(QPointF(0, y)).y();
    m_painter.setPen(m_style.pen(m_style.palette.grid, kThinLine));
    m_painter.drawLine(QPointF(m_frame.left(), at), QPointF(m_frame.right(), at));
    text(QRectF(m_frame.left() - 10, at, 0, 0), Qt::AlignRight | Qt::AlignVCenter, fixedText(y, decimals, locale),
         kSmallTextHeight);
  }
}

void PreviewPage::paintAxes() {
  m_painter.setPen(m_style.pen(m_style.palette.ink, kLine));
  m_painter.setBrush(Qt::NoBrush);
  m_painter.drawRect(m_frame);
  const QString place = m_drawing.travel ? tr("on the table") : tr("of the drawing");
  text(QRectF(m_frame.left(), m_frame.bottom() + 40, m_frame.width(), 40), Qt::AlignHCenter | Qt::AlignTop,
       tr("X %1, mm").arg(place));
  m_painter.save();
  m_painter.translate(m_page.left() + 14, m_frame.center().y());
  m_painter.rotate(-90);
  text(QRectF(0, 0, 0, 0), Qt::AlignCenter, tr("Y %1, mm").arg(place));
  m_painter.restore();
}

void PreviewPage::paintTitle() {
  m_painter.setPen(m_style.pen(m_style.palette.ink, kLine));
  m_painter.setBrush(Qt::NoBrush);
  m_painter.drawRect(m_block);
  const QRectF inner = m_block.adjusted(kBlockPadding, kBlockPadding, -kBlockPadding, -kBlockPadding);
  const QString scale = tr("Scale 1 : %1").arg(numberText(m_scale, 4, m_style.locale));
  double top = inner.top();
  text(QRectF(inner.left(), top, 0, kTitleRowHeight), Qt::AlignLeft | Qt::AlignTop, m_title.file, kTitleHeight, true);
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

  const double rule = inner.top() + m_upperHeight + kBlockPadding / 2;
  m_painter.setPen(m_style.pen(m_style.palette.grid, kThinLine));
  m_painter.drawLine(QPointF(m_block.left(), rule), QPointF(m_block.right(), rule));
  paintLegend(QPointF(inner.left(), rule + kBlockPadding / 2));
  paintProblemRows(rule + m_legendHeight + kBlockPadding);
}

std::vector<const base::Problem*> PreviewPage::sortedProblems() const {
  std::vector<const base::Problem*> sorted;
  for (const base::Problem& problem : m_drawing.problems) {
    sorted.push_back(&problem);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const base::Problem* a, const base::Problem* b) {
    return base::severityOf(*a) < base::severityOf(*b);
  });
  return sorted;
}

int PreviewPage::problemRows() const {
  return std::min(static_cast<int>(m_drawing.problems.size()), kMostProblemRows);
}

void PreviewPage::paintProblemRows(double top) {
  const std::vector<const base::Problem*> problems = sortedProblems();
  const auto shown = static_cast<std::size_t>(problemRows());
  const QFontMetricsF metrics(m_style.font(kTextHeight));
  for (std::size_t i = 0; i < shown; ++i, top += kLegendRowHeight) {
    const bool more = i + 1 == shown && problems.size() > shown;
    QString words = tr("… and %1 more").arg(problems.size() - shown + 1);
    if (!more) {
      const base::Problem& problem = *problems[i];
      paintSign(m_painter, QPointF(m_block.left() + 45, top + kLegendRowHeight / 2), base::severityOf(problem),
                m_style);
      words = problemText(problem, m_style.locale);
      if (problem.where) {
        words += QStringLiteral("  (X %1, Y %2)")
                     .arg(fixedText(problem.where->x(), 1, m_style.locale),
                          fixedText(problem.where->y(), 1, m_style.locale));
      }
    }
    text(QRectF(m_block.left() + 80, top, 0, kLegendRowHeight), Qt::AlignLeft | Qt::AlignVCenter,
         metrics.elidedText(words, Qt::ElideRight, m_block.width() - 110));
  }
}

void PreviewPage::paintLegend(const QPointF& topLeft) {
  const std::vector<LegendEntry> entries = legendOf(m_drawing);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = i / m_legendColumns;
    const double x = topLeft.x() + kLegendColumn * static_cast<double>(i % m_legendColumns);
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
  const geometry::Vector size = shownBox(drawing).sizes();
  Figure figure;
  figure.title = title.file;
  figure.page = size.y() > size.x() ? kA4Portrait : kA4Landscape;
  figure.paint = [page = figure.page, drawing = std::move(drawing), title = std::move(title)](QCPPainter& painter) {
    PreviewPage(painter, page, drawing, title).paint();
  };
  return figure;
}

} // namespace arris::ui
