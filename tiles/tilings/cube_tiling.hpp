// Direct stochastic tilings in three dimensions and in one: corner cubes, Wang cubes and dominoes, as values.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 2.10, 3.3.1 and 4.6.
#pragma once

#include "tiles/tilings/tile_lattice.hpp"
#include "tiles/tilings/tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <functional>
#include <span>

namespace poissonlab {

/// A box of cubes: those with x <= cube x < x + width, and the same for y and height, z and depth.
struct CubeWindow
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint64_t depth = 0;
};

/// Is given cube indices from (x, y, z) eastwards.
using CubeSink = std::function<void(std::int64_t x, std::int64_t y, std::int64_t z, std::span<const TileIndex> cubes)>;

class CubeTiling
{
public:
    /// Throws InputError for fewer than 2 colours or more than most_colors_of(kind), and for a period that is
    /// negative. `kind`: cube or wang_cube.
    CubeTiling(Color colors, const HashChoice& hash, std::uint64_t seed, Period period = {},
               TileKind kind = TileKind::cube);

    const TileSet& tile_set() const { return tile_set_; }
    Period period() const { return period_; }
    const ColorHash& hash() const { return hash_; }

    /// The index of the cube whose bottom south-west corner is (x, y, z).
    TileIndex tile(std::int64_t x, std::int64_t y, std::int64_t z) const;

    /// Hands a window's cubes to `sink`: layers from the bottom to the top, in each layer rows from north to
    /// south, in each row cubes from west to east; rows longer than 8192 cubes in pieces of that length.
    void stream(const CubeWindow& window, const CubeSink& sink) const;

private:
    TileSet tile_set_;
    Period period_;
    ColorHash hash_;
};

class DominoTiling
{
public:
    /// Throws InputError for fewer than 2 colours or more than max_colors, and for a period that is negative.
    DominoTiling(Color colors, const HashChoice& hash, std::uint64_t seed, std::int64_t period = 0);

    const TileSet& tile_set() const { return tile_set_; }
    const ColorHash& hash() const { return hash_; }

    /// The index of the domino from x to x + 1.
    TileIndex tile(std::int64_t x) const;

    /// Hands the dominoes of x <= domino x < x + width to `sink`, from west to east, in pieces of at most 8192; y and z
    /// are `place`'s.
    void stream(const CubeWindow& place, const CubeSink& sink) const;

private:
    TileSet tile_set_;
    Period period_;
    ColorHash hash_;
};

}
