// Points of aperiodic monotiles: the states of tiles, the proof of the distance, and windows far away.
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "host/tile_sampling/monotiles/monotile_sampler.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/monotiles/monotile_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using MonotilePoint = std::array<double, 2>;

MonotileTable monotile_table(const std::string& tiling, std::uint32_t points, std::uint32_t levels)
{
    return build_monotile_table(built_in_tiling(tiling), points, levels);
}

/// Returns the least distance of any two points, over all pairs.
double least_of_all_pairs(const std::vector<MonotilePoint>& points)
{
    double least = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
    return least;
}

// tests/tiles/monotiles/spectre_neighbours.py finds the numbers of spectres in a tiling that it makes by the rules of
// the paper's authors, without this code.
TEST(MonotileStates, NeighboursAreThoseOfAnIndependentProgram)
{
    const PolygonTiling& tiling = built_in_tiling("spectre");
    const auto touch = [&](const TileStates& states, const StatePair& pair) {
        const auto corners = [&](std::uint32_t state, const TileFrame& frame) {
            std::set<RingPlace> all;
            for (const RingPlace& corner : tiling.prototiles[states.prototiles[state]].corners)
                all.insert(frame.at +
                           tiling.ring.times(tiling.ring.unit(2 * frame.turn),
                                             moved(tiling.ring, states.own[states.prototiles[state]], corner)));
            return all;
        };
        const auto first = corners(pair.first, {});
        return std::ranges::any_of(corners(pair.second.state, pair.second.frame),
                                   [&](const RingPlace& corner) { return first.contains(corner); });
    };
    const TileStates plain = prototile_states(tiling);
    const StatePairs pairs = pairs_within(plain, 8);
    EXPECT_EQ(std::ranges::count_if(pairs.pairs, [&](const StatePair& pair) { return touch(plain, pair); }), 119);
    // The tiles that touch a tile follow from its state.
    const TileStates states = collared_states(tiling, plane_start(tiling));
    std::map<std::uint32_t, std::set<StatePart>> around;
    for (const StatePair& pair : pairs_within(states, 8).pairs)
        if (touch(states, pair)) around[pair.first].insert({states.prototiles[pair.second.state], pair.second.frame});
    std::set<std::pair<std::uint32_t, std::set<StatePart>>> coronas;
    for (const auto& [state, tiles] : around) coronas.insert({states.prototiles[state], tiles});
    EXPECT_EQ(coronas.size(), 42U);
}

TEST(MonotileStates, FrequenciesAreThoseOfThePapers)
{
    const double phi = (1 + std::sqrt(5.0)) / 2;
    for (const std::uint32_t levels : {0U, 1U}) {
        const TileStates hats = monotile_states(built_in_tiling("hat"), levels);
        const std::vector<double> shares = frequencies_of(hats);
        double reflected = 0, all = 0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            all += shares[i];
            if (built_in_tiling("hat").prototiles[hats.prototiles[i]].name == "reflected") reflected += shares[i];
        }
        EXPECT_NEAR(all, 1, 1e-12);
        EXPECT_NEAR(reflected / (all - reflected), std::pow(phi, -4), 1e-12);
        const TileStates spectres = monotile_states(built_in_tiling("spectre"), levels);
        double growth = 0;
        const std::vector<double> parts = frequencies_of(spectres);
        for (std::size_t i = 0; i < parts.size(); ++i)
            growth += parts[i] * static_cast<double>(spectres.parts[i].size());
        EXPECT_NEAR(growth, 4 + std::sqrt(15.0), 1e-12);
    }
}

// The tiling has as many pairs of near tiles as the list says, also far away from its origin.
TEST(MonotileStates, PairsAreAsFrequentAsInAWindowFarAway)
{
    constexpr double reach = 9;
    for (const char* word : {"hat", "turtle", "spectre"}) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const MonotileTable table{monotile_states(tiling, 0), 1, {}, {}};
        const StatePairs near = pairs_within(table.states, reach);
        // The tiling far away, by its tiles.
        const Substitution substitution(tiling, plane_start(tiling));
        const AddressedTile middle = substitution.tile_around(32, place_near(tiling, {7e8, -3e8})).value();
        const auto around = substitution.tiles_near(32, middle.tile.motion.at, 60, 100'000);
        double pairs = 0, tiles = 0, expected = 0;
        for (const AddressedTile& one : around) {
            const MonotilePoint at = point_of(tiling, one.tile.motion.at - middle.tile.motion.at);
            if (std::hypot(at[0], at[1]) > 45) continue;
            ++tiles;
            for (const AddressedTile& other : around) {
                const MonotilePoint away = point_of(tiling, other.tile.motion.at - one.tile.motion.at);
                if (other.address != one.address && std::hypot(away[0], away[1]) < reach) ++pairs;
            }
        }
        for (std::size_t i = 0; i < near.pairs.size(); ++i) {
            const MonotilePoint away = point_of(tiling, near.pairs[i].second.frame.at);
            if (std::hypot(away[0], away[1]) < reach) expected += near.frequencies[i];
        }
        EXPECT_NEAR(pairs / tiles, expected, 0.02 * expected) << word;
    }
}

TEST(MonotileTiles, TheProvenDistanceIsThatOfAllPairsFarAway)
{
    for (const char* word : {"hat", "spectre"})
        for (const std::uint32_t points : {1U, 2U, 3U, 8U})
            for (const std::uint32_t levels : {0U, 1U}) {
                if (points > 2 && levels > 0) continue; // these tables take long
                SCOPED_TRACE(fmt::format("{}, {} points, {} levels", word, points, levels));
                const MonotileTable table = monotile_table(word, points, levels);
                const MonotilePoints all(table);
                for (const std::uint32_t kept : std::set<std::uint32_t>{1, points}) {
                    // The places are some 10^9 edges away. Windows have most states, but need not have the nearest
                    // pair.
                    const double side = std::sqrt(1500 / monotile_density(table, kept));
                    double least = 1e9, found = 0;
                    for (const MonotilePoint& place : {MonotilePoint{2e9, 1e9}, MonotilePoint{-1.5e9, 2e8}}) {
                        const auto window = all.square(all.tile_at(place), side, kept);
                        found += static_cast<double>(window.size());
                        least = std::min(least, side * least_of_all_pairs(window));
                    }
                    const double proven = table.distances[kept - 1].length();
                    EXPECT_GT(least, proven * (1 - 1e-12));
                    EXPECT_LT(least, proven * 1.02);
                    EXPECT_NEAR(found, 3000, 60);
                }
                EXPECT_GT(table.distances.back().length() * std::sqrt(monotile_density(table, points)) /
                              max_min_distance(1, 2),
                          0.79);
                EXPECT_TRUE(std::ranges::is_sorted(table.distances, std::ranges::greater()));
                EXPECT_EQ(distances_of_prefixes(least_distances(table), points), table.distances);
            }
}

TEST(MonotileTiles, WindowsShowThePartsOfOneTiling)
{
    const MonotileTable table = monotile_table("spectre", 2, 1);
    const MonotilePoints all(table);
    const RingPlace middle = all.tile_at({1.9e9, -1.2e9});
    const MonotilePoint away = point_of(*table.states.tiling, all.tile_at({1.9e9 + 11, -1.2e9 + 4}) - middle);
    const auto large = all.square(middle, 60, 2);
    const auto small = all.square(all.tile_at({1.9e9 + 11, -1.2e9 + 4}), 20, 2);
    std::size_t found = 0;
    for (const MonotilePoint& p : small)
        found += static_cast<std::size_t>(std::ranges::count_if(large, [&](const MonotilePoint& q) {
            return std::hypot(p[0] * 20 + away[0] - q[0] * 60, p[1] * 20 + away[1] - q[1] * 60) < 1e-9;
        }));
    EXPECT_EQ(found, small.size());
    EXPECT_GT(found, 80U);
    EXPECT_EQ(all.square(middle, 60, 2), large);
    // A square that is moved has the points of one that is not.
    for (const MonotilePoint& p : all.square(middle, 20, 2, away))
        EXPECT_TRUE(std::ranges::any_of(
            small, [&](const MonotilePoint& q) { return std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-9; }));
}

TEST(MonotileTiles, SquaredLengthsAreExact)
{
    // 7 - 4 sqrt3 = (2 - sqrt3)^2 is near 0; the squares of good fractions of sqrt3 are nearer than doubles tell.
    EXPECT_GT((SquaredLength{7, -4}), (SquaredLength{}));
    EXPECT_LT((SquaredLength{-1351, 780}), (SquaredLength{}));
    EXPECT_GT((SquaredLength{708158977, -408855776}), (SquaredLength{}));
    EXPECT_EQ((SquaredLength{3, 1} <=> SquaredLength{3, 1}), std::strong_ordering::equal);
    for (const char* word : {"hat", "turtle", "spectre"})
        for (std::int64_t i = 0; i < 81; ++i) {
            const RingPlace place{{i % 3 - 1, i / 3 % 3 - 1, i / 9 % 3 - 1, i / 27 - 1}};
            const auto [x, y] = point_of(built_in_tiling(word), place);
            const SquaredLength squared = squared_length(built_in_tiling(word), place);
            EXPECT_NEAR(squared.length() * place_units, std::hypot(x, y), 1e-7) << word;
        }
}

TEST(MonotileTiles, TablesAreKeptAndDamagedOnesAreBuiltAgain)
{
    const TemporaryFolder folder;
    const BuiltOnce<MonotileTable> built = cached_monotile_table("hat", 3, 0, folder.path());
    EXPECT_FALSE(built.cached);
    const BuiltOnce<MonotileTable> read = cached_monotile_table("hat", 3, 0, folder.path());
    EXPECT_TRUE(read.cached);
    EXPECT_EQ(read.built.places, built.built.places);
    EXPECT_EQ(read.built.distances, built.built.distances);
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        if (entry.path().extension() == ".table") file = entry.path();
    const std::string bytes = read_whole_file(file);
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 1;
    // The last one is whole, but has points for two in a tile.
    const TemporaryFolder other;
    cached_monotile_table("hat", 2, 0, other.path());
    std::string of_two;
    for (const auto& entry : std::filesystem::directory_iterator(other.path()))
        if (entry.path().extension() == ".table") of_two = read_whole_file(entry.path());
    for (const std::string& damaged :
         {std::string("damaged"), std::string(), bytes.substr(0, bytes.size() - 1), bytes + '0', flipped, of_two}) {
        write_whole_file(file, damaged);
        const BuiltOnce<MonotileTable> again = cached_monotile_table("hat", 3, 0, folder.path());
        EXPECT_FALSE(again.cached);
        EXPECT_EQ(again.built.places, built.built.places);
    }
}

}
}
