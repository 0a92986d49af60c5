// The pictures of a tile set or tiling: its tiles or their regions, and the autocorrelation of its colours.
#pragma once

#include "reports/images/picture_store.hpp"
#include "results/run.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// One tile set or tiling of the report.
struct ReportTiling
{
    const Run* run = nullptr; ///< the runs outlive this
    const TilingResult* stored = nullptr;
    std::filesystem::path pictures; ///< folder of its pictures
};

/// The range of autocorrelation pictures from black to white: z from -6 to 6.
inline constexpr double shown_z = 6;

/// The picture of an autocorrelation, for example "corners-autocorrelation.png".
inline std::string autocorrelation_picture(const ColorStatistics& colors)
{
    return std::filesystem::path(colors.autocorrelation_file).stem().string() + ".png";
}

/// Writes tiles.svg, tiles.png and a picture of each autocorrelation. Throws InputError when stored files are
/// not what results.json says.
void draw_tiling_pictures(const ReportTiling& tiling, PictureStore& store);

}
