#include "core/toolpath/offset.h"

#include "core/base/tolerances.h"
#include "core/toolpath/blocked.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace arris::toolpath {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

/// What is left of a piece is dropped where it is shorter than this, mm.
constexpr double kSliver = 1e-7;

/// Spans meet where their ends are nearer to each other than this, mm.
constexpr double kMeet = 1e-6;

/// Where three edges are touched in one point to within rounding, a wheel larger by this is tried instead, mm.
constexpr double kLarger = 1e-6;
constexpr int kTries = 4;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The pieces of one ring, from `first` to before `end`.
struct PieceRing {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// Every piece before anything is cut off.
class Pieces {
public:
  Pieces(const Glass& glass, double radius) : m_glass(glass), m_radius(radius) {
    m_pieces.reserve(2 * glass.edges().size());
    for (const Ring& ring : glass.rings()) {
      PieceRing pieces{static_cast<std::uint32_t>(m_pieces.size()), 0};
      for (EdgeId edge = ring.first; edge < ring.first + ring.count; ++edge) {
        addFlank(edge);
        addRoll(edge);
      }
      pieces.end = static_cast<std::uint32_t>(m_pieces.size());
      m_rings.push_back(pieces);
    }
  }

  std::vector<Piece> take() {
    return std::move(m_pieces);
  }

  [[nodiscard]] const std::vector<PieceRing>& rings() const {
    return m_rings;
  }

private:
  [[nodiscard]] bool hasFlank(EdgeId edge) const {
    const auto* arc = std::get_if<Arc>(&m_glass.edges()[edge]);
    return !arc || (1 - arc->curvature * m_glass.side() * m_radius) * arc->length > kSliver;
  }

  void addFlank(EdgeId edge) {
    if (!hasFlank(edge)) {
      return;
    }
    const JointKind joint = m_glass.jointAfter(edge);
    const bool joins = joint == JointKind::Convex || (joint == JointKind::Tangential && hasFlank(m_glass.next(edge)));
    add(geometry::offset(m_glass.edges()[edge], m_glass.side() * m_radius), edge, false, joins);
  }

  void addRoll(EdgeId edge) {
    if (m_glass.jointAfter(edge) != JointKind::Convex) {
      return;
    }
    const Curve& before = m_glass.edges()[edge];
    const Vector tangent = geometry::endTangent(before);
    const double turn = m_glass.turnAfter(edge);
    const Point from = geometry::endPoint(before) + m_glass.side() * m_radius * geometry::leftOf(tangent);
    const double curvature = (turn > 0 ? 1 : -1) / m_radius;
    add(Arc{from, tangent, curvature, m_radius * std::abs(turn)}, edge, true, hasFlank(m_glass.next(edge)));
  }

  void add(const Curve& path, EdgeId edge, bool isRoll, bool joinsNext) {
    m_pieces.push_back({path, geometry::parameterLength(path), edge, isRoll, joinsNext});
  }

  const Glass& m_glass;
  double m_radius;
  std::vector<Piece> m_pieces;
  std::vector<PieceRing> m_rings;
};

/// Cuts pieces where they come too near to other edges.
class Cutter {
public:
  Cutter(const Glass& glass, double radius) : m_glass(glass), m_radius(radius), m_free(radius) {}

  /// What stays of the piece.
  const std::vector<Stretch>& cut(const Piece& piece) {
    m_stretches.clear();
    block(piece);
    m_free.appendTo(m_stretches);
    return m_stretches;
  }

private:
  void block(const Piece& piece) {
    m_free.begin(piece.path);
    const EdgeId next = m_glass.next(piece.edge);
    const EdgeId previous = m_glass.previous(piece.edge);
    const std::array<EdgeId, 4> around{next, previous, m_glass.next(next), m_glass.previous(previous)};
    // Neighbours take most away where anything is taken away at all.
    for (const EdgeId edge : around) {
      blockBy(edge, piece);
    }
    const auto isAround = [&](EdgeId edge) { return std::find(around.begin(), around.end(), edge) != around.end(); };
    constexpr int kFew = 64;
    int left = kFew;
    blockByNear(piece, isAround, [&left] { return --left > 0; });
    if (left > 0 || m_free.empty()) {
      return;
    }
    // Where very many lie near, those at ever larger steps along the edges, which are sorted by place, mostly leave so
    // little that few of the many matter.
    const auto count = static_cast<EdgeId>(m_glass.edges().size());
    for (EdgeId step = 1; step < count; step *= 2) {
      blockBy(piece.edge + step < count ? piece.edge + step : 0, piece);
      blockBy(piece.edge >= step ? piece.edge - step : count - 1, piece);
    }
    blockByNear(piece, isAround, [] { return true; });
  }

  void blockBy(EdgeId edge, const Piece& piece) {
    if (!m_free.empty() && !keepsDistance(piece, edge)) {
      m_free.block(m_glass.edges()[edge]);
    }
  }

  /// All edges near what is free that are not `done`, as long as there is something free and `goOn` says so.
  template <typename IsDone, typename GoOn> void blockByNear(const Piece& piece, IsDone isDone, GoOn goOn) {
    if (m_free.empty()) {
      return;
    }
    m_glass.tree().forNear(m_free.box(), m_radius, [&](std::size_t index) {
      const auto edge = static_cast<EdgeId>(index);
      if (!isDone(edge)) {
        blockBy(edge, piece);
      }
      return !m_free.empty() && goOn();
    });
  }

  // The edge itself, and lines beside it or beside its corner that turn away from the wheel.
  [[nodiscard]] bool keepsDistance(const Piece& piece, EdgeId edge) const {
    const auto isLine = [this](EdgeId e) { return std::holds_alternative<Line>(m_glass.edges()[e]); };
    const bool isNext = edge == m_glass.next(piece.edge);
    if (piece.isRoll) {
      return (edge == piece.edge || isNext) && isLine(edge);
    }
    if (edge == piece.edge) {
      return true;
    }
    if (!isLine(edge) || !isLine(piece.edge)) {
      return false;
    }
    const bool isPrevious = edge == m_glass.previous(piece.edge);
    return (isNext && m_glass.jointAfter(piece.edge) != JointKind::Concave) ||
           (isPrevious && m_glass.jointAfter(edge) != JointKind::Concave);
  }

  const Glass& m_glass;
  double m_radius;
  FreeStretches m_free;
  std::vector<Stretch> m_stretches;
};

/// Joins spans to loops.
class Stitcher {
public:
  Stitcher(const Glass& glass, double radius, const std::vector<Piece>& pieces, const std::vector<PieceRing>& rings,
           std::vector<Span> spans)
      : m_glass(glass), m_radius(radius), m_pieces(pieces), m_spans(std::move(spans)), m_next(m_spans.size(), kNone),
        m_hasPrevious(m_spans.size(), false), m_dropped(m_spans.size(), false) {
    joinNeighbours(rings);
    joinMeeting(kMeet, [](std::uint32_t, std::uint32_t) { return true; });
    // Where two paths meet almost tangentially, rounding moves their meeting far along them.
    joinMeeting(m_radius, [this](std::uint32_t span, std::uint32_t next) { return bringTogether(span, next); });
    dropDoubles();
  }

  /// The first end that no start follows.
  [[nodiscard]] std::optional<Point> open() const {
    for (std::uint32_t i = 0; i < m_next.size(); ++i) {
      if (m_next[i] == kNone && !m_dropped[i]) {
        return endOf(i);
      }
    }
    return std::nullopt;
  }

  std::vector<Loop> loops() {
    std::vector<Loop> result;
    std::vector<bool> taken = m_dropped;
    for (std::uint32_t first = 0; first < m_spans.size(); ++first) {
      Loop loop;
      for (std::uint32_t i = first; !taken[i]; i = m_next[i]) {
        taken[i] = true;
        loop.push_back(m_spans[i]);
      }
      if (!loop.empty()) {
        result.push_back(std::move(loop));
      }
    }
    return result;
  }

private:
  void join(std::uint32_t span, std::uint32_t next) {
    m_next[span] = next;
    m_hasPrevious[next] = true;
  }

  // Where neither end was cut off.
  void joinNeighbours(const std::vector<PieceRing>& rings) {
    std::vector<std::uint32_t> firstSpan(m_pieces.size(), kNone);
    for (auto i = static_cast<std::uint32_t>(m_spans.size()); i-- > 0;) {
      firstSpan[m_spans[i].piece] = i;
    }
    auto ring = rings.begin();
    for (std::uint32_t i = 0; i < m_spans.size(); ++i) {
      const std::uint32_t piece = m_spans[i].piece;
      while (piece >= ring->end) {
        ++ring;
      }
      if (m_spans[i].to < m_pieces[piece].length || !m_pieces[piece].joinsNext) {
        continue;
      }
      const std::uint32_t next = firstSpan[piece + 1 < ring->end ? piece + 1 : ring->first];
      if (next != kNone && m_spans[next].from == 0) {
        join(i, next);
      }
    }
  }

  [[nodiscard]] const Curve& pathOf(std::uint32_t span) const {
    return m_pieces[m_spans[span].piece].path;
  }

  [[nodiscard]] Point startOf(std::uint32_t span) const {
    return geometry::pointAt(pathOf(span), m_spans[span].from);
  }

  [[nodiscard]] Point endOf(std::uint32_t span) const {
    return geometry::pointAt(pathOf(span), m_spans[span].to);
  }

  // Where rounding moved the meeting of two almost parallel paths, one of them begins or ends where the other one does.
  bool bringTogether(std::uint32_t span, std::uint32_t next) {
    const geometry::Nearest onNext = geometry::nearest(pathOf(next), endOf(span));
    if (onNext.distance <= kMeet && onNext.lambda < m_spans[next].to - kSliver &&
        isFree(pathOf(next), onNext.lambda, m_spans[next].from)) {
      m_spans[next].from = onNext.lambda;
      return true;
    }
    const geometry::Nearest onSpan = geometry::nearest(pathOf(span), startOf(next));
    if (onSpan.distance <= kMeet && onSpan.lambda > m_spans[span].from + kSliver &&
        isFree(pathOf(span), m_spans[span].to, onSpan.lambda)) {
      m_spans[span].to = onSpan.lambda;
      return true;
    }
    return false;
  }

  /// Whether a path keeps its distance to within rounding also from λ = `from` to `to`.
  [[nodiscard]] bool isFree(const Curve& path, double from, double to) const {
    constexpr int kPlaces = 8;
    for (int i = 0; i < kPlaces && from < to; ++i) {
      const double lambda = from + (to - from) * i / kPlaces;
      if (m_glass.distance(geometry::pointAt(path, lambda), m_radius) < m_radius - kMeet) {
        return false;
      }
    }
    return true;
  }

  // Where more paths than one run within rounding of each other, one of them may be left over with open ends: it is
  // dropped where the others go all along it.
  void dropDoubles() {
    for (std::uint32_t first = 0; first < m_spans.size(); ++first) {
      if (m_hasPrevious[first]) {
        continue;
      }
      std::vector<std::uint32_t> open;
      for (std::uint32_t i = first; i != kNone; i = m_next[i]) {
        open.push_back(i);
      }
      if (std::all_of(open.begin(), open.end(), [&](std::uint32_t i) { return isDouble(i); })) {
        for (const std::uint32_t i : open) {
          m_dropped[i] = true;
        }
      }
    }
  }

  [[nodiscard]] bool isDouble(std::uint32_t span) const {
    constexpr int kPlaces = 8;
    for (int k = 0; k <= kPlaces; ++k) {
      const double lambda = m_spans[span].from + (m_spans[span].to - m_spans[span].from) * k / kPlaces;
      const Point place = geometry::pointAt(pathOf(span), lambda);
      bool isBeside = false;
      for (std::uint32_t i = 0; i < m_spans.size() && !isBeside; ++i) {
        const bool isClosed = m_next[i] != kNone && m_hasPrevious[i];
        if (isClosed && i != span) {
          const geometry::Nearest near = geometry::nearest(pathOf(i), place);
          isBeside =
              near.distance <= kMeet && near.lambda >= m_spans[i].from - kMeet && near.lambda <= m_spans[i].to + kMeet;
        }
      }
      if (!isBeside) {
        return false;
      }
    }
    return true;
  }

  /// Joins each end that is left to the nearest start within `reach` where `mayJoin`.
  template <typename MayJoin> void joinMeeting(double reach, MayJoin mayJoin) {
    struct Start {
      Point place;
      std::uint32_t span = 0;
      double distance = 0;
    };

    std::vector<Start> starts;
    for (std::uint32_t i = 0; i < m_spans.size(); ++i) {
      if (!m_hasPrevious[i]) {
        starts.push_back({startOf(i), i});
      }
    }
    std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.place.x() < b.place.x(); });
    std::vector<Start> near;
    for (std::uint32_t i = 0; i < m_spans.size(); ++i) {
      if (m_next[i] != kNone) {
        continue;
      }
      const Point end = endOf(i);
      near.clear();
      const auto isBefore = [](const Start& start, double x) { return start.place.x() < x; };
      for (auto s = std::lower_bound(starts.begin(), starts.end(), end.x() - reach, isBefore);
           s != starts.end() && s->place.x() <= end.x() + reach; ++s) {
        const double distance = (s->place - end).norm();
        if (distance <= reach && !m_hasPrevious[s->span]) {
          near.push_back({s->place, s->span, distance});
        }
      }
      std::sort(near.begin(), near.end(), [](const Start& a, const Start& b) { return a.distance < b.distance; });
      const auto best = std::find_if(near.begin(), near.end(), [&](const Start& s) { return mayJoin(i, s.span); });
      if (best != near.end()) {
        join(i, best->span);
      }
    }
  }

  const Glass& m_glass;
  double m_radius;
  const std::vector<Piece>& m_pieces;
  std::vector<Span> m_spans;
  std::vector<std::uint32_t> m_next; ///< by span
  std::vector<bool> m_hasPrevious;   ///< by span
  std::vector<bool> m_dropped;       ///< by span
};

std::vector<Span> cutAll(const Glass& glass, const std::vector<Piece>& pieces, double radius,
                         const std::stop_token& stop) {
  std::vector<Span> spans;
  spans.reserve(pieces.size());
  if (glass.isOneConvexPane()) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      spans.push_back({i, 0, pieces[i].length});
    }
    return spans;
  }
  Cutter cutter(glass, radius);
  for (std::uint32_t i = 0; i < pieces.size() && !stop.stop_requested(); ++i) {
    for (const Stretch& stretch : cutter.cut(pieces[i])) {
      if (stretch.to - stretch.from > kSliver) {
        spans.push_back({i, stretch.from, stretch.to});
      }
    }
  }
  return spans;
}

Offset tryOffset(const Glass& glass, double radius, const std::stop_token& stop) {
  Pieces maker(glass, radius);
  Offset result;
  result.radius = radius;
  result.pieces = maker.take();
  std::vector<Span> spans = cutAll(glass, result.pieces, radius, stop);
  if (stop.stop_requested()) {
    return result;
  }
  Stitcher stitcher(glass, radius, result.pieces, maker.rings(), std::move(spans));
  result.open = stitcher.open();
  if (!result.open) {
    result.loops = stitcher.loops();
  }
  return result;
}

} // namespace

Offset offsetOf(const Glass& glass, double radius, const std::stop_token& stop) {
  Offset result = tryOffset(glass, radius, stop);
  for (int i = 1; i < kTries && result.open; ++i) {
    result = tryOffset(glass, radius + i * kLarger, stop);
  }
  return result;
}

} // namespace arris::toolpath
