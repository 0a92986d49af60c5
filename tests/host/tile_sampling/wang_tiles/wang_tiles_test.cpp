// Tiles of the methods before Poisson disk tiles: distances over all pairs of tiles, the mean over all 4,096
// surroundings by CGAL, and tilings that are what their tiles say.
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/tilings/tiled_sets.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"
#include "tests/support/brute_force.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <set>

namespace poissonlab {
namespace {

TEST(WangPoints, EightTilesFourBesideAnEdge)
{
    std::set<std::array<Color, 4>> all;
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile) {
        const WangTile c = wang_colors_of(tile);
        all.insert({c.north, c.east, c.south, c.west});
        EXPECT_EQ((c.north + c.east + c.south + c.west) % 2, 0U);
        for (const auto& [x, y] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
            int beside = 0;
            for (std::size_t other = 0; other < wang_point_tiles; ++other) {
                beside += may_lie_beside(tile, other, x, y);
                EXPECT_EQ(may_lie_beside(tile, other, x, y), may_lie_beside(other, tile, -x, -y));
            }
            EXPECT_EQ(beside, 4);
        }
    }
    EXPECT_EQ(all.size(), 8U);
}

/// The number of a tile's points and their places are found again in the torus, in every tiling; and the smallest
/// distance of many tilings is what the pairs of tiles say.
TEST(WangPoints, TilingsConsistOfTheTiles)
{
    const WangPoints points = start_averaged_tiles(5, 1);
    const std::int64_t across = squared_distance_across(points), within = squared_distance_within(points);
    const double expected = std::sqrt(static_cast<double>(std::min(across, within))) / tile_units;
    double smallest = 1;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const PointSet torus = wang_torus(points, seed, 12);
        ASSERT_EQ(torus.size(), 12U * 12 * 5);
        smallest = std::min(smallest, 12 * test::brute_force_min_distance(torus));
    }
    EXPECT_NEAR(smallest, expected, 1e-9);
}

/// No pair that can be near is nearer than asked for, and no further dart fits.
TEST(ShadeTiles, KeepTheirDistanceInEveryTiling)
{
    constexpr std::uint64_t squared = 9000 * 9000;
    const WangPoints points = throw_shade_tiles(squared, 200'000, 3);
    EXPECT_GE(squared_distance_within(points), static_cast<std::int64_t>(squared));
    EXPECT_GE(squared_distance_across(points), static_cast<std::int64_t>(squared));
    EXPECT_EQ(throw_shade_tiles(squared, 200'000, 3), points);
    EXPECT_NE(throw_shade_tiles(squared, 200'000, 4), points);
    // A place is forbidden if a point of any tile that may lie there is near: of places drawn at random all must be.
    std::size_t free = 0;
    for (std::uint32_t i = 0; i < 4000; ++i) {
        const auto words = philox({i, 0, 0, 0}, stream_key(9, Purpose::random_points, 0));
        WangPoints more = points;
        more.tiles[i % 8].push_back(
            {static_cast<std::int32_t>(words[0] >> 16), static_cast<std::int32_t>(words[1] >> 16)});
        free += squared_distance_within(more) >= static_cast<std::int64_t>(squared) &&
                squared_distance_across(more) >= static_cast<std::int64_t>(squared);
    }
    EXPECT_LE(free, 1U);
}

/// The dissertation's reason to call these tiles flawed: a dart near an edge keeps four tiles away, so fewer fit there.
TEST(ShadeTiles, AreThinAtEdges)
{
    constexpr std::int32_t distance = 9000;
    double near = 0, inside = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        for (const auto& tile : throw_shade_tiles(std::uint64_t{distance} * distance, 5000, seed).tiles)
            for (const WangPoint& point : tile) {
                const std::int32_t edge = std::min({point[0], point[1], tile_units - point[0], tile_units - point[1]});
                (edge < distance / 2 ? near : inside) += 1;
            }
    const double side = 1 - static_cast<double>(distance) / tile_units;
    EXPECT_LT(near / (1 - side * side), 0.75 * inside / (side * side));
}

/// The mean over all surroundings of one tile, each by a Delaunay triangulation of 3 x 3 tiles.
std::vector<WangPoint> means_by_triangulation(const WangPoints& points, std::size_t middle)
{
    const std::size_t n = points.tiles[middle].size();
    std::vector<std::array<std::int64_t, 2>> sums(n);
    std::int64_t count = 0;
    std::array<std::size_t, 9> tiles{};
    const auto fits = [&](std::size_t place) {
        const auto x = static_cast<int>(place % 3), y = static_cast<int>(place / 3);
        for (std::size_t before = 0; before < place; ++before) {
            const int dx = static_cast<int>(before % 3) - x, dy = static_cast<int>(before / 3) - y;
            if (std::abs(dx) + std::abs(dy) == 1 && !may_lie_beside(tiles[place], tiles[before], dx, dy)) return false;
        }
        return true;
    };
    const auto add = [&] {
        PointSet set{2, {}};
        for (std::size_t place = 0; place < 9; ++place)
            for (const WangPoint& point : points.tiles[tiles[place]])
                for (std::size_t k = 0; k < 2; ++k) {
                    const auto offset = static_cast<double>(k == 0 ? place % 3 : place / 3);
                    set.coordinates.push_back((offset + static_cast<double>(point[k]) / tile_units) / 3);
                }
        const VoronoiCells cells = reference::voronoi_cells(set);
        std::size_t first = 0;
        for (std::size_t place = 0; place < 4; ++place) first += points.tiles[tiles[place]].size();
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < 2; ++k)
                sums[i][k] += std::lround(cells.displacements[2 * (first + i) + k] * 3 * tile_units);
        ++count;
    };
    const auto place_tile = [&](const auto& next, std::size_t place) -> void {
        if (place == 9) return add();
        for (std::size_t tile = place == 4 ? middle : 0; tile < (place == 4 ? middle + 1 : wang_point_tiles); ++tile) {
            tiles[place] = tile;
            if (fits(place)) next(next, place + 1);
        }
    };
    place_tile(place_tile, 0);
    EXPECT_EQ(count, 4096);
    std::vector<WangPoint> means;
    for (const auto& sum : sums)
        means.push_back({static_cast<std::int32_t>(std::nearbyint(static_cast<double>(sum[0]) / 4096)),
                         static_cast<std::int32_t>(std::nearbyint(static_cast<double>(sum[1]) / 4096))});
    return means;
}

/// Where points are spread well, three tiles decide a cell, and elsewhere all eight. Both are the mean over all.
TEST(AveragedTiles, MoveByTheMeanOverAllSurroundings)
{
    WangPoints points = start_averaged_tiles(16, 7);
    for (int i = 0; i < 4; ++i) points = average_once(points, AveragedVariant::exact, 0, 7);
    const WangPoints next = average_once(points, AveragedVariant::exact, 0, 7);
    constexpr std::size_t tile = 3;
    const std::vector<WangPoint> expected = means_by_triangulation(points, tile);
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t k = 0; k < 2; ++k) {
            const std::int32_t target = std::clamp(points.tiles[tile][i][k] + expected[i][k], 0, tile_units - 1);
            EXPECT_NEAR(next.tiles[tile][i][k], target, 1) << "point " << i; // of rounded sums
        }
}

/// A number of points a tile, iterations before, and the size of work-groups.
struct AveragedCase
{
    std::uint32_t points, iterations;
    std::size_t group_size;
};

class AveragedTileKernels : public testing::TestWithParam<AveragedCase>
{
};

/// In the beginning points lie in the middle of their tiles, and more than a quadrant decides many cells.
TEST_P(AveragedTileKernels, MoveAsTheTwin)
{
    static Device device = Device::open();
    AveragedTiles kernels(device, GetParam().group_size);
    for (const AveragedVariant variant : {AveragedVariant::exact, AveragedVariant::one_surrounding}) {
        WangPoints points = start_averaged_tiles(GetParam().points, 3);
        for (std::uint32_t i = 0; i <= GetParam().iterations; ++i) {
            const WangPoints expected = average_once(points, variant, i, 3);
            EXPECT_EQ(kernels.average_once(points, variant, i, 3), expected) << i;
            points = expected;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Small, AveragedTileKernels, testing::Values(AveragedCase{2, 0, 4}));
INSTANTIATE_TEST_SUITE_P(Sizes, AveragedTileKernels,
                         testing::Values(AveragedCase{2, 3, 0}, AveragedCase{16, 12, 0}, AveragedCase{63, 6, 16}));

TEST(AveragedTiles, AreTheSameOnAnyNumberOfThreads)
{
    const WangPoints points = start_averaged_tiles(20, 2);
    const WangPoints moved = average_once(points, AveragedVariant::exact, 0, 2);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(average_once(points, AveragedVariant::exact, 0, 2), moved);
}

/// Radii within tiles grow to those of relaxed sets; those across tiles stay behind, and more so in one surrounding.
TEST(AveragedTiles, AreWorseAcrossTilesThanWithin)
{
    const auto radius = [](std::int64_t squared, std::size_t n) {
        return relative_radius(std::sqrt(static_cast<double>(squared)) / tile_units, n, 2);
    };
    for (const AveragedVariant variant : {AveragedVariant::exact, AveragedVariant::one_surrounding}) {
        WangPoints points = start_averaged_tiles(32, 5);
        EXPECT_LT(radius(squared_distance_within(points), 32), 0.2);
        for (std::uint32_t i = 0; i < 30; ++i) points = average_once(points, variant, i, 5);
        const double within = radius(squared_distance_within(points), 32);
        const double across = radius(squared_distance_across(points), 32);
        EXPECT_GT(within, 0.6);
        EXPECT_GT(across, 0.35);
        EXPECT_LT(across, 0.78);
    }
}

/// The last record of the iterations is what the tilings have, measured among their points: within tiles and of any
/// two. Realizations take tile sets in turn, and each has its own iterations.
TEST(AveragedTiles, RecordWhatTheirTilingsHave)
{
    const SamplerSpec& spec = *find_sampler("averaged-tiles");
    Parameters given(spec.parameters);
    given.set("points_per_tile", std::int64_t{9}, {"test.toml", 1});
    given.set("iterations", std::int64_t{5}, {"test.toml", 1});
    given.set("sets", std::int64_t{2}, {"test.toml", 1});
    const auto sampler = spec.create(given, {9000, 2, 4}, Engine::reference, {});
    EXPECT_EQ(sampler->traits().tile_sets, 2U);
    std::vector<std::vector<IterationRecord>> records;
    for (std::uint32_t realization = 0; realization < 4; ++realization) {
        const PointSet points = sampler->sample(realization);
        records.push_back(sampler->traits().iterations);
        ASSERT_EQ(records.back().size(), 6U);
        const double within = min_distance_within_tiles(points, static_cast<int>(sampler->traits().tiles_along_axis));
        EXPECT_NEAR(*records.back().back().relative_radius_within_tiles, relative_radius(within, points.size(), 2),
                    1e-9);
        EXPECT_NEAR(records.back().back().relative_radius,
                    relative_radius(min_toroidal_distance(points), points.size(), 2), 1e-9);
    }
    EXPECT_EQ(records[0], records[2]);
    EXPECT_EQ(records[1], records[3]);
    EXPECT_NE(records[0], records[1]);
    const auto second = spec.create(Parameters(given), {9000, 2, 5}, Engine::reference, {});
    second->sample(0);
    EXPECT_EQ(second->traits().iterations, records[1]) << "the set of the next seed";
}

/// A tile of one point has no distance within it, and moves to where it is as far from others as it can be.
TEST(AveragedTiles, OfOnePointHaveNoRadiusWithin)
{
    const SamplerSpec& spec = *find_sampler("averaged-tiles");
    Parameters given(spec.parameters);
    given.set("points_per_tile", std::int64_t{1}, {"test.toml", 1});
    given.set("iterations", std::int64_t{3}, {"test.toml", 1});
    const auto sampler = spec.create(given, {64, 2, 4}, Engine::reference, {});
    EXPECT_EQ(sampler->sample(0).size(), 64U);
    const SetTraits traits = sampler->traits();
    for (const IterationRecord& record : traits.iterations) {
        EXPECT_FALSE(record.relative_radius_within_tiles);
        EXPECT_GT(record.relative_radius, 0.4);    // from the middles, half a tile apart at least
        EXPECT_LE(record.relative_radius, 0.9307); // of the square lattice
    }
}

TEST(WangSamplers, MakeTilingsOfTheSameTiles)
{
    Device device = Device::open();
    for (const char* name : {"shade-tiles", "averaged-tiles"}) {
        const SamplerSpec& spec = *find_sampler(name);
        Parameters given(spec.parameters);
        if (name == std::string("averaged-tiles")) given.set("iterations", std::int64_t{2}, {"test.toml", 1});
        if (name == std::string("shade-tiles")) given.set("attempts", std::int64_t{1000}, {"test.toml", 1});
        const auto make = [&](std::uint64_t seed, Engine engine = Engine::opencl) {
            return spec.create(given, {2048, 2, seed}, engine, [&]() -> Device& { return device; });
        };
        const auto sampler = make(1);
        EXPECT_NEAR(static_cast<double>(sampler->sample(0).size()), 2048, 200) << name;
        EXPECT_EQ(sampler->sample(1), make(1, Engine::reference)->sample(1));
        EXPECT_NE(sampler->sample(0), sampler->sample(1));
        EXPECT_NE(sampler->sample(0), make(2)->sample(0));
        EXPECT_EQ(sampler->traits().tile_set->tiles, 8U);
        EXPECT_EQ(sampler->traits().sizes_vary, name == std::string("shade-tiles"));
    }
}

}
}
