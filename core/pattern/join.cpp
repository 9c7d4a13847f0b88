#include "core/pattern/join.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/clean_pieces.h"
#include "core/pattern/course.h"
#include "core/pattern/match_ends.h"

#include <algorithm>
#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using base::Problem;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;

/// A sweep that lacks less than this of a full circle is one, rad.
constexpr double kFullSweep = 1e-12;

/// An arc that sweeps more than this keeps its radius when its ends move, rad: its short chord says little about it.
constexpr double kMostSweepOnChord = 1.5 * kPi;

/// The ends of a closed piece lie in one place to the rounding of the file, mm.
constexpr double kSameEnd = 1e-4;

/// A piece in the direction of its chain, and where its ends come to lie.
struct Link {
  Chain piece;
  bool backwards = false;
  Point from;
  Point to;
};

/// Walks from piece to piece along the joints.
class ChainWalk {
public:
  ChainWalk(const Pieces& pieces, const Matches& matches)
      : m_pieces(pieces), m_matches(matches), m_visited(pieces.size(), false) {}

  /// The chain that begins at `start`, up to a free end or once round; empty where it was walked before.
  std::vector<Link> from(EndId start) {
    std::vector<Link> chain;
    for (EndId end = start; end != kNoEnd && !m_visited[pieceOf(end)];) {
      m_visited[pieceOf(end)] = true;
      const EndId exit = otherEnd(end);
      chain.push_back({m_pieces[pieceOf(end)], !isStart(end), m_matches.joints[end], m_matches.joints[exit]});
      end = m_matches.partner[exit];
    }
    return chain;
  }

private:
  const Pieces& m_pieces;
  const Matches& m_matches;
  std::vector<bool> m_visited;
};

bool hasCollapsed(const Link& link) {
  return link.piece.size() == 1 && std::holds_alternative<Line>(link.piece.front()) &&
         (link.to - link.from).norm() < base::kZeroLength;
}

// Closing gaps can leave a short line between them without length: its neighbours meet then.
void dropCollapsed(std::vector<Link>& chain, bool closed) {
  std::vector<Link> kept;
  kept.reserve(chain.size());
  for (const Link& link : chain) {
    if (!hasCollapsed(link)) {
      kept.push_back(link);
      if (kept.size() > 1) {
        kept.back().from = kept[kept.size() - 2].to;
      }
    }
  }
  if (closed && !kept.empty()) {
    kept.back().to = kept.front().from;
  }
  chain = std::move(kept);
}

void appendPiece(const Link& link, std::vector<Curve>& curves) {
  const std::size_t first = curves.size();
  curves.insert(curves.end(), link.piece.begin(), link.piece.end());
  if (link.backwards) {
    std::reverse(curves.begin() + static_cast<std::ptrdiff_t>(first), curves.end());
    std::transform(curves.begin() + static_cast<std::ptrdiff_t>(first), curves.end(),
                   curves.begin() + static_cast<std::ptrdiff_t>(first), geometry::reversed);
  }
  if (link.piece.size() == 1) {
    curves.back() = withEnds(curves.back(), link.from, link.to);
  } else {
    curves[first] = withEnds(curves[first], link.from, geometry::endPoint(curves[first]));
    curves.back() = withEnds(curves.back(), geometry::startPoint(curves.back()), link.to);
  }
}

std::vector<Curve> curvesOf(const std::vector<Link>& chain) {
  std::vector<Curve> curves;
  curves.reserve(chain.size());
  for (const Link& link : chain) {
    appendPiece(link, curves);
  }
  return curves;
}

// A closed chain of one curve is an arc that closes on itself, or a line whose ends met.
void addClosed(const std::vector<Link>& links, Chains& chains) {
  std::vector<Curve> chain = curvesOf(links);
  if (chain.size() > 1) {
    chains.closed.push_back(std::move(chain));
    return;
  }
  const Curve& only = links.front().piece.front();
  if (const auto* arc = std::get_if<Arc>(&only); arc && std::abs(arc->sweep()) > kPi) {
    chains.closed.push_back({fullCircle(*arc)});
  } else {
    chains.repairs.push_back(
        Problem(Code::ZeroLengthRemoved, {{"size_mm", geometry::arcLength(only)}}).at(links.front().from));
  }
}

bool isClosed(Chain piece) {
  if (piece.size() > 1) {
    return (geometry::endPoint(piece.back()) - geometry::startPoint(piece.front())).norm() <= kSameEnd;
  }
  const auto* arc = std::get_if<Arc>(&piece.front());
  return arc && std::abs(arc->sweep()) >= 2 * kPi - kFullSweep;
}

std::vector<Curve> closedChain(Chain piece) {
  if (piece.size() == 1) {
    return {fullCircle(std::get<Arc>(piece.front()))};
  }
  std::vector<Curve> chain(piece.begin(), piece.end());
  chain.back() = withEnds(chain.back(), geometry::startPoint(chain.back()), geometry::startPoint(chain.front()));
  return chain;
}

// Closed pieces take no part in the joining.
Pieces takeOutClosed(Pieces pieces, Chains& chains) {
  Pieces open;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (isClosed(pieces[i])) {
      if (chains.closed.empty()) {
        for (std::size_t k = 0; k < i; ++k) {
          open.add(pieces[k]);
        }
      }
      chains.closed.push_back(closedChain(pieces[i]));
    } else if (!chains.closed.empty()) {
      open.add(pieces[i]);
    }
  }
  return chains.closed.empty() ? std::move(pieces) : open;
}

} // namespace

Arc fullCircle(const Arc& arc) {
  return {arc.start, arc.tangent, arc.curvature, 2 * kPi * arc.radius()};
}

Curve withEnds(const Curve& lineOrArc, const Point& from, const Point& to) {
  const auto* arc = std::get_if<Arc>(&lineOrArc);
  if (!arc) {
    return Line{from, to};
  }
  if (from == arc->start && to == geometry::endPoint(lineOrArc)) {
    return lineOrArc;
  }
  const double sweep = arc->sweep();
  if (std::abs(sweep) <= kMostSweepOnChord) {
    return geometry::arcBetween(from, to, sweep);
  }
  const double missing = 2 * std::asin(std::min(1.0, (to - from).norm() / (2 * arc->radius())));
  return geometry::arcBetween(from, to, std::copysign(2 * kPi - missing, sweep));
}

Chains chainPieces(Pieces pieces, double gap, const std::stop_token& stop) {
  Chains chains;
  pieces = withoutDuplicates(withoutZeroLength(std::move(pieces), chains.repairs), chains.repairs);
  pieces = takeOutClosed(std::move(pieces), chains);
  if (stop.stop_requested()) {
    return chains;
  }
  Matches matches = matchEnds(pieces, chains.closed, gap, stop);
  chains.repairs.insert(chains.repairs.end(), matches.repairs.begin(), matches.repairs.end());
  chains.problems = std::move(matches.problems);
  if (stop.stop_requested()) {
    return chains;
  }
  ChainWalk walk(pieces, matches);
  for (EndId end = 0; end < matches.partner.size(); ++end) {
    if (matches.partner[end] == kNoEnd) {
      std::vector<Link> chain = walk.from(end);
      dropCollapsed(chain, false);
      const std::vector<Curve> curves = curvesOf(chain);
      chains.loose.insert(chains.loose.end(), curves.begin(), curves.end());
    }
  }
  for (EndId end = 0; end < matches.partner.size(); end += 2) {
    std::vector<Link> chain = walk.from(end);
    dropCollapsed(chain, true);
    if (!chain.empty()) {
      addClosed(chain, chains);
    }
  }
  return chains;
}

} // namespace arris::pattern
