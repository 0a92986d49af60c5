// Points of recursive Wang tiles: of toroidal tilings, and how the levels of tiles of any window are gone through.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006. A tile of level
// 0 gets its points by rank, then the tiles in its cells, which are of level 1, get their sub-points, and so on, as far
// as the density asks for more. What a density has stays where it is when it grows.
//
// Departures: M x M tiles of level 0 lie on a torus, by the direct algorithm with one hash function. The tiles of a
// level get their next points one after the other, in an order in which neighbours are far from each other, rather than
// all at once: a uniform density of N points has just N. What is here is plain; recursive_sampler.hpp finds the points
// of a torus on a device.
//
// The largest tiles of recursive Wang tiles: a torus of few of them has few tilings, and realizations should be
// different ones.
#pragma once

#include "base/densities/density_bounds.hpp"
#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace poissonlab {

/// Even Wang tiles on a torus of side x side, row by row from the lower left.
using RootTiles = std::vector<std::uint32_t>;

/// The tiles of a torus by the direct algorithm with one hash function.
RootTiles hashed_root_tiles(std::uint32_t side, const StreamKey& stream);

/// The first, in the order of their tiles, of all tilings that are this one shifted on its torus.
RootTiles least_shifted(const RootTiles& tiles, std::uint32_t side);

/// The tilings of realizations. Each is hashed; on a torus of 2 x 2 to 4 x 4 tiles, one that an earlier realization
/// has, maybe shifted, is drawn again from all tilings, until it is another one. When all have been drawn, 14 of
/// 2 x 2 tiles, 128 of 3 x 3, or 8,312 of 4 x 4, they are repeated.
class RealizationRoots
{
public:
    RealizationRoots(std::uint32_t side, std::uint64_t seed) : side_(side), seed_(seed) {}

    /// The tiling of realization 0, 1, ...: it does not depend on which ones were asked for before.
    RootTiles of(std::uint32_t realization);

private:
    void draw_next();

    std::uint32_t side_;
    std::uint64_t seed_;
    std::vector<RootTiles> drawn_; ///< of the first realizations, on a small torus
    std::set<RootTiles> seen_;     ///< least_shifted() ones of these
};

// The density of points that recursive Wang tiles are to have, in points per tile of any level, as exact integers.

/// A density over a square of tiles of some level, which get a number of points together, as far as chance allows.
/// Each place asks for so many points per tile, in units of 2^-32 points.
class RecursiveDensity
{
public:
    /// So many tiles of `level` along each axis get `points` of them. Throws InputError, a line without place, where a
    /// tile of that level would get 2^31 points or more at the density's largest weight.
    RecursiveDensity(std::uint64_t points, std::array<std::uint64_t, 2> tiles, int level,
                     const std::optional<Density>& density);

    /// As many along both axes.
    RecursiveDensity(std::uint64_t points, std::uint64_t side, int level, const std::optional<Density>& density)
        : RecursiveDensity(points, std::array{side, side}, level, density)
    {}

    bool is_uniform() const { return is_uniform_; }

    /// The points per tile of a level where the weight is so large; 2^63 where they are more.
    std::uint64_t demand(std::uint64_t weight, int level) const
    {
        const auto at_level = static_cast<std::uint64_t>(static_cast<Wide>(weight) * most_ >> 40);
        if (level >= level_) return 4 * (level - level_) < 64 ? at_level >> 4 * (level - level_) : 0;
        const int up = 4 * (level_ - level);
        return up >= 63 || at_level > limit >> up ? (at_level == 0 ? 0 : limit) : at_level << up;
    }

    /// The points per tile of its own level at full weight, in units of 2^-32.
    std::uint64_t most() const { return most_; }

    /// Weights by place in the square.
    const DensityBounds& bounds() const { return bounds_; }

private:
    __extension__ using Wide = unsigned __int128;
    static constexpr std::uint64_t limit = std::uint64_t{1} << 63;

    int level_;
    bool is_uniform_;
    DensityBounds bounds_;
    std::uint64_t most_ = 0; ///< at full weight
};

/// The way from the levels of tiles to points.
enum class RecursiveDrawing
{
    once,  ///< a tile's points, and of the tiles in its cells what these have beside them
    twice, ///< the points of tiles and of the tiles in their cells: an error, as the first are among the second
};

/// A tile of a level, from the lowest one of that level that meets a window.
using RecursiveCell = std::array<std::uint64_t, 2>;

/// A window of whole tiles of a level, and how the tiles of each level that meet it lie: numbers stay small at any
/// depth, as they count from the lowest of these tiles.
struct RecursiveFrame
{
    /// The place of a window's lowest tile in a tile of the level above, from 0 to 3 along each axis, for the levels
    /// from 1 to that of the window; `size`: of the window, in tiles.
    RecursiveFrame(std::vector<std::array<std::uint8_t, 2>> digits, std::array<std::uint64_t, 2> size);

    int level() const { return static_cast<int>(digits.size()); }

    /// The place of a cell of a tile of `level`, at the next level.
    RecursiveCell cell_of(const RecursiveCell& tile, int level, std::uint32_t cell) const
    {
        const auto at = static_cast<std::size_t>(level);
        const std::array<std::uint8_t, 2> less = at < digits.size() ? digits[at] : std::array<std::uint8_t, 2>{};
        return {4 * tile[0] + (cell & 3U) - less[0], 4 * tile[1] + (cell >> 2) - less[1]};
    }

    /// Tells whether a tile meets the window; those of deeper levels do, as their parents did. Tiles before the lowest
    /// have numbers that wrapped around.
    bool has(const RecursiveCell& tile, int level) const
    {
        const auto at = static_cast<std::size_t>(level);
        return at >= sizes.size() || (tile[0] < sizes[at][0] && tile[1] < sizes[at][1]);
    }

    std::vector<std::array<std::uint8_t, 2>> digits;   ///< by level, from level 1 on
    std::vector<std::array<std::uint64_t, 2>> sizes{}; ///< by level, from level 0 on: the tiles that meet the window
};

/// The tile, of any level, and the rank there by which a point was found.
struct RecursiveOrigin
{
    int level = 0;
    RecursiveCell tile{};
    std::uint32_t rank = 0;

    auto operator<=>(const RecursiveOrigin&) const = default;
};

/// A point where it lies: `cell`, in tiles of a level that is no less than that of its window, from the window's lowest
/// corner, and the place in that tile.
struct RecursivePoint
{
    int level = 0;
    RecursiveCell cell{};
    RecursivePlace place{};
    RecursiveOrigin origin{};

    auto operator<=>(const RecursivePoint&) const = default;
};

/// A tile of level 0 in its place.
struct RecursiveRoot
{
    std::uint8_t tile = 0;
    std::uint64_t turn = 0; ///< when it gets its next point: parts of 2^32 of one point per tile; not 0
};

/// A tile of a level in its place, and the ranks of it that may have points: `count` from `first` on.
struct RankedCell
{
    std::uint8_t tile = 0;
    std::array<std::uint64_t, 2> cell{};
    std::uint64_t turn = 0; ///< when the tile gets its next point: parts of 2^32 of one
    std::uint32_t first = 0, count = 0;
};

/// A tile in its place, of any level.
struct RecursiveNode
{
    std::uint8_t tile = 0;
    RecursiveCell cell{};
    std::uint64_t turn = 0;
};

/// When the tile of a cell gets its next point, of one that gets it at `turn`: cells that are neighbours are far apart.
std::uint64_t turn_of_cell(std::uint32_t cell, std::uint64_t turn);

/// The points of a window, `roots` being the tiles of level 0 that meet it, in the order of levels, tiles and ranks.
/// `density` is one over just this window. Places are those of the window's level or deeper ones, exactly: points of
/// larger tiles are followed down.
std::vector<RecursivePoint> points_in_frame(const RecursiveTileSet& tiles, const RecursiveFrame& frame,
                                            std::vector<RecursiveNode> roots, const RecursiveDensity& density);

class RecursiveTiling
{
public:
    /// A torus of side x side tiles of level 0, `roots`; `tiles` must outlive it. Side from 1 to 256. The stream
    /// decides which of them get their points first.
    RecursiveTiling(const RecursiveTileSet& tiles, std::uint32_t side, const StreamKey& stream, RootTiles roots);

    /// Takes hashed_root_tiles() as the roots of the torus.
    RecursiveTiling(const RecursiveTileSet& tiles, std::uint32_t side, const StreamKey& stream)
        : RecursiveTiling(tiles, side, stream, hashed_root_tiles(side, stream))
    {}

    std::uint32_t side() const { return side_; }
    const RecursiveTileSet& tiles() const { return *tiles_; }

    /// The points of the whole torus, in the order of tiles and ranks. `density` is over the torus: its side, level 0.
    /// On all threads; the same for any number of them.
    PointSet torus_points(const RecursiveDensity& density, RecursiveDrawing drawing = RecursiveDrawing::once) const;

    /// Shows the tiles of each level that may have points, in the order of torus_points().
    void show_levels(const RecursiveDensity& density, RecursiveDrawing drawing,
                     const std::function<void(int level, const std::vector<RankedCell>&)>& show) const;

    /// The tiles of level 0, row by row from the lower left.
    std::vector<RecursiveNode> roots() const;

private:
    const RecursiveTileSet* tiles_;
    std::uint32_t side_;
    RootTiles root_tiles_;
    std::vector<std::uint64_t> root_turns_; ///< when a tile gets its next point: parts of 2^32 of one point per tile
};

}
