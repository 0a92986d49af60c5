// The settings of [[distribution]] kind = "surface".
#pragma once

#include "base/word_table.hpp"
#include "host/settings/distributions/quad_config.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace poissonlab {

enum class SurfaceMethod
{
    darts,
    elimination,
    tiles,
    quads
};

inline constexpr WordTable<SurfaceMethod, 4> surface_methods{{{{SurfaceMethod::darts, "darts"},
                                                               {SurfaceMethod::elimination, "elimination"},
                                                               {SurfaceMethod::tiles, "tiles"},
                                                               {SurfaceMethod::quads, "quads"}}}};

/// A mesh as it is read: see host/distribution/surfaces/surface_set.hpp.
struct SurfaceMesh;

struct PoissonTileSet;

/// kind = "surface": points on the triangles of a mesh, also those of tiles over its texture coordinates.
struct MeshPointSettings
{
    std::filesystem::path mesh;
    SurfaceMethod method = SurfaceMethod::darts;
    std::optional<std::size_t> points;
    std::optional<double> min_distance;
    std::optional<double> relative_radius;
    bool is_closed = false; ///< the tiling repeats after a unit
    double normal_angle = 120;
    double factor = 0.99;
    std::uint32_t candidates = 5;
    std::filesystem::path tiles;                        ///< empty: corner tiles of 3 colours, 32 points
    std::optional<double> tiles_per_unit;               ///< of texture coordinates
    QuadSettings quads;                                 ///< of method quads
    std::uint32_t colors = 1;                           ///< of the vertices of quads
    std::shared_ptr<const SurfaceMesh> read{};          ///< the mesh, where it was read already
    std::shared_ptr<const PoissonTileSet> read_tiles{}; ///< the same of the tiles
};

}
