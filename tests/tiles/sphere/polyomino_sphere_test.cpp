// Points of polyominoes on the sphere: their tiling, counts, order, and the proven distance against every pair.
#include "tiles/sphere/polyomino_sphere.hpp"

#include "tests/support/polyomino_tables.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace poissonlab {
namespace {

using test::p_table;

double cosine(const UnitVector& a, const UnitVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double angle(const UnitVector& a, const UnitVector& b)
{
    return 2 * std::asin(std::min(1.0, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / 2));
}

std::vector<UnitVector> directions(const std::vector<SpherePlace>& places)
{
    std::vector<UnitVector> all;
    for (const SpherePlace& place : places) all.push_back(direction_of(place));
    return all;
}

/// The eight vertices of three squares: at the latitude of the caps' borders.
std::vector<UnitVector> vertices_of_three()
{
    std::vector<UnitVector> vertices;
    for (int i = 0; i < 8; ++i) {
        const double z = i < 4 ? 2 / 3.0 : -2 / 3.0, turn = std::numbers::pi / 2 * i;
        vertices.push_back({std::sqrt(5) / 3 * std::cos(turn), std::sqrt(5) / 3 * std::sin(turn), z});
    }
    return vertices;
}

TEST(PolyominoSphere, TilesCoverEachCellOnce)
{
    for (std::uint32_t realization = 0; realization < 10; ++realization) {
        const PolyominoSphere sphere(p_table(), 1, realization);
        EXPECT_EQ(sphere.counts().roots, 60U);
        EXPECT_EQ(sphere.first_tiles().size(), 60U * 64);
        std::vector<int> cells(sphere.first_tiles().size());
        for (std::uint32_t square = 0; square < 12; ++square)
            for (int i = 0; i < 1600; ++i)
                ++cells[sphere.first_tile_at({square, (i % 40 + 0.5) / 40, (static_cast<double>(i / 40) + 0.5) / 40})];
        EXPECT_THAT(cells, testing::Each(5));
        const std::set<std::uint32_t> roots(sphere.order().begin(), sphere.order().end());
        EXPECT_EQ(roots.size(), 60U);
    }
}

/// Only tiles at vertices of three squares have neighbourhoods that no plane has; a tile of the first level is 3 cells
/// long, and cells are a 40th of a square's side.
TEST(PolyominoSphere, NeighbourhoodsAreThoseOfThePlaneButAtEightVertices)
{
    for (std::uint32_t realization = 0; realization < 10; ++realization) {
        const PolyominoSphere sphere(p_table(), 1, realization);
        EXPECT_GT(sphere.strange_tiles().size(), 0U);
        EXPECT_LE(sphere.strange_tiles().size(), 8 * 6U);
        for (int square = 0; square < 12; ++square)
            for (int i = 0; i < 1600; ++i) {
                const HealpixPlace place{static_cast<std::uint32_t>(square), (i % 40 + 0.5) / 40,
                                         (static_cast<double>(i / 40) + 0.5) / 40};
                const std::uint32_t tile = sphere.first_tile_at(place);
                if (!std::ranges::binary_search(sphere.strange_tiles(), tile)) continue;
                double nearest = 4;
                for (const UnitVector& vertex : vertices_of_three())
                    nearest = std::min(nearest, angle(vertex, direction_of(sphere_place(place))));
                EXPECT_LT(nearest, 6 / 40.0 * std::numbers::pi / 3 / least_healpix_stretch());
            }
    }
}

/// Points away from the eight vertices keep the proven distance. The least one is no more than 1.8 times it: places
/// where the map squeezes most are few.
TEST(PolyominoSphere, KeepsTheProvenDistance)
{
    for (const std::size_t points : {3840U, 5000U, 7680U, 11'000U}) {
        const PolyominoSphere sphere(p_table(), 3, 0);
        const auto all = directions(polyomino_points(sphere, points));
        ASSERT_EQ(all.size(), points);
        const double proven = proven_distance(sphere, points) * least_healpix_stretch();
        const double around = 8 * std::sqrt(4 * std::numbers::pi / static_cast<double>(points));
        const auto vertices = vertices_of_three();
        const auto is_away = [&](const UnitVector& v) {
            return std::ranges::all_of(vertices, [&](const UnitVector& of) { return angle(v, of) > around; });
        };
        double least = 4;
        for (std::size_t i = 0; i < points; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                if (cosine(all[i], all[j]) < 0.99) continue;
                if (is_away(all[i]) && is_away(all[j])) least = std::min(least, angle(all[i], all[j]));
            }
        EXPECT_GE(least, proven);
        EXPECT_LT(least, 1.8 * proven);
    }
}

/// Realizations differ, the same one does not, and its points are spread over the sphere from the first on: each of the
/// 12 squares has nearly as many as the others, of whatever number.
TEST(PolyominoSphere, AnyNumberOfPointsIsSpread)
{
    const PolyominoSphere sphere(p_table(), 1, 0), again(p_table(), 1, 0), other(p_table(), 1, 1);
    EXPECT_EQ(sphere.first_tiles(), again.first_tiles());
    EXPECT_EQ(sphere.order(), again.order());
    EXPECT_NE(sphere.first_tiles(), other.first_tiles());
    EXPECT_THAT(polyomino_points(sphere, 0), testing::IsEmpty());
    for (const std::size_t points : {1U, 2U, 3U, 12U, 40U, 61U, 90U, 1000U, 4097U}) {
        const auto places = polyomino_points(sphere, points);
        ASSERT_EQ(places.size(), points);
        std::vector<double> counts(12);
        for (const SpherePlace& place : places) ++counts[healpix_place(place).square];
        const double mean = static_cast<double>(points) / 12;
        for (const double count : counts) EXPECT_NEAR(count, mean, 1.5 * std::sqrt(mean) + 1.5) << points;
    }
    const auto all = polyomino_points(sphere, 61'440U);
    std::vector<int> counts(12);
    for (const SpherePlace& place : all) ++counts[healpix_place(place).square];
    for (const int count : counts) EXPECT_NEAR(count, 5120, 100); // tiles on borders: 4 x 160 cells, a fifth of them
}

/// A density over the sphere: a hemisphere with three times the points of the other one, and the same everywhere.
TEST(PolyominoSphere, PointsFollowADensity)
{
    const PolyominoSphere sphere(p_table(), 5, 0);
    const auto set =
        polyomino_points(sphere, 30'000, [](const SpherePlace& place) { return place.z > 0 ? 30'000.0 : 10'000.0; });
    const auto above = std::ranges::count_if(set, [](const SpherePlace& place) { return place.z > 0; });
    // Tiles that the equator crosses: some 4 x 5 x 32 of them at the finest level, each off by less than one half.
    EXPECT_NEAR(static_cast<double>(above), 15'000, 200);
    EXPECT_NEAR(static_cast<double>(set.size()), 20'000, 200);
    const auto even = polyomino_points(sphere, 5000, [](const SpherePlace&) { return 5000.0; });
    const auto plain = polyomino_points(sphere, 5000);
    ASSERT_EQ(even.size(), plain.size());
    for (std::size_t i = 0; i < even.size(); ++i) EXPECT_EQ(even[i].z, plain[i].z);
    EXPECT_THAT(polyomino_points(sphere, 100, [](const SpherePlace&) { return 0.0; }), testing::IsEmpty());
}

/// Hexominoes, which are divided into 81, as well. Tables of theirs take long to build, and no point is asked for.
TEST(PolyominoSphere, HexominoesCoverTheSphere)
{
    PolyominoTable table;
    table.neighbourhoods = neighbourhoods_of(division_rule(Polyomino::G));
    const PolyominoSphere sphere(table, 1, 0);
    EXPECT_EQ(sphere.counts().roots, 18U);
    std::vector<int> cells(sphere.first_tiles().size());
    for (std::uint32_t square = 0; square < 12; ++square)
        for (int i = 0; i < 27 * 27; ++i)
            ++cells[sphere.first_tile_at({square, (i % 27 + 0.5) / 27, (static_cast<double>(i / 27) + 0.5) / 27})];
    EXPECT_THAT(cells, testing::Each(6));
}

}
}
