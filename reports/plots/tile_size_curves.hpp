// Measures of tile sets over their number of points a tile: points in the regions of corners and edges, and the
// relative radius within tiles beside that of tilings.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 6.24 and 6.11.
#pragma once

#include "reports/plots/plot.hpp"
#include "results/run.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// One tile set: what is drawn as a dot, and what it is held against, which the line passes through.
struct TileSizeSample
{
    double points_per_tile = 0;
    double dot = 0;
    double line = 0;
};

/// Tile sets that differ only in the number of points a tile.
struct TileSizeCurve
{
    std::size_t index = 0;               ///< number of the curve, for the colour
    std::string label;                   ///< the kind of region, if it is about one, and what curves differ in
    std::vector<TileSizeSample> samples; ///< the number of points a tile grows
};

/// The points in the regions of a tile, on average over the set, for each kind of region but interiors; lines are as
/// many as the area (volume) of the regions holds. Empty where no tile sets differ in the number of points a tile
/// alone.
std::vector<TileSizeCurve> region_curves(const std::vector<const Series*>& series);

/// The relative radius within tiles; lines are that of tilings, where the nearest points may be of two tiles. Empty as
/// above, and where all tilings have the radius of their tiles: to three digits nothing is lost at their borders.
std::vector<TileSizeCurve> tile_radius_curves(const std::vector<const Series*>& series);

/// All curves in one plot.
Plot region_points_plot(const std::vector<TileSizeCurve>& curves);
Plot tile_radius_plot(const std::vector<TileSizeCurve>& curves);

}
