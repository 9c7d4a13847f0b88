#include "core/files/gcode.h"

#include "core/base/numbers.h"
#include "core/base/window_thread.h"
#include "core/files/gcode_text.h"
#include "core/geometry/parabola_arcs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace arris::files {
namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Parabola;
using geometry::Point;
using job::Job;
using job::Phase;
using job::PlannedPiece;
using motion::Interval;
using motion::Move;
using motion::Segment;
using motion::Vertical;

/// Arcs and lines stay this near to the parabola, mm; the rest of the promised 1 µm is for rounding.
constexpr double kTransitionTolerance = 5e-4;

/// A point P_d or P_a nearer than this to a joint, or to another such point, is not one of its own, mm.
constexpr double kSamePoint = 1e-3;

/// Time for the spindle to reach its speed and for the coolant to arrive, s.
constexpr int kSpinUp = 3;

// On each segment the λ of every P_d and P_a inside it, ascending: where a deceleration into a corner begins and where
// an acceleration out of one ends.
std::vector<std::vector<double>> splitsOf(const Job& job) {
  std::vector<std::vector<double>> splits(job.track.size());
  const auto split = [&](const PlannedPiece& piece, double lambda) {
    const auto segment = static_cast<std::size_t>(piece.motion.segment);
    std::vector<double>& here = splits[segment];
    const double last = here.empty() ? 0 : here.back();
    if (lambda > last + kSamePoint && lambda < motion::parameterLength(job.track[segment]) - kSamePoint) {
      here.push_back(lambda);
    }
  };
  const auto continues = [](const PlannedPiece& a, const PlannedPiece& b) {
    return a.phase == b.phase && a.corner == b.corner;
  };
  for (std::size_t i = 0; i < job.pieces.size(); ++i) {
    const PlannedPiece& piece = job.pieces[i];
    if (piece.corner == 0) {
      continue;
    }
    if (piece.phase == Phase::Decelerate && (i == 0 || !continues(job.pieces[i - 1], piece))) {
      split(piece, piece.motion.lambda);
    }
    if (piece.phase == Phase::Accelerate && (i + 1 == job.pieces.size() || !continues(piece, job.pieces[i + 1]))) {
      split(piece, piece.motion.endLambda);
    }
  }
  return splits;
}

/// The highest speeds that blocks can be run at from end to end. Blocks are asked for in the order of the track.
class SpeedCaps {
public:
  explicit SpeedCaps(const Job& job) : m_job(job) {}

  /// mm/min, of the part of a segment from λ = `from` to `to`.
  double over(std::size_t segmentIndex, double from, double to) {
    const Segment& segment = m_job.track[segmentIndex];
    const int number = static_cast<int>(segmentIndex);
    while (interval().segment < number || interval().to <= from) {
      ++m_interval;
    }
    double cap = std::min(segment.feed, segment.speedCap);
    for (std::size_t i = m_interval; i < m_job.intervals.size(); ++i) {
      const Interval& stretch = m_job.intervals[i];
      if (stretch.segment != number || stretch.from >= to) {
        break;
      }
      cap =
          std::min({cap, std::sqrt(std::min(stretch.cap2, stretch.capEnd2)),
                    heldByAxes(segment, std::max(from, stretch.from)), heldByAxes(segment, std::min(to, stretch.to))});
    }
    return 60 * cap;
  }

private:
  [[nodiscard]] const Interval& interval() const {
    return m_job.intervals[m_interval];
  }

  // λ̇ at which |q'' λ̇²| reaches the limit of an axis.
  [[nodiscard]] double heldByAxes(const Segment& segment, double lambda) const {
    double speed = std::numeric_limits<double>::infinity();
    if (m_job.limits.rule == recipe::AccelerationRule::PerAxis) {
      const Eigen::Vector3d second = motion::evaluate(segment, lambda).second.cwiseAbs();
      for (int axis = 0; axis < 2; ++axis) {
        speed = std::min(speed, std::sqrt(m_job.limits.acceleration[axis] / second[axis]));
      }
    }
    return speed;
  }

  const Job& m_job;
  std::size_t m_interval = 0;
};

void writeTransition(GCodeText& text, const Parabola& parabola, double feed, TransitionForm form) {
  switch (form) {
  case TransitionForm::Spline:
    text.spline(parabola, feed);
    break;
  case TransitionForm::Arcs:
    for (const Arc& arc : geometry::arcsAlong(parabola, kTransitionTolerance)) {
      text.arc(arc, feed);
    }
    break;
  case TransitionForm::Lines:
    for (const Point& point : geometry::chordsAlong(parabola, kTransitionTolerance)) {
      text.lineTo(point, feed);
    }
    break;
  }
}

void writeHeader(GCodeText& text, const Job& job, std::string_view patternFile) {
  const recipe::Recipe& recipe = job.recipe;
  text.comment(fmt::format("Arris {}: {}", ARRIS_VERSION, patternFile));
  text.comment(fmt::format("wheel radius {} mm, grinding depth {} mm, glass {} mm on supports of {} mm",
                           recipe.wheelRadius, recipe.depth, recipe.thickness, recipe.support));
  text.comment(
      fmt::format("feed {} mm/min, {} corners, {:.1f} s", recipe.feed, job.toolpath.corners.size(), job.duration));
  text.comment("X Y centre of the wheel, Z middle of its working profile above the table, mm");
  text.line("G17 G21 G40 G54 G61 G90 G94");
}

// Wherever the machine is: up first, then over the start of the program.
void writeStart(GCodeText& text, const Job& job) {
  const Eigen::Vector3d start = motion::evaluate(job.track.front(), 0).point;
  text.rapidToHeight(job.machine.travel.z());
  text.rapidTo(start.head<2>());
}

bool isWork(const Segment& segment) {
  return segment.number > 0;
}

void writeSpindleAndCoolant(GCodeText& text, const recipe::Recipe& recipe) {
  text.line(fmt::format("S{} M3", recipe.spindle));
  text.line("M8");
  text.line(fmt::format("G4 P{}", kSpinUp));
}

/// Writes the track segment by segment.
class Program {
public:
  Program(const Job& job, TransitionForm form, GCodeText& text)
      : m_job(job), m_form(form), m_text(text), m_splits(splitsOf(job)), m_caps(job) {}

  void write() {
    for (std::size_t i = 0; i < m_job.track.size(); ++i) {
      const Segment& segment = m_job.track[i];
      if (!m_spindleRuns && (segment.move == Move::Plunge || isWork(segment))) {
        writeSpindleAndCoolant(m_text, m_job.recipe);
        m_spindleRuns = true;
      }
      announce(segment);
      if (isWork(segment)) {
        work(i, segment);
      } else {
        rapidOrPlunge(segment);
      }
    }
  }

private:
  void announce(const Segment& segment) {
    if (segment.contour != m_contour && segment.contour > 0) {
      m_text.comment(fmt::format("contour {}", segment.contour));
    }
    m_contour = segment.contour;
    if (segment.corner > 0) {
      const toolpath::Corner& corner = m_job.toolpath.corners[static_cast<std::size_t>(segment.corner - 1)];
      m_text.comment(fmt::format("corner {}: {:.3f} degrees, {}", corner.id, base::degrees(corner.angle),
                                 segment.move == Move::Transition ? "transition" : "roll"));
    }
  }

  void rapidOrPlunge(const Segment& segment) {
    if (const auto* vertical = std::get_if<Vertical>(&segment.shape)) {
      if (segment.move == Move::Plunge) {
        m_text.feedToHeight(vertical->to, 60 * segment.feed);
      } else {
        m_text.rapidToHeight(vertical->to);
      }
    } else {
      m_text.rapidTo(std::get<Line>(segment.shape).to);
    }
  }

  void work(std::size_t index, const Segment& segment) {
    const double length = motion::parameterLength(segment);
    std::vector<double> ends = m_splits[index];
    ends.push_back(length);
    double from = 0;
    for (const double to : ends) {
      const bool stops = to == length && segment.stopAtEnd && isFollowedByWork(index);
      if (stops) {
        m_text.line("G61.1");
      }
      block(segment, from, to, m_caps.over(index, from, to));
      if (stops) {
        m_text.line("G61");
      }
      from = to;
    }
  }

  void block(const Segment& segment, double from, double to, double feed) {
    if (const auto* line = std::get_if<Line>(&segment.shape)) {
      m_text.lineTo(geometry::endPoint(geometry::part(*line, from, to)), feed);
    } else if (const auto* arc = std::get_if<Arc>(&segment.shape)) {
      m_text.arc(std::get<Arc>(geometry::part(*arc, from, to)), feed);
    } else {
      writeTransition(m_text, std::get<Parabola>(segment.shape), feed, m_form);
    }
  }

  [[nodiscard]] bool isFollowedByWork(std::size_t index) const {
    return index + 1 < m_job.track.size() && isWork(m_job.track[index + 1]);
  }

  const Job& m_job;
  TransitionForm m_form;
  GCodeText& m_text;
  std::vector<std::vector<double>> m_splits;
  SpeedCaps m_caps;
  int m_contour = 0;
  bool m_spindleRuns = false;
};

} // namespace

std::string gcode(const Job& job, std::string_view patternFile, TransitionForm form) {
  base::takesLong("gcode");
  assert(job.canBeGround() && !job.track.empty());
  GCodeText text;
  writeHeader(text, job, patternFile);
  writeStart(text, job);
  Program(job, form, text).write();
  for (const char* end : {"M5", "M9", "M30"}) {
    text.line(end);
  }
  return text.take();
}

} // namespace arris::files
