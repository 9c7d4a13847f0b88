#include "ui/figures/place_signs.h"

#include "ui/figures/drawing_painter.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kSignReach = 54; // nearer than this two signs, or a number and a sign, would cover each other
constexpr double kCountHeight = 26;
constexpr double kCountShift = 13;

constexpr std::size_t kMostSigns = 50;

struct Finding {
  QPointF place;
  base::Severity severity;
};

void append(std::vector<Finding>& findings, const base::Problems& problems, const QTransform& toDevice,
            const QRectF& frame) {
  for (const base::Problem& problem : problems) {
    const QPointF place = problem.where ? toDevice.map(toQt(*problem.where)) : QPointF();
    if (problem.where && frame.contains(place)) {
      findings.push_back({place, base::severityOf(problem)});
    }
  }
}

// Each finding joins a sign within `reach`, or becomes one: the worst, which come first, keep their places.
std::vector<PlaceSign> clustered(const std::vector<Finding>& findings, double reach) {
  std::vector<PlaceSign> signs;
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells; // of signs, `reach` wide
  for (const Finding& finding : findings) {
    const int column = static_cast<int>(std::floor(finding.place.x() / reach));
    const int row = static_cast<int>(std::floor(finding.place.y() / reach));
    PlaceSign* near = nullptr;
    for (int i = 0; i < 9 && near == nullptr; ++i) {
      const auto cell = cells.find({column + i % 3 - 1, row + i / 3 - 1});
      for (std::size_t k = 0; cell != cells.end() && k < cell->second.size(); ++k) {
        PlaceSign& sign = signs[cell->second[k]];
        const QPointF way = sign.place - finding.place;
        if (std::hypot(way.x(), way.y()) < reach) {
          near = &sign;
        }
      }
    }
    if (near != nullptr) {
      ++near->count;
    } else {
      cells[{column, row}].push_back(signs.size());
      signs.push_back({finding.place, finding.severity, 1});
    }
  }
  return signs;
}

void paintCount(QPainter& painter, const PlaceSign& sign, const FigureStyle& style) {
  const QString count = QString::number(sign.count);
  const double height = kCountHeight * style.unit;
  const QFont font = style.font(0.8 * kCountHeight, true);
  const double width = QFontMetricsF(font).horizontalAdvance(count) + 0.5 * height;
  const QPointF corner = sign.place + QPointF(kCountShift, -kCountShift) * style.unit;
  const QRectF box(corner.x(), corner.y() - height / 2, width, height);
  painter.setPen(style.pen(style.palette.ink, kThinLine));
  painter.setBrush(style.palette.paper);
  painter.drawRoundedRect(box, height / 3, height / 3);
  painter.setFont(font);
  painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, count);
}

} // namespace

std::vector<PlaceSign> placeSigns(const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                                  const FigureStyle& style) {
  std::vector<Finding> findings;
  append(findings, drawing.problems, toDevice, frame);
  append(findings, drawing.repairs, toDevice, frame);
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
  double reach = kSignReach * style.unit;
  std::vector<PlaceSign> signs = clustered(findings, reach);
  while (signs.size() > kMostSigns) {
    reach *= 1.5;
    signs = clustered(findings, reach);
  }
  return signs;
}

void paintSigns(QPainter& painter, const std::vector<PlaceSign>& signs, const FigureStyle& style) {
  std::for_each(signs.rbegin(), signs.rend(), [&](const PlaceSign& sign) {
    paintSign(painter, sign.place, sign.worst, style);
    if (sign.count > 1) {
      paintCount(painter, sign, style);
    }
  });
}

} // namespace arris::ui
