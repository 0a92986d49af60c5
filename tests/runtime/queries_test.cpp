// Windows and nearest points of runtime/poisson_tiles.h against all points of the tiles around.
#include "tests/runtime/tile_set_cases.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace poissonlab {
namespace {

using Position = std::array<double, 3>;

/// All points of the tiles from `first` to `last`, rows from south to north.
std::vector<ptiles_point> points_of(const ptiles_tiling& tiling, std::array<std::int32_t, 3> first,
                                    std::array<std::int32_t, 3> last)
{
    std::vector<ptiles_point> points;
    for (std::int32_t k = first[2]; k <= last[2]; ++k)
        for (std::int32_t j = first[1]; j <= last[1]; ++j)
            for (std::int32_t i = first[0]; i <= last[0]; ++i) {
                const std::int32_t tile[] = {i, j, k};
                const std::uint16_t* units = ptiles_points(&tiling.set, ptiles_tile(&tiling, i, j, k));
                for (std::uint32_t n = 0; n < tiling.set.points_per_tile; ++n)
                    points.push_back(ptiles_point_at(&tiling, tile, n, units + n * tiling.set.dimension));
            }
    return points;
}

std::array<std::int32_t, 3> tiles_around(const Position& position, std::int32_t reach, std::uint32_t dimension)
{
    std::array<std::int32_t, 3> tile{};
    for (std::size_t axis = 0; axis < dimension; ++axis)
        tile[axis] = static_cast<std::int32_t>(std::floor(position[axis])) + reach;
    return tile;
}

double squared_distance(const ptiles_point& point, const Position& position, std::uint32_t dimension)
{
    double sum = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis)
        sum += (point.position[axis] - position[axis]) * (point.position[axis] - position[axis]);
    return sum;
}

void expect_same(const ptiles_point& a, const ptiles_point& b)
{
    EXPECT_EQ(std::to_array(a.position), std::to_array(b.position));
    EXPECT_EQ(std::to_array(a.tile), std::to_array(b.tile));
    EXPECT_EQ(a.index, b.index);
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.level, b.level);
}

constexpr PoissonTiling query_tilings[] = {{1, 0}, {2, 3}, {3, 1}};

TEST(Window, HasThePointsInIt)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> low(-3, 3);
    std::uniform_real_distribution<double> size(0, 2.5);
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        for (int n = 0; n < 20; ++n) {
            const ptiles_tiling tiling = runtime_tiling(set, query_tilings[n % 3]);
            const std::uint32_t dimension = tiling.set.dimension;
            const Position from{low(random), low(random), low(random)};
            const Position to{from[0] + size(random), from[1] + size(random), from[2] + size(random)};
            auto expected = points_of(tiling, tiles_around(from, -1, dimension), tiles_around(to, 1, dimension));
            std::erase_if(expected, [&](const ptiles_point& point) {
                bool inside = true;
                for (std::size_t axis = 0; axis < dimension; ++axis)
                    inside = inside && point.position[axis] >= from[axis] && point.position[axis] < to[axis];
                return !inside;
            });
            std::vector<ptiles_point> found(expected.size() + 1);
            ASSERT_EQ(ptiles_in_window(&tiling, from.data(), to.data(), found.data(), found.size(), 1),
                      expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) expect_same(found[i], expected[i]);
            // Points that there is no room for are counted.
            ASSERT_EQ(ptiles_in_window(&tiling, from.data(), to.data(), nullptr, 0, 1), expected.size());
        }
    }
}

/// At any density a window has the points that the full one has, but for those of higher levels; levels are the ranks
/// of a tile, or where there are none, the bits of the point.
TEST(Window, GetsSparserByLevels)
{
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        const ptiles_tiling tiling = runtime_tiling(set, {4, 0});
        const std::uint32_t n = set.parameters.points_per_tile;
        const Position low{-1.3, 0.4, -0.2}, high{1.5, 2.9, 1.1};
        std::vector<ptiles_point> all(ptiles_in_window(&tiling, low.data(), high.data(), nullptr, 0, 1));
        ptiles_in_window(&tiling, low.data(), high.data(), all.data(), all.size(), 1);
        for (const ptiles_point& point : all) {
            const std::uint32_t tile = ptiles_tile(&tiling, point.tile[0], point.tile[1], point.tile[2]);
            EXPECT_EQ(point.level,
                      set.parameters.ranked ? (set.ranks[tile * n + point.index] + 0.5) / n : point.id / 4294967296.0);
        }
        for (const double density : {-1.0, 0.0, 0.5 / n, 0.3, 1.5 / n, 0.5, 0.999, 1.0, 2.0}) {
            std::vector<ptiles_point> kept(all.size());
            kept.resize(ptiles_in_window(&tiling, low.data(), high.data(), kept.data(), kept.size(), density));
            std::vector<ptiles_point> expected = all;
            std::erase_if(expected, [&](const ptiles_point& point) { return point.level >= density; });
            ASSERT_EQ(kept.size(), expected.size()) << name_of(set) << " at the density " << density;
            for (std::size_t i = 0; i < kept.size(); ++i) expect_same(kept[i], expected[i]);
        }
    }
}

TEST(Window, IsHalfOpen)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, 1, 1);
    set.points = {0, 32768};
    const ptiles_tiling tiling = runtime_tiling(set, {});
    const double low[] = {-2, -0.5};
    const double high[] = {1, 1.5};
    ptiles_point points[9];
    ASSERT_EQ(ptiles_in_window(&tiling, low, high, points, 9, 1), 6u);
    EXPECT_EQ(points[0].position[0], -2);
    EXPECT_EQ(points[0].position[1], -0.5);
    EXPECT_EQ(points[5].position[0], 0);
    EXPECT_EQ(points[5].position[1], 0.5);
}

TEST(NearestPoint, IsThatOfAllAround)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> somewhere(-20, 20);
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        for (int n = 0; n < 200; ++n) {
            const ptiles_tiling tiling = runtime_tiling(set, query_tilings[n % 3]);
            const std::uint32_t dimension = tiling.set.dimension;
            Position position{somewhere(random), somewhere(random), somewhere(random)};
            if (n % 10 == 0) position = {std::floor(position[0]), std::floor(position[1]), std::floor(position[2])};
            constexpr std::int32_t reach = 2;
            double expected = reach;
            for (const ptiles_point& point :
                 points_of(tiling, tiles_around(position, -reach, dimension), tiles_around(position, reach, dimension)))
                expected = std::min(expected, squared_distance(point, position, dimension));
            ptiles_point nearest;
            const double squared = ptiles_nearest(&tiling, position.data(), &nearest);
            EXPECT_NEAR(squared, expected, 1e-13) << name_of(set);
            EXPECT_NEAR(squared_distance(nearest, position, dimension), expected, 1e-13);
            expect_same(nearest,
                        points_of(tiling, std::to_array(nearest.tile), std::to_array(nearest.tile))[nearest.index]);
        }
    }
}

/// One point a tile, as far as can be from the corner that is asked for.
TEST(NearestPoint, IsFoundTilesAway)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::frame, 2, 1, 1, 1);
    set.points = {65535, 0};
    const ptiles_tiling tiling = runtime_tiling(set, {});
    const double position[] = {0.25, 0.999};
    ptiles_point nearest;
    EXPECT_NEAR(ptiles_nearest(&tiling, position, &nearest), 0.25 * 0.25 + 1e-6, 1e-5);
    EXPECT_EQ(nearest.tile[0], -1);
    EXPECT_EQ(nearest.tile[1], 1);
}

TEST(PointIds, AreOnePerPointAndRepeatWithThePeriod)
{
    const PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, 4, 64);
    const ptiles_tiling tiling = runtime_tiling(set, {1, 10});
    std::set<std::uint32_t> ids;
    const auto points = points_of(tiling, {0, 0, 0}, {9, 9, 0});
    for (const ptiles_point& point : points) ids.insert(point.id);
    EXPECT_EQ(ids.size(), points.size());
    const auto repeated = points_of(tiling, {-10, 20, 0}, {-1, 29, 0});
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].id, repeated[i].id);
}

}
}
