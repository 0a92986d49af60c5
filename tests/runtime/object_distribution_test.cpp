// runtime/object_distribution.h against ptiles_nearest, which looks at every point, and its numbers against statistics.
#include "runtime/object_distribution.h"

#include "tests/runtime/tile_set_cases.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

constexpr int place_count = 4000;

/// The radius of disks in a tiling of random tiles: half the smallest distance of points around.
double half_distance(const ptiles_tiling& tiling)
{
    double least = 1e300;
    const double low[3] = {-6, -6, -6}, high[3] = {6, 6, 6};
    std::vector<ptiles_point> points(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
    ptiles_in_window(&tiling, low, high, points.data(), points.size(), 1);
    points.resize(std::min<std::size_t>(points.size(), 6000));
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            double sum = 0;
            for (std::size_t a = 0; a < tiling.set.dimension; ++a)
                sum +=
                    (points[i].position[a] - points[k].position[a]) * (points[i].position[a] - points[k].position[a]);
            least = std::min(least, sum);
        }
    return std::sqrt(least) / 2;
}

/// Expects the object at a place to be the nearest point, its distance to the last bit.
void expect_nearest(const pobjects& objects, const double* at, pobjects_cursor* cursor)
{
    ptiles_point nearest;
    const double squared = ptiles_nearest(&objects.tiling, at, &nearest);
    const pobjects_object object = pobjects_at(&objects, at, cursor);
    ASSERT_EQ(object.squared, squared);
    ASSERT_EQ(object.point.index, nearest.index);
    ASSERT_TRUE(std::equal(nearest.tile, nearest.tile + 3, object.point.tile));
    ASSERT_EQ(object.point.id, nearest.id);
    ASSERT_EQ(object.inside, squared < objects.radius * objects.radius);
    double sum = 0;
    for (std::size_t a = 0; a < objects.tiling.set.dimension; ++a) {
        ASSERT_EQ(object.point.position[a], nearest.position[a]);
        ASSERT_NEAR(object.offset[a], at[a] - nearest.position[a], 1e-9);
        sum += object.offset[a] * object.offset[a];
    }
    ASSERT_NEAR(sum, squared, 1e-9);
}

/// Everywhere, near points, at exact ties on the grid of stored numbers, with the cursor and without.
TEST(ObjectDistribution, FindsTheNearestPoint)
{
    for (const PoissonTileSet& set : tile_sets_of_every_kind())
        for (const PoissonTiling& choice : {PoissonTiling{1, 0}, PoissonTiling{0x89abcdef, 6}, PoissonTiling{3, 1}}) {
            const ptiles_tiling tiling = runtime_tiling(set, choice);
            std::vector<std::uint16_t> sorted(pobjects_size(&tiling.set));
            pobjects_sort(&tiling.set, sorted.data());
            // Random tiles promise no distance: a radius of 0 never ends the search early.
            const pobjects objects = pobjects_open(&tiling, sorted.data(), 0);
            pobjects_cursor cursor{};
            std::mt19937 random(2);
            for (int i = 0; i < place_count; ++i) {
                double at[3];
                for (double& x : at)
                    x = i % 3 == 0 ? static_cast<double>(random() % 64) / 16 - 2
                                   : (static_cast<double>(random()) / 0x1p32 - 0.5) * (i % 3 == 1 ? 8 : 1e6);
                ASSERT_NO_FATAL_FAILURE(expect_nearest(objects, at, i % 2 == 0 ? &cursor : nullptr)) << i;
            }
        }
}

/// The cursor remembers the last object: along rows over several tiles, on the grid of stored numbers and off it, and
/// where a row ends far from the next one.
TEST(ObjectDistribution, FindsTheNearestPointAlongRows)
{
    for (const PoissonTileSet& set : tile_sets_of_every_kind())
        for (const PoissonTiling& choice : {PoissonTiling{1, 0}, PoissonTiling{3, 1}}) {
            const ptiles_tiling tiling = runtime_tiling(set, choice);
            std::vector<std::uint16_t> sorted(pobjects_size(&tiling.set));
            pobjects_sort(&tiling.set, sorted.data());
            // The radius is 0, or that within which there is no second point anywhere around.
            const double apart = choice.period == 1 ? half_distance(tiling) : 0;
            const pobjects objects = pobjects_open(&tiling, sorted.data(), apart);
            pobjects_cursor cursor{};
            for (const double step : {1.0 / 32, 0.013})
                for (int row = 0; row < 12; ++row)
                    for (int i = 0; i < 160; ++i) {
                        const double at[3] = {(row % 3 == 0 ? 1000 : -1) + i * step, row * 0.125 - 1, row * 0.0625};
                        ASSERT_NO_FATAL_FAILURE(expect_nearest(objects, at, &cursor)) << row << " " << i;
                    }
        }
}

/// A search that ends at the first point within the radius finds the same: there is only one.
TEST(ObjectDistribution, EndsAtTheOnlyPointInReach)
{
    const PoissonTileSet set = random_tile_set(PoissonTileKind::frame, 2, 1, 4, 13); // one tile: the window knows all
    const ptiles_tiling tiling = runtime_tiling(set, {1, 0});
    std::vector<std::uint16_t> sorted(pobjects_size(&tiling.set));
    pobjects_sort(&tiling.set, sorted.data());
    const double radius = half_distance(tiling);
    const pobjects objects = pobjects_open(&tiling, sorted.data(), radius);
    std::mt19937 random(2);
    int inside = 0;
    for (int i = 0; i < place_count; ++i) {
        const double at[3] = {static_cast<double>(random()) / 0x1p30, static_cast<double>(random()) / 0x1p30, 0};
        ptiles_point nearest;
        const double squared = ptiles_nearest(&tiling, at, &nearest);
        const pobjects_object object = pobjects_at(&objects, at, nullptr);
        ASSERT_EQ(object.point.id, nearest.id);
        ASSERT_EQ(object.inside, squared < radius * radius);
        inside += object.inside;
    }
    EXPECT_GT(inside, 0);
}

/// Mean and variance of uniform and normal numbers over identities: 1/2, 1/12; 0, 1. Tolerances are four standard
/// errors.
TEST(ObjectDistribution, HasNumbersOfTheirDistributions)
{
    constexpr int count = 20'000;
    double uniform = 0, uniform_squares = 0, normal = 0, normal_squares = 0, beyond = 0;
    for (std::uint32_t id = 0; id < count; ++id) {
        const double u = pobjects_uniform(id * 2654435761u, 5), n = pobjects_normal(id * 2654435761u, 11);
        uniform += u;
        uniform_squares += (u - 0.5) * (u - 0.5);
        normal += n;
        normal_squares += n * n;
        beyond += std::abs(n) > 1.959964;
    }
    EXPECT_NEAR(uniform / count, 0.5, 4 * std::sqrt(1 / 12.0 / count));
    EXPECT_NEAR(uniform_squares / count, 1 / 12.0, 4 * std::sqrt(1 / 180.0 / count));
    EXPECT_NEAR(normal / count, 0, 4 / std::sqrt(count));
    EXPECT_NEAR(normal_squares / count, 1, 4 * std::sqrt(2.0 / count));
    EXPECT_NEAR(beyond / count, 0.05, 4 * std::sqrt(0.05 * 0.95 / count));
}

/// Turned by a quarter, x of the object is y of the world; an aspect above 1 leaves an ellipse within the disk.
TEST(ObjectDistribution, HasLocalCoordinates)
{
    const ptiles_tiling tiling{};
    const pobjects objects = pobjects_open(&tiling, nullptr, 0.5);
    pobjects_object object{};
    object.offset[1] = 0.2;
    double u[2];
    ASSERT_TRUE(pobjects_local(&objects, &object, 0.8, 0, 1, 1, u));
    EXPECT_DOUBLE_EQ(u[0], 0.5);
    EXPECT_DOUBLE_EQ(u[1], 0);
    EXPECT_FALSE(pobjects_local(&objects, &object, 0.8, 1, 0, 2, u)) << "twice as long along x as along y";
    ASSERT_TRUE(pobjects_local(&objects, &object, 0.8, 1, 0, 0.5, u));
    EXPECT_DOUBLE_EQ(u[1], 0.5);
    EXPECT_FALSE(pobjects_local(&objects, &object, 0.3, 1, 0, 1, u)) << "outside of the disk";
}

}
}
