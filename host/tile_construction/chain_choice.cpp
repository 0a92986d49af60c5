#include "host/tile_construction/chain_choice.hpp"

#include "base/errors/errors.hpp"
#include "host/tile_construction/fill_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Tori that are filled for each two colours at once, and how often at most; one fifth of all edges have no path.
constexpr std::uint32_t tori_a_pair = 12;
constexpr std::uint32_t max_torus_rounds = 8;

/// Chains to choose from for each two colours and direction.
constexpr std::size_t wanted_candidates = 6;

}

std::size_t chain_tori(const PoissonTileParameters& p)
{
    return std::size_t{p.colors} * (p.colors + 1) / 2 * tori_a_pair;
}

ChainChoice::ChainChoice(const PoissonTileParameters& parameters, TileFiller& filler,
                         const ConstructionOptions& options, ConstructionReport& report)
    : p_(parameters), filler_(filler), options_(options), report_(report), finder_(parameters)
{
    for (std::size_t direction = 0; direction < chain_directions; ++direction) {
        candidates_[direction].resize(std::size_t{p_.colors} * p_.colors);
        taken_[direction].resize(candidates_[direction].size());
    }
}

void ChainChoice::choose(ChainPieces& pieces)
{
    for (std::uint32_t round = 0; round < max_torus_rounds && !are_enough(); ++round) {
        fill_tori(pieces, round);
        if (options_.progress) options_.progress("chains", round + 1, max_torus_rounds);
    }
    sort_by_balance();
    for (std::size_t direction = 0; direction < chain_directions; ++direction)
        for (std::size_t number = 0; number < candidates_[direction].size(); ++number) {
            if (candidates(direction, number).empty())
                throw invalid_value(
                    {}, "relative_radius", fmt::format("{}", p_.relative_radius),
                    fmt::format("no chain from colour {} to {} was found in {} tori of "
                                "{} points; must be about 0.6 to 0.85 for chains, and more points per tile help",
                                number / p_.colors, number % p_.colors, max_torus_rounds * tori_a_pair,
                                4 * p_.points_per_tile));
            pieces.chains[direction][number] = candidates(direction, number).front().chain;
        }
}

bool ChainChoice::replace(ChainPieces& pieces, std::size_t direction, std::size_t number)
{
    std::size_t& taken = taken_[direction][number];
    if (taken + 1 >= candidates(direction, number).size()) return false;
    pieces.chains[direction][number] = candidates(direction, number)[++taken].chain;
    return true;
}

/// Corner points stand in checkerboard, so that each torus shows all eight edges between two colours.
void ChainChoice::fill_tori(const ChainPieces& pieces, std::uint32_t round)
{
    FillStage stage{.regions = regions_of(p_), .number = chain_stage};
    stage.active.cells = all_cells(2);
    std::vector<FillProblem> problems;
    std::vector<std::array<std::uint32_t, 2>> colors;
    for (std::uint32_t a = 0; a < p_.colors; ++a)
        for (std::uint32_t b = a; b < p_.colors; ++b)
            for (std::uint32_t torus = 0; torus < tori_a_pair; ++torus) {
                FillProblem problem;
                for (std::int32_t y = 0; y < 2; ++y)
                    for (std::int32_t x = 0; x < 2; ++x) {
                        const UnitPosition corner = moved_to(pieces.corners[(x + y) % 2 == 0 ? a : b], {x, y});
                        problem.held.push_back({wrapped(corner[0]), wrapped(corner[1]), 0});
                    }
                problem.active = 4 * p_.points_per_tile - 4;
                problem.stream = static_cast<std::uint32_t>(problems.size());
                problems.push_back(std::move(problem));
                colors.push_back({a, b});
            }
    const std::vector<FilledTorus> filled = filler_.fill(stage, problems, round);
    report_.tori += filled.size();
    const auto wanted = asked_squared_distance(p_);
    for (std::size_t i = 0; i < filled.size(); ++i) {
        if (filled[i].squared_min_distance >= wanted)
            collect(pieces, colors[i][0], colors[i][1], filled[i]);
        else
            ++report_.failures;
    }
}

void ChainChoice::collect(const ChainPieces& pieces, std::uint32_t a, std::uint32_t b, const FilledTorus& torus)
{
    std::vector<TilePosition> points;
    for (const TilePosition& point : torus.active)
        points.push_back({wrapped(storable(point[0])), wrapped(storable(point[1])), 0});
    for (std::size_t direction = 0; direction < chain_directions; ++direction)
        for (std::int32_t y = 0; y < 2; ++y)
            for (std::int32_t x = 0; x < 2; ++x) {
                const bool starts_at_a = (x + y) % 2 == 0;
                const PlacedChain edge{direction, starts_at_a ? a : b, starts_at_a ? b : a, {x, y}};
                if (auto found = finder_.find(pieces, edge, points))
                    candidates(direction, edge.number(p_.colors)).push_back(std::move(*found));
            }
}

bool ChainChoice::are_enough() const
{
    return std::ranges::all_of(candidates_, [](const auto& direction) {
        return std::ranges::all_of(direction, [](const auto& each) { return each.size() >= wanted_candidates; });
    });
}

/// Candidates whose balance is nearest to the mean of their direction come first.
void ChainChoice::sort_by_balance()
{
    for (auto& direction : candidates_) {
        double sum = 0;
        std::size_t count = 0;
        for (const auto& each : direction)
            for (const ChainCandidate& candidate : each) {
                sum += candidate.balance;
                ++count;
            }
        const double mean = count == 0 ? 0 : sum / static_cast<double>(count);
        for (auto& each : direction)
            std::ranges::stable_sort(each, {}, [&](const ChainCandidate& c) { return std::abs(c.balance - mean); });
    }
}

}
