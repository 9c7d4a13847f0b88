#include "ui/figures/polyline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace arris::ui {
namespace {

double length(const QPointF& way) {
  return std::hypot(way.x(), way.y());
}

double direction(const QPointF& way) {
  return std::atan2(way.y(), way.x());
}

// The difference of two directions, rad in [−π, π].
double between(double from, double to) {
  return std::remainder(to - from, 2 * std::numbers::pi);
}

bool isNumber(const QPointF& point) {
  return std::isfinite(point.x()) && std::isfinite(point.y());
}

// The part of the way from `a` to `b` inside the rectangle, as shares of it (Liang and Barsky).
std::optional<std::pair<double, double>> insideShare(const QPointF& a, const QPointF& b, const QRectF& box) {
  double from = 0;
  double to = 1;
  const auto keepBelow = [&](double start, double change, double most) { // start + share·change ≤ most
    if (change == 0) {
      return start <= most;
    }
    const double share = (most - start) / change;
    (change > 0 ? to : from) = change > 0 ? std::min(to, share) : std::max(from, share);
    return from <= to;
  };
  const QPointF way = b - a;
  const bool inside = keepBelow(a.x(), way.x(), box.right()) && keepBelow(-a.x(), -way.x(), -box.left()) &&
                      keepBelow(a.y(), way.y(), box.bottom()) && keepBelow(-a.y(), -way.y(), -box.top());
  return inside ? std::optional(std::pair(from, to)) : std::nullopt;
}

// What of a polygon lies on the positive side of a straight border (Sutherland and Hodgman).
template <typename Side> QPolygonF keptSide(const QPolygonF& polygon, const Side& side) {
  QPolygonF result;
  for (qsizetype i = 0; i < polygon.size(); ++i) {
    const QPointF& a = polygon[i];
    const QPointF& b = polygon[(i + 1) % polygon.size()];
    const double atA = side(a);
    const double atB = side(b);
    if (atA >= 0) {
      result.append(a);
    }
    if ((atA >= 0) != (atB >= 0)) {
      result.append(a + atA / (atA - atB) * (b - a));
    }
  }
  return result;
}

} // namespace

// Aside and beyond the end together a point is off by the hypotenuse.
Thinner::Thinner(double tolerance, QPolygonF& into)
    : m_aside(0.8 * tolerance), m_back(0.6 * tolerance), m_result(into) {}

void Thinner::startAt(const QPointF& anchor) {
  m_result.append(anchor);
  m_anchor = m_last = anchor;
  m_farthest = 0;
  m_open = m_narrowed = false;
}

bool Thinner::fits(const QPointF& point) const {
  const double away = length(point - m_anchor);
  if (away < m_farthest - m_back) { // it turned back: the tip must stay
    return false;
  }
  return !m_narrowed || std::abs(between(m_middle, direction(point - m_anchor))) <= m_half;
}

void Thinner::narrowTo(const QPointF& point) {
  const QPointF way = point - m_anchor;
  const double away = length(way);
  m_farthest = std::max(m_farthest, away);
  if (away <= m_aside) {
    return;
  }
  const double aim = direction(way);
  const double slack = std::asin(m_aside / away);
  if (!m_narrowed) {
    m_middle = aim;
    m_half = slack;
    m_narrowed = true;
    return;
  }
  const double offset = between(m_middle, aim);
  const double least = std::max(-m_half, offset - slack);
  const double most = std::min(m_half, offset + slack);
  m_middle += (least + most) / 2;
  m_half = (most - least) / 2;
}

void Thinner::add(const QPointF& point) {
  if (!m_started) {
    startAt(point);
    m_started = true;
    return;
  }
  if (!fits(point)) {
    startAt(m_last);
  }
  narrowTo(point);
  m_last = point;
  m_open = true;
}

void Thinner::finish() {
  if (m_open) {
    startAt(m_last);
  }
  m_started = false;
}

QPolygonF thinned(const QPolygonF& polyline, double tolerance) {
  QPolygonF result;
  Thinner thinner(tolerance, result);
  for (const QPointF& point : polyline) {
    thinner.add(point);
  }
  thinner.finish();
  return result;
}

QPolygonF columnExtremes(const QPolygonF& curve, double columnWidth) {
  QPolygonF result;
  const auto byHeight = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
  for (auto first = curve.begin(); first != curve.end();) {
    const double column = std::floor(first->x() / columnWidth);
    const auto next =
        std::find_if(first, curve.end(), [&](const QPointF& p) { return std::floor(p.x() / columnWidth) != column; });
    auto [least, greatest] = std::minmax_element(first, next, byHeight);
    if (greatest < least) {
      std::swap(least, greatest);
    }
    const auto last = std::prev(next);
    result.append(*first);
    for (const auto inner : {least, greatest, last}) {
      if (result.back() != *inner) {
        result.append(*inner);
      }
    }
    first = next;
  }
  return result;
}

std::vector<Stretch> clipped(const QPolygonF& polyline, const QRectF& rectangle) {
  std::vector<Stretch> runs;
  double travelled = 0;
  bool joined = false; // the last run ends where the next piece starts
  for (qsizetype i = 1; i < polyline.size(); ++i) {
    const QPointF& a = polyline[i - 1];
    const QPointF& b = polyline[i];
    if (!isNumber(a) || !isNumber(b)) {
      joined = false;
      continue;
    }
    const auto inside = insideShare(a, b, rectangle);
    if (inside) {
      const auto [from, to] = *inside;
      if (!joined || from > 0) {
        runs.push_back({{a + from * (b - a)}, travelled + from * length(b - a)});
      }
      runs.back().points.append(to < 1 ? a + to * (b - a) : b);
    }
    joined = inside && inside->second >= 1;
    travelled += length(b - a);
  }
  return runs;
}

QPolygonF clippedArea(const QPolygonF& polygon, const QRectF& rectangle) {
  QPolygonF result = keptSide(polygon, [&](const QPointF& p) { return p.x() - rectangle.left(); });
  result = keptSide(result, [&](const QPointF& p) { return rectangle.right() - p.x(); });
  result = keptSide(result, [&](const QPointF& p) { return p.y() - rectangle.top(); });
  return keptSide(result, [&](const QPointF& p) { return rectangle.bottom() - p.y(); });
}

} // namespace arris::ui
