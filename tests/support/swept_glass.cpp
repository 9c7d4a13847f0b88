#include "tests/support/swept_glass.h"

#include "core/base/numbers.h"

#include <fmt/format.h>
#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace arris::test {
namespace {

using base::kPi;
using geometry::Point;
using geometry::Vector;
using toolpath::Role;

constexpr double kAllowed = 1e-3;  ///< mm, promised accuracy
constexpr double kFillet = 0.5e-3; ///< mm, that the arc in a concave corner may leave beside it

// Clipper finds suspects; it must miss none, so the glass is widened by R − kAllowed + kBudget: a chord of the widened
// glass (0.1 µm), a chord of the path (0.1 µm), and the roundings of both and of their crossings to the grid (50 nm).
constexpr double kPerUnit = 1e5; ///< Clipper's integers: 10 nm, up to 10 m without its slow arithmetic
constexpr double kSagitta = 0.1e-3;
constexpr double kBudget = 0.25e-3;

constexpr double kStep = 1.5;       ///< mm between samples along a curve
constexpr double kBeside = 0.05;    ///< mm, samples beside joints
constexpr double kReachable = 1e-6; ///< mm, of rounding: a centre this much too near to the glass is free

/// A line, an arc or a blend; t runs from 0 to 1.
struct Stretch {
  enum class Kind { Straight, Round, Blend };
  Kind kind = Kind::Straight;
  Point from{0, 0}, to{0, 0};
  Point middle{0, 0}; ///< centre of an arc, control point of a blend
  double radius = 0, startAngle = 0, sweep = 0;
  geometry::Box box;

  [[nodiscard]] Point at(double t) const {
    switch (kind) {
    case Kind::Straight:
      break;
    case Kind::Round:
      return middle + radius * direction(startAngle + t * sweep);
    case Kind::Blend:
      return (1 - t) * (1 - t) * from + 2 * t * (1 - t) * middle + t * t * to;
    }
    return from + t * (to - from);
  }

  /// Unit normal to the right of the direction of travel, of lines and arcs.
  [[nodiscard]] Vector rightAt(double t) const {
    if (kind == Kind::Round) {
      return (sweep > 0 ? 1 : -1) * direction(startAngle + t * sweep);
    }
    const Vector way = (to - from).normalized();
    return {way.y(), -way.x()};
  }

  [[nodiscard]] double length() const {
    return kind == Kind::Round ? radius * std::abs(sweep) : (middle - from).norm() + (to - middle).norm();
  }

  static Vector direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
  }
};

geometry::Box boxAround(const Stretch& stretch) {
  geometry::Box box(stretch.from);
  constexpr int kParts = 16;
  for (int i = 1; i <= kParts; ++i) {
    box.extend(stretch.at(static_cast<double>(i) / kParts));
  }
  if (stretch.kind == Stretch::Kind::Blend) {
    box.extend(stretch.middle);
  }
  const double sagitta =
      stretch.kind == Stretch::Kind::Round ? stretch.radius * (1 - std::cos(stretch.sweep / (2 * kParts))) : 0;
  const Vector margin = Vector::Constant(sagitta + 1e-9);
  return {box.min() - margin, box.max() + margin};
}

Stretch stretchOf(const geometry::Curve& curve) {
  Stretch result;
  if (const auto* line = std::get_if<geometry::Line>(&curve)) {
    result = {Stretch::Kind::Straight, line->from, line->to, line->from, 0, 0, 0, {}};
  } else if (const auto* arc = std::get_if<geometry::Arc>(&curve)) {
    const Vector toCentre(-arc->tangent.y() / arc->curvature, arc->tangent.x() / arc->curvature);
    result.kind = Stretch::Kind::Round;
    result.from = arc->start;
    result.middle = arc->start + toCentre;
    result.radius = toCentre.norm();
    result.startAngle = std::atan2(-toCentre.y(), -toCentre.x());
    result.sweep = arc->curvature * arc->length;
    result.to = result.at(1);
  } else {
    const auto& blend = std::get<geometry::Parabola>(curve);
    result = {Stretch::Kind::Blend, blend.a, blend.c, blend.q, 0, 0, 0, {}};
  }
  result.box = boxAround(result);
  return result;
}

double distanceToStraight(const Stretch& line, const Point& p) {
  const Vector way = line.to - line.from;
  const double t = std::clamp((p - line.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (line.at(t) - p).norm();
}

double distanceToRound(const Stretch& arc, const Point& p) {
  const Vector v = p - arc.middle;
  const double side = arc.sweep > 0 ? 1 : -1;
  const double along = std::fmod(side * (std::atan2(v.y(), v.x()) - arc.startAngle) + 4 * kPi, 2 * kPi);
  if (along <= std::abs(arc.sweep)) {
    return std::abs(v.norm() - arc.radius);
  }
  return std::min((arc.from - p).norm(), (arc.to - p).norm());
}

/// Least value of `f` over t from 0 to 1 and its place: the best of `count` samples, then refined.
template <class F> std::pair<double, double> least(const F& f, int count) {
  int best = 0;
  for (int i = 1; i <= count; ++i) {
    best = f(static_cast<double>(i) / count) < f(static_cast<double>(best) / count) ? i : best;
  }
  double low = std::max(0.0, (best - 1.0) / count);
  double high = std::min(1.0, (best + 1.0) / count);
  while (high - low > 1e-9) {
    const double third = (high - low) / 3;
    (f(low + third) < f(high - third) ? high : low) = f(low + third) < f(high - third) ? high - third : low + third;
  }
  const double middle = (low + high) / 2;
  const double sample = static_cast<double>(best) / count;
  return f(middle) < f(sample) ? std::pair{f(middle), middle} : std::pair{f(sample), sample};
}

double distanceTo(const Stretch& stretch, const Point& p) {
  switch (stretch.kind) {
  case Stretch::Kind::Straight:
    break;
  case Stretch::Kind::Round:
    return distanceToRound(stretch, p);
  case Stretch::Kind::Blend:
    return least([&](double t) { return (stretch.at(t) - p).norm(); }, 16).first;
  }
  return distanceToStraight(stretch, p);
}

double nearestOf(const std::vector<Stretch>& stretches, const Point& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : stretches) {
    if (stretch.box.squaredExteriorDistance(p) < best * best) {
      best = std::min(best, distanceTo(stretch, p));
    }
  }
  return best;
}

int partsFor(double radius, double angle, double sagitta) {
  const double step = radius > sagitta ? 2 * std::acos(1 - sagitta / radius) : kPi / 2;
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / std::min(step, kPi / 8))));
}

/// Chords that leave the curve by at most `sagitta`.
int chordsOf(const Stretch& stretch, double sagitta) {
  switch (stretch.kind) {
  case Stretch::Kind::Straight:
    break;
  case Stretch::Kind::Round:
    return partsFor(stretch.radius, stretch.sweep, sagitta);
  case Stretch::Kind::Blend: // h²/8 times the second derivative
    return 1 + static_cast<int>(std::sqrt((stretch.from - 2 * stretch.middle + stretch.to).norm() / (4 * sagitta)));
  }
  return 1;
}

/// The contours, with what Clipper needs of them; coordinates of Clipper are relative to the middle of the box.
class Glass {
public:
  explicit Glass(const std::vector<pattern::Contour>& contours) {
    for (const pattern::Contour& contour : contours) {
      m_rings.emplace_back();
      for (const geometry::Curve& curve : contour.curves) {
        m_rings.back().push_back(stretchOf(curve));
        m_all.push_back(m_rings.back().back());
        m_box.extend(m_all.back().box);
      }
    }
    constexpr double kCoarse = 0.1; // mm; enough to tell the inside at some distance
    for (const std::vector<Stretch>& ring : m_rings) {
      m_coarse.push_back(outline(ring, kCoarse));
    }
  }

  [[nodiscard]] const std::vector<std::vector<Stretch>>& rings() const {
    return m_rings;
  }

  /// Not signed.
  [[nodiscard]] double distance(const Point& p) const {
    return nearestOf(m_all, p);
  }

  /// Right for points farther from the contours than 0.1 mm.
  [[nodiscard]] bool holds(const Point& p) const {
    const auto around = std::count_if(m_coarse.begin(), m_coarse.end(), [&](const ClipperLib::Path& ring) {
      return ClipperLib::PointInPolygon(grid(p), ring) != 0;
    });
    return around % 2 == 1;
  }

  [[nodiscard]] double signedDistance(const Point& p) const {
    return holds(p) ? -distance(p) : distance(p);
  }

  [[nodiscard]] ClipperLib::IntPoint grid(const Point& p) const {
    const Vector v = kPerUnit * (p - m_box.center());
    return {std::llround(v.x()), std::llround(v.y())};
  }

  [[nodiscard]] Point table(const ClipperLib::IntPoint& p) const {
    return m_box.center() + Point(static_cast<double>(p.X), static_cast<double>(p.Y)) / kPerUnit;
  }

  [[nodiscard]] ClipperLib::Path chain(const Stretch& stretch, double sagitta) const {
    ClipperLib::Path path;
    const int chords = chordsOf(stretch, sagitta);
    for (int i = 0; i <= chords; ++i) {
      path.push_back(grid(stretch.at(static_cast<double>(i) / chords)));
    }
    return path;
  }

  [[nodiscard]] ClipperLib::Path outline(const std::vector<Stretch>& ring, double sagitta) const {
    ClipperLib::Path path;
    for (const Stretch& stretch : ring) {
      const ClipperLib::Path piece = chain(stretch, sagitta);
      path.insert(path.end(), piece.begin(), piece.end() - 1);
    }
    return path;
  }

private:
  std::vector<std::vector<Stretch>> m_rings;
  std::vector<Stretch> m_all;
  ClipperLib::Paths m_coarse;
  geometry::Box m_box;
};

/// The glass widened by `reach`: every point outside within that of the glass lies on the normal of its nearest point,
/// or in the fan of normals of a convex corner. So it is the glass, the normals of each curve, and the fans, united.
class WidenedGlass {
public:
  WidenedGlass(const Glass& glass, double reach) : m_glass(glass), m_reach(reach) {
    for (const std::vector<Stretch>& ring : glass.rings()) {
      m_parts.push_back(glass.outline(ring, kSagitta)); // cut-outs clockwise: they wind back to 0
      for (std::size_t i = 0; i < ring.size(); ++i) {
        addNormals(ring[i]);
        addFan(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
    ClipperLib::Clipper clipper;
    clipper.AddPaths(m_parts, ClipperLib::ptSubject, true);
    clipper.Execute(ClipperLib::ctUnion, m_region, ClipperLib::pftPositive, ClipperLib::pftPositive);
  }

  [[nodiscard]] const ClipperLib::Paths& region() const {
    return m_region;
  }

  /// Which piece of the free space holds a free point: 0 is the outside, others are numbered from 1.
  [[nodiscard]] std::size_t roomOf(const Point& p) const {
    std::size_t room = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_region.size(); ++i) {
      const double area = -ClipperLib::Area(m_region[i]); // holes run clockwise
      if (area > 0 && area < smallest && ClipperLib::PointInPolygon(m_glass.grid(p), m_region[i]) != 0) {
        smallest = area;
        room = i + 1;
      }
    }
    return room;
  }

private:
  void add(const std::vector<Point>& corners) {
    ClipperLib::Path path;
    for (const Point& corner : corners) {
      path.push_back(m_glass.grid(corner));
    }
    if (!ClipperLib::Orientation(path)) {
      std::reverse(path.begin(), path.end());
    }
    m_parts.push_back(std::move(path));
  }

  /// Between two arcs about a centre; a negative radius lies opposite.
  void addSector(const Point& centre, double startAngle, double sweep, double one, double other) {
    const int parts = partsFor(std::max(std::abs(one), std::abs(other)), sweep, kSagitta);
    std::vector<Point> corners;
    for (int i = 0; i <= parts; ++i) {
      corners.emplace_back(centre + one * Stretch::direction(startAngle + sweep * i / parts));
    }
    for (int i = other != 0 ? parts : 0; i >= 0; --i) {
      corners.emplace_back(centre + other * Stretch::direction(startAngle + sweep * i / parts));
    }
    add(corners);
  }

  void addNormals(const Stretch& stretch) {
    if (stretch.kind == Stretch::Kind::Straight) {
      const Vector away = m_reach * stretch.rightAt(0);
      add({stretch.from, stretch.to, stretch.to + away, stretch.from + away});
      return;
    }
    const int quarters = static_cast<int>(std::ceil(std::abs(stretch.sweep) / (kPi / 2)));
    const double sweep = stretch.sweep / quarters;
    for (int i = 0; i < quarters; ++i) {
      const double start = stretch.startAngle + i * sweep;
      const double end = stretch.radius + (sweep > 0 ? m_reach : -m_reach);
      addSector(stretch.middle, start, sweep, stretch.radius, std::max(end, 0.0));
      if (end < 0) { // the normals of a hollow tighter than that meet at its centre and go on
        addSector(stretch.middle, start, sweep, end, 0);
      }
    }
  }

  void addFan(const Stretch& before, const Stretch& after) {
    const Vector one = before.rightAt(1);
    const double turn = geometry::turn(one, after.rightAt(0));
    if (turn * m_reach > 1 / kPerUnit) { // to the left: convex
      addSector(after.from, std::atan2(one.y(), one.x()), turn, m_reach, 0);
    }
  }

  const Glass& m_glass;
  double m_reach;
  ClipperLib::Paths m_parts, m_region;
};

/// A piece of the path with what it is for.
struct PathPiece {
  Stretch stretch;
  Role role = Role::Contour;
  bool fillet = false; ///< the arc in a concave corner
};

std::vector<PathPiece> piecesOf(const job::Job& job) {
  std::vector<PathPiece> pieces;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    for (const toolpath::PathSegment& segment : chain.segments) {
      const bool concave =
          segment.corner > 0 &&
          job.toolpath.corners.at(static_cast<std::size_t>(segment.corner - 1)).kind == toolpath::CornerKind::Concave;
      pieces.push_back({stretchOf(segment.shape), segment.role, concave && segment.role == Role::Roll});
    }
  }
  return pieces;
}

/// Shares of a curve to look at: each 1.5 mm, its ends and close to them.
std::vector<double> samplesOf(const Stretch& stretch) {
  const double length = stretch.length();
  const int steps = 4 + static_cast<int>(length / kStep);
  std::vector<double> samples;
  for (int i = 0; i <= steps; ++i) {
    samples.push_back(static_cast<double>(i) / steps);
  }
  if (length > 4 * kBeside) {
    samples.insert(samples.end(), {kBeside / length, 1 - kBeside / length});
  }
  return samples;
}

std::string_view roleName(Role role) {
  static constexpr std::array<std::string_view, 5> kNames{"lead-in", "way along the contour", "transition", "roll",
                                                          "lead-out"};
  return kNames.at(static_cast<std::size_t>(role));
}

/// The pieces that have a part in the widened glass.
std::vector<const PathPiece*> suspectsOf(const std::vector<PathPiece>& pieces, const Glass& glass, double reach) {
  const WidenedGlass widened(glass, reach);
  ClipperLib::Clipper clipper;
  clipper.AddPaths(widened.region(), ClipperLib::ptClip, true);
  for (const PathPiece& piece : pieces) {
    clipper.AddPath(glass.chain(piece.stretch, kSagitta), ClipperLib::ptSubject, false);
  }
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  ClipperLib::Paths hits;
  ClipperLib::OpenPathsFromPolyTree(tree, hits);
  std::vector<const PathPiece*> suspects;
  for (const PathPiece& piece : pieces) {
    const bool hit = std::any_of(hits.begin(), hits.end(), [&](const ClipperLib::Path& path) {
      return std::any_of(path.begin(), path.end(), [&](const ClipperLib::IntPoint& p) {
        return distanceTo(piece.stretch, glass.table(p)) < 2 * kSagitta;
      });
    });
    if (hit) {
      suspects.push_back(&piece);
    }
  }
  return suspects;
}

/// Of a sampled contour point: the free centres from which the wheel touches it.
std::vector<Point> centresFor(const std::vector<Stretch>& ring, std::size_t index, double t, double wheel) {
  const Stretch& stretch = ring[index];
  const Point p = stretch.at(t);
  std::vector<Point> centres{p + wheel * stretch.rightAt(t)};
  if (t == 1) {
    const Vector one = stretch.rightAt(1);
    const double turn = geometry::turn(one, ring[(index + 1) % ring.size()].rightAt(0));
    constexpr int kDirections = 8;
    for (int i = 1; turn > 0 && i <= kDirections; ++i) {
      centres.emplace_back(p + wheel * (Eigen::Rotation2Dd(turn * i / kDirections) * one));
    }
  }
  return centres;
}

/// Whether a free place is one that the path should have used.
using Counts = std::function<bool(const Point& centre)>;

Counts roomsThatCount(const Glass& glass, const std::vector<PathPiece>& pieces, double wheel, Unentered unentered) {
  if (unentered == Unentered::Breach) {
    return [](const Point&) { return true; };
  }
  const auto widened = std::make_shared<WidenedGlass>(glass, wheel - kAllowed + kBudget);
  std::vector<std::size_t> entered{0}; // the outside is open to every wheel
  for (const PathPiece& piece : pieces) {
    entered.push_back(widened->roomOf(piece.stretch.at(0)));
  }
  return [widened, entered](const Point& centre) {
    return std::find(entered.begin(), entered.end(), widened->roomOf(centre)) != entered.end();
  };
}

std::string listed(std::string_view promise, const std::vector<Breach>& breaches) {
  if (breaches.empty()) {
    return {};
  }
  constexpr std::size_t kListed = 5;
  std::string text = fmt::format("{}: {} places\n", promise, breaches.size());
  for (std::size_t i = 0; i < std::min(kListed, breaches.size()); ++i) {
    text += fmt::format("  {} at ({:.4f}, {:.4f}): {:.3f} um\n", breaches[i].what, breaches[i].where.x(),
                        breaches[i].where.y(), 1e3 * breaches[i].amount);
  }
  return text;
}

} // namespace

double distanceFromGlass(const std::vector<pattern::Contour>& contours, const Point& point) {
  return Glass(contours).signedDistance(point);
}

double farthestApart(const std::vector<geometry::Curve>& a, const std::vector<geometry::Curve>& b) {
  std::vector<Stretch> target;
  std::transform(b.begin(), b.end(), std::back_inserter(target), stretchOf);
  double most = 0;
  for (const geometry::Curve& curve : a) {
    const Stretch stretch = stretchOf(curve);
    for (const double t : samplesOf(stretch)) {
      most = std::max(most, nearestOf(target, stretch.at(t)));
    }
  }
  return most;
}

std::vector<Breach> gouges(const job::Job& job) {
  const double wheel = job.recipe.wheelRadius;
  const Glass glass(job.contours);
  const std::vector<PathPiece> pieces = piecesOf(job);
  std::vector<Breach> breaches;
  for (const PathPiece* piece : suspectsOf(pieces, glass, wheel - kAllowed + kBudget)) {
    const auto distance = [&](double t) { return glass.signedDistance(piece->stretch.at(t)); };
    const auto [nearest, t] = least(distance, 20 + static_cast<int>(4 * piece->stretch.length()));
    if (nearest < wheel - kAllowed) {
      breaches.push_back({std::string(roleName(piece->role)), piece->stretch.at(t), nearest - wheel});
    }
  }
  return breaches;
}

std::vector<Breach> untouched(const job::Job& job, Unentered unentered) {
  const double wheel = job.recipe.wheelRadius;
  const Glass glass(job.contours);
  const std::vector<PathPiece> pieces = piecesOf(job);
  const Counts counts = roomsThatCount(glass, pieces, wheel, unentered);
  std::vector<Stretch> path;
  std::transform(pieces.begin(), pieces.end(), std::back_inserter(path), [](const auto& p) { return p.stretch; });
  const auto free = [&](const Point& centre) {
    return glass.distance(centre) >= wheel - kReachable && !glass.holds(centre) && counts(centre);
  };
  std::vector<Breach> breaches;
  for (const std::vector<Stretch>& ring : glass.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (const double t : samplesOf(ring[i])) {
        const Point p = ring[i].at(t);
        const double left = nearestOf(path, p) - wheel;
        const std::vector<Point> centres = centresFor(ring, i, t, wheel);
        if (left > kAllowed && std::any_of(centres.begin(), centres.end(), free)) {
          breaches.push_back({"reachable point", p, left});
        }
      }
    }
  }
  return breaches;
}

std::vector<Breach> idling(const job::Job& job) {
  const Glass glass(job.contours);
  std::vector<Breach> breaches;
  for (const PathPiece& piece : piecesOf(job)) {
    if (piece.role != Role::Contour && piece.role != Role::Roll) {
      continue;
    }
    const double most = job.recipe.wheelRadius + kAllowed + (piece.fillet ? kFillet : 0);
    for (const double t : samplesOf(piece.stretch)) {
      const Point p = piece.stretch.at(t);
      if (const double distance = glass.distance(p); distance > most) {
        breaches.push_back({std::string(roleName(piece.role)), p, distance - job.recipe.wheelRadius});
      }
    }
  }
  return breaches;
}

testing::AssertionResult grindsAllAndOnlyTheEdge(const job::Job& job, Unentered unentered) {
  const std::string text = listed("the wheel grinds into the glass", gouges(job)) +
                           listed("the wheel could touch and does not", untouched(job, unentered)) +
                           listed("the wheel is off the glass where it should grind", idling(job));
  return text.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << text;
}

} // namespace arris::test
