#include "host/tile_construction/chain_relaxation.hpp"

#include "host/tile_construction/chain_paths.hpp"
#include "host/tile_construction/chains/chain_mending.hpp"
#include "host/tile_construction/joint/stored_points.hpp"
#include "tiles/poisson/chain_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// An iteration shifts a chain by this part of what its balance lacks.
constexpr double shift_gain = 0.6;

PlacedChain chain_at_origin(std::size_t direction, std::size_t number, std::uint32_t colors)
{
    return {
        direction, static_cast<std::uint32_t>(number / colors), static_cast<std::uint32_t>(number % colors), {0, 0}};
}

/// All chains of a direction, by number.
std::vector<LooseChain> loose_chains(const ChainPieces& pieces, std::size_t direction)
{
    std::vector<LooseChain> loose;
    for (std::size_t number = 0; number < pieces.chains[direction].size(); ++number) {
        loose.push_back({direction, chain_ends(pieces, chain_at_origin(direction, number, pieces.colors)), {}});
        for (const UnitPosition& point : pieces.chains[direction][number])
            loose.back().points.push_back({static_cast<double>(point[0]), static_cast<double>(point[1])});
    }
    return loose;
}

/// Replaces chains by what they are after mending; those that cannot be mended stay as they are.
void take_mended(ChainPieces& pieces, const std::vector<LooseChain>& chains, const PoissonTileParameters& p)
{
    const auto squared_distance = static_cast<std::int64_t>(asked_squared_distance(p));
    for (std::size_t number = 0; number < chains.size(); ++number)
        if (auto sound = mended(chains[number], squared_distance))
            pieces.chains[chains[number].direction][number] = std::move(*sound);
}

class ChainRelaxation
{
public:
    ChainRelaxation(ChainPieces& pieces, const PoissonTileParameters& parameters)
        : p_(parameters), pieces_(pieces), before_(pieces)
    {}

    void run(JointEngine& engine, std::uint32_t iteration, bool chains_move)
    {
        store_points(chains_move);
        displacements_ = joint_displacements(
            engine, stored_, [this](std::uint32_t tile) { return own_pieces(tile); },
            [this](std::uint32_t tile) { return own_points(tile); }, p_, iteration);
        move_interiors();
        if (chains_move) move_chains();
        while (put_back_where_outside()) {
        }
    }

    void even_insides(JointEngine& engine)
    {
        store_points(false);
        displacements_ = evening_displacements(
            engine, stored_, [this](std::uint32_t tile) { return own_points(tile); }, p_);
        move_interiors();
        put_back_where_outside();
    }

private:
    /// Corner points by colour, chains by direction and number, the insides of tiles. Corner points are always held.
    void store_points(bool chains_move)
    {
        for (const UnitPosition& corner : pieces_.corners) stored_.add({&corner, 1}, 1.0 / pieces_.colors, false);
        for (std::size_t direction = 0; direction < chain_directions; ++direction) {
            const std::vector<Chain>& chains = pieces_.chains[direction];
            for (const Chain& chain : chains)
                chains_[direction].push_back(stored_.add(chain, 1.0 / static_cast<double>(chains.size()), chains_move));
        }
        for (const auto& interior : pieces_.interiors)
            interiors_.push_back(stored_.add(interior, 1.0 / static_cast<double>(pieces_.interiors.size()), true));
    }

    std::vector<std::size_t> own_pieces(std::uint32_t tile) const
    {
        const auto around = chains_around(tile, pieces_.colors);
        std::vector<std::size_t> own{around.front().lower};
        for (const PlacedChain& chain : {around.front(), around.back()})
            own.push_back(chains_[chain.direction][chain.number(pieces_.colors)]);
        own.push_back(interiors_[tile]);
        return own;
    }

    std::vector<OwnPoint> own_points(std::uint32_t tile) const
    {
        std::vector<OwnPoint> own;
        for (const std::size_t piece : own_pieces(tile))
            for (std::size_t i = stored_.first(piece); i < stored_.end(piece); ++i)
                own.push_back({static_cast<std::uint32_t>(i), {}});
        return own;
    }

    void move_interiors()
    {
        for (std::uint32_t tile = 0; tile < pieces_.interiors.size(); ++tile)
            for (std::size_t i = 0; i < pieces_.interiors[tile].size(); ++i)
                for (std::size_t k = 0; k < 2; ++k)
                    pieces_.interiors[tile][i][k] += static_cast<std::int32_t>(
                        std::nearbyint(displacements_[stored_.first(interiors_[tile]) + i][k]));
    }

    void move_chains()
    {
        for (std::size_t direction = 0; direction < chain_directions; ++direction) {
            std::vector<LooseChain> loose = loose_chains(pieces_, direction);
            for (std::size_t number = 0; number < loose.size(); ++number)
                for (std::size_t i = 0; i < loose[number].points.size(); ++i)
                    for (std::size_t k = 0; k < 2; ++k)
                        loose[number].points[i][k] += displacements_[stored_.first(chains_[direction][number]) + i][k];
            if (p_.equal_moments > 0)
                even_out(loose, p_, longest_joint_move(p_));
            else
                shift(loose, direction);
            take_mended(pieces_, loose, p_);
        }
    }

    void shift(std::vector<LooseChain>& chains, std::size_t direction) const
    {
        const std::vector<double> shifts = shifts_of(direction);
        for (std::size_t number = 0; number < chains.size(); ++number)
            for (auto& point : chains[number].points) point[1 - direction] += shifts[number];
    }

    /// The way of each chain sideways, towards the mean balance; units.
    std::vector<double> shifts_of(std::size_t direction) const
    {
        std::vector<double> balances;
        double sum = 0;
        for (std::size_t number = 0; number < before_.chains[direction].size(); ++number) {
            const PlacedChain chain = chain_at_origin(direction, number, p_.colors);
            balances.push_back(chain_balance(before_, direction, chain.lower, chain.upper, p_.points_per_tile));
            sum += balances.back();
        }
        const double mean = sum / static_cast<double>(balances.size());
        const double longest = longest_joint_move(p_);
        std::vector<double> shifts;
        for (const double balance : balances)
            shifts.push_back(
                std::clamp(-shift_gain * (balance - mean) / p_.points_per_tile * tile_units, -longest, longest));
        return shifts;
    }

    /// Points that are outside of their border go back, and where that does not help the border as well. Returns
    /// whether a border went back, which is that of other tiles, too.
    bool put_back_where_outside()
    {
        bool has_changed = false;
        for (std::uint32_t tile = 0; tile < pieces_.interiors.size(); ++tile) {
            const std::vector<UnitPosition> border = border_polygon(pieces_, tile);
            auto& interior = pieces_.interiors[tile];
            bool fits = true;
            for (std::size_t i = 0; i < interior.size() && fits; ++i) {
                if (is_strictly_inside(border, interior[i])) continue;
                interior[i] = before_.interiors[tile][i];
                fits = is_strictly_inside(border, interior[i]);
            }
            if (fits) continue;
            interior = before_.interiors[tile];
            for (const PlacedChain& chain : chains_around(tile, pieces_.colors)) {
                const std::size_t number = chain.number(pieces_.colors);
                pieces_.chains[chain.direction][number] = before_.chains[chain.direction][number];
            }
            has_changed = true;
        }
        return has_changed;
    }

    const PoissonTileParameters& p_;
    ChainPieces& pieces_;
    const ChainPieces before_;
    StoredPoints stored_;
    std::array<std::vector<std::size_t>, chain_directions> chains_; ///< their numbers as stored pieces
    std::vector<std::size_t> interiors_;
    std::vector<Displacement> displacements_;
};

}

void even_out_chains(ChainPieces& pieces, const PoissonTileParameters& parameters)
{
    for (std::size_t direction = 0; direction < chain_directions; ++direction) {
        std::vector<LooseChain> loose = loose_chains(pieces, direction);
        even_out(loose, parameters, longest_joint_move(parameters));
        take_mended(pieces, loose, parameters);
    }
}

void relax_together(ChainPieces& pieces, const PoissonTileParameters& parameters, JointEngine& engine,
                    std::uint32_t iteration, bool chains_move)
{
    ChainRelaxation(pieces, parameters).run(engine, iteration, chains_move);
}

void even_insides(ChainPieces& pieces, const PoissonTileParameters& parameters, JointEngine& engine)
{
    ChainRelaxation(pieces, parameters).even_insides(engine);
}

}
