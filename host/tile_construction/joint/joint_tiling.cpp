#include "host/tile_construction/joint/joint_tiling.hpp"

#include "base/geometry/lattice.hpp"
#include "base/random/random.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

constexpr std::uint32_t least_side_in_plane = 12;
constexpr std::uint32_t least_side_in_space = 5;
constexpr std::uint32_t copies_of_a_tile = 4;

/// Places that are tried for a tile that a torus lacks.
constexpr std::uint32_t max_places = 200;

/// Random numbers of the colours, of the places of missing tiles, and of template tiles.
enum Use : std::uint32_t
{
    color_use,
    place_use,
    order_use
};

using Place = std::array<std::uint32_t, 3>;

/// Colours on a torus, of which every tile has those around it: corners one a lattice point; edges two, that of the
/// edge that goes right from a lattice point, and that of the one that goes up.
class ColorTorus
{
public:
    ColorTorus(const PoissonTileParameters& parameters, std::uint32_t side)
        : p_(parameters), side_(side), places_(lattice_cells(side, parameters.dimension)),
          colors_(places_ * colors_a_place)
    {}

    std::size_t places() const { return places_; }

    /// Sets the colours at a lattice point.
    void set(std::size_t place, const std::array<std::uint32_t, 4>& random)
    {
        for (std::size_t i = 0; i < colors_a_place; ++i) colors_[place * colors_a_place + i] = random[i] % p_.colors;
    }

    std::uint32_t tile(const Place& at) const
    {
        if (p_.kind == PoissonTileKind::edge) {
            std::array<std::uint32_t, 12> edges{};
            for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = colors_[edge(at, i)];
            return edge_tile_of(edges, p_.colors);
        }
        std::array<std::uint32_t, 8> corners{};
        for (std::uint32_t i = 0; i < corner_count(); ++i) corners[i] = colors_[corner(at, i)];
        return corner_tile_of(corners, p_.dimension, p_.colors);
    }

    void put(const Place& at, std::uint32_t tile)
    {
        if (p_.kind == PoissonTileKind::edge) {
            const auto edges = edge_colors_of(tile, p_.colors);
            for (std::size_t i = 0; i < edges.size(); ++i) colors_[edge(at, i)] = edges[i];
            return;
        }
        const auto corners = corner_colors_of(tile, p_.dimension, p_.colors);
        for (std::uint32_t i = 0; i < corner_count(); ++i) colors_[corner(at, i)] = corners[i];
    }

    /// The tiles that have a colour of the tile at a place, itself among them.
    std::vector<std::uint32_t> tiles_around(const Place& at) const
    {
        const std::uint32_t reach = p_.kind == PoissonTileKind::edge ? 2 : 1;
        const std::uint32_t width = 2 * reach + 1;
        std::vector<std::uint32_t> around;
        for (std::uint32_t i = 0; i < lattice_cells(width, p_.dimension); ++i) {
            Place place = at;
            const Place step{i % width, i / width % width, i / width / width};
            for (std::size_t k = 0; k < static_cast<std::size_t>(p_.dimension); ++k)
                place[k] += side_ + step[k] - reach;
            around.push_back(tile(place));
        }
        return around;
    }

private:
    /// A corner's, or that of the edge that goes right; then that of the edge that goes up.
    static constexpr std::size_t colors_a_place = 2;

    std::uint32_t corner_count() const { return 1u << p_.dimension; }

    /// The index of the first colour at a lattice point.
    std::size_t index(const Place& at) const
    {
        std::size_t place = 0;
        for (auto k = static_cast<std::size_t>(p_.dimension); k-- > 0;) place = place * side_ + at[k] % side_;
        return place * colors_a_place;
    }

    /// The index of the colour of a tile's corner.
    std::size_t corner(const Place& at, std::uint32_t number) const
    {
        return index({at[0] + (number & 1), at[1] + (number >> 1 & 1), at[2] + (number >> 2)});
    }

    /// The index of the colour of a tile's edge, in the order of edge_colors_of().
    std::size_t edge(const Place& at, std::size_t number) const
    {
        struct Edge
        {
            std::uint32_t x, y; ///< one more than the place of its lower end
            std::size_t goes_up;
        };
        static constexpr std::array<Edge, 12> edges{{{1, 2, 0}, // north, east, south, west
                                                     {2, 1, 1},
                                                     {1, 1, 0},
                                                     {1, 1, 1},
                                                     {2, 2, 0}, // at the north-east corner
                                                     {2, 2, 1},
                                                     {2, 1, 0}, // at the south-east corner
                                                     {2, 0, 1},
                                                     {0, 1, 0}, // at the south-west corner
                                                     {1, 0, 1},
                                                     {0, 2, 0}, // at the north-west corner
                                                     {1, 2, 1}}};
        const Edge& e = edges[number];
        return index({at[0] + side_ + e.x - 1, at[1] + side_ + e.y - 1, 0}) + e.goes_up;
    }

    const PoissonTileParameters& p_;
    std::uint32_t side_;
    std::size_t places_;
    std::vector<std::uint32_t> colors_;
};

/// A torus of random colours, whose tiles are counted.
class CountedTorus
{
public:
    CountedTorus(const PoissonTileParameters& parameters, std::uint32_t iteration)
        : p_(parameters), side_(joint_side(parameters)), iteration_(iteration),
          stream_(stream_key(parameters.seed, Purpose::joint_tiling, 0)), torus_(parameters, side_),
          counts_(parameters.tiles)
    {
        for (std::uint32_t i = 0; i < torus_.places(); ++i) torus_.set(i, random(i, 0, color_use));
        for (const std::uint32_t tile : tiles()) ++counts_[tile];
    }

    void add_missing_tiles()
    {
        for (std::uint32_t missing = 0; missing < p_.tiles; ++missing)
            for (std::uint32_t attempt = 0; attempt < max_places && counts_[missing] == 0; ++attempt) {
                const auto words = random(missing, attempt, place_use);
                try_place(missing, {words[0] % side_, words[1] % side_, p_.dimension == 3 ? words[2] % side_ : 0});
            }
    }

    std::vector<std::uint32_t> tiles() const
    {
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < torus_.places(); ++i)
            all.push_back(torus_.tile({i % side_, i / side_ % side_, i / side_ / side_}));
        return all;
    }

private:
    std::array<std::uint32_t, 4> random(std::uint32_t a, std::uint32_t b, Use use) const
    {
        return philox({a, b, iteration_, use}, stream_);
    }

    /// Puts a tile where it costs no other tile its last place.
    void try_place(std::uint32_t missing, const Place& at)
    {
        const auto before = torus_.tiles_around(at);
        const std::uint32_t old = torus_.tile(at);
        torus_.put(at, missing);
        const auto after = torus_.tiles_around(at);
        for (const std::uint32_t tile : before) --counts_[tile];
        for (const std::uint32_t tile : after) ++counts_[tile];
        if (std::ranges::none_of(before, [&](std::uint32_t tile) { return counts_[tile] == 0; })) return;
        torus_.put(at, old);
        for (const std::uint32_t tile : after) --counts_[tile];
        for (const std::uint32_t tile : before) ++counts_[tile];
    }

    const PoissonTileParameters& p_;
    std::uint32_t side_, iteration_;
    StreamKey stream_;
    ColorTorus torus_;
    std::vector<std::uint32_t> counts_;
};

/// Template tiles fit anywhere: as many of each as can be, in random order.
std::vector<std::uint32_t> shuffled_tiles(const PoissonTileParameters& p, std::uint32_t iteration)
{
    const std::uint32_t side = joint_side(p);
    const StreamKey stream = stream_key(p.seed, Purpose::joint_tiling, 0);
    std::vector<std::uint32_t> tiles;
    for (std::uint32_t i = 0; i < side * side; ++i) tiles.push_back(i % p.tiles);
    for (std::uint32_t i = side * side; i > 1; --i)
        std::swap(tiles[i - 1], tiles[philox({i, 0, iteration, order_use}, stream)[0] % i]);
    return tiles;
}

}

std::uint32_t joint_side(const PoissonTileParameters& p)
{
    std::uint32_t side = p.dimension == 2 ? least_side_in_plane : least_side_in_space;
    while (lattice_cells(side, p.dimension) < std::size_t{copies_of_a_tile} * p.tiles) ++side;
    return side;
}

std::vector<std::uint32_t> joint_tiling(const PoissonTileParameters& p, std::uint32_t iteration)
{
    if (p.kind == PoissonTileKind::frame) return shuffled_tiles(p, iteration);
    CountedTorus torus(p, iteration);
    torus.add_missing_tiles();
    return torus.tiles();
}

}
