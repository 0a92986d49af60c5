// The map that kind = "cells" asks for, and its numbers.
#pragma once

#include "results/pictures/distribution_result.hpp"
#include "tiles/cells/cell_map.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace poissonlab {

// The settings of [[distribution]] kind = "cells": see tiles/cells/cell_map.hpp.

struct CellSettings
{
    std::filesystem::path alphabet;
    std::array<std::int64_t, 4> window{0, 0, 48, 27}; ///< X, Y, width and height, in cells
};

/// An alphabet with a window of its map.
struct DrawnCells
{
    CellAlphabet alphabet;
    CellMap map;
};

/// Throws InputError for an alphabet that is none, and for a window whose picture has too many pixels along a side.
DrawnCells drawn_cells(const CellSettings& settings, std::uint64_t seed);

/// The number of cells, of different ones, and the part of the corners of each colour.
std::vector<DistributionNumber> cell_counts(const DrawnCells& drawn);

}
