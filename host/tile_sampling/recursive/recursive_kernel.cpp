#include "host/tile_sampling/recursive/recursive_kernel.hpp"

#include "kernels/common/tile_sampling/recursive_tiles.h"

#include <array>
#include <utility>

namespace poissonlab {

using contract::recursive_tiles::RankedLevel;
using contract::recursive_tiles::RankedTile;

namespace {

/// One call finds the points of so many ranks, of so many tiles at most.
constexpr std::size_t ranks_of_a_call = std::size_t{1} << 20;
constexpr std::size_t tiles_of_a_call = std::size_t{1} << 15;

}

struct RecursiveBuffers
{
    Buffer<RankedTile> tiles;
    Buffer<std::uint16_t> links;
    Buffer<std::uint32_t> children;
    Buffer<RecursivePlace> places;
    Buffer<std::uint64_t> weights;
    Buffer<std::array<double, 2>> points;

    NeededBuffers needed(std::size_t points_per_tile, std::size_t weight_count)
    {
        using namespace contract::recursive_tiles;
        return {{tiles, tiles_of_a_call},
                {links, TILES * CELLS * points_per_tile},
                {children, std::size_t{TILES} * CELLS},
                {places, TILES * points_per_tile},
                {weights, weight_count},
                {points, ranks_of_a_call}};
    }
};

RecursiveGenerator::RecursiveGenerator(Device device, const RecursiveTileSet& tiles, const RecursiveDensity& density,
                                       std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<RecursiveBuffers>()), density_(&density)
{
    const std::size_t points = tiles.points_per_tile();
    reserve(device_, buffers_->needed(points, density.bounds().weights.size()));
    for (std::size_t tile = 0; tile < even_wang_tiles; ++tile) {
        std::vector<std::uint16_t> links;
        for (const RecursiveLink link : tiles.tile(tile).links) links.push_back(link.word);
        buffers_->links.write(links, tile * links.size());
        const auto& children = tiles.tile(tile).children;
        buffers_->children.write(std::vector<std::uint32_t>(children.begin(), children.end()), tile * recursive_cells);
        buffers_->places.write(tiles.places(tile), tile * points);
    }
    buffers_->weights.write(density.bounds().weights);
}

DeviceMemory RecursiveGenerator::memory(std::size_t points_per_tile, std::size_t weights)
{
    return memory_of(RecursiveBuffers{}.needed(points_per_tile, weights));
}

/// Adds the points of some tiles of a level, in as many calls as buffers ask for.
void RecursiveGenerator::place(const RecursiveTiling& tiling, int level, const std::vector<RankedCell>& cells,
                               PointSet& set)
{
    Kernel place_ranks = device_.kernel(kernel_program("recursive_tiles.cl", {}), "place_ranks");
    RankedLevel header{};
    header.most = density_->most();
    header.across = std::uint64_t{tiling.side()} << 2 * (level + 1);
    header.level = static_cast<std::uint32_t>(level);
    header.points_per_tile = tiling.tiles().points_per_tile();
    header.width = density_->bounds().width;
    header.height = density_->bounds().height;
    header.is_uniform = density_->is_uniform();
    std::vector<std::array<double, 2>> points;
    for (std::size_t next = 0; next < cells.size();) {
        std::vector<RankedTile> tiles;
        header.ranks = 0;
        for (; next < cells.size() && tiles.size() < tiles_of_a_call &&
               header.ranks + cells[next].count <= ranks_of_a_call;
             ++next) {
            const RankedCell& from = cells[next];
            if (from.count == 0) continue;
            tiles.push_back({from.cell[0], from.cell[1], from.turn, from.tile, from.first, header.ranks, 0});
            header.ranks += from.count;
        }
        header.tiles = static_cast<std::uint32_t>(tiles.size());
        buffers_->tiles.write(tiles);
        place_ranks.run(header.ranks, work_group_size_, header, buffers_->tiles, buffers_->links, buffers_->children,
                        buffers_->places, buffers_->weights, buffers_->points);
        points.resize(header.ranks);
        buffers_->points.read(points);
        for (const auto& point : points)
            if (point[0] >= 0) set.coordinates.insert(set.coordinates.end(), point.begin(), point.end());
    }
}

PointSet RecursiveGenerator::torus_points(const RecursiveTiling& tiling, RecursiveDrawing drawing)
{
    PointSet set{2, {}};
    tiling.show_levels(*density_, drawing,
                       [&](int level, const std::vector<RankedCell>& cells) { place(tiling, level, cells, set); });
    return set;
}

}
