#include "host/scenes/construction_tiling.hpp"

#include "tiles/poisson/tile_pieces.hpp"

namespace poissonlab {
namespace {

std::variant<Tiling, ColorHash> source_of(const PoissonTileParameters& p)
{
    const WangColors colors{p.colors, p.colors};
    if (p.kind == PoissonTileKind::frame) return make_color_hash(HashKind::xxh64, p.tiles, p.seed);
    if (p.kind == PoissonTileKind::edge)
        return Tiling(DirectAlgorithm::wang_edge_hash, colors, HashKind::xxh64, p.seed);
    return Tiling(DirectAlgorithm::corner, colors, HashKind::xxh64, p.seed);
}

}

ConstructionTiling::ConstructionTiling(const PoissonTileParameters& parameters)
    : parameters_(parameters), source_(source_of(parameters))
{}

std::uint32_t ConstructionTiling::tile(std::int64_t x, std::int64_t y) const
{
    if (const auto* hash = std::get_if<ColorHash>(&source_))
        return std::visit([&](const auto& h) { return h(x, y); }, *hash);
    const Tiling& tiling = std::get<Tiling>(source_);
    return parameters_.kind == PoissonTileKind::edge ? edge_based_tile(tiling, x, y) : tiling.tile(x, y);
}

std::uint32_t ConstructionTiling::edge_based_tile(const Tiling& wang, std::int64_t x, std::int64_t y) const
{
    const auto at = [&](std::int64_t dx, std::int64_t dy) {
        return wang_tile(wang.tile(x + dx, y + dy), {parameters_.colors, parameters_.colors});
    };
    const WangTile own = at(0, 0), north = at(0, 1), east = at(1, 0), south = at(0, -1), west = at(-1, 0);
    return edge_tile_of({own.north, own.east, own.south, own.west, east.north, north.east, east.south, south.east,
                         west.south, south.west, west.north, north.west},
                        parameters_.colors);
}

}
