#pragma once

#include "ui/figures/figure.h"
#include "ui/figures/profile.h"

#include <QString>

#include <vector>

namespace arris::ui {

/// A lying page of A4 with the profile plot over the time of the work, under a heading. One profile, or two (planned
/// and actual) over each other. Numbers with a decimal point.
[[nodiscard]] Figure profileFigure(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits,
                                   const QString& heading, const QString& subheading);

/// The figure of a planned job.
[[nodiscard]] Figure profileFigure(const job::Job& job, const QString& file);

} // namespace arris::ui
