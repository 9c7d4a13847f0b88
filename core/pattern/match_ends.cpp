#include "core/pattern/match_ends.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/course.h"
#include "core/pattern/effort.h"

#include <queue>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace arris::pattern {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using base::Code;
using base::Problem;
using geometry::Arc;
using geometry::Curve;
using geometry::Point;

/// Gaps up to this are the rounding of the file and not worth telling, mm: six decimals of an inch, or of a degree at
/// a radius of metres.
constexpr double kRounding = 1e-4;

/// An arc may close on itself from this sweep on, rad; a shorter piece never does.
constexpr double kClosingSweep = base::kPi;

/// A piece of several curves may close on itself where it is this many times longer than its ends are apart.
constexpr double kClosingLength = 10;

using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeEntry = std::pair<TreePoint, EndId>;
using Tree = bgi::rtree<TreeEntry, bgi::quadratic<16>>;

TreePoint treePoint(const Point& p) {
  return {p.x(), p.y()};
}

/// Rings of the ends that lie in exactly the same place, as most do: found by a hash over the coordinates.
class Places {
public:
  explicit Places(const std::vector<Point>& ends) : m_ends(ends), m_next(ends.size()) {
    std::size_t buckets = 16;
    while (buckets < 2 * ends.size()) {
      buckets *= 2;
    }
    std::vector<EndId> first(buckets, kNoEnd);
    for (EndId end = 0; end < ends.size(); ++end) {
      std::size_t b = hash(ends[end]) & (buckets - 1);
      while (first[b] != kNoEnd && m_ends[first[b]] != m_ends[end]) {
        b = (b + 1) & (buckets - 1);
      }
      if (first[b] == kNoEnd) {
        m_next[end] = end;
        first[b] = end;
      } else {
        m_next[end] = m_next[first[b]];
        m_next[first[b]] = end;
      }
    }
  }

  /// The next end in the same place, round and round.
  [[nodiscard]] EndId next(EndId end) const {
    return m_next[end];
  }

  [[nodiscard]] std::int64_t count(EndId end) const {
    std::int64_t result = 1;
    for (EndId e = m_next[end]; e != end; e = m_next[e]) {
      ++result;
    }
    return result;
  }

private:
  static std::size_t hash(const Point& p) {
    const auto mix = [](std::uint64_t h) {
      h *= 0x9E3779B97F4A7C15U;
      return h ^ (h >> 32U);
    };
    return mix(mix(std::bit_cast<std::uint64_t>(p.x())) + std::bit_cast<std::uint64_t>(p.y()));
  }

  const std::vector<Point>& m_ends;
  std::vector<EndId> m_next;
};

std::vector<Point> endsOf(const Pieces& pieces) {
  const Point positiveZero = Point::Zero(); // −0 + 0 = 0: the same place has the same bits
  std::vector<Point> ends;
  ends.reserve(2 * pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ends.emplace_back(geometry::startPoint(pieces[i].front()) + positiveZero);
    ends.emplace_back(geometry::endPoint(pieces[i].back()) + positiveZero);
  }
  return ends;
}

/// Every curve of a drawing by its place, to find what lies under a point.
class CurvesByPlace {
public:
  CurvesByPlace(const Pieces& pieces, const std::vector<std::vector<Curve>>& closed, const std::stop_token& stop)
      : m_effort(pieces.size(), stop) {
    std::vector<BoxEntry> entries;
    const auto add = [&](Chain chain, std::size_t piece) {
      for (const Curve& curve : chain) {
        const geometry::Box box = geometry::bounds(curve);
        entries.push_back({{treePoint(box.min()), treePoint(box.max())}, {&curve, piece}});
      }
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      add(pieces[i], i);
    }
    for (const std::vector<Curve>& chain : closed) {
      add(chain, kNoPiece);
    }
    m_tree = BoxTree(entries);
  }

  /// Whether a curve of another piece than this passes within `reach` of the point. Once the effort is spent, none.
  [[nodiscard]] bool passes(const Point& point, double reach, std::size_t exceptPiece) {
    const Point corner = Point::Constant(reach);
    const bg::model::box<TreePoint> box(treePoint(point - corner), treePoint(point + corner));
    const auto near = [&](const BoxEntry& e) {
      return m_effort.spend() && e.second.second != exceptPiece &&
             geometry::nearest(*e.second.first, point).distance <= reach;
    };
    return !m_effort.isSpent() && m_tree.qbegin(bgi::intersects(box) && bgi::satisfies(near)) != m_tree.qend();
  }

private:
  static constexpr std::size_t kNoPiece = ~std::size_t{0};
  using BoxEntry = std::pair<bg::model::box<TreePoint>, std::pair<const Curve*, std::size_t>>;
  using BoxTree = bgi::rtree<BoxEntry, bgi::quadratic<16>>;

  BoxTree m_tree;
  Effort m_effort;
};

class Matcher {
public:
  Matcher(const Pieces& pieces, const std::vector<std::vector<Curve>>& closed, double gap, std::stop_token stop)
      : m_pieces(pieces), m_closed(closed), m_gap(gap), m_stop(std::move(stop)), m_ends(endsOf(pieces)),
        m_branching(m_ends.size(), false) {
    m_result.partner.assign(m_ends.size(), kNoEnd);
    m_result.joints = m_ends;
  }

  Matches match() {
    joinSamePlace();
    forNearestPairs(freeEnds(Branching::Without), m_gap, [this](EndId a, EndId b) { join(a, b); });
    const std::vector<EndId> free = freeEnds(Branching::With);
    if (!free.empty()) {
      findBranches(free);
      findEndsOnPieces(free);
      tellFree(free);
    }
    return std::move(m_result);
  }

private:
  enum class Branching { With, Without };

  void joinSamePlace() {
    const Places places(m_ends);
    for (EndId end = 0; end < m_ends.size(); ++end) {
      const EndId next = places.next(end);
      if (next == end || m_result.partner[end] != kNoEnd || m_branching[end]) {
        continue;
      }
      if (places.next(next) == end && mayJoin(end, next)) {
        join(end, next);
      } else {
        tellBranch(end, places.count(end));
        for (EndId e = next; !m_branching[e]; e = places.next(e)) {
          m_branching[e] = true;
        }
      }
    }
  }

  [[nodiscard]] bool mayJoin(EndId a, EndId b) const {
    if (pieceOf(a) != pieceOf(b)) {
      return true;
    }
    const Chain piece = m_pieces[pieceOf(a)];
    if (piece.size() > 1) {
      return lengthOf(piece) > kClosingLength * (m_ends[a] - m_ends[b]).norm();
    }
    const auto* arc = std::get_if<Arc>(&piece.front());
    return arc && std::abs(arc->sweep()) > kClosingSweep;
  }

  void join(EndId a, EndId b) {
    m_result.partner[a] = b;
    m_result.partner[b] = a;
    const Point middle = (m_ends[a] + m_ends[b]) / 2;
    m_result.joints[a] = middle;
    m_result.joints[b] = middle;
    const double size = (m_ends[a] - m_ends[b]).norm();
    if (size > kRounding) {
      m_result.repairs.push_back(Problem(Code::GapClosed, {{"size_mm", size}}).at(middle));
    }
  }

  /// In the order of their places, so that the order of the pieces decides nothing.
  [[nodiscard]] std::vector<EndId> freeEnds(Branching branching) const {
    std::vector<EndId> free;
    for (EndId end = 0; end < m_ends.size(); ++end) {
      if (m_result.partner[end] == kNoEnd && (branching == Branching::With || !m_branching[end])) {
        free.push_back(end);
      }
    }
    const auto place = [this](EndId end) { return std::tuple(m_ends[end].y(), m_ends[end].x()); };
    std::sort(free.begin(), free.end(), [&](EndId a, EndId b) { return place(a) < place(b); });
    return free;
  }

  /// Calls `act(a, b)` for the two nearest ends that are at most `reach` apart and may be joined, then for the two
  /// nearest of the rest, and so on. An end is the nearest of at most six others, so few searches are repeated.
  template <typename Act> void forNearestPairs(const std::vector<EndId>& ends, double reach, Act act) {
    std::vector<TreeEntry> entries;
    entries.reserve(ends.size());
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
      entries.emplace_back(treePoint(m_ends[ends[i]]), i);
    }
    Tree tree(entries);

    using Pair = std::tuple<double, std::uint32_t, std::uint32_t>; // distance, numbers in `ends`
    std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue;
    const auto enqueue = [&](std::uint32_t i) {
      const auto allowed = [&](const TreeEntry& e) { return e.second != i && mayJoin(ends[i], ends[e.second]); };
      for (auto found = tree.qbegin(bgi::nearest(entries[i].first, 1) && bgi::satisfies(allowed)); found != tree.qend();
           ++found) {
        const double distance = (m_ends[ends[i]] - m_ends[ends[found->second]]).norm();
        if (distance <= reach) {
          queue.emplace(distance, i, found->second);
        }
      }
    };
    for (std::uint32_t i = 0; i < ends.size() && !m_stop.stop_requested(); ++i) {
      enqueue(i);
    }
    std::vector<bool> taken(ends.size(), false);
    while (!queue.empty() && !m_stop.stop_requested()) {
      const auto [distance, a, b] = queue.top();
      queue.pop();
      if (taken[a]) {
        continue;
      }
      if (taken[b]) {
        enqueue(a);
        continue;
      }
      for (const std::uint32_t i : {a, b}) {
        taken[i] = true;
        tree.remove(entries[i]);
      }
      act(ends[a], ends[b]);
    }
  }

  /// A free end next to others that are joined to each other branches off there. The reach ends half-way along its own
  /// piece: in a chain of short chords the next joint is near without being meant.
  void findBranches(const std::vector<EndId>& free) {
    std::vector<TreeEntry> entries;
    for (EndId end = 0; end < m_ends.size(); ++end) {
      entries.emplace_back(treePoint(m_ends[end]), end);
    }
    const Tree tree(entries);
    for (const EndId end : free) {
      if (m_stop.stop_requested()) {
        return;
      }
      const double reach = reachOf(end);
      const Point corner = Point::Constant(reach);
      const bg::model::box<TreePoint> box(treePoint(m_ends[end] - corner), treePoint(m_ends[end] + corner));
      const auto other = [&](const TreeEntry& e) {
        return pieceOf(e.second) != pieceOf(end) && (m_ends[e.second] - m_ends[end]).norm() <= reach;
      };
      std::int64_t others = 0;
      bool told = m_branching[end];
      constexpr std::int64_t kMostOthers = 100;
      for (auto found = tree.qbegin(bgi::intersects(box) && bgi::satisfies(other));
           found != tree.qend() && others < kMostOthers; ++found) {
        ++others;
        told = told || m_branching[found->second];
      }
      if (others >= 2 && !told) {
        tellBranch(end, others + 1);
      }
      m_branching[end] = m_branching[end] || others >= 2;
    }
  }

  [[nodiscard]] double reachOf(EndId end) const {
    return std::min(m_gap, lengthOf(m_pieces[pieceOf(end)]) / 2);
  }

  /// What is left may end on a piece between that one's ends. Where this is not found out, the end is told as free.
  void findEndsOnPieces(const std::vector<EndId>& free) {
    CurvesByPlace curves(m_pieces, m_closed, m_stop);
    for (const EndId end : free) {
      if (!m_branching[end] && curves.passes(m_ends[end], reachOf(end), pieceOf(end))) {
        m_branching[end] = true;
        m_result.problems.push_back(Problem(Code::EndOnPiece).at(m_ends[end]));
      }
    }
  }

  void tellBranch(EndId end, std::int64_t count) {
    m_branching[end] = true;
    m_result.problems.push_back(Problem(Code::BranchingChain, {{"count", count}}).at(m_ends[end]));
  }

  /// One problem for each gap: the two free ends nearest to each other, and so on. Both ends of the last piece that is
  /// left alone face each other.
  void tellFree(const std::vector<EndId>& free) {
    std::vector<bool> told = m_branching;
    const auto tell = [&](EndId a, EndId b) {
      const double gap = (m_ends[a] - m_ends[b]).norm();
      const bool atABranch = gap <= m_gap; // or they would have been joined; that has been told
      if ((!m_branching[a] || !m_branching[b]) && !atABranch) {
        m_result.problems.push_back(
            Problem(Code::OpenChain, {{"gap_mm", gap}, {"tolerance_mm", m_gap}}).at(m_ends[m_branching[a] ? b : a]));
      }
      told[a] = true;
      told[b] = true;
    };
    forNearestPairs(free, std::numeric_limits<double>::infinity(), tell);
    for (const EndId end : free) {
      if (!told[end] && !m_branching[otherEnd(end)]) {
        const double length = (m_ends[end] - m_ends[otherEnd(end)]).norm();
        m_result.problems.push_back(Problem(Code::StrayPiece, {{"length_mm", length}}).at(m_ends[end]));
        told[end] = told[otherEnd(end)] = true;
      }
    }
  }

  const Pieces& m_pieces;
  const std::vector<std::vector<Curve>>& m_closed;
  double m_gap;
  std::stop_token m_stop;
  std::vector<Point> m_ends;
  std::vector<bool> m_branching;
  Matches m_result;
};

} // namespace

Matches matchEnds(const Pieces& pieces, const std::vector<std::vector<Curve>>& closed, double gap,
                  const std::stop_token& stop) {
  return Matcher(pieces, closed, gap, stop).match();
}

} // namespace arris::pattern
