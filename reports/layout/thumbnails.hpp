// Small pictures: of every series for tables and cards, and one of every run for the overview.
#pragma once

#include "base/images/grey_image.hpp"
#include "reports/layout/report_layout.hpp"

namespace poissonlab {

/// The picture of a run on the overview, in the run's folder.
inline constexpr auto run_thumbnail = "thumbnail.png";

/// The mean of blocks of pixels: the smallest blocks that make the image at most `largest` pixels wide and high. Pixels
/// that fill no block at the right and lower borders are left out.
GreyImage smaller_image(const GreyImage& image, int largest);

/// Writes run_thumbnail: of the run's middle series, whose small pictures must have been drawn, or of its first tiling
/// or construction.
void draw_run_thumbnail(const ReportRun& run);

}
