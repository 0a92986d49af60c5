// Foretells the sizes of the tori that the construction fills.
#include "base/geometry/lattice.hpp"
#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/chain_choice.hpp"
#include "host/tile_construction/chain_construction.hpp"
#include "host/tile_construction/joint/joint_tiling.hpp"
#include "host/tile_construction/tile_construction.hpp"

#include <cmath>

namespace poissonlab {
namespace {

/// Points of the fullest of many regions where `mean` are expected. Construction chooses pieces that are close to it.
std::size_t fullest(double mean) { return static_cast<std::size_t>(std::ceil(mean + std::sqrt(mean))); }

/// Expected number of points in the regions of some pieces.
double held_points(const PoissonTileParameters& p, const TileRegions& regions, const std::vector<PlacedPiece>& pieces)
{
    double volume = 0;
    for (const PlacedPiece& piece : pieces) volume += regions.volume(piece.axes);
    return p.points_per_tile * volume;
}

FillShape boundary_shape(const PoissonTileParameters& p, const TileRegions& regions, const BoundaryStage& stage)
{
    const std::size_t all = std::size_t{p.points_per_tile} << p.dimension;
    const double held = held_points(p, regions, stage.tori.front().held);
    const double active = static_cast<double>(all) - held;
    return {stage.tori.size(), all, held == 0 ? all : std::min(all, fullest(std::max(0.0, active)))};
}

FillShape interior_shape(const PoissonTileParameters& p, const TileRegions& regions)
{
    const double n = p.points_per_tile;
    const double active = n * regions.volume(all_axes(p.dimension));
    const double held = held_points(p, regions, pieces_around(p, 0));
    double points = held + active;
    // The first of template tiles is there already.
    const std::size_t tori = p.kind == PoissonTileKind::frame ? std::max(1U, p.tiles - 1) : p.tiles;
    if (p.lloyd_iterations > 0) {
        const double side = 1 + 2.0 * surroundings_margin(regions, p.dimension) / tile_units;
        points = std::max(points, n * std::pow(side, p.dimension));
        if (p.dimension == 2) return {tori, fullest(points), fullest(points - held)}; // surroundings move
    }
    return {tori, fullest(points), std::min<std::size_t>(p.points_per_tile, fullest(active))};
}

/// The fillings that bring back the distance after joint iterations: of pieces that tiles share, and of tiles.
std::vector<FillShape> mending_shapes(const PoissonTileParameters& p, const TileRegions& regions)
{
    const auto shape = [&](std::uint8_t axes, const std::vector<PlacedPiece>& around) {
        const double held = held_points(p, regions, around), active = p.points_per_tile * regions.volume(axes);
        return FillShape{piece_count(p, axes), fullest(held + active), fullest(active)};
    };
    std::vector<FillShape> shapes{shape(all_axes(p.dimension), pieces_around(p, 0))};
    if (p.kind == PoissonTileKind::frame) {
        const std::size_t points = fullest(p.points_per_tile * (1 - regions.volume(all_axes(2))));
        shapes.push_back({1, points, points, 4});
        return shapes;
    }
    for (std::uint8_t axes = 0; axes < all_axes(p.dimension); ++axes)
        shapes.push_back(shape(axes, earlier_neighbours(p, axes, 0)));
    return shapes;
}

/// Tori of all pairs of colours, insides of all tiles, and the torus of all tiles.
DeviceMemory chain_memory(const PoissonTileParameters& p, const DeviceInfo& device)
{
    const std::size_t points = p.points_per_tile;
    // Borders have some sqrt N points a side; 2 is generous.
    const auto border = static_cast<std::size_t>(8 * std::sqrt(points));
    const std::vector<FillShape> tori{{chain_tori(p), 4 * points, 4 * points}};
    const std::vector<FillShape> insides{{p.tiles, border + points, points}};
    return filling_memory(chain_torus_settings(p), tori, device) +
           filling_memory(chain_interior_settings(p), insides, device) + joint_memory_of(p);
}

}

DeviceMemory joint_memory_of(const PoissonTileParameters& p)
{
    if (p.joint_iterations == 0) return {};
    const std::size_t copies = lattice_cells(joint_side(p), p.dimension) * p.points_per_tile;
    return joint_memory(p.dimension, copies, std::size_t{p.tiles} * p.points_per_tile, p.points_per_tile);
}

DeviceMemory construction_memory(const PoissonTileParameters& parameters, const DeviceInfo& device)
{
    if (parameters.border == TileBorder::chain) return chain_memory(parameters, device);
    const TileRegions regions = regions_of(parameters);
    std::vector<FillShape> shapes{interior_shape(parameters, regions)};
    if (parameters.kind == PoissonTileKind::frame) {
        const std::size_t points = parameters.points_per_tile;
        shapes.push_back({master_tiles, points, points, 4});
    } else {
        for (const BoundaryStage& stage : boundary_stages(parameters))
            shapes.push_back(boundary_shape(parameters, regions, stage));
    }
    const DeviceMemory pieces = filling_memory(fill_settings(parameters), shapes, device);
    if (!are_relaxed_together(parameters)) return pieces;
    return pieces + filling_memory(mending_settings(parameters), mending_shapes(parameters, regions), device) +
           joint_memory_of(parameters);
}

}
