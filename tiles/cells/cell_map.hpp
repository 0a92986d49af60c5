// Alphabets of cells: a drawing for each combination of the colours of a cell's corners.
//
// With two colours these are the 16 tiles of marching squares (Lorensen and Cline 1987, in the plane), which map
// editors call corner terrains; with C colours C^4 corner tiles (Lagae 2007, section 2.6). Cells fit, since neighbours
// share corners, and a hash of each corner's place lays an endless map.
//
// Maps of cells: a window of the endless map that an alphabet and a seed give, as a picture and for editors of maps.
#pragma once

#include "base/images/png_file.hpp"
#include "tiles/tilings/tile_index.hpp"
#include "tiles/tilings/tiling.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
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

/// The cells of a window by corner_index(), rows from north to south.
struct CellMap
{
    std::uint64_t columns = 0, rows = 0;
    std::vector<TileIndex> cells;
};

inline constexpr std::uint64_t most_map_cells = std::uint64_t{1} << 22;
inline constexpr std::uint64_t most_map_side = 65'500; ///< pixels of its picture

/// The colour of the lattice point (x, y): ttiles_color() of runtime/texture_tiles.h over as many colours as weights
/// have in their sum, of which each corner has its weight's share, in their order.
Color cell_corner(const CellAlphabet& alphabet, std::uint64_t seed, std::int64_t x, std::int64_t y);

/// Windows with the same seed fit together; places count modulo 2^32.
CellMap cell_map(const CellAlphabet& alphabet, const TileWindow& window, std::uint64_t seed);

/// The picture of a map, cell by cell, and of all cells in the packing of corner tiles (closed_packing.hpp), C^2 x C^2
/// of them, which is a map as well. Throws StorageError.
void write_cell_map(const std::filesystem::path& file, const CellAlphabet& alphabet, const CellMap& map);
CellMap packed_cells(Color colors);

/// The number of a cell in that picture, row by row from its upper left.
std::uint32_t cell_number(const CellAlphabet& alphabet, TileIndex cell);

/// The numbers of all cells of a map, a line a row, counted from `first`: layers of Tiled count from 1.
std::string cell_numbers(const CellAlphabet& alphabet, const CellMap& map, std::uint32_t first = 0,
                         std::string_view row_end = "\n");

/// A map of Tiled (TMX 1.10): one layer as CSV and a tile set with the picture `picture`, whose tiles know the colours
/// of their corners, as its terrain brush wants them.
std::string tiled_map(const CellAlphabet& alphabet, const CellMap& map, const std::string& picture);

}
