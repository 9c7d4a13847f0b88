#pragma once

#include "ui/figures/figure.h"
#include "ui/figures/profile.h"
#include "ui/figures/profile_path.h"

#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace arris::ui {

/// What of the profiles is plotted.
struct ProfileView {
  PlotContent content = PlotContent::Speeds;
  std::optional<std::pair<double, double>> times = {}; ///< s; the work where not given
  int corner = 0;                                      ///< that stands out; 0 for none
};

/// A lying page of A4 with the profile plot under a heading. One profile, or two (planned and actual) over each other.
/// Numbers with a decimal point.
[[nodiscard]] Figure profileFigure(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits,
                                   const QString& heading, const QString& subheading, const ProfileView& view = {});

/// What of the way is shown.
struct PathView {
  QRectF box;                             ///< mm, in the middle of the picture
  std::optional<CornerPass> pass = {};    ///< whose places are named
  std::optional<double> instant = {};     ///< s, at which the wheel is drawn
  std::optional<double> wheelRadius = {}; ///< mm
};

/// A lying page of A4 with the way of the wheel in the plane, as `profileFigure`.
[[nodiscard]] Figure pathFigure(const std::vector<ProfileCurves>& profiles, const PathSetting& setting,
                                const QString& heading, const QString& subheading, const PathView& view);

/// The values of a job that matter for its profile, in a line.
[[nodiscard]] QString profileSubheading(const job::Job& job);

/// The figure of a planned job.
[[nodiscard]] Figure profileFigure(const job::Job& job, const QString& file);

} // namespace arris::ui
