// Records that samplers make of their point sets beside the points.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The state of an iterative method before its first iteration (entry 0) and after each one.
struct IterationRecord
{
    double relative_radius = 0;
    double energy = 0; ///< mean squared distance of the torus to its nearest point, times N^(2/dimension); 0: no energy
    std::optional<double> relative_radius_within_tiles =
        {}; ///< of tiles, of which the nearest two points may be in two

    bool operator==(const IterationRecord&) const = default;
};

/// The time that building a tile set took, and the machine.
struct TileSetBuild
{
    double seconds = 0; ///< with the proof of its minimum distance, without building kernels
    std::string device; ///< OpenCL; empty: the reference engine
    int threads = 0;    ///< of the host

    bool operator==(const TileSetBuild&) const = default;
};

/// The points of a tile in the regions of its corners, edges, faces or in its interior, on average over the tile set.
struct RegionPoints
{
    std::string name; ///< "corners", "edges", "faces" or "interior"
    double points = 0;
    double expected = 0; ///< of as many points spread evenly: by area (volume)

    bool operator==(const RegionPoints&) const = default;
};

/// The tile set that a tiling method takes its points from.
struct TileSetRecord
{
    std::uint64_t tiles = 0;
    std::uint64_t points_per_tile = 0;
    bool cached = false;                      ///< read from the cache, not built this time
    std::optional<TileSetBuild> build;        ///< this time or then; nothing where that is not known
    std::vector<RegionPoints> regions;        ///< of corners first, the interior last; empty for templates
    std::optional<double> shared_points = {}; ///< the part of a tile's points that another tile of the set has as well

    bool operator==(const TileSetRecord&) const = default;
};

}
