// The points of a block of tiles, made on a device: a copy of each tile's points and an addition.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 3.3 and 4.6. Order: rows of tiles from south to north
// (3D: layers from the bottom), in each from west to east, the points of a tile as they are stored. Positions
// are relative to the lowest corner of the block, as floats in tiles, which round where the block is wide, or
// as 32-bit integers in units of 1/65,536 of a tile, modulo 2^32, which do not. Points of tiles with chains may lie up
// to half a tile outside of the block.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/needed_buffers.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

/// Integer positions are so many to a tile's side.
inline constexpr std::uint32_t units_per_tile = 65536;

/// The tiles from `lowest` on, `size` of them along each axis; in 2D, one layer.
struct TileBlock
{
    std::array<std::int32_t, 3> lowest{};
    std::array<std::uint32_t, 3> size{1, 1, 1};

    std::uint64_t tiles() const { return std::uint64_t{size[0]} * size[1] * size[2]; }
};

/// Throws InputError for sizes below 1 or above 65,536, for blocks that are not at places of 32 bits, and in
/// 2D for layers.
void check(const TileBlock& block, int dimension);

/// A part of a block in its order of tiles.
struct TileRun
{
    std::uint64_t first = 0;
    std::uint32_t count = 0;
};

/// The place of an integer position on a circle of so many tiles; positions are at most half a tile outside of it,
/// below 0 modulo 2^32.
std::uint64_t torus_place(std::uint32_t unit, std::uint32_t tiles);

/// Integer positions of a torus of `period` tiles as coordinates in [0, 1): each, modulo the side of the torus, divided
/// by that. Positions are at most half a tile outside of it.
void append_torus_points(std::span<const std::uint32_t> units, std::uint32_t period, std::vector<double>& coordinates);

namespace reference {
/// All points of a block, coordinate after coordinate.
std::vector<float> tile_points(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block);
std::vector<std::uint32_t> exact_tile_points(const PoissonTileSet& tiles, const PoissonTiling& tiling,
                                             const TileBlock& block);
/// All points of the toroidal tiling with this period.
PointSet torus_points(const PoissonTileSet& tiles, std::uint32_t seed, std::uint32_t period);
}

/// Makes the same points, bit for bit, by kernels/tile_points.cl. The tiles are copied to the device once.
class TilePointGenerator
{
public:
    /// `work_group_size` 0: the default.
    TilePointGenerator(Device device, const PoissonTileSet& tiles, std::size_t work_group_size = 0);

    /// The memory that a generator takes on such a device for a block of so many tiles, with stream() or
    /// generate_torus(). The tile set is copied in one piece; blocks are made in pieces that fit.
    static DeviceMemory memory(const PoissonTileParameters& parameters, std::uint64_t tiles, const DeviceInfo& device);

    /// The number of coordinates of a tile's points.
    std::size_t values_per_tile() const { return values_per_tile_; }

    /// Enqueues the positions of a part of a block; `points` has room for them and may be reused, which is
    /// much faster than memory that nothing was written to before. The block is checked.
    void place(const PoissonTiling& tiling, const TileBlock& block, const TileRun& run, Buffer<float>& points);
    void place(const PoissonTiling& tiling, const TileBlock& block, const TileRun& run, Buffer<std::uint32_t>& points);

    /// Takes exact positions of whole tiles.
    using Sink = std::function<void(std::span<const std::uint32_t> units)>;

    /// Hands all exact positions of a block to `sink`, in pieces: memory does not depend on the block.
    void stream(const PoissonTiling& tiling, const TileBlock& block, const Sink& sink);

    /// Hands on the exact positions of a part of a block: of the tiles from `first` on, below `end`.
    void stream(const PoissonTiling& tiling, const TileBlock& block, std::uint64_t first, std::uint64_t end,
                const Sink& sink);

    /// All points of the toroidal tiling with this period, 1 to 65,536.
    PointSet generate_torus(std::uint32_t seed, std::uint32_t period);

private:
    struct Buffers
    {
        Buffer<std::uint16_t> units;
        Buffer<std::uint32_t> tiles;  ///< the numbers of a run's tiles
        Buffer<std::uint32_t> points; ///< of stream()

        /// `piece`: tiles that stream() makes at once.
        NeededBuffers needed(const PoissonTileParameters& parameters, std::size_t piece);
    };

    Kernel kernel(const char* name, const char* value);
    template <class Value>
    void place_values(Kernel& place, const PoissonTiling& tiling, const TileBlock& block, const TileRun& run,
                      Buffer<Value>& points);

    Device device_;
    PoissonTileParameters parameters_;
    std::size_t work_group_size_;
    std::size_t values_per_tile_;
    Buffers buffers_;
    std::vector<std::uint32_t> piece_; ///< of stream()
    Kernel look_up_, place_floats_, place_integers_;
};

// Whoever needs the points of many tiles takes them from a stream, which a kernel or its plain twin makes.

/// Hands on the integer positions of the points of the tiles `first` ... `end` - 1 of a block, in pieces of whole
/// tiles.
using UnitStream =
    std::function<void(const PoissonTiling& tiling, const TileBlock& block, std::uint64_t first, std::uint64_t end,
                       const std::function<void(std::span<const std::uint32_t>)>& sink)>;

/// Makes a stream by a kernel. The device and the tiles must outlive what is returned.
UnitStream device_stream(const Device& device, const PoissonTileSet& tiles);

/// Makes a stream by the plain twin, one tile after the other. The tiles must outlive what is returned.
UnitStream reference_stream(const PoissonTileSet& tiles);

}
