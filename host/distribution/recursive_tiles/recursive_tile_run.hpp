// kind = "recursive-tiles": points of recursive Wang tiles in a window anywhere in the plane, at any zoom, and pictures
// that are painted with stamps at these points.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006; Lagae et al.,
// Tile-Based Methods for Interactive Applications, SIGGRAPH 2008 class notes, part V: "texture painting". A density
// says how many points there are where; ranks decide which. Each point has a stamp, turned and sized by random bits
// that stay with it in all windows and at all densities.
#pragma once

#include "base/images/png_file.hpp"
#include "host/kinds/kind.hpp"
#include "host/tile_sampling/recursive/recursive_plane.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct RecursiveTileSettings
{
    RecursiveWindow window; ///< of one tile of level 0, unless it is given
    std::size_t points = 0; ///< in the window
    DensityChoice density;  ///< over the window; an empty text: 1 everywhere
    std::uint32_t points_per_tile = 256;
    std::vector<std::filesystem::path> stamps; ///< pictures; none: dots
    double stamp_size = 1;                     ///< the mean width, in distances of points where they are densest
    bool is_upright = false;
};

/// A point with the stamp that is laid there.
struct StampedPoint
{
    std::array<double, 2> place{}; ///< in tiles of the window's level, from its lowest corner
    std::uint32_t stamp = 0;
    double turn = 0; ///< radians, counterclockwise
    double size = 1; ///< of the mean width: from 0.7 to 1.3
};

struct StampedWindow
{
    RecursiveTileSet tiles;
    std::uint32_t seed = 0; ///< of the tiling
    std::string note{};     ///< of the density, for users
    double spacing = 0;     ///< the side of the square that a point has where they are densest, in tiles
    std::vector<StampedPoint> points;
};

/// The points of a window. Throws InputError for a density that is none.
StampedWindow stamped_window(const RecursiveTileSettings& settings, std::uint64_t seed, const DistributionPlace& place);

/// The height of a painting that is `pixels` wide.
int painting_height(const RecursiveWindow& window, int pixels);

/// The picture of the window on white paper, `pixels` wide: stamps in the order of points, which is that of levels,
/// tiles and ranks. Those of points outside the window are left out.
PngPixels painting(const RecursiveTileSettings& settings, const StampedWindow& window, int pixels);

/// Lines x, y, stamp, turn, size under the names of their columns.
std::string stamps_csv(const StampedWindow& window);

DistributionNumbers recursive_tile_numbers(const RecursiveTileSettings& settings, const StampedWindow& window);

Kind recursive_tile_kind();

}
