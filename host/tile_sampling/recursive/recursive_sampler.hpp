// The sampler "recursive-wang-tiles".
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006; Lagae,
// Tile-Based Methods in Computer Graphics, 2007, section 6.14. Runs on the host: what a processor does to a point is
// less than what it takes to move it.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/sampler.hpp"
#include "host/tile_sampling/recursive/recursive_points.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

// Points of recursive Wang tiles on a device, by kernels/recursive_tiles.cl: those of RecursiveTiling::torus_points(),
// bit for bit.

/// Makes sets of one tile set and one density, both of which are copied to the device once.
class RecursiveGenerator : DeviceMethod<struct RecursiveBuffers>
{
public:
    /// `density` must outlive it, and is over a torus: its side, level 0. `work_group_size` 0: the default.
    RecursiveGenerator(Device device, const RecursiveTileSet& tiles, const RecursiveDensity& density,
                       std::size_t work_group_size = 0);

    /// The points of the whole torus. No density is so large that tiles are divided more than seven times: the numbers
    /// of tiles fit 24 bits.
    PointSet torus_points(const RecursiveTiling& tiling, RecursiveDrawing drawing = RecursiveDrawing::once);

    /// The memory that a generator takes for tiles of so many points, and a density with so many weights.
    static DeviceMemory memory(std::size_t points_per_tile, std::size_t weights);

private:
    void place(const RecursiveTiling& tiling, int level, const std::vector<RankedCell>& cells, PointSet& set);

    const RecursiveDensity* density_;
};

SamplerSpec recursive_wang_tile_sampler();

// Recursive Wang tiles that were built before.

struct CachedRecursiveTiles
{
    RecursiveTileSet tiles;
    TileSetRecord record;
    double waiting_seconds = 0; ///< for another process that was building them
};

/// The tiles from `folder`, or built and put there: see cached_tile_set(), which does the same for other tiles.
CachedRecursiveTiles cached_recursive_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                                            const std::filesystem::path& folder,
                                            const std::function<void(const std::string& what)>& on_step = {});

}
