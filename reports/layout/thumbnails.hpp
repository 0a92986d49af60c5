// Small pictures: of every series for tables and cards, and one of every run for the overview.
#pragma once

#include "base/images/grey_image.hpp"
#include "reports/layout/report_layout.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// The picture of a run on the overview, in the run's folder.
inline constexpr auto run_thumbnail = "thumbnail.png";

/// The mean of blocks of pixels: the smallest blocks that make the image at most `largest` pixels wide and high. Pixels
/// that fill no block at the right and lower borders are left out.
GreyImage smaller_image(const GreyImage& image, int largest);

/// The radially averaged power as a small SVG: no words, the dashed line is 1.
std::string radial_thumbnail_svg(const Curve& curve, const CurveScales& scales);

/// Writes run_thumbnail: of the run's middle series, whose small pictures must have been drawn, or of its first tiling
/// or construction.
void draw_run_thumbnail(const ReportRun& run);

}
