// Small pictures: of every series for tables and cards, and one of every run for the overview.
//
// Small pictures for tables and lists of series: which there are of a series, and how they are called.
#pragma once

#include "base/images/png_file.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/layout/report_layout.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The picture of a run on the overview, in the run's folder.
inline constexpr auto run_thumbnail = "thumbnail.png";

/// Writes a drawing whose units are pixels, smaller: the least whole number of units becomes a pixel that makes the
/// picture at most `largest` pixels wide and high. Units that fill no pixel at the right and lower borders are left
/// out. Throws StorageError.
void write_thumbnail(const std::filesystem::path& path, Drawing drawing, int largest);

/// Pixels as a drawing.
Drawing drawing_of(PngPixels pixels);

/// Writes run_thumbnail: of the run's middle series, whose small pictures must have been drawn, or of its first tiling
/// or construction.
void draw_run_thumbnail(const ReportRun& run);

/// One small picture of a series, beside its others.
struct SmallPicture
{
    std::string kind; ///< as in Thumbnail
    std::string name;
    std::string file;        ///< in the series' folder
    std::string image_class; ///< how the style sheet shows it
};

/// The small pictures of a series, the most telling first. Every series has at least that of its points.
std::vector<SmallPicture> small_pictures(const ReportSeries& series);

}
