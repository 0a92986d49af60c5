// Points of tori with polyominoes: counts, order, the proven distance against every pair, and densities.
#include "tiles/polyominoes/polyomino_points.hpp"

#include "base/densities/density_text.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/polyomino_tables.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/polyominoes/point_pairs.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace poissonlab {
namespace {

using test::p_table;

/// The least squared distance of all pairs of points of a row, in squared units: exact integers.
std::int64_t counted_distance(const PolyominoTorus& torus, std::uint32_t level, std::uint32_t row)
{
    const PolyominoTable& table = torus.table();
    const std::int64_t side = torus.side_units(level);
    std::vector<LatticePlace> points;
    const LatticePlace anchor = anchor_of(table.neighbourhoods.rule.shape);
    const std::uint64_t values = torus.counts().tiles(level) / table.last_row() * row;
    for (std::uint64_t value = 0; value < values; ++value) {
        const LevelTile tile = torus.tile(value, level);
        const LatticePlace at =
            point_of(tile.pose, anchor, table.correction(row, tile.tile_class, tile.number)) + LatticePlace{side, side};
        points.push_back({at.x % side, at.y % side});
    }
    std::int64_t least = 2 * side * side;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::int64_t x = std::abs(points[i].x - points[j].x), y = std::abs(points[i].y - points[j].y);
            const std::int64_t u = std::min(x, side - x), v = std::min(y, side - y);
            least = std::min(least, u * u + v * v);
        }
    return least;
}

/// The distance that is proven of a row is that of tori: never more, and reached by most rows in one of three tori.
TEST(PolyominoTables, ProveTheDistanceOfEveryRow)
{
    const PolyominoTable& table = p_table();
    ASSERT_EQ(table.last_row(), 16U);
    std::vector<PolyominoTorus> tori;
    for (std::uint32_t realization = 0; realization < 3; ++realization) tori.emplace_back(table, 5, 1, realization);
    int reached = 0;
    for (std::uint32_t row = 1; row <= table.last_row(); ++row) {
        const RowProof& proof = table.proofs[row - 1];
        const auto proven = static_cast<std::int64_t>(proof.squared_distance);
        std::int64_t least = INT64_MAX;
        for (const PolyominoTorus& torus : tori) least = std::min(least, counted_distance(torus, proof.divisions, row));
        EXPECT_GE(least, proven) << "row " << row;
        reached += least == proven;
        EXPECT_GT(proven_relative_radius(table, row), 0.75) << "row " << row;
        EXPECT_LE(proof.divisions, row < 6 ? 7U : 5U);
    }
    EXPECT_GE(reached, 8);
}

/// A table in which one correction is wrong has a smaller distance: the proof looks at the corrections.
TEST(PolyominoTables, ProofsSeeEveryEntry)
{
    PolyominoTable table = p_table();
    const std::uint32_t row = 16;
    for (std::uint32_t entry = 0; entry < 58U * row; entry += 97) {
        const Correction kept = table.rows[row - 1][entry];
        table.rows[row - 1][entry] = {static_cast<std::int16_t>(kept[0] + 2 * cell_units), kept[1]};
        EXPECT_LT(proof_of_row(table, row).squared_distance, table.proofs[row - 1].squared_distance);
        table.rows[row - 1][entry] = kept;
    }
    EXPECT_EQ(proof_of_row(table, row).squared_distance, table.proofs[row - 1].squared_distance);
}

/// One row of hexominoes, of which a whole table takes a minute.
TEST(PolyominoTables, ProveRowsOfHexominoes)
{
    const Neighbourhoods unordered = neighbourhoods_of(division_rule(Polyomino::G));
    PolyominoTable table;
    table.neighbourhoods = with_children_in_order(unordered, farthest_children(unordered));
    table.rows.resize(81);
    table.proofs.resize(81);
    constexpr std::uint32_t row = 20;
    table.rows[row - 1] = relaxed_row({table.neighbourhoods, 1, row}, frequencies_of(table.neighbourhoods));
    table.proofs[row - 1] = proof_of_row(table, row);
    EXPECT_GT(proven_relative_radius(table, row), 0.78);
    const PolyominoTorus torus(table, 6, 1, 0);
    ASSERT_EQ(table.proofs[row - 1].divisions, 2U);
    EXPECT_GE(counted_distance(torus, 2, row), static_cast<std::int64_t>(table.proofs[row - 1].squared_distance));
}

TEST(PolyominoTables, AreTheSameForAnyNumberOfThreads)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const PolyominoTable again = build_polyomino_table(Polyomino::P);
    EXPECT_EQ(again.rows, p_table().rows);
    for (std::size_t i = 0; i < again.proofs.size(); ++i)
        EXPECT_EQ(again.proofs[i].squared_distance, p_table().proofs[i].squared_distance);
}

TEST(PolyominoTables, AreReadAsTheyWereWritten)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "p.table";
    EXPECT_FALSE(read_polyomino_table(file));
    write_polyomino_table(file, p_table());
    const auto read = read_polyomino_table(file);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->rows, p_table().rows);
    EXPECT_EQ(proven_relative_radius(*read, 11), proven_relative_radius(p_table(), 11));
    EXPECT_EQ(read->neighbourhoods.next, p_table().neighbourhoods.next);
    EXPECT_EQ(read->neighbourhoods.collars, p_table().neighbourhoods.collars);
    EXPECT_EQ(read->neighbourhoods.rule.children, p_table().neighbourhoods.rule.children);
    std::fstream damaged(file, std::ios::in | std::ios::out | std::ios::binary);
    damaged.seekp(1000);
    damaged.put('\x55').put('\x55').put('\x55').put('\x55');
    damaged.close();
    EXPECT_FALSE(read_polyomino_table(file));
    std::filesystem::resize_file(file, 3);
    EXPECT_FALSE(read_polyomino_table(file));
}

/// The distance that is proven of tiles with few known ancestors is less, but not by much, and holds for tori that were
/// divided as often as the first level asks for.
TEST(PolyominoTables, ProveRowsOfTilesThatWereDividedLessOften)
{
    const PolyominoTable& table = p_table();
    int less = 0;
    for (std::uint32_t row = 1; row <= table.last_row(); ++row) {
        const RowProof& proof = table.proofs[row - 1];
        EXPECT_LE(proof.squared_distance_before, proof.squared_distance);
        EXPECT_EQ(proof.squared_distance_after(proof.divisions), proof.squared_distance);
        if (proof.divisions == 5) {
            EXPECT_EQ(proof.squared_distance_before, proof.squared_distance) << "row " << row;
            continue;
        }
        EXPECT_EQ(proof.squared_distance_after(proof.divisions - 1), proof.squared_distance_before);
        less += proof.squared_distance_before < proof.squared_distance;
        EXPECT_GT(static_cast<double>(proof.squared_distance_before),
                  0.4 * static_cast<double>(proof.squared_distance));
        for (std::uint32_t realization = 0; realization < 3; ++realization)
            EXPECT_GE(counted_distance(PolyominoTorus(table, 5, 1, realization), 5, row),
                      static_cast<std::int64_t>(proof.squared_distance_before));
    }
    RecordProperty("rows of which less is proven", less);
}

/// All pairs of tiles that tori have at some distance are among those that tilings may have.
TEST(PolyominoTables, KnowAllPairsThatTilingsHave)
{
    const Neighbourhoods& all = p_table().neighbourhoods;
    constexpr std::int64_t reach = 6;
    const std::vector<NearTiles> pairs = pairs_within(all, reach);
    EXPECT_TRUE(std::ranges::is_sorted(pairs));
    const PolyominoTorus torus(p_table(), 10, 8, 0);
    const std::vector<Pose>& tiles = torus.first_tiles();
    const std::vector<std::uint32_t>& classes = torus.first_classes();
    const LatticePlace sum = centroid_sum(all.rule.shape);
    std::size_t seen = 0, missing = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        for (std::size_t j = 0; j < tiles.size(); ++j) {
            const Pose pose = seen_from(tiles[i], tiles[j]);
            const LatticePlace step = turned(pose.turn, sum) - sum + 10 * pose.shift; // in tenths of a cell
            if (i == j || step.x * step.x + step.y * step.y > 100 * reach * reach) continue;
            ++seen;
            missing += !std::ranges::binary_search(pairs, NearTiles{classes[i], classes[j], pose});
        }
    EXPECT_GT(seen, 10'000U);
    EXPECT_EQ(missing, 0U);
}

/// Any number of points, exactly; their distance is at least what is proven of them.
TEST(PolyominoPoints, AreAsManyAsAskedFor)
{
    const PolyominoTorus torus(p_table(), 5, 3, 1);
    EXPECT_EQ(torus.counts().roots, 5U);
    for (const std::size_t points :
         {std::size_t{1}, std::size_t{50}, std::size_t{777}, std::size_t{1601}, std::size_t{6000}}) {
        const PointSet set = polyomino_points(torus, points);
        ASSERT_EQ(set.size(), points);
        for (const double c : set.coordinates) EXPECT_TRUE(c >= 0 && c < 1);
        const double proven = proven_distance(torus, points);
        if (points == 1) continue; // it has no distance
        EXPECT_GE(test::brute_force_min_distance(set), proven * (1 - 1e-12));
        // The row has 0.75, of which a set without a sixth of its points has less; of few points a row has more than
        // are asked for.
        EXPECT_GT(relative_radius(proven, points, 2), points > 1600 ? 0.67 : points > 320 ? 0.45 : 0.2);
    }
}

/// Values are numbers of tiles: all tiles of a level have one, and those of the first M/16 of all values are the tiles
/// whose last two digits are below M, in each of their second ancestors.
TEST(PolyominoPoints, HaveTilesOfTheirOwn)
{
    const PolyominoTorus torus(p_table(), 5, 2, 0);
    const std::uint32_t level = torus.counts().least_level;
    std::set<Pose> tiles;
    std::vector<std::size_t> numbers(16);
    for (std::uint64_t value = 0; value < torus.counts().tiles(level); ++value) {
        const LevelTile tile = torus.tile(value, level);
        tiles.insert(tile.pose);
        EXPECT_EQ(tile.number, value / (torus.counts().tiles(level) / 16));
        ++numbers[tile.number];
    }
    EXPECT_EQ(tiles.size(), torus.counts().tiles(level));
    EXPECT_THAT(numbers, ::testing::Each(torus.counts().tiles(level) / 16));
}

/// A tile's first child has its value one level on, and lies in it.
TEST(PolyominoPoints, StayWithTheirValueWhenTilesAreDivided)
{
    const PolyominoTorus torus(p_table(), 10, 2, 0);
    const std::uint32_t level = torus.counts().least_level;
    for (std::uint64_t value = 0; value < torus.counts().tiles(level); value += 37) {
        const Pose parent = torus.tile(value, level).pose;
        EXPECT_EQ(torus.tile(value, level + 1).pose, p_table().neighbourhoods.rule.child(parent, 0));
    }
}

/// A constant density gives the points that no density gives. Where two densities are equal, points are, whatever the
/// densities are elsewhere.
TEST(PolyominoPoints, DependOnTheDensityAtTheirPlaceAlone)
{
    const PolyominoTorus torus(p_table(), 10, 4, 0);
    const Density even = density_of_values(1, 1, {1}, "one"), half = density_of_formula("x < 0 ? 1 : 0", 1, 1);
    const PointSet all = polyomino_points(torus, 3000);
    EXPECT_EQ(polyomino_points(torus, 3000, even), all);
    std::set<std::pair<double, double>> left, expected;
    for (const auto& [set, into] : {std::pair{polyomino_points(torus, 1500, half), &left}, std::pair{all, &expected}})
        for (std::size_t i = 0; i < set.size(); ++i)
            if (set[i][0] > 0.05 && set[i][0] < 0.45) into->emplace(set[i][0], set[i][1]); // away from the edge
    EXPECT_EQ(left, expected);
    EXPECT_GT(left.size(), 1000U);
}

/// Counts in parts of the torus against the integral of the density there.
TEST(PolyominoPoints, FollowADensity)
{
    const PolyominoTorus torus(p_table(), 10, 5, 0);
    const Density ramp = density_of_formula("x + 1", 1, 1);
    constexpr std::size_t points = 20'000;
    const PointSet set = polyomino_points(torus, points, ramp);
    std::array<double, 8> counts{};
    for (std::size_t i = 0; i < set.size(); ++i) ++counts[static_cast<std::size_t>(8 * set[i][0])];
    EXPECT_NEAR(static_cast<double>(set.size()), points, 0.01 * points);
    for (std::size_t i = 0; i < 8; ++i) { // the integral of 2 x over an eighth
        const double expected = points * (2 * static_cast<double>(i) + 1) / 64;
        EXPECT_NEAR(counts[i], expected, 3 * std::sqrt(expected)) << i; // blue noise stays well within
    }
}

}
}
