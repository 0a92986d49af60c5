// Recursive Wang tiles: eight tiles with points in an order, each of which consists of sixteen of them.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006; Lagae,
// Tile-Based Methods in Computer Graphics, 2007, section 6.14. A tile is divided into 4 x 4 smaller ones of the same
// set. Each of its N points is a point of one of these as well, so that a tile's points and those that the smaller
// tiles have beside them, its sub-points, are together just the points of the smaller tiles. All 16 N of them have a
// rank: the tile's own come first. More density adds points by rank, then divides tiles, and moves nothing.
//
// Departure: a rank is a link to a point of a smaller tile, and no coordinates are stored. The digits of a point's
// place to the base of 4 are the cells that its links lead through, to any depth, in integers.
#pragma once

#include "tiles/tilings/even_wang_tiles.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

inline constexpr std::uint32_t recursive_cells = 16; ///< smaller tiles, row by row from the lower left

/// Limits of N: corners of smaller tiles must not touch, and a link has 12 bits for a point.
inline constexpr std::uint32_t min_recursive_points = 128;
inline constexpr std::uint32_t max_recursive_points = 4096;

/// A place in a tile, in units of 2^-32 of its side.
using RecursivePlace = std::array<std::uint32_t, 2>;

/// A place in a cell as a place in the tile around, rounded down.
constexpr RecursivePlace place_in_parent(std::uint32_t cell, const RecursivePlace& place)
{
    return {(cell & 3U) << 30 | place[0] >> 2, (cell >> 2) << 30 | place[1] >> 2};
}

/// A point of a smaller tile.
struct RecursiveLink
{
    std::uint16_t word = 0;

    static RecursiveLink to(std::uint32_t cell, std::uint32_t point)
    {
        return {static_cast<std::uint16_t>(cell << 12 | point)};
    }
    std::uint32_t cell() const { return std::uint32_t{word} >> 12; }
    std::uint32_t point() const { return std::uint32_t{word} & 0xFFFU; }

    bool operator==(const RecursiveLink&) const = default;
};

struct RecursiveTile
{
    std::array<std::uint8_t, recursive_cells> children{}; ///< the tiles of its cells
    std::vector<RecursiveLink> links;                     ///< by rank; the first N are the tile's own points

    bool operator==(const RecursiveTile&) const = default;
};

using RecursiveTiles = std::array<RecursiveTile, even_wang_tiles>;
using RecursivePlaces = std::array<std::vector<RecursivePlace>, even_wang_tiles>; ///< of tiles' own points, by rank

/// The places of the tiles' first `points_per_tile` links, rounded down: digits are the cells that links lead through.
RecursivePlaces places_of_links(const RecursiveTiles& tiles, std::uint32_t points_per_tile);

class RecursiveTileSet
{
public:
    /// Throws InputError, a line without place, where links are not all points of all smaller tiles once, or smaller
    /// tiles do not fit beside each other and into their tiles' borders.
    RecursiveTileSet(std::uint32_t points_per_tile, std::uint64_t seed, RecursiveTiles tiles);

    std::uint32_t points_per_tile() const { return points_per_tile_; }
    std::uint64_t seed() const { return seed_; }
    const RecursiveTile& tile(std::size_t number) const { return tiles_[number]; }

    /// A tile's own points by rank, rounded down.
    const std::vector<RecursivePlace>& places(std::size_t tile) const { return places_[tile]; }

    /// The place of any rank of a tile, rounded down.
    RecursivePlace place(std::size_t tile, std::uint32_t rank) const
    {
        const RecursiveLink link = tiles_[tile].links[rank];
        return place_in_parent(link.cell(), places_[tiles_[tile].children[link.cell()]][link.point()]);
    }

    bool operator==(const RecursiveTileSet&) const = default;

private:
    std::uint32_t points_per_tile_;
    std::uint64_t seed_;
    RecursiveTiles tiles_;
    RecursivePlaces places_;
};

// Files of recursive Wang tiles: what a cache keeps.
//
// Bytes, all numbers with the low byte first: "RECWANG1"; N as 32 bits, seed as 64 bits; for each of the 8 tiles 16
// bytes, the tiles of its cells, and 16 N links of 16 bits, the cell times 4,096 plus the point; XXH64 of all before.

/// The bytes of a file.
std::string recursive_tile_bytes(const RecursiveTileSet& tiles);

/// Throws StorageError.
void write_recursive_tiles(const std::filesystem::path& file, const RecursiveTileSet& tiles);

/// Throws InputError, a line with the file's name, for a file that is damaged or something else.
RecursiveTileSet read_recursive_tiles(const std::filesystem::path& file);

}
