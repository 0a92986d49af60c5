// Recursive Wang tiles of the whole plane: the points of a window anywhere, at any depth, without all others.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006: "local random
// access to infinite patterns". Tiles of level 0 are chosen by hashed corners, the direct algorithm with one hash
// function; the tiles of further levels follow from those above them, of which four at most meet a small window. Work
// and memory grow with the depth and with the points, and not with the distance from the origin.
//
// Departures: a place is a tile of level 0 and digits, so that no depth rounds it. The tiles of level 0 get their
// points one after the other as the cells of tiles do, as if they were cells of larger tiles themselves.
#pragma once

#include "host/tile_sampling/recursive/recursive_points.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// A tile of any level along one axis: the tile of level 0, and which quarter of its side, which quarter of that, ...
struct RecursiveAddress
{
    std::int64_t base = 0;
    std::vector<std::uint8_t> digits{}; ///< from 0 to 3, as many as the level

    bool operator==(const RecursiveAddress&) const = default;
};

/// Addresses are from -2^52 to 2^52, where JavaScript has all whole numbers, and have at most so many digits.
inline constexpr std::int64_t farthest_recursive_tile = std::int64_t{1} << 52;
inline constexpr std::size_t deepest_recursive_level = 1000;

/// Reads "-5", or "-5:0132" with digits from the largest tiles down. Throws InputError, which says what is allowed.
RecursiveAddress read_recursive_address(const std::string& text);

/// Writes an address as it is read.
std::string text_of(const RecursiveAddress& address);

/// Returns an address moved by so many tiles of its own level, |tiles| <= 2^20.
RecursiveAddress moved(RecursiveAddress address, std::int64_t tiles);

/// Whole tiles of a level.
struct RecursiveWindow
{
    std::array<RecursiveAddress, 2> corner{}; ///< the lowest tile; both have as many digits
    std::array<std::uint32_t, 2> size{1, 1};  ///< from 1 to most_window_tiles
};

/// A window's tiles along each axis: places in it are exact in doubles.
inline constexpr std::uint32_t most_window_tiles = 256;

/// Which tile of level 0 is where in the plane, and when it gets its points.
RecursiveRoot plane_root(std::uint32_t seed, std::int64_t x, std::int64_t y);

using RecursiveRoots = std::function<RecursiveRoot(std::int64_t x, std::int64_t y)>;

/// The points of a window of any tiling, see points_in_frame(). `density` is one over just the window's tiles, at its
/// level; `roots` are the tiles of level 0.
std::vector<RecursivePoint> window_points(const RecursiveTileSet& tiles, const RecursiveRoots& roots,
                                          const RecursiveWindow& window, const RecursiveDensity& density);

/// The lowest 32 bits of the numbers of a window's lowest tile of a level, along each axis.
std::array<std::uint32_t, 2> low_bits(const RecursiveWindow& window, int level);

/// Random bits that stay with a point in whichever window it is found.
std::uint32_t point_bits(std::uint32_t seed, const RecursiveWindow& window, const RecursiveOrigin& origin);

/// The place of a point in its window, in tiles of the window's level from the lowest corner: exact.
std::array<double, 2> place_in_window(const RecursiveWindow& window, const RecursivePoint& point);

}
