#pragma once

#include "core/job/job.h"

namespace arris::job {

/// Numbers the contours in the order in which they are machined (those left unground last, as they were), and puts them
/// in that order; everything in the job that names a contour follows. Profile, report and problems then count alike.
void numberContoursAsMachined(Job& job);

} // namespace arris::job
