#pragma once

#include "core/geometry/biarc.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace arris::geometry {

/// How far a fitted curve may lie from the one it stands for, mm: half of what a smoothed joint may differ by.
inline constexpr double kFitTolerance = 0.5e-3;

/// Follows smooth curves one after the other with a single chain of lines and arcs. Within a curve the joints are
/// tangential; where a curve has no direction of its own to the scale of the tolerance (a cusp, or a bend sharper than
/// that) a corner stays. The same curves in the other direction give the same chain, turned round.
class ArcFitter {
public:
  /// Point and direction at a parameter from 0 to 1.
  using Trace = std::function<Station(double)>;

  /// `tolerance` in mm; `mostLooks` is how many stretches may be looked at before the curve is given up.
  ArcFitter(double tolerance, std::int64_t mostLooks) : m_tolerance(tolerance), m_looksLeft(mostLooks) {}

  /// Appends the curve, whose ends are `start` and `end`. `places` is how many places of a stretch are looked at: some
  /// more than the curve can have bends. False where the looks are used up; the chain is then of no use.
  [[nodiscard]] bool follow(const Trace& trace, const Station& start, const Station& end, int places);

  /// The chain so far, from the start of the first curve to the end of the last; it begins anew. Empty where all of it
  /// was too small to have a direction.
  [[nodiscard]] std::vector<Curve> takeChain();

  [[nodiscard]] std::int64_t looksLeft() const {
    return m_looksLeft;
  }

private:
  struct Stretch {
    double from = 0;
    double to = 0;
    Station start;
    Station end;
  };

  struct Look;

  void follow(const Trace& trace, const Stretch& stretch, int places);
  void split(const Trace& trace, const Stretch& stretch, int places, int parts);
  [[nodiscard]] Look lookAt(const Trace& trace, const Stretch& stretch, int places);
  [[nodiscard]] Point startOf(const Stretch& stretch) const;
  void append(const Station& start, const Station& end);
  void moveEnd(const Point& end);

  double m_tolerance;
  std::int64_t m_looksLeft;
  std::vector<Curve> m_chain;
  std::optional<Point> m_reached; ///< where the chain ends

  /// What the last curves of the chain were made from.
  struct Last {
    Station start;
    Station end;
    std::size_t firstCurve = 0;
  };

  std::optional<Last> m_last;
  std::vector<Station> m_stations;
};

} // namespace arris::geometry
