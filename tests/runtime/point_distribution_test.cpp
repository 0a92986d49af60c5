// runtime/point_distribution.hpp, as Gaffer would call it with Imath's boxes, against all points of the tiles around by
// runtime/poisson_tiles.h, and by the distances of all pairs.
#include "runtime/point_distribution.hpp"
#include "tests/runtime/tile_set_cases.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

using Imath::Box2f;
using Imath::V2f;
using ptiles::PointDistribution;

std::string shipped(const std::string& name) { return source_folder() + "/runtime/tile_sets/" + name + ".ptiles"; }

struct Emitted
{
    float x, y, threshold;

    auto operator<=>(const Emitted&) const = default;
};

std::vector<Emitted> emitted_by(const PointDistribution& distribution, const Box2f& bounds, float density)
{
    std::vector<Emitted> points;
    distribution(bounds, density, [&](const V2f& p, float threshold) { points.push_back({p.x, p.y, threshold}); });
    return points;
}

std::set<std::pair<float, float>> places_of(const std::vector<Emitted>& points)
{
    std::set<std::pair<float, float>> places;
    for (const Emitted& p : points) places.emplace(p.x, p.y);
    return places;
}

/// The ranks of the points of each tile, by the place where the header for engines has them, scaled and rounded.
using RankedPlaces = std::map<std::pair<float, float>, std::pair<std::array<std::int32_t, 2>, std::uint32_t>>;

RankedPlaces all_points(const ptiles_tiling& tiling, std::int32_t first, std::int32_t last, double side)
{
    RankedPlaces places;
    for (std::int32_t j = first; j <= last; ++j)
        for (std::int32_t i = first; i <= last; ++i) {
            const std::int32_t tile[] = {i, j, 0};
            const std::uint16_t* numbers = ptiles_points(&tiling.set, ptiles_tile(&tiling, i, j, 0));
            for (std::uint32_t n = 0; n < tiling.set.points_per_tile; ++n) {
                const ptiles_point p = ptiles_point_at(&tiling, tile, n, numbers + 2 * n);
                const auto rank = static_cast<std::uint32_t>(p.level * tiling.set.points_per_tile);
                places[{static_cast<float>(side * p.position[0]), static_cast<float>(side * p.position[1])}] = {{i, j},
                                                                                                                rank};
            }
        }
    return places;
}

/// A tile has the points of the lowest ranks: as many as the density says, rounded down or up.
void expect_lowest_ranks(const PointDistribution& distribution, const ptiles_tiling& tiling, float density)
{
    const double side = distribution.side_of_tiles(distribution.full_density(density));
    const auto reach = static_cast<float>(6 * side); // whole tiles from -5 to 4, wherever their points are
    const RankedPlaces places = all_points(tiling, -8, 7, side);
    std::map<std::array<std::int32_t, 2>, std::set<std::uint32_t>> ranks;
    for (const Emitted& p : emitted_by(distribution, Box2f(V2f(-reach), V2f(reach)), density)) {
        const auto found = places.find({p.x, p.y});
        ASSERT_NE(found, places.end()) << p.x << ", " << p.y;
        EXPECT_TRUE(ranks[found->second.first].insert(found->second.second).second);
    }
    const double share = density * side * side;
    for (std::int32_t j = -5; j < 5; ++j)
        for (std::int32_t i = -5; i < 5; ++i) {
            const std::set<std::uint32_t>& of_tile = ranks[{i, j}];
            EXPECT_THAT(of_tile.size(), testing::AllOf(testing::Ge(std::floor(share)), testing::Le(std::ceil(share))));
            if (!of_tile.empty()) {
                EXPECT_EQ(*of_tile.rbegin(), of_tile.size() - 1);
            }
        }
}

TEST(PointDistribution, HasTheLowestRanksOfEveryTile)
{
    const TemporaryFolder folder;
    int sets = 0;
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        if (!set.parameters.ranked || set.parameters.dimension != 2) continue;
        SCOPED_TRACE(name_of(set));
        const auto file = folder.path() / "set.ptiles";
        write_tile_set_file(file, set);
        const PointDistribution distribution(file, 0, 9);
        const ptiles_tiling tiling = runtime_tiling(set, {9, 0});
        for (const float density : {7.0F, 5.5F, 100.0F, 0.3F}) expect_lowest_ranks(distribution, tiling, density);
        ++sets;
    }
    EXPECT_EQ(sets, 3);
}

TEST(PointDistribution, ChoosesTilesInStepsOfFour)
{
    const PointDistribution steps(shipped("corner-c4-n64-r075"));
    for (const auto& [density, full] : std::map<double, double>{{64, 64},
                                                                {63, 64},
                                                                {16.5, 64},
                                                                {16, 16},
                                                                {15, 16},
                                                                {64.5, 256},
                                                                {1000, 1024},
                                                                {1, 1},
                                                                {0.3, 1},
                                                                {0.25, 0.25}})
        EXPECT_EQ(steps.full_density(density), full) << density;
    const PointDistribution largest(shipped("corner-c4-n64-r075"), 100);
    for (const auto& [density, full] :
         std::map<double, double>{{100, 100}, {1, 100}, {1e-6, 100}, {101, 400}, {401, 1600}})
        EXPECT_EQ(largest.full_density(density), full) << density;
}

/// Over 40 x 40 tiles. The fractional parts of multiples of the shifts' numbers are so even that a row of tiles is off
/// by less than two points, where ranks alone would be off by up to half a point a tile.
TEST(PointDistribution, HasTheDensity)
{
    constexpr int side = 40;
    const PointDistribution distribution(shipped("corner-c3-n64-r075"), 0, 3, side);
    for (double density = 16.25; density < 64; density += 2.25) {
        const auto points = emitted_by(distribution, Box2f(V2f(0), V2f(side)), static_cast<float>(density));
        EXPECT_NEAR(static_cast<double>(points.size()), density * side * side, 2 * side) << density;
    }
}

/// The smallest distance over all pairs of points in a square of so many tiles.
double least_distance(const PointDistribution& distribution, float density, float tiles)
{
    const auto width = tiles * static_cast<float>(distribution.side_of_tiles(distribution.full_density(density)));
    const auto points = emitted_by(distribution, Box2f(V2f(0), V2f(width)), density);
    double squared = 1e300;
    for (std::size_t a = 0; a < points.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const double x = double{points[a].x} - points[b].x, y = double{points[a].y} - points[b].y;
            squared = std::min(squared, x * x + y * y);
        }
    return std::sqrt(squared);
}

/// Coordinates up to W are rounded by W 2^-24 at most, distances by that times 2 sqrt 2.
TEST(PointDistribution, KeepsTheProvenDistance)
{
    for (const char* name : {"corner-c4-n64-r075", "corner-c3-n64-r085"}) {
        const PointDistribution distribution(shipped(name), 0, 5);
        const PoissonTileSet set = read_tile_set(shipped(name));
        const double in_tiles = std::sqrt(static_cast<double>(set.squared_min_distance)) / 65536;
        for (const float density : {64.0F, 40.0F, 17.0F, 1024.0F, 0.9F}) {
            const double proven = distribution.min_distance(density), found = least_distance(distribution, density, 8);
            EXPECT_NEAR(proven, in_tiles * std::sqrt(64 / distribution.full_density(density)), 1e-15 * proven);
            EXPECT_GE(found, proven * (1 - 8 / in_tiles * 0x1p-22)) << name << density;
            if (density == 64) {
                EXPECT_LT(found, 1.05 * proven) << name;
            }
        }
    }
}

/// Any two densities of one step: the points of the smaller one are those of the larger one with thresholds of up to
/// their quotient.
TEST(PointDistribution, AddsPointsAndMovesNone)
{
    const PointDistribution distribution(shipped("corner-c3-n64-r085"), 900);
    const Box2f bounds(V2f(3.25F, -7), V2f(5, -5.5F));
    const std::vector<Emitted> all = emitted_by(distribution, bounds, 800);
    EXPECT_THAT(all.size(), testing::AllOf(testing::Gt(1900U), testing::Lt(2300U)));
    for (const float density : {700.0F, 333.25F, 12.5F}) {
        std::set<std::pair<float, float>> kept;
        for (const Emitted& p : all)
            if (p.threshold <= density / 800) kept.emplace(p.x, p.y);
        EXPECT_EQ(places_of(emitted_by(distribution, bounds, density)), kept) << density;
    }
    for (const Emitted& p : all) EXPECT_TRUE(p.threshold > 0 && p.threshold <= 1) << p.threshold;
}

TEST(PointDistribution, AsksForDensitiesOfPoints)
{
    const PointDistribution distribution(shipped("corner-c3-n64-r075"));
    const Box2f bounds(V2f(-2), V2f(2));
    const auto ramp = [](const V2f& p) { return (p.x + 2) / 4; };
    std::vector<std::pair<float, float>> asked, filtered;
    distribution(bounds, 50, ramp, [&](const V2f& p) { asked.emplace_back(p.x, p.y); });
    for (const Emitted& p : emitted_by(distribution, bounds, 50))
        if (ramp({p.x, p.y}) >= p.threshold) filtered.emplace_back(p.x, p.y);
    EXPECT_EQ(asked, filtered);
    EXPECT_THAT(asked.size(), testing::AllOf(testing::Gt(360U), testing::Lt(440U))); // half of 800
}

/// Boxes side by side, a million units away, where floats are 1/16 apart: each point is in one of them.
TEST(PointDistribution, FillsBoxesWithoutGapsAndTwins)
{
    const PointDistribution distribution(shipped("corner-c3-n64-r075"), 0, 11);
    const V2f low(1'000'000, -1'000'000);
    std::multiset<Emitted> parts;
    const std::vector<float> cuts{0, 17.0625F, 40, 41.5F, 99.9375F, 200};
    for (std::size_t i = 1; i < cuts.size(); ++i)
        for (std::size_t j = 1; j < cuts.size(); ++j)
            for (const Emitted& p : emitted_by(
                     distribution, Box2f(low + V2f(cuts[i - 1], cuts[j - 1]), low + V2f(cuts[i], cuts[j])), 0.3F))
                parts.insert(p);
    const auto whole = emitted_by(distribution, Box2f(low, low + V2f(200)), 0.3F);
    EXPECT_EQ(parts, std::multiset<Emitted>(whole.begin(), whole.end()));
    EXPECT_GT(whole.size(), 11'500U);
}

TEST(PointDistribution, ClosesAfterItsPeriod)
{
    const PointDistribution distribution(shipped("corner-c3-n64-r075"), 0, 1, 4);
    std::set<std::pair<float, float>> moved;
    for (const Emitted& p : emitted_by(distribution, Box2f(V2f(4, 8), V2f(8, 12)), 43)) moved.emplace(p.x - 4, p.y - 8);
    const auto first = places_of(emitted_by(distribution, Box2f(V2f(0), V2f(4)), 43));
    EXPECT_EQ(moved, first); // coordinates are multiples of 2^-16, which floats below 2^8 have
    EXPECT_GT(first.size(), 600U);
}

/// A type that has `min` and `max` with `x` and `y` is a box.
TEST(PointDistribution, TakesBoxesOfAnyNumbers)
{
    struct Position
    {
        double x, y;
    };
    struct Bounds
    {
        Position min, max;
    };
    const PointDistribution distribution(shipped("corner-c3-n64-r075"));
    std::vector<Emitted> exact;
    distribution(Bounds{{0, 0}, {3, 3}}, 30, [&](const Position& p, float t) {
        exact.push_back({static_cast<float>(p.x), static_cast<float>(p.y), t});
    });
    EXPECT_EQ(exact, emitted_by(distribution, Box2f(V2f(0), V2f(3)), 30));
}

TEST(PointDistribution, IsEmptyWhereNothingIsAskedFor)
{
    const PointDistribution distribution(shipped("corner-c3-n64-r075"));
    for (const float density : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_TRUE(emitted_by(distribution, Box2f(V2f(0), V2f(3)), density).empty());
    EXPECT_TRUE(emitted_by(distribution, Box2f(), 64).empty());
    EXPECT_TRUE(emitted_by(distribution, Box2f(V2f(1), V2f(1)), 64).empty());
    EXPECT_EQ(message_of<std::range_error>([&] { emitted_by(distribution, Box2f(V2f(0), V2f(1e12F)), 64); }),
              "bounds reach further than 2^31 tiles from the origin");
    EXPECT_EQ(message_of<std::range_error>(
                  [&] { emitted_by(distribution, Box2f(V2f(0), V2f(1)), std::numeric_limits<float>::infinity()); }),
              "the density is infinite");
}

TEST(PointDistribution, RefusesWhatItCannotUse)
{
    const TemporaryFolder folder;
    const std::string file = folder.path() / "set.ptiles";
    const auto said_of = [&](const PoissonTileSet& set) {
        write_tile_set_file(file, set);
        return message_of<std::runtime_error>([&] { const PointDistribution refused(file); });
    };
    EXPECT_EQ(said_of(random_chain_set(2, 5)),
              file + ": the set is not ranked: tiles build --ranked makes one that is");
    EXPECT_EQ(said_of(with_random_ranks(random_tile_set(PoissonTileKind::corner, 3, 2, 5))),
              file + ": tiles of space: must be a tile set in the plane");
    PoissonTileSet twice = with_random_ranks(random_chain_set(2, 5));
    twice.ranks[1] = twice.ranks[0];
    EXPECT_EQ(said_of(twice), file + ": ranks that are not each there once");
    folder.write("set.ptiles", "PTILES");
    EXPECT_EQ(message_of<std::runtime_error>([&] { const PointDistribution refused(file); }),
              file + ": shorter than the header of a tile set file");
    EXPECT_EQ(message_of<std::runtime_error>([&] { const PointDistribution refused("no/such.ptiles"); }),
              "no/such.ptiles: cannot be opened");
    const std::string no_file = folder.path();
    EXPECT_EQ(message_of<std::runtime_error>([&] { const PointDistribution refused(no_file); }),
              no_file + ": cannot be read");
    const std::string good = shipped("corner-c3-n64-r075");
    EXPECT_EQ(message_of<std::runtime_error>([&] { const PointDistribution refused(good, -1); }),
              good + ": the density must be 0 or a positive number");
}

TEST(PointDistribution, SharesOneOfTheEnvironment)
{
    const char* name = "CORTEX_POINTDISTRIBUTION_TILESET";
    ASSERT_EQ(::unsetenv(name), 0);
    EXPECT_EQ(message_of<std::runtime_error>([] { PointDistribution::defaultInstance(); }),
              std::string(name) + ": the environment variable is not set: it names a ranked tile set (.ptiles)");
    ASSERT_EQ(::setenv(name, shipped("corner-c3-n64-r075").c_str(), 1), 0);
    const PointDistribution& shared = PointDistribution::defaultInstance();
    EXPECT_EQ(&shared, &PointDistribution::defaultInstance());
    const Box2f bounds(V2f(0), V2f(2));
    EXPECT_EQ(emitted_by(shared, bounds, 64), emitted_by(PointDistribution(shipped("corner-c3-n64-r075")), bounds, 64));
}

}
}
