#include "tiles/monotiles/monotile_table.hpp"

#include "base/geometry/relative_radius.hpp"
#include "tiles/polyominoes/pair_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

/// The number of divisions of the tiling; it is even, so that the tiling is not mirrored.
constexpr int depth = 32;

using PlanePlace = std::array<double, 2>;
__extension__ using WideInteger = __int128;

constexpr double root_of_three = 1.7320508075688772;

/// Returns the motion of the second tile in the first one's own frame.
TileMotion motion_between(const TileStates& states, const StatePair& pair)
{
    const RootRing& ring = states.tiling->ring;
    const TileMotion& first = states.own[states.prototiles[pair.first]];
    TileMotion second = states.own[states.prototiles[pair.second.state]];
    second.at = pair.second.frame.at;
    second.turn = ring.times(ring.unit(2 * pair.second.frame.turn), second.turn);
    if (!first.is_mirrored) {
        const RingPlace back = ring.conjugate(first.turn);
        return {ring.times(back, second.at), ring.times(back, second.turn), second.is_mirrored};
    }
    return {ring.times(first.turn, ring.conjugate(second.at)), ring.times(first.turn, ring.conjugate(second.turn)),
            !second.is_mirrored};
}

RingPlace ring_place(const MonotilePlace& place) { return {{place.x, 0, 0, place.y}}; }

RingPlace in_units(const RingPlace& place)
{
    RingPlace scaled = place;
    for (std::int64_t& c : scaled.c) c *= place_units;
    return scaled;
}

MonotilePlace rounded(const PolygonTiling& tiling, const PlanePlace& place)
{
    const auto units = [&](std::size_t axis) {
        return static_cast<std::int32_t>(std::lround(place[axis] / tiling.lengths[axis] * place_units));
    };
    return {units(0), units(1)};
}

PlanePlace in_plane(const PolygonTiling& tiling, const MonotilePlace& place)
{
    return {place.x * tiling.lengths[0] / place_units, place.y * tiling.lengths[1] / place_units};
}

double length_of(const PlanePlace& place) { return std::sqrt(place[0] * place[0] + place[1] * place[1]); }

/// Returns the largest distance of a point from the origin of its tile.
double overhang_of(const MonotileTable& table)
{
    double longest = 0;
    for (const MonotilePlace& place : table.places)
        longest = std::max(longest, length_of(in_plane(*table.states.tiling, place)));
    return longest;
}

// Before points move, they are at centroids of equal parts of the tile, by Lloyd's method on a grid.

bool is_in_outline(const std::vector<PlanePlace>& outline, const PlanePlace& p)
{
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePlace &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a[1] > p[1]) == (b[1] > p[1])) continue;
        if (p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}

std::vector<PlanePlace> grid_in_tile(const PolygonTiling& tiling)
{
    constexpr int steps = 100; // along the longer side
    std::vector<PlanePlace> outline;
    PlanePlace low{1e9, 1e9}, high{-1e9, -1e9};
    for (const RingPlace& corner : tiling.prototiles[0].corners) {
        outline.push_back(point_of(tiling, corner));
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], outline.back()[k]);
            high[k] = std::max(high[k], outline.back()[k]);
        }
    }
    const double step = std::max(high[0] - low[0], high[1] - low[1]) / steps;
    std::vector<PlanePlace> grid;
    for (int row = 0; row < steps; ++row)
        for (int column = 0; column < steps; ++column) {
            const PlanePlace p{low[0] + (column + 0.5) * step, low[1] + (row + 0.5) * step};
            if (is_in_outline(outline, p)) grid.push_back(p);
        }
    return grid;
}

double squared_between(const PlanePlace& a, const PlanePlace& b)
{
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

std::vector<PlanePlace> equal_parts(const PolygonTiling& tiling, std::size_t count)
{
    constexpr int iterations = 60;
    const std::vector<PlanePlace> grid = grid_in_tile(tiling);
    std::vector<PlanePlace> places{grid.front()};
    const auto nearest = [&](const PlanePlace& p) {
        return static_cast<std::size_t>(
            std::ranges::min_element(places, {}, [&](const PlanePlace& q) { return squared_between(p, q); }) -
            places.begin());
    };
    while (places.size() < count) // adds the farthest place
        places.push_back(*std::ranges::max_element(
            grid, {}, [&](const PlanePlace& p) { return squared_between(p, places[nearest(p)]); }));
    for (int i = 0; i < iterations; ++i) {
        std::vector<std::array<double, 3>> sums(count);
        for (const PlanePlace& p : grid) {
            auto& [x, y, members] = sums[nearest(p)];
            x += p[0];
            y += p[1];
            ++members;
        }
        for (std::size_t k = 0; k < count; ++k)
            if (sums[k][2] > 0) places[k] = {sums[k][0] / sums[k][2], sums[k][1] / sums[k][2]};
    }
    return places;
}

// These functions list the pairs of points of all pairs of tiles, which are relaxed.

constexpr std::size_t orientations = 24; // twelfths of a turn, without and with a mirror

std::vector<Orientation> all_orientations(const RootRing& ring)
{
    std::vector<Orientation> all;
    for (std::size_t i = 0; i < orientations; ++i) {
        const auto [x, y] = ring.value(ring.unit(static_cast<int>(i) % 12));
        all.push_back(i < 12 ? Orientation{x, -y, y, x} : Orientation{x, y, y, -x});
    }
    return all;
}

std::uint32_t orientation_of(const RootRing& ring, const TileMotion& motion)
{
    std::uint32_t steps = 0;
    while (ring.unit(static_cast<int>(steps)) != motion.turn) ++steps;
    return steps + (motion.is_mirrored ? 12 : 0);
}

class TablePairs
{
public:
    TablePairs(const MonotileTable& table, double spacing) : table_(table), spacing_(spacing) {}

    SharedPoints points() const
    {
        const TileStates& states = table_.states;
        const double reach = (soft_reach + 2 * longest_correction) * spacing_;
        const StatePairs near = pairs_within(states, reach + 2 * overhang_);
        SharedPoints shared;
        shared.orientations = all_orientations(states.tiling->ring);
        shared.spacing = spacing_;
        const std::vector<double> frequencies = frequencies_of(states);
        for (std::uint32_t state = 0; state < frequencies.size(); ++state) {
            shared.frequencies.insert(shared.frequencies.end(), table_.points, frequencies[state]);
            add(shared, {state, {state, {}}}, frequencies[state], reach);
        }
        for (std::size_t i = 0; i < near.pairs.size(); ++i) add(shared, near.pairs[i], near.frequencies[i], reach);
        return shared;
    }

private:
    /// Each pair of tiles is listed twice, seen from either tile, and therefore gets half of the weight.
    void add(SharedPoints& shared, const StatePair& pair, double frequency, double reach) const
    {
        const PolygonTiling& tiling = *table_.states.tiling;
        const TileMotion motion = motion_between(table_.states, pair);
        const PlanePlace at = point_of(tiling, motion.at);
        if (length_of(at) > reach + 2 * overhang_) return;
        const std::uint32_t orientation = orientation_of(tiling.ring, motion);
        const Orientation& turn = shared.orientations[orientation];
        const bool is_same = pair.first == pair.second.state && pair.second.frame == TileFrame{};
        for (std::uint32_t j = 0; j < table_.points; ++j) {
            const PlanePlace second = place(pair.second.state, j);
            const PairVector there = turned(turn, {second[0], second[1]});
            for (std::uint32_t i = 0; i < table_.points; ++i) {
                if (is_same && i == j) continue;
                const PlanePlace first = place(pair.first, i);
                const PairVector difference{at[0] + there.x - first[0], at[1] + there.y - first[1]};
                if (difference.x * difference.x + difference.y * difference.y > reach * reach) continue;
                shared.pairs.push_back({pair.first * table_.points + i, pair.second.state * table_.points + j,
                                        orientation, difference, frequency / 2});
            }
        }
    }

    PlanePlace place(std::uint32_t state, std::uint32_t number) const
    {
        return in_plane(*table_.states.tiling, table_.places[state * table_.points + number]);
    }

    const MonotileTable& table_;
    double spacing_;
    double overhang_ = overhang_of(table_);
};

constexpr SquaredLength no_distance{std::numeric_limits<std::int64_t>::max(), 0};

/// Returns the numbers of points in the order of the table: the last ones are left out first.
std::vector<std::uint32_t> even_order(const std::vector<SquaredLength>& least, std::uint32_t points)
{
    std::vector<std::uint32_t> order(points);
    for (std::uint32_t i = 0; i < points; ++i) order[i] = i;
    const auto distance_without = [&](std::uint32_t left_out, std::uint32_t count) {
        SquaredLength found = no_distance;
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t j = 0; j <= i; ++j)
                if (i != left_out && j != left_out) found = std::min(found, least[order[i] * points + order[j]]);
        return found;
    };
    for (std::uint32_t count = points; count > 1; --count) {
        std::uint32_t best = count - 1;
        for (std::uint32_t i = 0; i < count; ++i)
            if (distance_without(i, count) > distance_without(best, count)) best = i;
        std::swap(order[best], order[count - 1]);
    }
    return order;
}

}

std::strong_ordering SquaredLength::operator<=>(const SquaredLength& other) const
{
    // The sign of a + b sqrt(3) is that of the term with the larger absolute value.
    const WideInteger a = WideInteger{whole} - other.whole, b = WideInteger{root} - other.root;
    const auto sign = [](WideInteger x) { return x < 0 ? -1 : x > 0 ? 1 : 0; };
    return (sign(a) == sign(b) ? sign(a) : a * a > 3 * b * b ? sign(a) : sign(b)) <=> 0;
}

double SquaredLength::length() const
{
    return std::sqrt(static_cast<double>(whole) + root_of_three * static_cast<double>(root)) / place_units;
}

SquaredLength squared_length(const PolygonTiling& tiling, const RingPlace& difference)
{
    const auto& [a, b, c, d] = difference.c; // a + c w + z (b + d w), w a sixth of a turn and z a twelfth
    const auto square = [&](std::size_t i) { return std::llround(tiling.lengths[i] * tiling.lengths[i]); };
    const std::int64_t even = a * a + a * c + c * c, odd = b * b + b * d + d * d, both = a * b + c * b + c * d;
    const std::int64_t first = square(0), second = square(1);
    if (first == second) return {first * (even + odd), first * both};
    return {first * even + second * odd + 3 * both, 0};
}

double densest_distance(const MonotileTable& table, std::uint32_t kept)
{
    return max_min_distance(1, 2) / std::sqrt(monotile_density(table, kept));
}

bool are_near_their_tiles(const MonotileTable& table)
{
    double reach = 0;
    for (const RingPlace& corner : table.states.tiling->prototiles[0].corners)
        reach = std::max(reach, length_of(point_of(*table.states.tiling, corner)));
    constexpr double rounding = 1e-3;
    return overhang_of(table) <= reach + longest_correction * densest_distance(table, table.points) + rounding;
}

double monotile_density(const MonotileTable& table, std::uint32_t kept)
{
    return kept / area_of(*table.states.tiling, 0);
}

TileStates monotile_states(const PolygonTiling& tiling, std::uint32_t levels)
{
    TileStates states = collared_states(tiling, plane_start(tiling));
    for (std::uint32_t i = 0; i < levels; ++i) states = with_parents(states);
    return states;
}

std::vector<SquaredLength> least_distances(const MonotileTable& table, const std::vector<SquaredLength>& promised)
{
    // Some points are at most as far apart as in the densest packing, and tiles farther apart have no such points.
    const TileStates& states = table.states;
    const RootRing& ring = states.tiling->ring;
    const double reach = densest_distance(table, 1) + 2 * overhang_of(table);
    std::vector<SquaredLength> least(std::size_t{table.points} * table.points, no_distance);
    bool is_broken = false; // a promise
    const auto look = [&](const StatePair& pair) {
        const TileMotion motion = motion_between(states, pair);
        if (length_of(point_of(*states.tiling, motion.at)) > reach) return;
        const bool is_same = pair.first == pair.second.state && pair.second.frame == TileFrame{};
        const TileMotion scaled{in_units(motion.at), motion.turn, motion.is_mirrored};
        for (std::uint32_t j = 0; j < table.points; ++j) {
            const RingPlace there = moved(ring, scaled, ring_place(table.places[pair.second.state * table.points + j]));
            for (std::uint32_t i = 0; i < table.points; ++i) {
                if (is_same && i == j) continue;
                const RingPlace here = ring_place(table.places[pair.first * table.points + i]);
                const SquaredLength found = squared_length(*states.tiling, there - here);
                for (SquaredLength* known : {&least[i * table.points + j], &least[j * table.points + i]})
                    *known = std::min(*known, found);
                is_broken = is_broken || (!promised.empty() && found < promised[std::max(i, j)]);
            }
        }
    };
    for (std::uint32_t state = 0; state < states.parts.size(); ++state) look({state, {state, {}}});
    if (is_broken) return least;
    for (const StatePair& pair : pairs_within(states, reach).pairs) {
        look(pair);
        if (is_broken) break;
    }
    return least;
}

std::vector<SquaredLength> distances_of_prefixes(const std::vector<SquaredLength>& least, std::uint32_t points)
{
    std::vector<SquaredLength> distances(points, no_distance);
    for (std::uint32_t i = 0; i < points; ++i) {
        if (i > 0) distances[i] = distances[i - 1];
        for (std::uint32_t j = 0; j <= i; ++j) distances[i] = std::min(distances[i], least[i * points + j]);
    }
    return distances;
}

MonotileTable build_monotile_table(const PolygonTiling& tiling, std::uint32_t points, std::uint32_t levels,
                                   const std::function<void(const std::string& what)>& on_step)
{
    const auto report = [&](const char* what) {
        if (on_step) on_step(tiling.title + ": " + what);
    };
    report("the states of tiles");
    MonotileTable table{monotile_states(tiling, levels), points, {}, {}};
    std::vector<MonotilePlace> places;
    for (const PlanePlace& place : equal_parts(tiling, points)) places.push_back(rounded(tiling, place));
    for (std::size_t i = 0; i < table.states.parts.size(); ++i)
        table.places.insert(table.places.end(), places.begin(), places.end());
    report("points of all tiles together");
    const std::vector<PairVector> moves = relaxed_points(TablePairs(table, densest_distance(table, points)).points());
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const PlanePlace place = in_plane(tiling, table.places[i]);
        table.places[i] = rounded(tiling, {place[0] + moves[i].x, place[1] + moves[i].y});
    }
    report("the proof of the minimum distance");
    const std::vector<SquaredLength> least = least_distances(table);
    const std::vector<std::uint32_t> order = even_order(least, points);
    const std::vector<MonotilePlace> unordered = table.places;
    for (std::size_t i = 0; i < unordered.size(); ++i) table.places[i] = unordered[i - i % points + order[i % points]];
    std::vector<SquaredLength> ordered;
    for (const std::uint32_t i : order)
        for (const std::uint32_t j : order) ordered.push_back(least[i * points + j]);
    table.distances = distances_of_prefixes(ordered, points);
    return table;
}

MonotilePoints::MonotilePoints(const MonotileTable& table)
    : table_(table), substitution_(*table.states.tiling, plane_start(*table.states.tiling)),
      start_(start_states(table.states, plane_start(*table.states.tiling))), overhang_(overhang_of(table))
{}

RingPlace MonotilePoints::tile_at(const PlanePlace& point) const
{
    const auto tile = substitution_.tile_around(depth, place_near(*table_.states.tiling, point));
    if (!tile) throw std::logic_error("a tiling does not cover the plane");
    return tile->tile.motion.at;
}

std::vector<PlanePlace> MonotilePoints::square(const RingPlace& middle, double side, std::uint32_t kept,
                                               const PlanePlace& shift) const
{
    const PolygonTiling& tiling = *table_.states.tiling;
    const double radius = side * std::sqrt(0.5) + overhang_ + length_of(shift);
    std::vector<PlanePlace> found;
    for (const auto& [tile, address] :
         substitution_.tiles_near(depth, middle, radius, std::numeric_limits<std::size_t>::max())) {
        std::uint32_t state = start_[address[0]];
        for (std::size_t level = 1; level < address.size(); ++level)
            state = table_.states.parts[state][address[level]].state;
        const TileMotion from_middle{in_units(tile.motion.at - middle), tile.motion.turn, tile.motion.is_mirrored};
        for (std::uint32_t i = 0; i < kept; ++i) {
            const RingPlace place =
                moved(tiling.ring, from_middle, ring_place(table_.places[state * table_.points + i]));
            const auto [x, y] = point_of(tiling, place);
            const double u = (x / place_units - shift[0]) / side, v = (y / place_units - shift[1]) / side;
            if (u >= -0.5 && u < 0.5 && v >= -0.5 && v < 0.5) found.push_back({u, v});
        }
    }
    return found;
}

}
