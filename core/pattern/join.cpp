#include "core/pattern/join.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/clean_pieces.h"
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

/// A piece in the direction of its chain, and where its ends come to lie.
struct Link {
  Curve curve;
  Point from;
  Point to;
};

/// Walks from piece to piece along the joints.
class ChainWalk {
public:
  ChainWalk(const std::vector<Curve>& pieces, const Matches& matches)
      : m_pieces(pieces), m_matches(matches), m_visited(pieces.size(), false) {}

  /// The chain that begins at `start`, up to a free end or once round; empty where it was walked before.
  std::vector<Link> from(EndId start) {
    std::vector<Link> chain;
    for (EndId end = start; end != kNoEnd && !m_visited[pieceOf(end)];) {
      m_visited[pieceOf(end)] = true;
      const EndId exit = otherEnd(end);
      const Curve& piece = m_pieces[pieceOf(end)];
      chain.push_back(
          {isStart(end) ? piece : geometry::reversed(piece), m_matches.joints[end], m_matches.joints[exit]});
      end = m_matches.partner[exit];
    }
    return chain;
  }

private:
  const std::vector<Curve>& m_pieces;
  const Matches& m_matches;
  std::vector<bool> m_visited;
};

bool hasCollapsed(const Link& link) {
  const auto* line = std::get_if<Line>(&link.curve);
  return line && (link.to - link.from).norm() < base::kZeroLength;
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

std::vector<Curve> curvesOf(const std::vector<Link>& chain) {
  std::vector<Curve> curves;
  curves.reserve(chain.size());
  for (const Link& link : chain) {
    curves.push_back(withEnds(link.curve, link.from, link.to));
  }
  return curves;
}

// A closed chain of one curve is an arc that closes on itself, or a line whose ends met.
void addClosed(const std::vector<Link>& chain, Chains& chains) {
  if (chain.size() > 1) {
    chains.closed.push_back(curvesOf(chain));
  } else if (const auto* arc = std::get_if<Arc>(&chain.front().curve); arc && std::abs(arc->sweep()) > kPi) {
    chains.closed.push_back({fullCircle(*arc)});
  } else {
    chains.repairs.push_back(Problem(Code::ZeroLengthRemoved, {{"size_mm", geometry::arcLength(chain.front().curve)}})
                                 .at(chain.front().from));
  }
}

// Full circles are closed already and take no part in the joining.
void takeOutCircles(std::vector<Curve>& pieces, Chains& chains) {
  const auto isCircle = [&chains](const Curve& piece) {
    const auto* arc = std::get_if<Arc>(&piece);
    if (!arc || std::abs(arc->sweep()) < 2 * kPi - kFullSweep) {
      return false;
    }
    chains.closed.push_back({fullCircle(*arc)});
    return true;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isCircle), pieces.end());
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

Chains chainPieces(std::vector<Curve> pieces, double gap) {
  Chains chains;
  pieces = withoutDuplicates(withoutZeroLength(std::move(pieces), chains.repairs), chains.repairs);
  takeOutCircles(pieces, chains);
  Matches matches = matchEnds(pieces, gap);
  chains.repairs.insert(chains.repairs.end(), matches.repairs.begin(), matches.repairs.end());
  chains.problems = std::move(matches.problems);
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
