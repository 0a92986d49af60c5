#include "host/tile_construction/chain_construction.hpp"

#include "base/errors/errors.hpp"
#include "host/tile_construction/chain_choice.hpp"
#include "host/tile_construction/chain_filling.hpp"
#include "host/tile_construction/chain_relaxation.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/moments/equal_moments.hpp"
#include "tiles/poisson/chain_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// Steps of moving chains towards even shares before tiles are filled: afterwards they move with what is inside.
constexpr std::uint32_t evening_steps = 100;

/// Other chains are tried where two tiles, or one in so many, cannot have equal moments: among more, each new chain
/// brings new tiles that cannot.
constexpr std::size_t tiles_a_failure = 50;

/// Settings that ask for a little more than the minimum distance, which rounding then takes.
FillSettings settings_with_margin(PoissonTileParameters p)
{
    p.repulsion = true;
    const double distance = asked_min_distance(p) * tile_units;
    p.relative_radius *= (distance + chain_rounding + moment_margin(p)) / distance;
    return fill_settings(p);
}

class ChainConstruction
{
public:
    ChainConstruction(const PoissonTileParameters& parameters, const ChainEngines& engines,
                      const ConstructionOptions& options)
        : p_(parameters), engines_(engines), options_(options), pieces_(p_.colors, p_.tiles), saved_(pieces_),
          choice_(p_, engines.tori, options_, report_), filler_(pieces_, p_, engines.interiors, options_, report_)
    {}

    ConstructedTileSet run()
    {
        pieces_.corners = spread_corners(p_);
        choice_.choose(pieces_);
        for (std::uint32_t i = 0; i < evening_steps && p_.equal_moments > 0; ++i) even_out_chains(pieces_, p_);
        fill_all_tiles();
        relax_tiles();
        return {tile_set_of(pieces_, p_), report_};
    }

private:
    using Tiles = ChainFiller::Tiles;
    using Replaced = std::set<std::array<std::size_t, 2>>; ///< direction, number

    // Filling.

    void fill_all_tiles()
    {
        Tiles open(p_.tiles);
        std::iota(open.begin(), open.end(), 0u);
        for (std::uint32_t round = 0; !open.empty(); ++round) {
            const Tiles failed = filler_.fill_anew(open, inside_stage, round);
            if (failed.empty()) return;
            if (round + 1 == max_rounds) give_up(failed);
            const Replaced replaced = replace_chains(failed, round);
            if (replaced.empty()) give_up(failed);
            open = tiles_with(replaced);
        }
    }

    /// Gives failed tiles another chain each, and returns these; none where a tile has no other.
    Replaced replace_chains(const Tiles& failed, std::uint32_t round)
    {
        Replaced replaced;
        for (const std::uint32_t tile : failed) {
            const auto chains = chains_around(tile, p_.colors);
            bool has_new = std::ranges::any_of(chains, [&](const PlacedChain& c) { return replaced.contains(key(c)); });
            for (std::uint32_t k = 0; k < chains.size() && !has_new; ++k) {
                const PlacedChain& chain = chains[(tile + round + k) % chains.size()];
                has_new = choice_.replace(pieces_, chain.direction, chain.number(p_.colors));
                if (has_new) replaced.insert(key(chain));
            }
            if (!has_new) return {};
        }
        report_.remade += replaced.size();
        return replaced;
    }

    std::array<std::size_t, 2> key(const PlacedChain& chain) const
    {
        return {chain.direction, chain.number(p_.colors)};
    }

    Tiles tiles_with(const Replaced& replaced) const
    {
        Tiles tiles;
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
            if (std::ranges::any_of(chains_around(tile, p_.colors),
                                    [&](const PlacedChain& chain) { return replaced.contains(key(chain)); }))
                tiles.push_back(tile);
        return tiles;
    }

    [[noreturn]] void give_up(const Tiles& failed) const
    {
        throw invalid_value(
            {}, "relative_radius", fmt::format("{}", p_.relative_radius),
            fmt::format("{} of {} tiles could not be filled; a smaller number helps, or more points per tile",
                        failed.size(), p_.tiles));
    }

    // Relaxation of all tiles together.

    void relax_tiles()
    {
        const std::uint32_t last = std::min(p_.joint_iterations, last_joint_iterations);
        const std::uint32_t first = p_.joint_iterations - last;
        saved_ = pieces_;
        for (std::uint32_t iteration = 0; iteration < first; ++iteration) iterate(iteration, true);
        if (first > 0) mend_tiles(all_tiles());
        for (std::uint32_t iteration = first; iteration < p_.joint_iterations; ++iteration) {
            const auto before = pieces_.interiors;
            iterate(iteration, false);
            for (const std::uint32_t tile : filler_.repel(all_tiles())) pieces_.interiors[tile] = before[tile];
        }
        if (p_.equal_moments > 0) equalize_moments();
    }

    // Moments.

    void equalize_moments()
    {
        const EvenableTiles tiles{
            [&] { return tile_set_of(pieces_, p_); },
            [&](const MomentTargets& targets, const Tiles& open) { return filler_.repel(open, &targets); },
            [&](const MomentTargets& targets, const Tiles& open, std::uint32_t round) {
                return filler_.fill_anew(open, moment_stage, round, &targets);
            },
            [&](const MomentTargets& targets, std::uint32_t tile) { return make_exact(targets, tile); },
            [&](const Tiles& failed) { return give_way(failed); },
            moment_rounds,
            pieces_.interiors,
            [&] { even_insides(pieces_, p_, engines_.joint); }};
        make_moments_equal(p_, tiles, [&](std::size_t done, std::size_t total) {
            if (options_.progress) options_.progress("equal moments", done, total);
        });
    }

    bool make_exact(const MomentTargets& targets, std::uint32_t tile)
    {
        const auto border = border_polygon(pieces_, tile);
        return targets.make_exact(pieces_.interiors[tile], own_border_points(pieces_, p_, tile)) &&
               std::ranges::all_of(pieces_.interiors[tile],
                                   [&](const UnitPosition& point) { return is_strictly_inside(border, point); });
    }

    void iterate(std::uint32_t iteration, bool chains_move)
    {
        relax_together(pieces_, p_, engines_.joint, iteration, chains_move);
        if (options_.progress) options_.progress("joint iterations", iteration + 1, p_.joint_iterations);
    }

    Tiles all_tiles() const
    {
        Tiles all(p_.tiles);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }

    /// Brings back the minimum distance. Tiles that can neither be pushed apart nor filled anew get the chains back
    /// that they were filled with before: at the latest when all chains are back, all tiles are good.
    void mend_tiles(Tiles open)
    {
        for (std::uint32_t round = 0; !open.empty(); ++round) {
            const Tiles failed = filler_.fill_anew(filler_.repel(open), repair_stage, round);
            if (failed.empty()) return;
            open = with_chains_back(failed);
        }
    }

    /// Gives tiles the chains back that they were filled with before. Returns the tiles that have these and others.
    Tiles with_chains_back(const Tiles& failed)
    {
        report_.remade += failed.size();
        for (const std::uint32_t tile : failed)
            for (const PlacedChain& chain : chains_around(tile, p_.colors)) back_.insert(key(chain));
        for (const auto& [direction, number] : back_)
            pieces_.chains[direction][number] = saved_.chains[direction][number];
        Tiles open = tiles_with(back_);
        std::erase_if(open, [&](std::uint32_t tile) {
            const bool is_as_before = std::ranges::all_of(
                chains_around(tile, p_.colors), [&](const PlacedChain& chain) { return back_.contains(key(chain)); });
            if (is_as_before) pieces_.interiors[tile] = saved_.interiors[tile];
            return is_as_before;
        });
        return open;
    }

    /// Gives tiles that cannot have equal moments other chains, and where there are no more, those that they had before
    /// joint relaxation. False: they have these already, or that made more tiles fail.
    bool give_way(const Tiles& failed)
    {
        if (failed.size() > 2 * std::exchange(failed_before_, failed.size())) return false;
        const bool are_few = failed.size() <= std::max<std::size_t>(2, p_.tiles / tiles_a_failure);
        if (are_few && moment_replacements_ < max_rounds && fill_with_even_chains(failed, moment_replacements_++))
            return true;
        const std::size_t before = back_.size();
        const Tiles open = with_chains_back(failed);
        if (back_.size() == before) return false;
        mend_tiles(open);
        return true;
    }

    /// Gives failed tiles other chains, whose shares are evened out towards those of all others. All stays as it is
    /// where tiles cannot be filled with them. False: there are no others.
    bool fill_with_even_chains(const Tiles& failed, std::uint32_t round)
    {
        const ChainPieces before = pieces_;
        const Replaced replaced = replace_chains(failed, round);
        if (replaced.empty()) {
            pieces_ = before; // some tiles may have had another chain
            return false;
        }
        ChainPieces even = pieces_;
        for (std::uint32_t i = 0; i < evening_steps; ++i) even_out_chains(even, p_);
        for (const auto& [direction, number] : replaced)
            pieces_.chains[direction][number] = even.chains[direction][number];
        if (!filler_.fill_anew(filler_.repel(tiles_with(replaced)), repair_stage, max_rounds + round).empty())
            pieces_ = before;
        return true;
    }

    const PoissonTileParameters p_;
    const ChainEngines& engines_;
    const ConstructionOptions& options_;
    ConstructionReport report_;
    ChainPieces pieces_;
    ChainPieces saved_;                                                     ///< as they were before joint relaxation
    Replaced back_;                                                         ///< chains that are as they were then
    std::size_t failed_before_ = std::numeric_limits<std::uint32_t>::max(); ///< tiles without equal moments
    std::uint32_t moment_replacements_ = 0; ///< rounds of giving tiles other chains so that moments can be equal
    ChainChoice choice_;
    ChainFiller filler_;
};

}

FillSettings chain_torus_settings(const PoissonTileParameters& parameters) { return settings_with_margin(parameters); }

FillSettings chain_interior_settings(const PoissonTileParameters& parameters)
{
    PoissonTileParameters p = parameters;
    p.lloyd_iterations = 0;
    return settings_with_margin(p);
}

ConstructedTileSet construct_chain_tiles(const PoissonTileParameters& parameters, const ChainEngines& engines,
                                         const ConstructionOptions& options)
{
    return ChainConstruction(parameters, engines, options).run();
}

}
