#include "host/tile_construction/joint_tiling.hpp"

#include "base/random/random.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t least_side = 12;
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

/// A torus of corner colours, whose tiles are counted.
class ColoredTorus
{
public:
    ColoredTorus(const PoissonTileParameters& parameters, std::uint32_t iteration)
        : p_(parameters), side_(joint_side(parameters)), iteration_(iteration),
          stream_(stream_key(parameters.seed, Purpose::joint_tiling, 0)), colors_(std::size_t{side_} * side_),
          counts_(parameters.tiles)
    {
        for (std::uint32_t i = 0; i < colors_.size(); ++i) colors_[i] = random(i, 0, color_use)[0] % p_.colors;
        for (std::uint32_t y = 0; y < side_; ++y)
            for (std::uint32_t x = 0; x < side_; ++x) ++counts_[tile(x, y)];
    }

    void add_missing_tiles()
    {
        for (std::uint32_t missing = 0; missing < p_.tiles; ++missing)
            for (std::uint32_t attempt = 0; attempt < max_places && counts_[missing] == 0; ++attempt) {
                const auto words = random(missing, attempt, place_use);
                try_place(missing, words[0] % side_, words[1] % side_);
            }
    }

    std::vector<std::uint32_t> tiles() const
    {
        std::vector<std::uint32_t> all;
        for (std::uint32_t y = 0; y < side_; ++y)
            for (std::uint32_t x = 0; x < side_; ++x) all.push_back(tile(x, y));
        return all;
    }

private:
    std::array<std::uint32_t, 4> random(std::uint32_t a, std::uint32_t b, Use use) const
    {
        return philox({a, b, iteration_, use}, stream_);
    }

    std::uint32_t& color(std::uint32_t x, std::uint32_t y)
    {
        return colors_[std::size_t{y % side_} * side_ + x % side_];
    }
    std::uint32_t color(std::uint32_t x, std::uint32_t y) const
    {
        return colors_[std::size_t{y % side_} * side_ + x % side_];
    }

    std::uint32_t tile(std::uint32_t x, std::uint32_t y) const
    {
        return corner_tile_of({color(x, y), color(x + 1, y), color(x, y + 1), color(x + 1, y + 1)}, 2, p_.colors);
    }

    /// The nine tiles that have one of the four corners of the tile at a place.
    std::array<std::uint32_t, 9> tiles_around(std::uint32_t x, std::uint32_t y) const
    {
        std::array<std::uint32_t, 9> around{};
        for (std::uint32_t i = 0; i < 9; ++i) around[i] = tile(x + side_ - 1 + i % 3, y + side_ - 1 + i / 3);
        return around;
    }

    /// Puts a tile where it costs no other tile its last place.
    void try_place(std::uint32_t missing, std::uint32_t x, std::uint32_t y)
    {
        const auto wanted = corner_colors_of(missing, 2, p_.colors);
        const auto before = tiles_around(x, y);
        const std::array<std::uint32_t, 4> old{color(x, y), color(x + 1, y), color(x, y + 1), color(x + 1, y + 1)};
        for (std::uint32_t k = 0; k < 4; ++k) color(x + (k & 1), y + (k >> 1)) = wanted[k];
        for (const std::uint32_t t : before) --counts_[t];
        for (const std::uint32_t t : tiles_around(x, y)) ++counts_[t];
        if (std::ranges::none_of(before, [&](std::uint32_t t) { return counts_[t] == 0; })) return;
        for (const std::uint32_t t : tiles_around(x, y)) --counts_[t];
        for (std::uint32_t k = 0; k < 4; ++k) color(x + (k & 1), y + (k >> 1)) = old[k];
        for (const std::uint32_t t : before) ++counts_[t];
    }

    const PoissonTileParameters& p_;
    std::uint32_t side_, iteration_;
    StreamKey stream_;
    std::vector<std::uint32_t> colors_, counts_;
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
    return std::max(least_side,
                    static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(copies_of_a_tile) * p.tiles))));
}

std::vector<std::uint32_t> joint_tiling(const PoissonTileParameters& p, std::uint32_t iteration)
{
    if (p.kind == PoissonTileKind::frame) return shuffled_tiles(p, iteration);
    ColoredTorus torus(p, iteration);
    torus.add_missing_tiles();
    return torus.tiles();
}

StoredPoints::StoredPoints(const ChainPieces& pieces) : count_(pieces.colors)
{
    for (std::size_t direction = 0; direction < chain_directions; ++direction)
        for (const Chain& chain : pieces.chains[direction]) {
            chains_[direction].push_back(count_);
            count_ += chain.size();
        }
    for (const auto& interior : pieces.interiors) {
        interiors_.push_back(count_);
        count_ += interior.size();
    }
}

std::vector<WeightedPoint> StoredPoints::mean_tile(const ChainPieces& pieces, bool chains_move) const
{
    std::vector<WeightedPoint> points;
    for (const UnitPosition& corner : pieces.corners) points.push_back({corner, 1.0 / pieces.colors, false});
    for (const auto& direction : pieces.chains)
        for (const Chain& chain : direction)
            for (const UnitPosition& point : chain)
                points.push_back({point, 1.0 / static_cast<double>(direction.size()), chains_move});
    for (const auto& interior : pieces.interiors)
        for (const UnitPosition& point : interior)
            points.push_back({point, 1.0 / static_cast<double>(pieces.interiors.size()), true});
    return points;
}

JointTorus StoredPoints::torus(const ChainPieces& pieces, std::uint32_t side,
                               const std::vector<std::uint32_t>& tiles) const
{
    JointTorus result{side, {}};
    const auto size = static_cast<std::int32_t>(side) * tile_units;
    for (std::uint32_t place = 0; place < tiles.size(); ++place) {
        const std::array<std::int32_t, 2> at{static_cast<std::int32_t>(place % side),
                                             static_cast<std::int32_t>(place / side)};
        const auto add = [&](std::size_t stored, const UnitPosition& position) {
            const UnitPosition moved = moved_to(position, at);
            result.copies.push_back({static_cast<std::uint32_t>(stored),
                                     {(moved[0] % size + size) % size, (moved[1] % size + size) % size}});
        };
        const std::uint32_t tile = tiles[place];
        const auto chains = chains_around(tile, pieces.colors);
        add(corner(chains.front().lower), pieces.corners[chains.front().lower]);
        for (const PlacedChain& own : {chains.front(), chains.back()}) {
            const std::size_t number = own.number(pieces.colors);
            const Chain& points = pieces.chains[own.direction][number];
            for (std::size_t i = 0; i < points.size(); ++i) add(chain(own.direction, number) + i, points[i]);
        }
        for (std::size_t i = 0; i < pieces.interiors[tile].size(); ++i)
            add(interior(tile) + i, pieces.interiors[tile][i]);
    }
    return result;
}

}
