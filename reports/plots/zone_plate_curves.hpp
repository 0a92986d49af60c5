// The curves of the sampling test: the error of the zone plate over its frequency, alone and overlaid.
#pragma once

#include "analysis/zone_plate/zone_plate_error.hpp"
#include "reports/plots/gnuplot.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// What is drawn of one series.
struct ZonePlateCurve
{
    std::size_t index = 0; ///< number of the series, for its colour
    std::string label;     ///< for the key
    int size = 0;          ///< pixels of the picture along each axis
    std::vector<ErrorBin> bins;
};

/// The axes, the same in all plots of a report so that plots compare.
struct ZonePlateScales
{
    double max_frequency = 2; ///< cycles per pixel
    double max_error = 0.3;
};

/// Scales that show all curves, frequencies up to 2 cycles per pixel and errors up to 0.5. `curves` must not
/// be empty.
ZonePlateScales common_zone_plate_scales(const std::vector<ZonePlateCurve>& curves);

/// The plot of one series, with the distance from the origin along its upper edge.
GnuplotPicture plot_zone_plate_error(const ZonePlateCurve& curve, const ZonePlateScales& scales,
                                     const std::filesystem::path& stem);

/// All series in one plot, with a key; the upper edge has distances where all pictures are of one size.
GnuplotPicture overlay_zone_plate_error(const std::vector<ZonePlateCurve>& curves, const ZonePlateScales& scales,
                                        const std::filesystem::path& stem);

}
