// The points in the regions of corners and edges of tiles over the number of points a tile.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figure 6.24.
#pragma once

#include "reports/plots/plot.hpp"
#include "results/run.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// One tile set; points are means over its tiles.
struct RegionSample
{
    double points_per_tile = 0;
    double points = 0;   ///< in the regions of that kind, of a tile
    double expected = 0; ///< as many as the area (volume) of the regions holds
};

/// The regions of one kind of tile sets that differ only in the number of points a tile.
struct RegionCurve
{
    std::size_t index = 0;             ///< number of the curve, for the colour
    std::string label;                 ///< the kind of region, and the parameters in which curves differ
    std::vector<RegionSample> samples; ///< the number of points a tile grows
};

/// Curves of all regions but interiors. Empty where no tile sets differ in the number of points a tile alone.
std::vector<RegionCurve> region_curves(const std::vector<const Series*>& series);

/// All curves in one plot: dots are points as they were counted, lines as many as their areas let expect.
Plot region_points_plot(const std::vector<RegionCurve>& curves);

}
