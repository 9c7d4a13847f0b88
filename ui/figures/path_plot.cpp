#include "ui/figures/path_plot.h"

#include "core/base/numbers.h"
#include "ui/figures/drawing_painter.h"
#include "ui/figures/polyline.h"
#include "ui/figures/profile_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kMarginLeft = 130;
constexpr double kMarginBelow = 92;
constexpr double kMarginElse = 22;
constexpr double kPathTick = 8;
constexpr double kPlaceRadius = 6;
constexpr double kNameAway = 34;
constexpr double kIndexShift = 9;
constexpr double kCentreHalf = 12;
constexpr double kPathFlatness = 0.3;

constexpr double kBoxRoom = 0.12; // of the box, on each side
constexpr double kLeastBox = 1;   // mm
constexpr double kStepsOfPass = 200;
constexpr double kPathTapReach = 30; // px
constexpr int kPathWheelAlpha = 40;  // of 255
constexpr int kLeastRimPoints = 60;
constexpr int kMostRimPoints = 2000;

// What is painted in a layer of the plot by a function, within the panel.
class Painted : public QCPLayerable {
public:
  Painted(QCustomPlot* plot, const QString& layer, std::function<void(QCPPainter&)> paint)
      : QCPLayerable(plot, layer), m_paint(std::move(paint)) {}

protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override {
    painter->setAntialiasing(true);
  }

  [[nodiscard]] QRect clipRect() const override {
    return mParentPlot->axisRect()->rect();
  }

  void draw(QCPPainter* painter) override {
    m_paint(*painter);
  }

private:
  std::function<void(QCPPainter&)> m_paint;
};

} // namespace

PathPlot::PathPlot(const FigureStyle& style, QWidget* parent) : PointedPlot(style, parent) {
  axisRect()->setupFullAxesBox();
  axisRect()->setAutoMargins(QCP::msNone);
  const QMarginsF margins(kMarginLeft, kMarginElse, kMarginElse, kMarginBelow);
  axisRect()->setMargins((margins * style.unit).toMargins());
  for (QCPAxis* axis : axisRect()->axes()) {
    prepareAxis(*axis);
  }
  xAxis->setLabel(inShownUnits(tr("X, mm"), style.lengths));
  yAxis->setLabel(inShownUnits(tr("Y, mm"), style.lengths));
  new Painted(this, QStringLiteral("main"), [this](QCPPainter& painter) { paintWay(painter); });
  new Painted(this, QStringLiteral("overlay"), [this](QCPPainter& painter) { paintWheels(painter); });
  layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmBuffered);
}

void PathPlot::prepareAxis(QCPAxis& axis) {
  styleAxis(axis);
  axis.setTicks(&axis == xAxis || &axis == yAxis);
  axis.setTickLength(0, static_cast<int>(kPathTick * m_style.unit));
  axis.setNumberFormat(QStringLiteral("gb"));
  axis.setNumberPrecision(6);
  axis.grid()->setZeroLinePen(Qt::NoPen);
}

void PathPlot::setProfiles(const std::vector<ProfileCurves>& profiles, PathSetting setting,
                           std::optional<double> wheelRadius, bool keepView) {
  m_profiles = profiles;
  m_paths.clear();
  for (const ProfileCurves& curves : profiles) {
    m_paths.push_back(pathOf(curves));
  }
  m_setting = std::move(setting);
  m_wheelRadius = wheelRadius;
  m_fromProfile.reset();
  if (!keepView) {
    m_selected = 0;
    showWork();
  }
  refresh();
}

void PathPlot::showPass(const CornerPass& pass) {
  m_selected = pass.corner;
  m_fromProfile.reset();
  if (m_setting.corners.empty() && !m_profiles.empty()) {
    m_fromProfile = placesOf(m_profiles.front(), pass);
  }
  QRectF box = m_profiles.empty() ? QRectF() : boxOf(m_profiles.front(), pass);
  if (const CornerPlaces* corner = placesOfSelected()) {
    QPolygonF places{box.topLeft(), box.bottomRight()};
    for (const PathPlace& place : corner->places) {
      places.append(place.place);
    }
    box = places.boundingRect();
  }
  m_step = std::max((pass.to - pass.from) / kStepsOfPass, 1e-3);
  showBox(box);
}

void PathPlot::selectCorner(int corner) {
  if (corner != m_selected) {
    m_selected = corner;
    m_fromProfile.reset();
    refresh();
  }
}

void PathPlot::showWork() {
  QRectF box;
  for (const std::vector<PathPiece>& path : m_paths) {
    box = box.united(boxOf(path));
  }
  if (!m_setting.glass.box.isEmpty()) {
    box = box.united(QRectF(toQt(m_setting.glass.box.min()), toQt(m_setting.glass.box.max())));
  }
  double duration = 0;
  for (const ProfileCurves& curves : m_profiles) {
    duration = std::max(duration, curves.workTo - curves.workFrom);
  }
  m_step = std::max(duration / kStepsOfPass, 1e-3);
  showBox(box);
}

void PathPlot::showAll() {
  showWork();
  if (const auto& travel = m_setting.glass.travel) {
    showBox(QRectF(toQt(travel->min()), toQt(travel->max())));
  }
}

void PathPlot::showBox(const QRectF& box) {
  m_room = kBoxRoom;
  m_box = box;
  layOut();
  refresh();
}

void PathPlot::showExactly(const QRectF& box) {
  m_room = 0;
  m_box = box;
  layOut();
  refresh();
}

QRectF PathPlot::shownBox() const {
  const double perMillimetre = shown(1);
  return QRectF(QPointF(xAxis->range().lower, yAxis->range().lower) / perMillimetre,
                QPointF(xAxis->range().upper, yAxis->range().upper) / perMillimetre);
}

void PathPlot::layOut() {
  for (const auto phase : {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout}) {
    plotLayout()->update(phase);
  }
  if (m_box) {
    fitBox();
  } else {
    yAxis->setScaleRatio(xAxis, 1);
  }
}

// All of the box in the middle, in one scale.
void PathPlot::fitBox() {
  const QSize room = axisRect()->size();
  if (room.width() < 1 || room.height() < 1) {
    return;
  }
  const double share = 1 + 2 * m_room;
  const double perPixel = std::max(
      {m_box->width() * share / room.width(), m_box->height() * share / room.height(), kLeastBox / room.width()});
  const QPointF middle = m_box->center();
  xAxis->setRange(shown(middle.x()), shown(room.width() * perPixel), Qt::AlignCenter);
  yAxis->setRange(shown(middle.y()), shown(room.height() * perPixel), Qt::AlignCenter);
}

void PathPlot::zoomBy(double factor) {
  m_box.reset();
  xAxis->scaleRange(1 / factor);
  yAxis->scaleRange(1 / factor);
  refresh();
}

void PathPlot::showEvent(QShowEvent* event) {
  layOut();
  PointedPlot::showEvent(event);
}

void PathPlot::resizeEvent(QResizeEvent* event) {
  if (!event->size().isEmpty()) {
    setViewport(QRect(QPoint(), event->size()));
    layOut();
    PointedPlot::resizeEvent(event);
  }
}

void PathPlot::prepareForPrint(const QSize& size) {
  setViewport(QRect(QPoint(), size));
  layOut();
}

QTransform PathPlot::toDevice() const {
  const QPointF origin(xAxis->coordToPixel(0), yAxis->coordToPixel(0));
  const double across = xAxis->coordToPixel(shown(1)) - origin.x();
  const double up = yAxis->coordToPixel(shown(1)) - origin.y();
  return {across, 0, 0, up, origin.x(), origin.y()};
}

const CornerPlaces* PathPlot::placesOfSelected() const {
  if (m_fromProfile) {
    return &*m_fromProfile;
  }
  const auto corner = std::find_if(m_setting.corners.begin(), m_setting.corners.end(),
                                   [this](const CornerPlaces& candidate) { return candidate.corner == m_selected; });
  return corner != m_setting.corners.end() ? &*corner : nullptr;
}

void PathPlot::paintWay(QCPPainter& painter) {
  const QRectF frame = axisRect()->rect();
  paintDrawing(painter, m_setting.glass, toDevice(), frame, m_style);
  const CornerPlaces* corner = placesOfSelected();
  if (corner != nullptr) {
    paintTangents(painter, *corner);
  }
  for (std::size_t i = 0; i < m_paths.size(); ++i) {
    paintPath(painter, m_paths[i], m_paths.size() > 1 && i == 0);
  }
  m_labels = placeCornerLabels(m_setting.glass, toDevice(), frame, m_style);
  if (corner != nullptr) { // its places stand there
    m_labels.erase(std::remove_if(m_labels.begin(), m_labels.end(),
                                  [&](const CornerLabel& label) { return label.corner == corner->corner; }),
                   m_labels.end());
    paintPlaces(painter, *corner);
  }
  paintCornerLabels(painter, m_labels, m_selected, m_style);
}

// Of two ways the first lies wide and pale under the second, as curves do.
void PathPlot::paintPath(QCPPainter& painter, const std::vector<PathPiece>& path, bool under) const {
  const QTransform map = toDevice();
  painter.setBrush(Qt::NoBrush);
  for (const PathPiece& piece : path) {
    const QColor color = piece.inCorner ? m_style.palette.transition : m_style.palette.path;
    const QPen pen = under ? overlaidPen(m_style, color) : m_style.pen(color, piece.inCorner ? kLine + 1 : kLine);
    painter.setPen(pen);
    const QPolygonF line = thinned(map.map(piece.points), kPathFlatness * m_style.unit);
    for (const Stretch& run : clipped(line, axisRect()->rect())) {
      painter.drawPolyline(run.points);
    }
  }
}

// The tangents that meet in Q.
void PathPlot::paintTangents(QCPPainter& painter, const CornerPlaces& corner) const {
  const auto placeOf = [&](const QString& name) {
    const auto found = std::find_if(corner.places.begin(), corner.places.end(),
                                    [&](const PathPlace& place) { return place.name == name; });
    return found != corner.places.end() ? std::optional(found->place) : std::nullopt;
  };
  const auto a = placeOf(QStringLiteral("A"));
  const auto q = placeOf(QStringLiteral("Q"));
  const auto c = placeOf(QStringLiteral("C"));
  if (a && q && c) {
    QPen pen = m_style.pen(m_style.palette.faint, kThinLine);
    pen.setDashPattern({4, 4});
    painter.setPen(pen);
    for (const Stretch& run : clipped(toDevice().map(QPolygonF{*a, *q, *c}), axisRect()->rect())) {
      painter.drawPolyline(run.points);
    }
  }
}

void PathPlot::paintPlaces(QCPPainter& painter, const CornerPlaces& corner) const {
  const QTransform map = toDevice();
  for (const PathPlace& place : corner.places) {
    const QPointF at = map.map(place.place);
    if (axisRect()->rect().contains(at.toPoint())) {
      painter.setPen(m_style.pen(m_style.palette.ink, kLine));
      painter.setBrush(m_style.palette.paper);
      painter.drawEllipse(at, kPlaceRadius * m_style.unit, kPlaceRadius * m_style.unit);
      paintName(painter, place);
    }
  }
}

void PathPlot::paintName(QCPPainter& painter, const PathPlace& place) const {
  const QPointF away = place.away.isNull() ? QPointF(0.7, 0.7) : place.away;
  const QPointF at = toDevice().map(place.place) + QPointF(away.x(), -away.y()) * kNameAway * m_style.unit;
  const QFont font = m_style.font(kTextHeight, true);
  const QFont lower = m_style.font(0.8 * kSmallTextHeight, true);
  const double width = QFontMetricsF(font).horizontalAdvance(place.name);
  const double all = width + QFontMetricsF(lower).horizontalAdvance(place.index);
  painter.setPen(m_style.palette.ink);
  painter.setFont(font);
  painter.drawText(QRectF(at.x() - all / 2, at.y(), 0, 0), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                   place.name);
  painter.setFont(lower);
  painter.drawText(QRectF(at.x() - all / 2 + width, at.y() + kIndexShift * m_style.unit, 0, 0),
                   Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, place.index);
}

void PathPlot::paintWheels(QCPPainter& painter) const {
  const QRectF frame = axisRect()->rect();
  const QTransform map = toDevice();
  const double radius = m_wheelRadius.value_or(0) * std::abs(map.m11());
  for (std::size_t i = 0; m_instant && i < m_profiles.size(); ++i) {
    const std::optional<QPointF> place = placeAt(m_profiles[i], *m_instant);
    if (!place) {
      continue;
    }
    const bool under = m_profiles.size() > 1 && i == 0;
    const QPointF at = map.map(*place);
    QPolygonF rim;
    const int points = std::clamp(static_cast<int>(radius), kLeastRimPoints, kMostRimPoints);
    for (int k = 0; k <= points; ++k) {
      const double angle = 2 * base::kPi * k / points;
      rim.append(at + radius * QPointF(std::cos(angle), std::sin(angle)));
    }
    QColor disc = m_style.palette.x;
    const QPen pen = under ? overlaidPen(m_style, disc) : m_style.pen(disc, kLine);
    disc.setAlpha(kPathWheelAlpha);
    painter.setPen(Qt::NoPen);
    painter.setBrush(under ? QBrush() : QBrush(disc));
    painter.drawPolygon(clippedArea(rim, frame));
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    const QPointF half(kCentreHalf * m_style.unit, kCentreHalf * m_style.unit);
    const QPointF other(half.x(), -half.y());
    for (const QPolygonF& line : {rim, QPolygonF{at - half, at + half}, QPolygonF{at - other, at + other}}) {
      for (const Stretch& run : clipped(line, frame)) {
        painter.drawPolyline(run.points);
      }
    }
  }
}

void PathPlot::pointBeside(int steps) {
  if (!m_profiles.empty()) {
    const ProfileCurves& curves = m_profiles.front();
    const double from = m_instant.value_or(curves.workFrom);
    Q_EMIT instantPointed(std::clamp(from + steps * m_step, curves.workFrom, curves.workTo));
  }
}

// The nearest place of the uppermost way, where it is near enough.
void PathPlot::pointAt(const QPointF& place) {
  if (m_paths.empty()) {
    return;
  }
  const QTransform map = toDevice();
  double best = kPathTapReach;
  std::optional<double> time;
  for (const PathPiece& piece : m_paths.back()) {
    const QPolygonF line = map.map(piece.points);
    for (qsizetype i = 1; i < line.size(); ++i) {
      const QPointF way = line[i] - line[i - 1];
      const double square = QPointF::dotProduct(way, way);
      const double share =
          square > 0 ? std::clamp(QPointF::dotProduct(place - line[i - 1], way) / square, 0.0, 1.0) : 0.0;
      const QPointF off = place - line[i - 1] - share * way;
      if (const double away = std::hypot(off.x(), off.y()); away < best) {
        const auto at = static_cast<std::size_t>(i);
        best = away;
        time = piece.times[at - 1] + share * (piece.times[at] - piece.times[at - 1]);
      }
    }
  }
  if (time) {
    Q_EMIT instantPointed(*time);
  }
}

void PathPlot::mouseReleaseEvent(QMouseEvent* event) {
  PointedPlot::mouseReleaseEvent(event);
  if (!isTap(*event)) {
    m_box.reset();
    return;
  }
  for (const CornerLabel& label : m_labels) {
    const double grow = std::max(0.0, kPathTapReach - label.box.height() / 2);
    if (label.box.adjusted(-grow, -grow, grow, grow).contains(event->position())) {
      Q_EMIT cornerTapped(label.corner);
      return;
    }
  }
  pointAt(event->position());
}

void PathPlot::wheelEvent(QWheelEvent* event) {
  m_box.reset();
  PointedPlot::wheelEvent(event);
}

} // namespace arris::ui
