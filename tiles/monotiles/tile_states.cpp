#include "tiles/monotiles/tile_states.hpp"

#include "tiles/prototiles/substitution.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>

namespace poissonlab {
namespace {

constexpr int sixths = 6;

int turned_by(int turn) { return (turn % sixths + sixths) % sixths; }

/// Returns the exponent of the ring's root whose power a unit is.
int steps_of(const RootRing& ring, const RingPlace& unit)
{
    for (int k = 0; k < ring.order(); ++k)
        if (ring.unit(k) == unit) return k;
    throw std::logic_error("a turn of a monotile is no unit of the ring");
}

TileFrame seen_from(const RootRing& ring, const TileFrame& frame, const TileFrame& other)
{
    return {ring.times(ring.unit(-2 * frame.turn), other.at - frame.at), turned_by(other.turn - frame.turn)};
}

RingPlace grown(const TileStates& states, const RingPlace& place)
{
    const PolygonTiling& tiling = *states.tiling;
    const RingPlace image = mapped(tiling.ring, tiling.magnification, place);
    return states.flips ? tiling.ring.conjugate(image) : image;
}

/// Calls `action` with each pair of a part of the first tile and a part of the second one. If both are the same tile,
/// the pairs are of different parts.
template <class Action>
void for_part_pairs(const TileStates& states, const StatePair& pair, const Action& action)
{
    const RootRing& ring = states.tiling->ring;
    const bool is_same = pair.second.frame == TileFrame{} && pair.first == pair.second.state;
    const auto& firsts = states.parts[pair.first];
    const auto& seconds = states.parts[pair.second.state];
    for (std::size_t j = 0; j < seconds.size(); ++j) {
        const TileFrame second = frame_of_part(states, pair.second.frame, seconds[j].frame);
        for (std::size_t i = 0; i < firsts.size(); ++i)
            if (!is_same || i != j)
                action(StatePair{firsts[i].state, {seconds[j].state, seen_from(ring, firsts[i].frame, second)}});
    }
}

/// The growth of places by divisions: a linear map of the ring's numbers to the plane grows by a factor, and differs
/// from the place in the plane by a bounded length.
class Growth
{
public:
    explicit Growth(const TileStates& states)
    {
        const PolygonTiling& tiling = *states.tiling;
        for (std::size_t i = 0; i < 4; ++i) {
            RingPlace unit;
            unit.c[i] = 1;
            const auto point = point_of(tiling, unit);
            const RingPlace image = grown(states, unit);
            for (std::size_t k = 0; k < 2; ++k) plane_[k][i] = point[k];
            for (std::size_t j = 0; j < 4; ++j) step_[j][i] = static_cast<double>(image.c[j]);
        }
        find_limit();
        for (const RingPlace& place : {RingPlace{{1, 0, 0, 0}}, RingPlace{{0, 1, 0, 0}}, RingPlace{{2, -1, 1, 3}}}) {
            const double once = length(limit_, place) * factor_, divided = length(limit_, grown(states, place));
            if (std::abs(divided - once) > rounding * once)
                throw std::logic_error("a division does not enlarge all lengths alike");
        }
        double longest = 0;
        for (const auto& parts : states.parts)
            for (const StatePart& part : parts) longest = std::max(longest, length(limit_, part.frame.at));
        nearest_reach_ = 2 * longest / (factor_ - 1);
        Rows rest = plane_;
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < 4; ++i) rest[k][i] -= limit_[k][i];
        double away = 0;
        for (int level = 0; level < shrinking_levels; ++level, rest = times_step(rest, 1)) {
            away = 0;
            for (const auto& parts : states.parts)
                for (const StatePart& part : parts) away = std::max(away, length(rest, part.frame.at));
            deviation_ += 2 * away;
        }
        deviation_ += 2 * away; // further levels, each of which adds less than half of the one before
    }

    /// Returns the reach in lengths of the limit that includes all pairs of a reach in the plane and their ancestors.
    double reach_for(double in_plane) const
    {
        return std::max(nearest_reach_, in_plane + deviation_) * (1 + rounding) + rounding;
    }

    double length(const RingPlace& place) const { return length(limit_, place); }

private:
    using Rows = std::array<std::array<double, 4>, 2>;
    static constexpr double rounding = 1e-6;    // far above the rounding of doubles here
    static constexpr int levels = 40;           // enough for what shrinks from level to level to vanish
    static constexpr int shrinking_levels = 12; // rounding grows as the rest shrinks

    static double length(const Rows& rows, const RingPlace& place)
    {
        std::array<double, 2> sum{};
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < 4; ++i) sum[k] += rows[k][i] * static_cast<double>(place.c[i]);
        return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
    }

    Rows times_step(const Rows& rows, double factor) const
    {
        Rows product{};
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j) product[k][i] += rows[k][j] * step_[j][i] / factor;
        return product;
    }

    void find_limit()
    {
        const auto size = [](const Rows& rows) {
            double sum = 0;
            for (const auto& row : rows)
                for (const double x : row) sum += x * x;
            return std::sqrt(sum);
        };
        Rows rows = plane_;
        for (int level = 0; level < levels; ++level) rows = times_step(times_step(rows, 1), 4);
        factor_ = std::sqrt(size(times_step(times_step(rows, 1), 1)) / size(rows));
        limit_ = plane_;
        for (int level = 0; level < levels; ++level) limit_ = times_step(times_step(limit_, factor_), factor_);
    }

    Rows plane_{}; ///< maps to the place in the plane
    Rows limit_{}; ///< maps to the place's descendants over the factor, in the limit
    std::array<std::array<double, 4>, 4> step_{};
    double factor_ = 1;
    double nearest_reach_ = 0;
    double deviation_ = 0; ///< the largest one of differences of places in tilings
};

struct StatePairHash
{
    std::size_t operator()(const StatePair& pair) const
    {
        const std::uint64_t states = std::uint64_t{pair.first} << 32 | pair.second.state;
        return RingPlaceHash{}(pair.second.frame.at) ^
               (states * sixths + static_cast<std::uint64_t>(pair.second.frame.turn)) * 0x9E3779B97F4A7C15U;
    }
};

/// Returns the distance of the farthest corner of any tile from its frame's origin.
double tile_reach(const PolygonTiling& tiling)
{
    double reach = 0;
    for (const Prototile& prototile : tiling.prototiles)
        for (const RingPlace& corner : prototile.corners) {
            const auto [x, y] = point_of(tiling, corner);
            reach = std::max(reach, std::sqrt(x * x + y * y));
        }
    return reach;
}

std::vector<RingPlace> corners_in_frame(const TileStates& states, std::uint32_t prototile, const TileFrame& frame)
{
    const RootRing& ring = states.tiling->ring;
    std::vector<RingPlace> corners;
    for (const RingPlace& corner : states.tiling->prototiles[prototile].corners)
        corners.push_back(frame.at + ring.times(ring.unit(2 * frame.turn), moved(ring, states.own[prototile], corner)));
    return corners;
}

using NearPrototiles = std::set<StatePair>; ///< states are prototiles

/// Returns pairs of prototiles that touch, and pairs with descendants that touch.
NearPrototiles near_prototiles(const TileStates& states)
{
    std::vector<StatePair> all = pairs_within(states, 2 * tile_reach(*states.tiling)).pairs;
    NearPrototiles near;
    for (const StatePair& pair : all) {
        const auto first = corners_in_frame(states, pair.first, {});
        for (const RingPlace& corner : corners_in_frame(states, pair.second.state, pair.second.frame))
            if (std::ranges::find(first, corner) != first.end()) near.insert(pair);
    }
    if (std::ranges::any_of(near, [&](const StatePair& pair) {
            return std::ranges::is_permutation(corners_in_frame(states, pair.first, {}),
                                               corners_in_frame(states, pair.second.state, pair.second.frame));
        }))
        throw std::logic_error("tiles of a monotile's tiling coincide");
    for (std::size_t before = 0; before != near.size();) {
        before = near.size();
        for (const StatePair& pair : all)
            for_part_pairs(states, pair, [&](const StatePair& parts) {
                if (near.contains(parts)) near.insert(pair);
            });
    }
    return near;
}

using PrototileCollar = std::vector<StatePart>; ///< ascending; states are prototiles

class CollarSearch
{
public:
    explicit CollarSearch(TileStates states) : states_(std::move(states)), near_(near_prototiles(states_)) {}

    /// Returns all collars that follow from that of the tile around the origin.
    TileStates run(std::size_t start)
    {
        constexpr int depth = 20; // an even number: the level is not mirrored
        const Substitution substitution(*states_.tiling, start);
        const RingPlace origin;
        constexpr std::size_t plenty = 100'000;
        const AddressedTile middle = substitution.tile_around(depth, origin).value();
        std::vector<StatePart> tiles;
        double reach = 0;
        for (const StatePair& pair : near_) {
            const auto [x, y] = point_of(*states_.tiling, pair.second.frame.at);
            reach = std::max(reach, std::sqrt(x * x + y * y));
        }
        for (const AddressedTile& near : substitution.tiles_near(depth, middle.tile.motion.at, reach, plenty))
            tiles.push_back({static_cast<std::uint32_t>(near.tile.prototile), frame_of(states_, near.tile)});
        TileStates result = states_;
        result.prototiles.clear();
        result.parts.clear();
        number(static_cast<std::uint32_t>(middle.tile.prototile),
               collar({static_cast<std::uint32_t>(middle.tile.prototile), frame_of(states_, middle.tile)}, tiles));
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const auto [prototile, own_collar] = found_[i];
            result.prototiles.push_back(prototile);
            result.parts.push_back(parts(prototile, own_collar));
        }
        return result;
    }

private:
    PrototileCollar collar(const StatePart& tile, const std::vector<StatePart>& others) const
    {
        PrototileCollar found;
        for (const StatePart& other : others) {
            const StatePart seen{other.state, seen_from(states_.tiling->ring, tile.frame, other.frame)};
            if (near_.contains({tile.state, seen})) found.push_back(seen);
        }
        std::ranges::sort(found);
        return found;
    }

    std::uint32_t number(std::uint32_t prototile, PrototileCollar collar)
    {
        const auto [at, is_new] =
            numbers_.try_emplace({prototile, std::move(collar)}, static_cast<std::uint32_t>(found_.size()));
        if (is_new) found_.push_back(at->first);
        return at->second;
    }

    std::vector<StatePart> parts(std::uint32_t prototile, const PrototileCollar& own_collar)
    {
        std::vector<StatePart> all = states_.parts[prototile];
        const std::size_t count = all.size();
        for (const StatePart& other : own_collar)
            for (const StatePart& part : states_.parts[other.state])
                all.push_back({part.state, frame_of_part(states_, other.frame, part.frame)});
        std::vector<StatePart> found;
        for (std::size_t i = 0; i < count; ++i)
            found.push_back({number(all[i].state, collar(all[i], all)), all[i].frame});
        return found;
    }

    TileStates states_;
    NearPrototiles near_;
    std::map<std::pair<std::uint32_t, PrototileCollar>, std::uint32_t> numbers_;
    std::deque<std::pair<std::uint32_t, PrototileCollar>> found_;
};

}

TileFrame frame_of_part(const TileStates& states, const TileFrame& whole, const TileFrame& part)
{
    const RootRing& ring = states.tiling->ring;
    const int turn = states.flips ? -whole.turn : whole.turn;
    return {grown(states, whole.at) + ring.times(ring.unit(2 * turn), part.at), turned_by(turn + part.turn)};
}

TileStates prototile_states(const PolygonTiling& tiling)
{
    const RootRing& ring = tiling.ring;
    if (ring.order() != 12 || tiling.is_periodic()) throw std::logic_error("a monotile's tiling has 12 directions");
    TileStates states{&tiling, false, std::vector<TileMotion>(tiling.prototiles.size()), {}, {}};
    for (const auto& parts : tiling.parts)
        for (const PlacedTile& part : parts)
            states.flips |= part.motion.is_mirrored && !tiling.parts[part.prototile].empty();
    std::set<std::size_t> known;
    for (const auto& parts : tiling.parts) {
        states.prototiles.push_back(static_cast<std::uint32_t>(states.parts.size()));
        std::vector<StatePart>& list = states.parts.emplace_back();
        for (const PlacedTile& part : parts) {
            const int steps = steps_of(ring, part.motion.turn) * (states.flips ? -1 : 1);
            const int odd = std::abs(steps) % 2;
            const TileMotion own{{}, ring.unit(odd), part.motion.is_mirrored != states.flips};
            if (!known.insert(part.prototile).second && states.own[part.prototile] != own)
                throw std::logic_error("parts of one prototile have different frames");
            if (!tiling.parts[part.prototile].empty() && own != TileMotion{})
                throw std::logic_error("a part that is divided is turned by a twelfth");
            states.own[part.prototile] = own;
            const RingPlace at = states.flips ? ring.conjugate(part.motion.at) : part.motion.at;
            list.push_back({static_cast<std::uint32_t>(part.prototile), {at, turned_by((steps - odd) / 2)}});
        }
    }
    return states;
}

TileFrame frame_of(const TileStates& states, const PlacedTile& tile)
{
    const RootRing& ring = states.tiling->ring;
    const int steps = steps_of(ring, tile.motion.turn) - steps_of(ring, states.own[tile.prototile].turn);
    return {tile.motion.at, turned_by(steps / 2)};
}

TileStates collared_states(const PolygonTiling& tiling, std::size_t start)
{
    return CollarSearch(prototile_states(tiling)).run(start);
}

TileStates with_parents(const TileStates& states)
{
    TileStates result{states.tiling, states.flips, states.own, {}, {}};
    std::vector<std::uint32_t> first; // the first one of the states of a tile's parts
    std::uint32_t count = 0;
    for (const auto& parts : states.parts) {
        first.push_back(count);
        count += static_cast<std::uint32_t>(parts.size());
    }
    for (const auto& parts : states.parts)
        for (const StatePart& part : parts) {
            result.prototiles.push_back(states.prototiles[part.state]);
            std::vector<StatePart>& list = result.parts.emplace_back();
            for (std::uint32_t i = 0; i < states.parts[part.state].size(); ++i)
                list.push_back({first[part.state] + i, states.parts[part.state][i].frame});
        }
    return result;
}

std::vector<double> frequencies_of(const TileStates& states)
{
    constexpr int steps = 200;
    std::vector<double> shares(states.parts.size(), 1.0 / static_cast<double>(states.parts.size()));
    for (int step = 0; step < steps; ++step) {
        std::vector<double> next(shares.size());
        double sum = 0;
        for (std::size_t i = 0; i < shares.size(); ++i)
            for (const StatePart& part : states.parts[i]) next[part.state] += shares[i], sum += shares[i];
        for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = next[i] / sum;
    }
    return shares;
}

StatePairs pairs_within(const TileStates& states, double reach)
{
    const Growth growth(states);
    const double longest = growth.reach_for(reach);
    const auto count = static_cast<std::uint32_t>(states.parts.size());
    std::unordered_map<StatePair, std::uint32_t, StatePairHash> numbers;
    std::vector<StatePair> found;
    std::vector<std::array<std::uint32_t, 2>>
        descents; // from a state, or from a pair, whose number is added to the number of states
    const auto divide = [&](std::uint32_t from, const StatePair& pair) {
        for_part_pairs(states, pair, [&](const StatePair& parts) {
            if (growth.length(parts.second.frame.at) > longest) return;
            const auto [at, is_new] = numbers.try_emplace(parts, static_cast<std::uint32_t>(found.size()));
            if (is_new) found.push_back(parts);
            descents.push_back({from, at->second});
        });
    };
    for (std::uint32_t i = 0; i < count; ++i) divide(i, {i, {i, {}}});
    for (std::uint32_t i = 0; i < found.size(); ++i) divide(count + i, StatePair(found[i]));
    // Frequencies of pairs that come from a pair are divided by the growth of the number of tiles.
    constexpr int steps = 60;
    const std::vector<double> shares = frequencies_of(states);
    double factor = 0;
    for (std::size_t i = 0; i < count; ++i) factor += shares[i] * static_cast<double>(states.parts[i].size());
    std::vector<double> frequencies(found.size());
    for (int step = 0; step < steps; ++step) {
        std::vector<double> next(found.size());
        for (const auto& [from, to] : descents)
            next[to] += (from < count ? shares[from] : frequencies[from - count]) / factor;
        frequencies = std::move(next);
    }
    std::vector<std::uint32_t> order(found.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return found[i]; });
    StatePairs result;
    for (const std::uint32_t i : order) {
        result.pairs.push_back(found[i]);
        result.frequencies.push_back(frequencies[i]);
    }
    return result;
}

std::vector<std::uint32_t> start_states(const TileStates& states, std::size_t start)
{
    const std::vector<PlacedTile>& tiles = states.tiling->starts.at(start).tiles;
    const auto is_of = [&](std::uint32_t state, const PlacedTile& tile) {
        return states.prototiles[state] == tile.prototile;
    };
    if (tiles.size() == 1) {
        for (std::uint32_t i = 0; i < states.prototiles.size(); ++i)
            if (is_of(i, tiles[0])) return {i};
    } else if (tiles.size() == 2) {
        const TileFrame seen = seen_from(states.tiling->ring, frame_of(states, tiles[0]), frame_of(states, tiles[1]));
        for (const StatePair& pair : pairs_within(states, 2 * tile_reach(*states.tiling)).pairs)
            if (pair.second.frame == seen && is_of(pair.first, tiles[0]) && is_of(pair.second.state, tiles[1]))
                return {pair.first, pair.second.state};
    }
    throw std::logic_error("no tiling has the tiles of a start beside each other");
}

std::size_t plane_start(const PolygonTiling& tiling)
{
    const auto found = std::ranges::find(tiling.starts, "plane", &StartPatch::name);
    return found == tiling.starts.end() ? 0 : static_cast<std::size_t>(found - tiling.starts.begin());
}

}
