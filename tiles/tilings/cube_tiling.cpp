#include "tiles/tilings/cube_tiling.hpp"

#include "tiles/tilings/direct_tiling.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::uint64_t longest_piece = 8192;

/// Calls `use` with the hash function and the lattice, as the types that they have.
template <class Use>
auto with_types(const ColorHash& hash, Period period, const Use& use)
{
    return std::visit([&](const auto& h) { return period == Period{} ? use(h, Plane{}) : use(h, Torus{period}); },
                      hash);
}

template <class Hash, class Lattice>
TileIndex index_at(const TileSet& set, const Hash& hash, const Lattice& lattice, std::int64_t x, std::int64_t y,
                   std::int64_t z)
{
    const Color colors = set.colors().horizontal;
    return set.kind() == TileKind::cube ? cube_index(direct_cube(hash, lattice, x, y, z), colors)
                                        : wang_cube_index(face_hash_wang_cube(hash, lattice, x, y, z), colors);
}

}

CubeTiling::CubeTiling(Color colors, const HashChoice& hash, std::uint64_t seed, Period period, TileKind kind)
    : tile_set_(TileSet::complete(kind, colors)), period_(checked_period(period)),
      hash_(make_color_hash(hash, colors, seed))
{
    if (axes_of(kind) != 3) throw std::logic_error("a tiling of space is made of cubes");
}

TileIndex CubeTiling::tile(std::int64_t x, std::int64_t y, std::int64_t z) const
{
    return with_types(hash_, period_, [&](const auto& hash, const auto& lattice) {
        return index_at(tile_set_, hash, lattice, x, y, z);
    });
}

void CubeTiling::stream(const CubeWindow& window, const CubeSink& sink) const
{
    std::vector<TileIndex> cubes(std::min(window.width, longest_piece));
    const auto fill = [&](std::span<TileIndex> piece, std::int64_t x, std::int64_t y, std::int64_t z) {
        with_types(hash_, period_, [&](const auto& hash, const auto& lattice) {
            for (std::size_t i = 0; i < piece.size(); ++i)
                piece[i] = index_at(tile_set_, hash, lattice, stepped(x, i), y, z);
        });
    };
    for (std::uint64_t layer = 0; layer < window.depth; ++layer) {
        const std::int64_t z = stepped(window.z, layer);
        for (std::uint64_t row = 0; row < window.height; ++row) {
            const std::int64_t y = stepped(window.y, window.height - 1 - row);
            for (std::uint64_t begin = 0; begin < window.width; begin += cubes.size()) {
                const std::span piece(cubes.data(), std::min<std::uint64_t>(cubes.size(), window.width - begin));
                fill(piece, stepped(window.x, begin), y, z);
                sink(stepped(window.x, begin), y, z, piece);
            }
        }
    }
}

DominoTiling::DominoTiling(Color colors, const HashChoice& hash, std::uint64_t seed, std::int64_t period)
    : tile_set_(TileSet::complete(TileKind::domino, colors)), period_(checked_period({period, 0, 0})),
      hash_(make_color_hash(hash, colors, seed))
{}

TileIndex DominoTiling::tile(std::int64_t x) const
{
    return with_types(hash_, period_, [&](const auto& hash, const auto& lattice) {
        return domino_index(direct_domino(hash, lattice, x), tile_set_.colors().horizontal);
    });
}

void DominoTiling::stream(const CubeWindow& place, const CubeSink& sink) const
{
    std::vector<TileIndex> dominoes(std::min(place.width, longest_piece));
    for (std::uint64_t begin = 0; begin < place.width; begin += dominoes.size()) {
        const std::span piece(dominoes.data(), std::min<std::uint64_t>(dominoes.size(), place.width - begin));
        const std::int64_t x = stepped(place.x, begin);
        for (std::size_t i = 0; i < piece.size(); ++i) piece[i] = tile(stepped(x, i));
        sink(x, place.y, place.z, piece);
    }
}

}
