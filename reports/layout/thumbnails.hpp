// Small pictures: of every series for tables and cards, and one of every run for the overview.
#pragma once

#include "base/images/png_file.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/layout/report_layout.hpp"

#include <filesystem>

namespace poissonlab {

/// The picture of a run on the overview, in the run's folder.
inline constexpr auto run_thumbnail = "thumbnail.png";

/// The width of the largest picture of at most `largest` pixels each way that is the whole one divided by a whole
/// number.
int thumbnail_width(int width, int height, int largest);

/// Writes a picture that is so much smaller. Throws StorageError.
void write_thumbnail(const std::filesystem::path& path, PngPixels pixels, int largest);

/// The radially averaged power: no words, the dashed line is 1.
Drawing draw_radial_thumbnail(const Curve& curve, const CurveScales& scales);

/// Writes run_thumbnail: of the run's middle series, whose small pictures must have been drawn, or of its first tiling
/// or construction.
void draw_run_thumbnail(const ReportRun& run);

}
