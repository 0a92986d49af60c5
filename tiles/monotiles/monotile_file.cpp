#include "tiles/monotiles/monotile_file.hpp"

#include "base/errors/errors.hpp"
#include "tiles/monotiles/monotile_ranks.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

namespace poissonlab {
namespace {

constexpr std::size_t header_size = 128, promise_offset = 40, checksum_offset = 120;

/// Appends the lowest bytes of a number, which may be negative, the lowest one first.
void put(std::string& bytes, std::int64_t value, int size)
{
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> 8 * i & 0xff);
}

void put_record(std::string& bytes, const StatePart& tile, std::uint32_t order)
{
    put(bytes, tile.state, 4);
    for (const std::int64_t c : tile.frame.at.c) put(bytes, c, 2);
    put(bytes, tile.frame.turn, 2);
    put(bytes, order, 2);
}

/// Returns the place of each part of a state in their order, which is that of their first ranks.
std::vector<std::uint32_t> orders_of(const std::uint16_t* ranks, std::size_t parts, std::uint32_t points)
{
    std::vector<std::uint32_t> sorted(parts), order(parts);
    std::iota(sorted.begin(), sorted.end(), 0U);
    std::ranges::sort(sorted, {}, [&](std::uint32_t part) {
        return *std::min_element(ranks + std::size_t{part} * points, ranks + std::size_t{part + 1} * points);
    });
    for (std::uint32_t i = 0; i < parts; ++i) order[sorted[i]] = i;
    return order;
}

/// Returns the squared distance in squares of 1/place_units, rounded down. Doubles are off by few units, of which exact
/// comparison leaves none.
std::int64_t rounded_down(const SquaredLength& squared)
{
    const double length = squared.length() * place_units;
    auto whole = static_cast<std::int64_t>(length * length);
    while (SquaredLength{whole, 0} > squared) --whole;
    while (SquaredLength{whole + 1, 0} <= squared) ++whole;
    return whole;
}

std::string header_of(const MonotileTable& table, std::uint32_t levels, std::size_t parts, std::size_t starts)
{
    const PolygonTiling& tiling = *table.states.tiling;
    const RootRing& ring = tiling.ring;
    const auto odd = std::llround(tiling.lengths[1] * tiling.lengths[1]);
    std::string bytes = "PTILES\r\n";
    for (const std::size_t number : {std::size_t{4}, header_size, std::size_t{3}, std::size_t{2}, std::size_t{odd == 1},
                                     table.states.parts.size(), std::size_t{table.points}, std::size_t{levels}})
        put(bytes, static_cast<std::int64_t>(number), 4);
    put(bytes, rounded_down(table.distances.back()), 8);
    put(bytes, static_cast<std::int64_t>(parts), 4);
    put(bytes, static_cast<std::int64_t>(starts), 4);
    put(bytes, table.states.flips, 4);
    put(bytes, odd, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        RingPlace unit;
        unit.c[i] = 1;
        RingPlace image = mapped(ring, tiling.magnification, unit);
        if (table.states.flips) image = ring.conjugate(image);
        for (const std::int64_t c : image.c) put(bytes, c, 1);
    }
    put(bytes, pmono_divisions, 4);
    bytes.resize(header_size);
    return bytes;
}

/// `levels` are those of monotile_states(), `ranks` those of monotile_ranks().
std::string monotile_file_bytes(const MonotileTable& table, std::uint32_t levels,
                                const std::vector<std::uint16_t>& ranks)
{
    const TileStates& states = table.states;
    const std::size_t start = plane_start(*states.tiling), parts = ranks.size() / table.points;
    const std::vector<std::uint32_t> starts = start_states(states, start);
    std::string bytes = header_of(table, levels, parts, starts.size());
    for (const SquaredLength& squared : table.distances) {
        put(bytes, squared.whole, 8);
        put(bytes, squared.root, 8);
    }
    for (std::size_t i = 0; i < starts.size(); ++i)
        put_record(bytes, {starts[i], frame_of(states, states.tiling->starts[start].tiles[i])}, 0);
    std::string rows;
    std::size_t first = 0;
    for (std::size_t state = 0; state < states.parts.size(); ++state) {
        const auto& own_parts = states.parts[state];
        const auto order = orders_of(ranks.data() + first * table.points, own_parts.size(), table.points);
        for (std::size_t i = 0; i < own_parts.size(); ++i) put_record(bytes, own_parts[i], order[i]);
        put(rows, static_cast<std::int64_t>(first), 4);
        put(rows, static_cast<std::int64_t>(own_parts.size()), 2);
        const TileMotion& own = states.own[states.prototiles[state]];
        put(rows, (own.turn != states.tiling->ring.unit(0) ? 1 : 0) + (own.is_mirrored ? 2 : 0), 2);
        first += own_parts.size();
    }
    bytes += rows;
    for (const MonotilePlace& place : table.places) {
        put(bytes, place.x, 4);
        put(bytes, place.y, 4);
    }
    for (const std::uint16_t rank : ranks) put(bytes, rank, 2);
    std::string sum;
    put(sum, static_cast<std::int64_t>(tile_file_checksum(bytes)), 8);
    return bytes.replace(checksum_offset, sum.size(), sum);
}

/// Returns the exact squared distances that a file states.
std::vector<SquaredLength> stored_distances(const pmono_set& set)
{
    const auto number = [&](std::size_t i) {
        const unsigned char* at = set.distances + 8 * i;
        return static_cast<std::int64_t>(pmono_word(at) | std::uint64_t{pmono_word(at + 4)} << 32);
    };
    std::vector<SquaredLength> distances;
    for (std::size_t i = 0; i < set.points_per_tile; ++i) distances.push_back({number(2 * i), number(2 * i + 1)});
    return distances;
}

/// Says whether some points could have the distances of a table: more points are not farther apart, and none are
/// farther apart than in the densest packing. Numbers are also so small that doubles hold them.
bool can_be_true(const MonotileTable& table)
{
    constexpr std::int64_t largest = std::int64_t{1} << 52;
    constexpr double rounding = 1e-6;
    for (std::uint32_t i = 0; i < table.points; ++i) {
        const SquaredLength& squared = table.distances[i];
        if (std::min(squared.whole, squared.root) < -largest || std::max(squared.whole, squared.root) > largest ||
            squared <= SquaredLength{} || squared.length() > densest_distance(table, i + 1) * (1 + rounding))
            return false;
        if (i > 0 && squared > table.distances[i - 1]) return false;
    }
    return true;
}

}

std::string ranked_monotile_file(const MonotileTable& table, std::uint32_t levels)
{
    return monotile_file_bytes(table, levels, monotile_ranks(table, levels));
}

std::string built_monotile_file(const PolygonTiling& tiling, std::uint32_t points, std::uint32_t levels,
                                const std::function<void(const std::string& what)>& on_step)
{
    const MonotileTable table = build_monotile_table(tiling, points, levels, on_step);
    if (on_step) on_step(tiling.title + ": ranks");
    return ranked_monotile_file(table, levels);
}

MonotileTable proven_monotile_table(const MonotilePointsFile& file, const PolygonTiling& tiling)
{
    const pmono_set& set = file.set();
    const auto refused = [&](const std::string& what) { return InputError(what).moved_to({file.name()}); };
    const InputError other_distances = refused("promises other distances than are proven");
    MonotileTable table{monotile_states(tiling, file.levels()), set.points_per_tile, {}, stored_distances(set)};
    if (table.states.parts.size() != set.states)
        throw refused(fmt::format("{} states: must be {} for this tiling", set.states, table.states.parts.size()));
    std::size_t parts = 0;
    for (const auto& own : table.states.parts) parts += own.size();
    if (parts != set.parts) throw refused(fmt::format("{} parts: must be {} for this tiling", set.parts, parts));
    for (std::size_t i = 0; i < std::size_t{set.states} * set.points_per_tile; ++i)
        table.places.push_back({pmono_signed_word(set.place + 8 * i), pmono_signed_word(set.place + 8 * i + 4)});
    // The proof takes long, and most files that lie are refused before it.
    if (!can_be_true(table)) throw other_distances;
    if (!are_near_their_tiles(table)) throw refused("has points far from their tiles");
    std::vector<std::uint16_t> ranks(std::size_t{set.parts} * set.points_per_tile);
    for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] = static_cast<std::uint16_t>(pmono_half(set.rank + 2 * i));
    const std::string expected = monotile_file_bytes(table, file.levels(), ranks), &found = file.bytes();
    if (found.substr(promise_offset, 8) != expected.substr(promise_offset, 8)) throw other_distances;
    if (found != expected) throw refused("has tables that are not those of the tiling");
    if (distances_of_prefixes(least_distances(table, table.distances), table.points) != table.distances)
        throw other_distances;
    return table;
}

}
