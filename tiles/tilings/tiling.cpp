#include "tiles/tilings/tiling.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/direct_tiling.hpp"
#include "tiles/tilings/tile_rows.hpp"

#include <algorithm>
#include <string>

namespace poissonlab {
namespace {

TileSet tile_set_of(DirectAlgorithm algorithm, WangColors colors)
{
    if (algorithm == DirectAlgorithm::corner) return TileSet::complete(TileKind::corner, colors);
    if (algorithm == DirectAlgorithm::wang_one_hash) return one_hash_wang_set(colors.horizontal);
    return TileSet::complete(TileKind::wang, colors);
}

WangColors checked_colors(DirectAlgorithm algorithm, WangColors colors)
{
    const bool must_be_same = algorithm == DirectAlgorithm::corner || algorithm == DirectAlgorithm::wang_one_hash;
    if (must_be_same && colors.horizontal != colors.vertical)
        throw InputError("colors = " + std::to_string(colors.horizontal) + " x " + std::to_string(colors.vertical) +
                         ": this algorithm has one number of colours");
    return colors;
}

/// Two hash functions differ, two kinds of edges with one hash function only if they must.
std::uint32_t vertical_stream(DirectAlgorithm algorithm, WangColors colors)
{
    const bool one = algorithm == DirectAlgorithm::wang_edge_hash && colors.horizontal == colors.vertical;
    return one || algorithm == DirectAlgorithm::corner || algorithm == DirectAlgorithm::wang_one_hash ? 0 : 1;
}

template <class Hash, class Lattice>
TileIndex tile_at(DirectAlgorithm algorithm, WangColors colors, const Hash& horizontal, const Hash& vertical,
                  const Lattice& lattice, std::int64_t x, std::int64_t y)
{
    switch (algorithm) {
    case DirectAlgorithm::corner:
        return corner_index(direct_corner_tile(horizontal, lattice, x, y), colors.horizontal);
    case DirectAlgorithm::wang_two_hashes:
        return wang_index(two_hash_wang_tile(horizontal, vertical, lattice, x, y), colors);
    case DirectAlgorithm::wang_one_hash:
        return wang_index(one_hash_wang_tile(horizontal, lattice, x, y), colors);
    case DirectAlgorithm::wang_edge_hash:
        return wang_index(edge_hash_wang_tile(horizontal, vertical, lattice, x, y), colors);
    }
    return 0;
}

}

Tiling::Tiling(DirectAlgorithm algorithm, WangColors colors, HashKind hash, std::uint64_t seed, Period period)
    : algorithm_(algorithm), colors_(checked_colors(algorithm, colors)), tile_set_(tile_set_of(algorithm, colors)),
      period_(checked_period(period)), horizontal_(make_color_hash(hash, colors.horizontal, seed)),
      vertical_(make_color_hash(hash, colors.vertical, seed, vertical_stream(algorithm, colors)))
{}

TileIndex Tiling::tile(std::int64_t x, std::int64_t y) const
{
    return std::visit(
        [&](const auto& horizontal) {
            const auto& vertical = *std::get_if<std::remove_cvref_t<decltype(horizontal)>>(&vertical_);
            if (period_ == Period{}) return tile_at(algorithm_, colors_, horizontal, vertical, Plane{}, x, y);
            return tile_at(algorithm_, colors_, horizontal, vertical, Torus{period_}, x, y);
        },
        horizontal_);
}

void Tiling::fill_row(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles) const
{
    TileRows rows(*this);
    while (!tiles.empty()) {
        const std::size_t count = std::min<std::size_t>(tiles.size(), TileRows::longest);
        rows.fill(x, y, tiles.first(count));
        tiles = tiles.subspan(count);
        x = stepped(x, count);
    }
}

void Tiling::stream(const TileWindow& window, const TileSink& sink) const
{
    TileRows rows(*this);
    std::vector<TileIndex> tiles(std::min<std::uint64_t>(window.width, TileRows::longest));
    for (std::uint64_t row = 0; row < window.height; ++row) {
        const std::int64_t y = stepped(window.y, window.height - 1 - row);
        for (std::uint64_t begin = 0; begin < window.width; begin += tiles.size()) {
            const std::int64_t x = stepped(window.x, begin);
            const std::span piece(tiles.data(), std::min<std::uint64_t>(tiles.size(), window.width - begin));
            rows.fill(x, y, piece);
            sink(x, y, piece);
        }
    }
}

}
