// Alphabets of cells: a drawing for each combination of the colours of a cell's corners.
//
// With two colours these are the 16 tiles of marching squares (Lorensen and Cline 1987, in the plane), which map
// editors call corner terrains; with C colours C^4 corner tiles (Lagae 2007, section 2.6). Cells fit, since neighbours
// share corners, and a hash of each corner's place lays an endless map.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

using CellColor = std::array<std::uint8_t, 3>; ///< red, green, blue

/// A colour of corners, such as rock or floor.
struct CellCorner
{
    std::string name;
    CellColor color{};
    std::uint32_t weight = 1; ///< how many of the corners have it, beside the others' weights
};

struct CellAlphabet
{
    std::string name;
    int size = 16; ///< pixels along a side of a cell
    std::vector<CellCorner> corners;
    std::vector<std::vector<CellColor>> cells; ///< by corner_index(), rows from north to south

    Color colors() const { return static_cast<Color>(corners.size()); }
    std::uint32_t weights() const; ///< their sum
};

inline constexpr int least_cell_pixels = 2, most_cell_pixels = 256;
inline constexpr std::size_t most_cell_colors = 6;      ///< 1296 cells
inline constexpr std::uint32_t most_cell_weight = 1000; ///< of one colour

/// The rule for cells that have no drawing: a pixel has the colour of the corners that weigh most there by bilinear
/// interpolation, which is marching squares where there are two; borders are lines beside which two colours weigh the
/// same.
struct CellRule
{
    CellColor border{};
    double border_width = 0; ///< in cells, along the steepest way; 0: no borders
};
std::vector<CellColor> ruled_cell(const CellAlphabet& alphabet, const CellRule& rule, const CornerTile& corners);

/// A drawing turned by 90 degrees clockwise, and the corners of a cell turned so.
std::vector<CellColor> turned(const std::vector<CellColor>& drawing, int size);
CornerTile turned(const CornerTile& corners);

}
