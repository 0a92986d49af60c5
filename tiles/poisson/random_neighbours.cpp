#include "tiles/poisson/random_neighbours.hpp"

#include "tiles/poisson/tile_pieces.hpp"

namespace poissonlab {
namespace {

/// Random numbers by their place, four from each call of the generator.
class RandomNumbers
{
public:
    RandomNumbers(const StreamKey& stream, std::uint32_t tile, std::uint32_t counter)
        : stream_(stream), tile_(tile), counter_(counter)
    {}

    std::uint32_t below(std::uint32_t limit)
    {
        if (used_ % 4 == 0) block_ = philox({tile_, counter_, used_ / 4, 0}, stream_);
        return block_[used_++ % 4] % limit;
    }

private:
    StreamKey stream_;
    std::uint32_t tile_, counter_, used_ = 0;
    std::array<std::uint32_t, 4> block_{};
};

/// Calls with the places of all neighbours.
template <class Visit>
void for_each_place(int dimension, const Visit& visit)
{
    const int layers = dimension == 3 ? 1 : 0;
    for (int z = -layers; z <= layers; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) visit(x, y, z);
}

/// Lattice points from -1 to 2 along each axis have colours; the tile has those at 0 and 1.
NeighbourTiles corner_neighbours(const PoissonTileParameters& p, std::uint32_t tile, RandomNumbers& random)
{
    std::array<std::uint32_t, 64> colors{};
    for (std::uint32_t& color : colors) color = random.below(p.colors);
    const auto color_at = [&](int x, int y, int z) -> std::uint32_t& {
        return colors[static_cast<std::size_t>(16 * (z + 1) + 4 * (y + 1) + x + 1)];
    };
    const auto own = corner_colors_of(tile, p.dimension, p.colors);
    const unsigned corners = 1U << p.dimension;
    for (unsigned k = 0; k < corners; ++k) color_at(k & 1, k >> 1 & 1, static_cast<int>(k >> 2)) = own[k];
    NeighbourTiles tiles{};
    for_each_place(p.dimension, [&](int x, int y, int z) {
        std::array<std::uint32_t, 8> around{};
        for (unsigned k = 0; k < corners; ++k)
            around[k] =
                color_at(x + static_cast<int>(k & 1), y + static_cast<int>(k >> 1 & 1), z + static_cast<int>(k >> 2));
        tiles[neighbour_number(x, y, z)] = corner_tile_of(around, p.dimension, p.colors);
    });
    return tiles;
}

/// Edges go right (axis 0) or up (axis 1) from lattice points, which are -2 to 2 along each axis.
NeighbourTiles edge_neighbours(const PoissonTileParameters& p, std::uint32_t tile, RandomNumbers& random)
{
    struct Edge
    {
        int x, y, axis;
    };
    /// The edges of a tile, in the order of edge_colors_of().
    constexpr std::array<Edge, 12> own_edges{{{0, 1, 0},
                                              {1, 0, 1},
                                              {0, 0, 0},
                                              {0, 0, 1},
                                              {1, 1, 0},
                                              {1, 1, 1},
                                              {1, 0, 0},
                                              {1, -1, 1},
                                              {-1, 0, 0},
                                              {0, -1, 1},
                                              {-1, 1, 0},
                                              {0, 1, 1}}};
    std::array<std::uint32_t, 50> colors{};
    for (std::uint32_t& color : colors) color = random.below(p.colors);
    const auto color_of = [&](const Edge& edge, int x, int y) -> std::uint32_t& {
        return colors[static_cast<std::size_t>(25 * edge.axis + 5 * (edge.y + y + 2) + edge.x + x + 2)];
    };
    const auto own = edge_colors_of(tile, p.colors);
    for (std::size_t e = 0; e < own_edges.size(); ++e) color_of(own_edges[e], 0, 0) = own[e];
    NeighbourTiles tiles{};
    for_each_place(2, [&](int x, int y, int z) {
        std::array<std::uint32_t, 12> around{};
        for (std::size_t e = 0; e < own_edges.size(); ++e) around[e] = color_of(own_edges[e], x, y);
        tiles[neighbour_number(x, y, z)] = edge_tile_of(around, p.colors);
    });
    return tiles;
}

NeighbourTiles any_neighbours(const PoissonTileParameters& p, std::uint32_t tile, RandomNumbers& random)
{
    NeighbourTiles tiles{};
    for_each_place(p.dimension, [&](int x, int y, int z) { tiles[neighbour_number(x, y, z)] = random.below(p.tiles); });
    tiles[neighbour_number(0, 0, 0)] = tile;
    return tiles;
}

}

NeighbourTiles random_neighbours(const PoissonTileParameters& p, std::uint32_t tile, const StreamKey& stream,
                                 std::uint32_t counter)
{
    RandomNumbers random(stream, tile, counter);
    switch (p.kind) {
    case PoissonTileKind::corner:
        return corner_neighbours(p, tile, random);
    case PoissonTileKind::edge:
        return edge_neighbours(p, tile, random);
    default:
        return any_neighbours(p, tile, random);
    }
}

}
