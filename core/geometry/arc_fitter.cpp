#include "core/geometry/arc_fitter.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arris::geometry {
namespace {

/// Of the tolerance; the rest is for what lies between the places looked at.
constexpr double kShare = 0.85;

/// Of the tolerance: a stretch that is shorter and still not calm has no direction worth keeping.
constexpr double kLeastLength = 0.04;

/// A stretch for one biarc turns by no more than this in all, and by no more than that between two places, rad.
constexpr double kMostTurn = 1.6;
constexpr double kMostTurnOfHop = 0.35;

/// No hop between two places is more than this part of the whole: a parameter that runs unevenly hides nothing.
constexpr double kMostHop = 1.0 / 3;

/// A stretch of the parameter shorter than this is a point.
constexpr double kLeastStretch = 1e-12;

double distanceFrom(const Biarc& biarc, const Point& point) {
  const double first = nearest(biarc.first, point).distance;
  return biarc.second ? std::min(first, nearest(*biarc.second, point).distance) : first;
}

bool facesEachOther(const Station& start, const Station& end) {
  constexpr double kLeastCosine = 0.3;
  const Vector way = end.point - start.point;
  const double least = kLeastCosine * way.norm();
  return start.tangent.dot(way) > least && end.tangent.dot(way) > least;
}

} // namespace

/// What is seen of a stretch: its length in hops, and whether one biarc can be expected to follow it.
struct ArcFitter::Look {
  double length = 0;
  bool calm = false;
};

bool ArcFitter::follow(const Trace& trace, const Station& start, const Station& end, int places) {
  follow(trace, Stretch{0, 1, start, end}, places);
  return m_looksLeft > 0;
}

std::vector<Curve> ArcFitter::takeChain() {
  m_reached.reset();
  m_last.reset();
  return std::exchange(m_chain, {});
}

Point ArcFitter::startOf(const Stretch& stretch) const {
  return m_reached.value_or(stretch.start.point);
}

// The stations looked at are left in `m_stations`, both ends included.
ArcFitter::Look ArcFitter::lookAt(const Trace& trace, const Stretch& stretch, int places) {
  m_stations.clear();
  m_stations.push_back(stretch.start);
  for (int i = 1; i < places; ++i) {
    m_stations.push_back(trace(stretch.from + (stretch.to - stretch.from) * i / places));
  }
  m_stations.push_back(stretch.end);
  Look look;
  double turned = 0;
  double mostTurn = 0;
  double mostHop = 0;
  for (std::size_t i = 1; i < m_stations.size(); ++i) {
    const double hop = (m_stations[i].point - m_stations[i - 1].point).norm();
    const double angle = std::abs(turn(m_stations[i - 1].tangent, m_stations[i].tangent));
    look.length += hop;
    turned += angle;
    mostHop = std::max(mostHop, hop);
    mostTurn = std::max(mostTurn, angle);
  }
  look.calm = turned < kMostTurn && mostTurn < kMostTurnOfHop && mostHop < kMostHop * look.length &&
              facesEachOther({startOf(stretch), stretch.start.tangent}, stretch.end);
  return look;
}

// Equal parts, as many as the deviation (it grows with the third power) makes likely to do: the same from either end.
void ArcFitter::follow(const Trace& trace, const Stretch& stretch, int places) {
  if (--m_looksLeft <= 0) {
    return;
  }
  const Look look = lookAt(trace, stretch, places);
  int parts = 2;
  if (look.calm) {
    const Biarc biarc = biarcBetween({startOf(stretch), stretch.start.tangent}, stretch.end);
    double deviation = 0;
    for (const Station& station : m_stations) {
      deviation = std::max(deviation, distanceFrom(biarc, station.point));
    }
    if (deviation <= kShare * m_tolerance) {
      append({startOf(stretch), stretch.start.tangent}, stretch.end);
      return;
    }
    parts = static_cast<int>(std::clamp(std::ceil(std::cbrt(deviation / (kShare * m_tolerance))), 2.0, 8.0));
  }
  if (look.length > kLeastLength * m_tolerance && stretch.to - stretch.from > kLeastStretch) {
    split(trace, stretch, places, parts);
  } else {
    moveEnd(m_last ? stretch.end.point : startOf(stretch));
  }
}

void ArcFitter::split(const Trace& trace, const Stretch& stretch, int places, int parts) {
  Stretch part = stretch;
  for (int i = 1; i <= parts && m_looksLeft > 0; ++i) {
    part.to = i == parts ? stretch.to : stretch.from + (stretch.to - stretch.from) * i / parts;
    part.end = i == parts ? stretch.end : trace(part.to);
    follow(trace, part, places);
    part.from = part.to;
    part.start = part.end;
  }
}

void ArcFitter::append(const Station& start, const Station& end) {
  m_last = Last{start, end, m_chain.size()};
  const Biarc biarc = biarcBetween(start, end);
  m_chain.push_back(biarc.first);
  if (biarc.second) {
    m_chain.push_back(*biarc.second);
  }
  m_reached = end.point;
}

// The last curves take in what is too short for a curve of its own; what the chain begins with the next ones will.
void ArcFitter::moveEnd(const Point& end) {
  m_reached = end;
  if (m_last) {
    const Last last = *m_last;
    m_chain.resize(last.firstCurve);
    append(last.start, {end, last.end.tangent});
  }
}

} // namespace arris::geometry
