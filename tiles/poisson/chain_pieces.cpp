#include "tiles/poisson/chain_pieces.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr std::uint32_t no_tile = UINT32_MAX;

/// Corners of corner_colors_of().
constexpr std::size_t lower_left = 0, lower_right = 1, upper_left = 2, upper_right = 3;

constexpr std::array direction_names{"lower", "left"};

/// Reads the pieces of a set, each from the first tile that has it, and compares what other tiles have.
class PieceReader
{
public:
    explicit PieceReader(const PoissonTileSet& set)
        : set_(set), p_(set.parameters), pieces_(p_.colors, p_.tiles), corner_seen_(p_.colors, no_tile)
    {
        for (auto& seen : chain_seen_) seen.assign(std::size_t{p_.colors} * p_.colors, no_tile);
    }

    ChainPieces read()
    {
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile) read_tile(tile);
        return std::move(pieces_);
    }

private:
    void read_tile(std::uint32_t tile)
    {
        const std::uint32_t corner = corner_colors_of(tile, 2, p_.colors)[lower_left];
        const auto chains = chains_around(tile, p_.colors);
        const std::uint32_t right = length_of(chains.front()), up = length_of(chains.back());
        if (std::uint64_t{1} + right + up > p_.points_per_tile)
            throw InputError(fmt::format("tile {}: chains of {} and {} points: must leave one of {} for its corner",
                                         tile, right, up, p_.points_per_tile));
        compare(pieces_.corners[corner], set_.position(tile, 0), corner_seen_[corner], tile,
                [] { return std::string("corner point"); });
        read_chain(chains.front(), tile, 1, right);
        read_chain(chains.back(), tile, 1 + right, up);
        for (std::uint32_t i = 1 + right + up; i < p_.points_per_tile; ++i)
            pieces_.interiors[tile].push_back(set_.position(tile, i));
    }

    std::uint32_t length_of(const PlacedChain& chain) const
    {
        const std::size_t all = std::size_t{p_.colors} * p_.colors;
        return set_.chain_lengths[chain.direction * all + chain.number(p_.colors)];
    }

    void read_chain(const PlacedChain& placed, std::uint32_t tile, std::uint32_t first, std::uint32_t length)
    {
        Chain chain;
        for (std::uint32_t i = first; i < first + length; ++i) chain.push_back(set_.position(tile, i));
        const std::size_t number = placed.number(p_.colors);
        compare(pieces_.chains[placed.direction][number], chain, chain_seen_[placed.direction][number], tile,
                [&] { return fmt::format("{} chain", direction_names[placed.direction]); });
    }

    template <class Piece, class Name>
    void compare(Piece& known, const Piece& piece, std::uint32_t& seen, std::uint32_t tile, Name name)
    {
        if (seen == no_tile) {
            known = piece;
            seen = tile;
        } else if (known != piece) {
            throw InputError(fmt::format("tile {}: its {} differs from tile {}'s: must be the same in all tiles that "
                                         "have it",
                                         tile, name(), seen));
        }
    }

    const PoissonTileSet& set_;
    const PoissonTileParameters& p_;
    ChainPieces pieces_;
    std::vector<std::uint32_t> corner_seen_; ///< the first tile that has it
    std::array<std::vector<std::uint32_t>, chain_directions> chain_seen_;
};

}

ChainPieces::ChainPieces(std::uint32_t c, std::uint32_t tiles) : colors(c), corners(c), interiors(tiles)
{
    for (auto& direction : chains) direction.resize(std::size_t{c} * c);
}

std::array<PlacedChain, 4> chains_around(std::uint32_t tile, std::uint32_t colors)
{
    const auto corner = corner_colors_of(tile, 2, colors);
    return {{{0, corner[lower_left], corner[lower_right], {0, 0}},
             {1, corner[lower_right], corner[upper_right], {1, 0}},
             {0, corner[upper_left], corner[upper_right], {0, 1}},
             {1, corner[lower_left], corner[upper_left], {0, 0}}}};
}

UnitPosition moved_to(const UnitPosition& position, const std::array<std::int32_t, 2>& base)
{
    return {position[0] + base[0] * tile_units, position[1] + base[1] * tile_units, 0};
}

std::array<UnitPosition, 2> chain_ends(const ChainPieces& pieces, const PlacedChain& chain)
{
    std::array<std::int32_t, 2> far = chain.base;
    ++far[chain.direction];
    return {moved_to(pieces.corners[chain.lower], chain.base), moved_to(pieces.corners[chain.upper], far)};
}

std::vector<UnitPosition> border_polygon(const ChainPieces& pieces, std::uint32_t tile)
{
    std::vector<UnitPosition> polygon;
    const auto chains = chains_around(tile, pieces.colors);
    for (std::size_t side = 0; side < 4; ++side) {
        const PlacedChain& placed = chains[side];
        const Chain& chain = pieces.chains[placed.direction][placed.number(pieces.colors)];
        const bool is_backward = side >= 2; // from its upper end
        polygon.push_back(chain_ends(pieces, placed)[is_backward]);
        const auto first = static_cast<std::ptrdiff_t>(polygon.size());
        for (const UnitPosition& point : chain) polygon.push_back(moved_to(point, placed.base));
        if (is_backward) std::reverse(polygon.begin() + first, polygon.end());
    }
    return polygon;
}

std::int64_t interior_size(const ChainPieces& pieces, std::uint32_t tile, std::uint32_t points_per_tile)
{
    const auto chains = chains_around(tile, pieces.colors);
    std::int64_t size = std::int64_t{points_per_tile} - 1;
    for (const PlacedChain& own : {chains.front(), chains.back()})
        size -= static_cast<std::int64_t>(pieces.chains[own.direction][own.number(pieces.colors)].size());
    return size;
}

ChainPieces chain_pieces_of(const PoissonTileSet& set) { return PieceReader(set).read(); }

PoissonTileSet tile_set_of(const ChainPieces& pieces, const PoissonTileParameters& parameters)
{
    PoissonTileSet set{parameters, 0, {}};
    const StoredScale scale = stored_scale(parameters.border);
    const auto add = [&](const UnitPosition& position) {
        for (std::size_t k = 0; k < 2; ++k)
            set.points.push_back(static_cast<std::uint16_t>((position[k] - scale.low) / scale.step));
    };
    for (std::uint32_t tile = 0; tile < parameters.tiles; ++tile) {
        add(pieces.corners[corner_colors_of(tile, 2, pieces.colors)[lower_left]]);
        const auto chains = chains_around(tile, pieces.colors);
        for (const PlacedChain& own : {chains.front(), chains.back()})
            for (const UnitPosition& point : pieces.chains[own.direction][own.number(pieces.colors)]) add(point);
        for (const UnitPosition& point : pieces.interiors[tile]) add(point);
    }
    for (const auto& direction : pieces.chains)
        for (const Chain& chain : direction) set.chain_lengths.push_back(static_cast<std::uint16_t>(chain.size()));
    return set;
}

}
