#include "ui/figures/job_sheet.h"

#include "core/base/window_thread.h"
#include "core/recipe/fields.h"
#include "ui/figures/corner_labels.h"
#include "ui/figures/drawing_legend.h"
#include "ui/figures/drawing_painter.h"
#include "ui/figures/preview_figure.h"
#include "ui/figures/sheet.h"
#include "ui/text/job_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <qcustomplot.h>

#include <algorithm>
#include <memory>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kSheetLeft = 150; // wider: the sheet is filed
constexpr double kSheetRight = 100;
constexpr double kSheetTop = 100;
constexpr double kSheetBottom = 100;
constexpr double kHeadRoom = 60; // above the rows: file and date
constexpr double kFootRoom = 60;
constexpr double kPartTitleHeight = 56;
constexpr double kSheetTitleHeight = 64;
constexpr double kSheetLine = 38;
constexpr double kPictureHeight = 1000;
constexpr double kPictureMargin = 90; // of the drawing in its frame: room for the corners' numbers
constexpr double kSheetLegendWidth = 440;
constexpr double kSignRoom = 60;
// Of half the width, for the name of a value.
constexpr double kRecipeNames = 0.7;
constexpr double kMachineNames = 0.44;

constexpr int kValueDecimals = 6;

struct NamedValue {
  QString name;
  QString value;
};

class SheetMaker {
  Q_DECLARE_TR_FUNCTIONS(JobSheet)

public:
  SheetMaker(const job::Job& job, const Drawing& drawing, QString file, QString date, const QLocale& locale)
      : m_job(job), m_drawing(std::make_shared<Drawing>(drawing)), m_file(std::move(file)), m_date(std::move(date)) {
    m_style.locale = locale;
  }

  [[nodiscard]] std::vector<Figure> pages() const;

private:
  [[nodiscard]] SheetPart heading() const;
  [[nodiscard]] SheetPart corners() const;
  [[nodiscard]] SheetPart times() const;
  [[nodiscard]] SheetPart findings(const QString& title, const base::Problems& problems) const;
  [[nodiscard]] SheetPart listOf(const QString& title, const std::vector<NamedValue>& values, double names) const;
  [[nodiscard]] std::vector<NamedValue> recipe() const;
  [[nodiscard]] std::vector<NamedValue> choices() const;
  [[nodiscard]] std::vector<NamedValue> machine() const;
  [[nodiscard]] SheetRow textRow(const QString& words, double height, double textHeight, bool bold) const;
  [[nodiscard]] SheetRow picture() const;
  [[nodiscard]] SheetRow legend() const;
  [[nodiscard]] SheetRow finding(const base::Problem& problem) const;
  [[nodiscard]] std::vector<QString> cells(const toolpath::Corner& corner) const;
  [[nodiscard]] QString number(double value, int decimals = kValueDecimals) const;
  [[nodiscard]] QString placeOf(const std::optional<Eigen::Vector2d>& place) const;
  [[nodiscard]] QString axes(const Eigen::Vector3d& values, const QString& unit) const;
  [[nodiscard]] Figure page(const std::vector<PlacedRow>& rows, std::size_t at, std::size_t count) const;

  static double width() {
    return kA4Portrait.width() - kSheetLeft - kSheetRight;
  }

  static QString yesOrNo(bool is) {
    return is ? tr("yes") : tr("no");
  }

  const job::Job& m_job;
  std::shared_ptr<const Drawing> m_drawing;
  QString m_file;
  QString m_date;
  FigureStyle m_style;
};

QString SheetMaker::number(double value, int decimals) const {
  return numberText(value, decimals, m_style.locale);
}

QString SheetMaker::placeOf(const std::optional<Eigen::Vector2d>& place) const {
  return place ? tr("X %1, Y %2 mm").arg(number(place->x(), 3), number(place->y(), 3)) : tr("chosen by the program");
}

QString SheetMaker::axes(const Eigen::Vector3d& values, const QString& unit) const {
  return QStringLiteral("X %1, Y %2, Z %3 %4").arg(number(values.x()), number(values.y()), number(values.z()), unit);
}

SheetRow SheetMaker::textRow(const QString& words, double height, double textHeight, bool bold) const {
  return {height, [=, style = m_style](QPainter& painter, const QRectF& box) {
            const QFont font = style.font(textHeight, bold);
            painter.setPen(style.palette.ink);
            painter.setFont(font);
            painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                             QFontMetricsF(font).elidedText(words, Qt::ElideMiddle, box.width()));
          }};
}

SheetPart SheetMaker::heading() const {
  SheetPart part;
  part.rows.push_back(textRow(tr("Job sheet: %1").arg(m_file), kSheetTitleHeight, kTitleHeight, true));
  for (const QString& line : previewTitle(m_job, m_file, m_style.locale).lines) {
    part.rows.push_back(textRow(line, kSheetLine, kTextHeight, false));
  }
  part.rows.push_back(picture());
  part.rows.push_back(legend());
  return part;
}

SheetRow SheetMaker::picture() const {
  return {kPictureHeight, [drawing = m_drawing, style = m_style](QPainter& painter, const QRectF& area) {
            const QRectF frame = area.adjusted(0, 20, 0, -10);
            const QRectF inner = frame.adjusted(kPictureMargin, kPictureMargin, -kPictureMargin, -kPictureMargin);
            if (!drawing->box.isEmpty()) {
              const QPointF size = toQt(geometry::Point(drawing->box.sizes()));
              const double scale =
                  std::min(inner.width() / std::max(size.x(), 1e-3), inner.height() / std::max(size.y(), 1e-3));
              const QPointF middle = toQt(drawing->box.center());
              QTransform map = QTransform::fromTranslate(frame.center().x(), frame.center().y());
              map.scale(scale, -scale);
              map.translate(-middle.x(), -middle.y());
              paintDrawing(painter, *drawing, map, frame, style);
              paintCornerLabels(painter, placeCornerLabels(*drawing, map, frame.adjusted(15, 15, -15, -15), style), 0,
                                style);
            }
            painter.setPen(style.pen(style.palette.ink, kLine));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(frame);
          }};
}

SheetRow SheetMaker::legend() const {
  const std::vector<LegendEntry> entries = legendOf(*m_drawing);
  const auto columns = static_cast<std::size_t>(width() / kSheetLegendWidth);
  const std::size_t rows = (entries.size() + columns - 1) / columns;
  return {kSheetLine * static_cast<double>(rows), [=, style = m_style](QPainter& painter, const QRectF& area) {
            for (std::size_t i = 0; i < entries.size(); ++i) {
              const std::size_t row = i / columns;
              const QPointF left(area.left() + kSheetLegendWidth * static_cast<double>(i % columns),
                                 area.top() + kSheetLine * (static_cast<double>(row) + 0.5));
              entries[i].sample(painter, left, style);
              painter.setPen(style.palette.ink);
              painter.setFont(style.font(kSmallTextHeight));
              painter.drawText(QRectF(left.x() + kLegendSample + 15, left.y(), 0, 0),
                               Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, entries[i].words);
            }
          }};
}

// Two values in a row.
SheetPart SheetMaker::listOf(const QString& title, const std::vector<NamedValue>& values, double names) const {
  const double half = width() / 2;
  const std::vector<SheetColumn> columns = {{{}, names * half, Qt::AlignLeft},
                                            {{}, (1 - names) * half, Qt::AlignLeft},
                                            {{}, names * half, Qt::AlignLeft},
                                            {{}, (1 - names) * half, Qt::AlignLeft}};
  SheetPart part{title};
  for (std::size_t i = 0; i < values.size(); i += 2) {
    std::vector<QString> cells{values[i].name, values[i].value};
    if (i + 1 < values.size()) {
      cells.insert(cells.end(), {values[i + 1].name, values[i + 1].value});
    }
    part.rows.push_back(tableRow(columns, cells, m_style));
  }
  return part;
}

std::vector<NamedValue> SheetMaker::recipe() const {
  std::vector<NamedValue> values;
  for (const recipe::NumberField& field : recipe::numberFields()) {
    const QString unit = toQString(field.unit);
    const QString space = unit == QStringLiteral("°") ? QString() : QString(QChar::Nbsp);
    values.push_back({fieldText(field), number(m_job.recipe.*field.member) + space + unit});
  }
  for (NamedValue& choice : choices()) {
    values.push_back(std::move(choice));
  }
  return values;
}

std::vector<NamedValue> SheetMaker::choices() const {
  const recipe::Recipe& r = m_job.recipe;
  QStringList layers;
  for (const std::string& layer : r.layers) {
    layers << QString::fromStdString(layer);
  }
  const QString mirror = r.mirror == recipe::Mirror::X   ? tr("X reversed")
                         : r.mirror == recipe::Mirror::Y ? tr("Y reversed")
                                                         : tr("no");
  static const std::array kUnits{QT_TR_NOOP("mm"), QT_TR_NOOP("cm"), QT_TR_NOOP("m"), QT_TR_NOOP("inch"),
                                 QT_TR_NOOP("foot")};
  return {
      {tr("Accelerations bind"),
       r.accelerationRule == recipe::AccelerationRule::PerAxis ? tr("each axis on its own") : tr("X and Y together")},
      {tr("Direction round outlines"),
       r.direction == recipe::Direction::Clockwise ? tr("clockwise") : tr("counter-clockwise")},
      {tr("Mirrored"), mirror},
      {tr("Unit of the drawing"), r.units ? tr(kUnits.at(static_cast<std::size_t>(*r.units))) : tr("as its file says")},
      {tr("Layers"), layers.isEmpty() ? tr("all") : layers.join(QStringLiteral(", "))},
      {tr("What the wheel cannot reach may stay unground"), yesOrNo(r.acceptUnreached)},
      {tr("Start nearest to"), placeOf(r.start)},
      {tr("Lower left of the pane"), placeOf(r.place)}};
}

std::vector<NamedValue> SheetMaker::machine() const {
  const recipe::Machine& m = m_job.machine;
  return {{tr("Travel"), axes(m.travel, QStringLiteral("mm"))},
          {tr("Greatest speed"), axes(m.maxSpeed, QStringLiteral("mm/min"))},
          {tr("Greatest acceleration"), axes(m.maxAccel, QStringLiteral("mm/s²"))},
          {tr("Park position"), axes(m.park, QStringLiteral("mm"))},
          {tr("Feed when going down"), number(m.plungeFeed) + QStringLiteral(" mm/min")},
          {tr("Period of the axes"), number(1000 * m.period) + QStringLiteral(" ms")},
          {tr("Back-off from the glass"), tr("%1 mm after %2 s").arg(number(m.backOff), number(m.backOffAfter))},
          {tr("Following error allowed"), number(m.followingError) + QStringLiteral(" mm")}};
}

std::vector<QString> SheetMaker::cells(const toolpath::Corner& corner) const {
  const bool isTransition = corner.treatment == toolpath::Treatment::Transition;
  const auto ofTransition = [&](double value, int decimals) {
    return isTransition ? fixedText(value, decimals, m_style.locale) : QStringLiteral("–");
  };
  const double margin = corner.widest - m_job.recipe.wheelRadius - corner.tipDepth;
  return {QString::number(corner.id),
          QString::number(corner.contour),
          angleText(corner.angle, m_style.locale),
          cornerKindText(corner.kind),
          treatmentText(corner.treatment),
          ofTransition(corner.transitionSpeed, 2),
          ofTransition(corner.blendTime, 3),
          (isTransition && margin >= 0 ? QStringLiteral("+") : QString()) + ofTransition(margin, 2)};
}

SheetPart SheetMaker::corners() const {
  const std::vector<SheetColumn> columns = {
      {tr("Corner"), 190, Qt::AlignRight},    {tr("Contour"), 200, Qt::AlignRight},
      {tr("Angle β"), 190, Qt::AlignRight},   {tr("Kind"), 230, Qt::AlignLeft},
      {tr("Treatment"), 320, Qt::AlignLeft},  {tr("Speed v, mm/s"), 240, Qt::AlignRight},
      {tr("Time t, s"), 200, Qt::AlignRight}, {tr("Relief margin, mm"), 280, Qt::AlignRight}};
  SheetPart part{tr("Corners")};
  if (m_job.toolpath.corners.empty()) {
    part.rows.push_back(textRow(tr("None."), kSheetLine, kSmallTextHeight, false));
    return part;
  }
  part.head = tableHead(columns, m_style);
  for (const toolpath::Corner& corner : m_job.toolpath.corners) {
    part.rows.push_back(tableRow(columns, cells(corner), m_style));
  }
  return part;
}

SheetPart SheetMaker::times() const {
  SheetPart part{tr("Times")};
  if (m_job.pieces.empty()) {
    part.rows.push_back(textRow(tr("The pattern cannot be ground."), kSheetLine, kSmallTextHeight, false));
    return part;
  }
  const std::vector<SheetColumn> columns = {
      {tr("Phase"), 700, Qt::AlignLeft}, {tr("Duration"), 350, Qt::AlignRight}, {tr("Share"), 200, Qt::AlignRight}};
  part.head = tableHead(columns, m_style);
  const auto add = [&](const QString& what, double seconds) {
    const QString share = fixedText(100 * seconds / m_job.duration, 0, m_style.locale) + QChar::Nbsp + QLatin1Char('%');
    part.rows.push_back(tableRow(columns, {what, durationText(seconds, m_style.locale), share}, m_style));
  };
  for (int i = 0; i < job::kPhaseCount; ++i) {
    if (const double seconds = m_job.byPhase.at(static_cast<std::size_t>(i)); seconds > 0) {
      add(phaseText(static_cast<job::Phase>(i)), seconds);
    }
  }
  add(tr("Grinding, lead-in to lead-out"), m_job.working);
  add(tr("Whole program"), m_job.duration);
  return part;
}

SheetRow SheetMaker::finding(const base::Problem& problem) const {
  const QString words = (problemText(problem, m_style.locale, m_style.lengths) + QLatin1Char(' ') +
                         placeText(problem, m_style.locale, m_style.lengths))
                            .trimmed();
  const std::vector<SheetColumn> columns = {{{}, kSignRoom, Qt::AlignLeft}, {{}, width() - kSignRoom, Qt::AlignLeft}};
  SheetRow row = tableRow(columns, {{}, words}, m_style);
  row.height = std::max(row.height, 1.3 * kSheetLine);
  row.paint = [text = row.paint, severity = base::severityOf(problem), style = m_style](QPainter& painter,
                                                                                        const QRectF& box) {
    text(painter, box);
    paintSign(painter, QPointF(box.left() + kSignRoom / 2, box.center().y()), severity, style);
  };
  return row;
}

SheetPart SheetMaker::findings(const QString& title, const base::Problems& problems) const {
  SheetPart part{title};
  for (const base::Problem& problem : problems) {
    part.rows.push_back(finding(problem));
  }
  if (problems.empty()) {
    part.rows.push_back(textRow(tr("None."), kSheetLine, kSmallTextHeight, false));
  }
  return part;
}

Figure SheetMaker::page(const std::vector<PlacedRow>& rows, std::size_t at, std::size_t count) const {
  Figure figure;
  figure.title = tr("Job sheet: %1").arg(m_file);
  figure.page = kA4Portrait;
  const QString foot = tr("Page %1 of %2").arg(at).arg(count);
  figure.paint = [rows, foot, file = m_file, date = m_date, style = m_style](QCPPainter& painter) {
    const QRectF sheet(kSheetLeft, kSheetTop, width(), kA4Portrait.height() - kSheetTop - kSheetBottom);
    const QFont font = style.font(kSmallTextHeight);
    painter.setPen(style.palette.faint);
    painter.setFont(font);
    const double dateWidth = QFontMetricsF(font).horizontalAdvance(date) + kSignRoom;
    painter.drawText(sheet, Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip,
                     QFontMetricsF(font).elidedText(file, Qt::ElideMiddle, sheet.width() - dateWidth));
    painter.drawText(sheet, Qt::AlignRight | Qt::AlignTop | Qt::TextDontClip, date);
    painter.drawText(sheet, Qt::AlignLeft | Qt::AlignBottom | Qt::TextDontClip, QStringLiteral("Arris"));
    painter.drawText(sheet, Qt::AlignRight | Qt::AlignBottom | Qt::TextDontClip, foot);
    for (const PlacedRow& placed : rows) {
      placed.row.paint(painter,
                       QRectF(sheet.left(), sheet.top() + kHeadRoom + placed.top, sheet.width(), placed.row.height));
    }
  };
  return figure;
}

std::vector<Figure> SheetMaker::pages() const {
  const std::vector<SheetPart> parts = {heading(),
                                        listOf(tr("Recipe"), recipe(), kRecipeNames),
                                        listOf(tr("Machine"), machine(), kMachineNames),
                                        times(),
                                        findings(tr("Problems"), m_drawing->problems),
                                        findings(tr("Repairs of the drawing"), m_drawing->repairs),
                                        corners()};
  const double room = kA4Portrait.height() - kSheetTop - kSheetBottom - kHeadRoom - kFootRoom;
  const auto rows = paginated(parts, room, [this](const QString& title, bool continued) {
    return textRow(continued ? tr("%1, continued").arg(title) : title, kPartTitleHeight, kTextHeight * 1.2, true);
  });
  std::vector<Figure> pages;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    pages.push_back(page(rows[i], i + 1, rows.size()));
  }
  return pages;
}

} // namespace

std::vector<Figure> jobSheet(const job::Job& job, const Drawing& drawing, const QString& file, const QString& date,
                             const QLocale& locale) {
  base::takesLong("jobSheet");
  return SheetMaker(job, drawing, file, date, locale).pages();
}

} // namespace arris::ui
