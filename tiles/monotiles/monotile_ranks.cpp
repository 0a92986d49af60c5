#include "tiles/monotiles/monotile_ranks.hpp"

#include "tiles/polyominoes/pair_relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// Pairs of tiles up to this distance, in units of lengths before they are divided, keep their parts' points apart:
/// those that touch, and some more.
constexpr double least_reach = 9;

/// Two undivided tiles of a tiling: the second one's parts as seen from the first one's.
struct DividedPair
{
    std::uint32_t first = 0;
    double weight = 0; ///< the mean number of such tiles around one of the first tile's state
    Orientation turn{};
    PairVector at;
};

/// Returns for each state of the table the one that it refines of the states without ancestors.
std::vector<std::uint32_t> states_without_ancestors(const PolygonTiling& tiling, std::uint32_t levels)
{
    std::vector<std::uint32_t> plain(monotile_states(tiling, 0).parts.size());
    for (std::uint32_t i = 0; i < plain.size(); ++i) plain[i] = i;
    for (std::uint32_t level = 0; level < levels; ++level) {
        std::vector<std::uint32_t> next;
        for (const auto& parts : monotile_states(tiling, level).parts)
            for (const StatePart& part : parts) next.push_back(plain[part.state]);
        plain = std::move(next);
    }
    return plain;
}

class Ranking
{
public:
    /// The table has states without ancestors.
    explicit Ranking(const MonotileTable& table) : table_(table), states_(table.states)
    {
        const std::size_t count = states_.parts.size();
        points_.resize(count);
        ranks_.resize(count);
        energies_.resize(count);
        by_second_.resize(count);
        for (std::size_t state = 0; state < count; ++state) {
            for (const StatePart& part : states_.parts[state])
                for (std::uint32_t i = 0; i < table.points; ++i) points_[state].push_back(place_of(part, i));
            ranks_[state].assign(points_[state].size(), unranked);
            energies_[state].resize(points_[state].size());
        }
        list_pairs();
        for (std::uint32_t state = 0; state < count; ++state) push_from_copies(state);
        for (std::uint32_t state = 0; state < count; ++state) by_second_[state].push_back({state, 1, {1, 0, 0, 1}, {}});
    }

    /// Returns [state][number of the part * points + point].
    std::vector<std::vector<std::uint16_t>> run()
    {
        std::vector<std::array<double, 2>> turns; // the part of its points that a state has by then, and the state
        for (std::size_t state = 0; state < points_.size(); ++state)
            for (std::size_t k = 0; k < points_[state].size(); ++k)
                turns.push_back({(static_cast<double>(k) + 0.5) / static_cast<double>(points_[state].size()),
                                 static_cast<double>(state)});
        std::ranges::sort(turns);
        std::vector<std::uint16_t> taken(points_.size());
        for (const auto& turn : turns) {
            const auto state = static_cast<std::size_t>(turn[1]);
            const std::size_t next = lowest(state);
            ranks_[state][next] = taken[state]++;
            push_away(state, points_[state][next]);
        }
        return ranks_;
    }

private:
    static constexpr std::uint16_t unranked = std::numeric_limits<std::uint16_t>::max();

    PairVector place_of(const StatePart& part, std::uint32_t index) const
    {
        const PolygonTiling& tiling = *states_.tiling;
        const MonotilePlace& p = table_.places[part.state * table_.points + index];
        const TileMotion& own = states_.own[states_.prototiles[part.state]];
        const RingPlace turn = tiling.ring.unit(2 * part.frame.turn);
        const RingPlace in_frame = tiling.ring.times(turn, moved(tiling.ring, own, {{p.x, 0, 0, p.y}}));
        const auto [x, y] = point_of(tiling, in_frame);
        const auto [at_x, at_y] = point_of(tiling, part.frame.at);
        return {at_x + x / place_units, at_y + y / place_units};
    }

    void list_pairs()
    {
        const PolygonTiling& tiling = *states_.tiling;
        const StatePairs near = pairs_within(states_, least_reach);
        const std::vector<double> shares = frequencies_of(states_);
        for (std::size_t i = 0; i < near.pairs.size(); ++i) {
            const auto& [first, second] = near.pairs[i];
            const TileFrame frame = frame_of_part(states_, second.frame, {});
            const auto [c, s] = tiling.ring.value(tiling.ring.unit(2 * frame.turn));
            const auto [x, y] = point_of(tiling, frame.at);
            by_second_[second.state].push_back({first, near.frequencies[i] / shares[first], {c, -s, s, c}, {x, y}});
        }
    }

    /// A point is taken in all tiles of its state at once: it keeps away from its copies in tiles that are near. Three
    /// of them may lie around a corner.
    void push_from_copies(std::uint32_t state)
    {
        for (const DividedPair& pair : by_second_[state]) {
            if (pair.first != state) continue;
            for (std::size_t i = 0; i < points_[state].size(); ++i)
                energies_[state][i] += energy(pair, points_[state][i], points_[state][i]);
        }
    }

    /// Returns the energy of a point of the pair's first tile beside one of the second tile.
    static double energy(const DividedPair& pair, const PairVector& second, const PairVector& first)
    {
        const PairVector there = turned(pair.turn, second);
        const double x = pair.at.x + there.x - first.x, y = pair.at.y + there.y - first.y;
        const double squared = x * x + y * y;
        return pair.weight / (squared * squared);
    }

    std::size_t lowest(std::size_t state) const
    {
        std::size_t best = ranks_[state].size();
        for (std::size_t i = 0; i < ranks_[state].size(); ++i)
            if (ranks_[state][i] == unranked &&
                (best == ranks_[state].size() || energies_[state][i] < energies_[state][best]))
                best = i;
        return best;
    }

    void push_away(std::size_t state, const PairVector& point)
    {
        for (const DividedPair& pair : by_second_[state])
            for (std::size_t i = 0; i < ranks_[pair.first].size(); ++i)
                if (ranks_[pair.first][i] == unranked)
                    energies_[pair.first][i] += energy(pair, point, points_[pair.first][i]);
    }

    const MonotileTable& table_;
    const TileStates& states_;
    std::vector<std::vector<PairVector>> points_;
    std::vector<std::vector<std::uint16_t>> ranks_;
    std::vector<std::vector<double>> energies_;
    std::vector<std::vector<DividedPair>> by_second_;
};

}

std::vector<std::uint16_t> monotile_ranks(const MonotileTable& table, std::uint32_t levels)
{
    const PolygonTiling& tiling = *table.states.tiling;
    const std::vector<std::uint32_t> plain = states_without_ancestors(tiling, levels);
    MonotileTable base{monotile_states(tiling, 0), table.points, {}, {}};
    base.places.resize(base.states.parts.size() * table.points);
    for (std::size_t state = 0; state < plain.size(); ++state)
        for (std::uint32_t i = 0; i < table.points; ++i)
            base.places[plain[state] * table.points + i] = table.places[state * table.points + i];
    const auto ranks = Ranking(base).run();
    std::vector<std::uint16_t> all;
    for (const std::uint32_t state : plain) all.insert(all.end(), ranks[state].begin(), ranks[state].end());
    return all;
}

}
