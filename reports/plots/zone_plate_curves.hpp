// The curves of the sampling test: the error of the zone plate over its frequency.
#pragma once

#include "analysis/zone_plate/zone_plate_error.hpp"
#include "reports/plots/plot.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The curve of one series.
struct ZonePlateCurve
{
    std::size_t index = 0; ///< number of the series
    std::string label;
    int size = 0;                                ///< pixels of the picture along each axis
    const std::vector<ErrorBin>* bins = nullptr; ///< outlive this
};

/// All curves, of which there must be one; frequencies up to 2 cycles per pixel and errors up to 0.5. The upper edge
/// has distances from the origin where all pictures are of one size.
Plot zone_plate_plot(const std::vector<ZonePlateCurve>& curves);

/// The plot of series `index` alone, whose picture has that size: always with distances.
Plot zone_plate_alone(const Plot& all, std::size_t index, int size);

}
