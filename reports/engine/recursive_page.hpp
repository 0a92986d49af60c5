// A page on which one zooms into a tiling of recursive Wang tiles for ever, and paints with stamps at its points.
#pragma once

#include "tiles/recursive/recursive_tile_set.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

struct RecursivePage
{
    std::uint32_t seed = 0;            ///< of the tiling
    std::string place;                 ///< the first view, as the page's address has it
    std::string command;               ///< that makes points of windows, without those of a window
    std::vector<std::string> stamps{}; ///< PNG files, their bytes
    double stamp_size = 1;             ///< distances of points
    bool is_turned = true;
};

/// The page with all that it needs in it: it opens from the disk.
std::string render_recursive_page(const RecursiveTileSet& tiles, const RecursivePage& page);

}
