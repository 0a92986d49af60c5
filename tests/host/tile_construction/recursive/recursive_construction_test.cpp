// The construction of recursive Wang tiles: sets with points that are there already, borders that are shared, and
// distances over all tiles that may lie beside each other.
#include "host/tile_construction/recursive/recursive_construction.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t few = 128;

/// One set for all tests: building takes half a second.
const RecursiveTileSet& small_recursive_set()
{
    static const RecursiveTileSet set = build_recursive_tiles(few, 1);
    return set;
}

TEST(ForcedDarts, AreRelaxationDartsWhereNoneAreForced)
{
    const StreamKey stream = stream_key(3, Purpose::recursive_tile_darts, 0);
    RelaxationDartThrowingRequest request;
    request.points = 200;
    request.stream = stream;
    const PointSet expected = reference::throw_relaxation_darts(request).points;
    const auto darts = throw_darts_around(200, {}, 0, stream);
    for (std::size_t i = 0; i < 200; ++i)
        for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(darts[i].place[k] * 0x1p-32, expected[i][k]);
}

TEST(ForcedDarts, TakeTheirTurnAndTheirPlace)
{
    const double spacing = max_min_distance(300, 2);
    const auto forced =
        darts_near_corner(throw_darts_around(300, {}, 0, stream_key(1, Purpose::recursive_tile_darts, 0)), 3 * spacing);
    ASSERT_GT(forced.size(), 15U);
    const auto darts = throw_darts_around(300, forced, 2 * spacing, stream_key(1, Purpose::recursive_tile_darts, 1));
    for (const ForcedDart& each : forced) EXPECT_EQ(darts[each.rank], each.dart);
    std::size_t near = 0;
    for (std::size_t i = 0; i < darts.size(); ++i) {
        near += squared_distance<2>(darts[i].place, {0, 0}) < squared_threshold(2 * spacing);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(squared_distance<2>(darts[i].place, darts[j].place), darts[i].squared_distance) << i << " " << j;
    }
    EXPECT_EQ(near, static_cast<std::size_t>(std::ranges::count_if(forced, [&](const ForcedDart& each) {
                  return squared_distance<2>(each.dart.place, {0, 0}) < squared_threshold(2 * spacing);
              })));
}

/// The points of a tile in the strip of a side, and at least four spacings away from its ends.
std::vector<RecursivePlace> strip(const std::vector<RankedPlace>& tile, TileSide side, double spacing)
{
    std::vector<RecursivePlace> points;
    for (const RankedPlace& point : tile) {
        const double x = point.place[0] * 0x1p-32, y = point.place[1] * 0x1p-32;
        const double inward = side == TileSide::north   ? 1 - y
                              : side == TileSide::east  ? 1 - x
                              : side == TileSide::south ? y
                                                        : x;
        const double along = side == TileSide::north || side == TileSide::south ? x : y;
        if (inward < own_strip * spacing && std::min(along, 1 - along) > 4 * spacing) points.push_back(point.place);
    }
    std::ranges::sort(points);
    return points;
}

/// A strip half a spacing wide is that of the edge's colour in every tile that has it, and another one for the other.
TEST(EdgeMerging, GivesTilesTheStripsOfTheirColours)
{
    const auto tiles = merged_recursive_tiles(512, 2);
    const double spacing = max_min_distance(512, 2);
    int compared = 0;
    for (std::size_t a = 0; a < even_wang_tiles; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const WangTile first = wang_colors_of(a), second = wang_colors_of(b);
            const auto compare = [&](bool same, TileSide side) {
                const bool are_equal = strip(tiles[a], side, spacing) == strip(tiles[b], side, spacing);
                EXPECT_EQ(are_equal, same) << a << " " << b;
                ++compared;
            };
            compare(first.north == second.north, TileSide::north);
            compare(first.east == second.east, TileSide::east);
            compare(first.south == second.south, TileSide::south);
            compare(first.west == second.west, TileSide::west);
        }
    EXPECT_EQ(compared, 4 * 28);
}

TEST(EdgeMerging, KeepsEachPointOnceAndTheDensity)
{
    for (const auto& tile : merged_recursive_tiles(512, 2)) {
        std::vector<RecursivePlace> places;
        for (const RankedPlace& point : tile) places.push_back(point.place);
        std::ranges::sort(places);
        EXPECT_EQ(std::ranges::adjacent_find(places), places.end());
        EXPECT_NEAR(static_cast<double>(tile.size()), 560, 20);
    }
}

/// Brute force, in the words of the definition: a point comes when it fits.
TEST(MendedOrder, LetsPointsWaitUntilTheyFit)
{
    std::vector<RankedPlace> points;
    const auto darts = throw_darts_around(400, {}, 0, stream_key(5, Purpose::recursive_tile_darts, 0));
    for (std::uint32_t i = 0; i < 400; ++i) points.push_back({i, darts[399 - i].place}); // the worst order
    const auto order = mended_order(points, 200);
    ASSERT_EQ(order.size(), 200U);
    EXPECT_EQ(order[0], points[0].place);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double away = std::hypot(order[i][0] * 0x1p-32 - order[j][0] * 0x1p-32,
                                           order[i][1] * 0x1p-32 - order[j][1] * 0x1p-32);
            EXPECT_GE(away, 0.6 * max_min_distance(i + 1, 2) * (1 - 1e-6));
        }
}

TEST(Divisions, AreOthersForOtherSeedsAndHaveBothColours)
{
    EXPECT_NE(random_divisions(1), random_divisions(2));
    for (std::uint64_t seed = 0; seed < 50; ++seed)
        for (const TileCells& cells : random_divisions(seed)) {
            Color north = 0, west = 0;
            for (std::uint32_t i = 0; i < 4; ++i) {
                north += wang_colors_of(cells[12 + i]).north;
                west += wang_colors_of(cells[4 * i]).west;
            }
            EXPECT_EQ(north, 2U);
            EXPECT_EQ(west, 2U);
        }
}

/// The smallest squared distance, in units of 2^-64, of the first points of two tiles at an offset.
double smallest_distance(const RecursiveTileSet& set, std::size_t tile, std::size_t other, int x, int y,
                         std::uint32_t ranks)
{
    std::int64_t smallest = INT64_MAX;
    for (std::uint32_t i = 0; i < ranks; ++i)
        for (std::uint32_t j = 0; j < ranks; ++j) {
            if (x == 0 && y == 0 && i == j) continue;
            const RecursivePlace a = set.place(tile, i), b = set.place(other, j);
            // Half units, so that squares fit.
            const std::int64_t dx = (std::int64_t{b[0]} - a[0] + x * (std::int64_t{1} << 32)) / 2,
                               dy = (std::int64_t{b[1]} - a[1] + y * (std::int64_t{1} << 32)) / 2;
            if (std::abs(dx) < std::int64_t{1} << 30 && std::abs(dy) < std::int64_t{1} << 30)
                smallest = std::min(smallest, dx * dx + dy * dy);
        }
    return 2 * std::sqrt(static_cast<double>(smallest)) * 0x1p-32;
}

/// All tiles that may lie at a side or a corner, and every number of points: half of what is possible, as 0.5 is what
/// points keep when they choose, and sub-points do better.
TEST(RecursiveTiles, KeepTheirDistanceInAllTilings)
{
    const RecursiveTileSet& set = small_recursive_set();
    for (const std::uint32_t ranks : {few / 2, few, 2 * few, 4 * few}) {
        double smallest = 1;
        for (std::size_t tile = 0; tile < even_wang_tiles; ++tile)
            for (std::size_t other = 0; other < even_wang_tiles; ++other)
                for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, -1}})
                    if (x == 0 && y == 0 ? tile == other : may_lie_beside(tile, other, x, y))
                        smallest = std::min(smallest, smallest_distance(set, tile, other, x, y, ranks));
        EXPECT_GE(relative_radius(smallest, ranks, 2), ranks <= few ? 0.49 : 0.6) << ranks;
        EXPECT_LE(relative_radius(smallest, ranks, 2), 0.75) << "more than the method gives: is something left out?";
    }
}

/// Rank by rank, the next sub-point is the farthest one from all that may be near: checked for some ranks by looking at
/// all others.
TEST(RecursiveTiles, SubPointsAreTheFarthestOnes)
{
    const RecursiveTileSet& set = small_recursive_set();
    constexpr std::size_t tile = 2;
    for (const std::uint32_t rank : {few, few + 1, 2 * few, 5 * few}) {
        const auto gap = [&](std::uint32_t candidate) {
            double nearest = 1;
            const RecursivePlace a = set.place(tile, candidate);
            for (std::size_t other = 0; other < even_wang_tiles; ++other)
                for (int y = -1; y <= 1; ++y)
                    for (int x = -1; x <= 1; ++x) {
                        const bool is_own = x == 0 && y == 0;
                        if (is_own ? other != tile : !may_lie_beside(tile, other, x, y)) continue;
                        // Tiles before this one have their point of this rank already.
                        const std::uint32_t there = rank + (other < tile ? 1 : 0);
                        for (std::uint32_t i = 0; i < there; ++i) {
                            const RecursivePlace b = set.place(other, i);
                            nearest = std::min(nearest, std::hypot((double{1} * b[0] - a[0]) * 0x1p-32 + x,
                                                                   (double{1} * b[1] - a[1]) * 0x1p-32 + y));
                        }
                    }
            return nearest;
        };
        const double chosen = gap(rank);
        for (std::uint32_t later = rank + 1; later < recursive_cells * few; later += 7)
            EXPECT_LE(gap(later), chosen * (1 + 1e-9)) << rank << " " << later;
    }
}

TEST(RecursiveTiles, AreTheSameOnAnyNumberOfThreads)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(build_recursive_tiles(few, 1), small_recursive_set());
    EXPECT_NE(build_recursive_tiles(few, 2), small_recursive_set());
}

TEST(RecursiveTiles, EndWhereTheyAreToldTo)
{
    EXPECT_THROW(build_recursive_tiles(few, 1, [](const std::string&) { throw std::runtime_error("enough"); }),
                 std::runtime_error);
}

}
}
