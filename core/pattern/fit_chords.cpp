#include "core/pattern/fit_chords.h"

#include "core/pattern/chopped_joints.h"
#include "core/pattern/fit_run.h"

#include <algorithm>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using geometry::Curve;
using geometry::Line;

/// So many times a run is fitted again without the chords that could not be followed.
constexpr int kMostDepth = 3;

class ChordFitter {
public:
  ChordFitter(const std::vector<Curve>& chain, double tolerance, std::stop_token stop)
      : m_chain(chain), m_tolerance(tolerance), m_stop(std::move(stop)), m_joints(findChoppedJoints(chain, tolerance)) {
    m_fit.notes = std::move(m_joints.notes);
  }

  /// The fitted chain.
  std::vector<Curve> fit() {
    const std::size_t n = m_chain.size();
    const std::size_t start = firstEnd();
    if (start == n) {
      fitRunOf(0, n, true, 0);
      return std::move(m_fitted);
    }
    for (std::size_t i = start; i < start + n && !m_stop.stop_requested();) {
      std::size_t end = i + 1;
      while (end < start + n && !endsRun(end % n)) {
        ++end;
      }
      fitRunOf(i, end, false, 0);
      i = end;
    }
    return std::move(m_fitted);
  }

  [[nodiscard]] ChordFit result() const {
    return m_fit;
  }

private:
  [[nodiscard]] const Curve& curve(std::size_t i) const {
    return m_chain[i % m_chain.size()];
  }

  [[nodiscard]] bool isLine(std::size_t i) const {
    return std::holds_alternative<Line>(curve(i));
  }

  /// Whether the joint at the start of a curve stays as it is, or an arc begins or ends there.
  [[nodiscard]] bool endsRun(std::size_t i) const {
    return !m_joints.smooth[i] || !isLine(i) || !isLine(i + m_chain.size() - 1);
  }

  [[nodiscard]] std::size_t firstEnd() const {
    std::size_t i = 0;
    while (i < m_chain.size() && !endsRun(i)) {
      ++i;
    }
    return i;
  }

  /// `depth`: how many times what could not be followed was taken out.
  void fitRunOf(std::size_t begin, std::size_t end, bool closed, int depth) {
    if (end - begin > 1) {
      const FittedRun fitted = fitRun(runOf(begin, end, closed), m_tolerance, m_stop);
      if (fitted.deviation <= m_tolerance) {
        m_fitted.insert(m_fitted.end(), fitted.curves.begin(), fitted.curves.end());
        m_fit.deviation = std::max(m_fit.deviation, fitted.deviation);
        return;
      }
      tellFailed(begin + (fitted.failed.empty() ? 0 : fitted.failed.front()), fitted);
      if (!fitted.failed.empty() && depth < kMostDepth) {
        fitBetweenFailed(begin, end, closed, fitted.failed, depth + 1);
        return;
      }
    }
    for (std::size_t i = begin; i < end; ++i) {
      m_fitted.push_back(curve(i));
    }
  }

  // The chords that could not be followed stay lines between corners. A closed run is cut open at the first of them.
  void fitBetweenFailed(std::size_t begin, std::size_t end, bool closed, std::vector<std::size_t> failed, int depth) {
    std::sort(failed.begin(), failed.end());
    std::size_t next = begin;
    if (closed) {
      next = begin + failed.front();
      end += failed.front();
    }
    for (const std::size_t chord : failed) {
      if (begin + chord > next) {
        fitRunOf(next, begin + chord, false, depth);
      }
      m_fitted.push_back(curve(begin + chord));
      next = begin + chord + 1;
    }
    if (next < end) {
      fitRunOf(next, end, false, depth);
    }
  }

  void tellFailed(std::size_t chord, const FittedRun& fitted) {
    m_fit.notes.push_back(
        Problem(Code::ChordsTooCoarse, {{"count", static_cast<std::int64_t>(fitted.failed.size() + 1)},
                                        {"needed_mm", fitted.deviation},
                                        {"tolerance_mm", m_tolerance}})
            .at(geometry::startPoint(curve(chord))));
  }

  [[nodiscard]] ChordRun runOf(std::size_t begin, std::size_t end, bool closed) const {
    const std::size_t n = m_chain.size();
    ChordRun run;
    run.closed = closed;
    run.vertices.reserve(end - begin + 1);
    for (std::size_t i = begin; i < end; ++i) {
      run.vertices.push_back(geometry::startPoint(curve(i)));
    }
    run.vertices.push_back(geometry::endPoint(curve(end - 1)));
    if (!closed && m_joints.smooth[begin % n] && !isLine(begin + n - 1)) {
      run.startTangent = geometry::endTangent(curve(begin + n - 1));
    }
    if (!closed && m_joints.smooth[end % n] && !isLine(end)) {
      run.endTangent = geometry::startTangent(curve(end));
    }
    return run;
  }

  const std::vector<Curve>& m_chain;
  double m_tolerance;
  std::stop_token m_stop;
  ChoppedJoints m_joints;
  std::vector<Curve> m_fitted;
  ChordFit m_fit;
};

} // namespace

ChordFit fitChords(std::vector<Curve>& closedChain, double tolerance, const std::stop_token& stop) {
  if (closedChain.size() < 3) {
    return {};
  }
  ChordFitter fitter(closedChain, tolerance, stop);
  std::vector<Curve> fitted = fitter.fit();
  if (!stop.stop_requested()) {
    closedChain = std::move(fitted);
  }
  return fitter.result();
}

} // namespace arris::pattern
