#include "host/tile_construction/chain_relaxation.hpp"

#include "host/tile_construction/chain_mending.hpp"
#include "host/tile_construction/chain_paths.hpp"
#include "host/tile_construction/joint_tiling.hpp"
#include "tiles/poisson/chain_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// An iteration shifts a chain by this part of what its balance lacks; neither this nor nulling moves a point farther
/// than the longest move, in spacings.
constexpr double shift_gain = 0.6;
constexpr double longest_move = 0.05;

class ChainRelaxation
{
public:
    ChainRelaxation(ChainPieces& pieces, const PoissonTileParameters& parameters)
        : p_(parameters), pieces_(pieces), before_(pieces), stored_(pieces),
          longest_(longest_move * tile_units / std::sqrt(parameters.points_per_tile))
    {}

    void run(JointEngine& engine, std::uint32_t iteration, bool chains_move)
    {
        find_displacements(engine, iteration, chains_move);
        move_interiors();
        if (chains_move) move_chains();
        while (put_back_where_outside()) {
        }
    }

private:
    void find_displacements(JointEngine& engine, std::uint32_t iteration, bool chains_move)
    {
        const JointTorus torus = stored_.torus(pieces_, joint_side(p_), joint_tiling(p_, iteration));
        displacements_ = engine.mean_displacements(torus, stored_.count());
        if (!p_.null_peaks) return;
        const auto nulling =
            engine.nulling_displacements(stored_.mean_tile(pieces_, chains_move), p_.points_per_tile, longest_);
        for (std::size_t i = 0; i < displacements_.size(); ++i)
            for (std::size_t k = 0; k < 2; ++k) displacements_[i][k] += nulling[i][k];
    }

    void move_interiors()
    {
        for (std::uint32_t tile = 0; tile < pieces_.interiors.size(); ++tile)
            for (std::size_t i = 0; i < pieces_.interiors[tile].size(); ++i)
                for (std::size_t k = 0; k < 2; ++k)
                    pieces_.interiors[tile][i][k] +=
                        static_cast<std::int32_t>(std::nearbyint(displacements_[stored_.interior(tile) + i][k]));
    }

    void move_chains()
    {
        const auto squared_distance = static_cast<std::int64_t>(asked_squared_distance(p_));
        for (std::size_t direction = 0; direction < chain_directions; ++direction) {
            const std::vector<double> shifts = shifts_of(direction);
            for (std::size_t number = 0; number < shifts.size(); ++number) {
                Chain& chain = pieces_.chains[direction][number];
                LooseChain loose{direction, chain_ends(before_, placed(direction, number)), {}};
                for (std::size_t i = 0; i < chain.size(); ++i) {
                    const Displacement& by = displacements_[stored_.chain(direction, number) + i];
                    loose.points.push_back({chain[i][0] + by[0], chain[i][1] + by[1]});
                    loose.points.back()[1 - direction] += shifts[number];
                }
                if (auto sound = mended(loose, squared_distance)) chain = std::move(*sound);
            }
        }
    }

    PlacedChain placed(std::size_t direction, std::size_t number) const
    {
        return {direction,
                static_cast<std::uint32_t>(number / pieces_.colors),
                static_cast<std::uint32_t>(number % pieces_.colors),
                {0, 0}};
    }

    /// How far each chain goes sideways, towards the mean balance; units.
    std::vector<double> shifts_of(std::size_t direction) const
    {
        std::vector<double> balances;
        double sum = 0;
        for (std::size_t number = 0; number < before_.chains[direction].size(); ++number) {
            const PlacedChain chain = placed(direction, number);
            balances.push_back(chain_balance(before_, direction, chain.lower, chain.upper, p_.points_per_tile));
            sum += balances.back();
        }
        const double mean = sum / static_cast<double>(balances.size());
        std::vector<double> shifts;
        for (const double balance : balances)
            shifts.push_back(
                std::clamp(-shift_gain * (balance - mean) / p_.points_per_tile * tile_units, -longest_, longest_));
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
    const StoredPoints stored_;
    double longest_; ///< units
    std::vector<Displacement> displacements_;
};

}

void relax_together(ChainPieces& pieces, const PoissonTileParameters& parameters, JointEngine& engine,
                    std::uint32_t iteration, bool chains_move)
{
    ChainRelaxation(pieces, parameters).run(engine, iteration, chains_move);
}

}
