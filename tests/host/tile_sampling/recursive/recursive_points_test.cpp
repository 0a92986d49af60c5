// Points of recursive Wang tiles: exact numbers, densities that contain each other, windows of any depth.
#include "host/tile_sampling/recursive/recursive_points.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/set_mark.hpp"
#include "base/densities/density_text.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "host/tile_sampling/recursive/recursive_sampler.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::uint32_t tile_points = 128;

const RecursiveTileSet& recursive_set()
{
    static const RecursiveTileSet set = build_recursive_tiles(tile_points, 1);
    return set;
}

RecursiveTiling recursive_tiling(std::uint32_t side, std::uint32_t realization = 0)
{
    return {recursive_set(), side, stream_key(1, Purpose::recursive_tilings, realization)};
}

RecursiveDensity uniform(std::uint64_t points, std::uint64_t side, int level = 0) { return {points, side, level, {}}; }

using Positions = std::vector<std::array<double, 2>>;

Positions sorted_positions(const PointSet& set)
{
    Positions positions;
    for (std::size_t i = 0; i < set.size(); ++i) positions.push_back({set[i][0], set[i][1]});
    std::ranges::sort(positions);
    return positions;
}

TEST(RecursivePoints, AreAsManyAsAreAskedFor)
{
    for (const std::uint32_t side : {1U, 2U, 3U, 5U})
        for (const std::uint64_t points : {1ULL, 2ULL, 17ULL, 128ULL, 129ULL, 1000ULL, 2048ULL, 2049ULL, 4095ULL,
                                           18'437ULL, 32'768ULL, 32'769ULL, 50'001ULL}) {
            const PointSet set = recursive_tiling(side).torus_points(uniform(points, side));
            EXPECT_EQ(set.size(), points) << side;
            for (const double c : set.coordinates) EXPECT_TRUE(c >= 0 && c < 1);
        }
}

/// Points of less density are among those of more to the last bit, for uniform densities and formulas.
TEST(RecursivePoints, OfLessDensityAreAmongThoseOfMore)
{
    const Density formula = density_of_formula("gauss-and-waves", 1, 1);
    for (const auto& density : {std::optional<Density>(), std::optional(formula)}) {
        Positions before;
        for (const std::uint64_t points : {100ULL, 700ULL, 701ULL, 2500ULL, 9000ULL, 40'000ULL}) {
            const Positions all =
                sorted_positions(recursive_tiling(2).torus_points(RecursiveDensity(points, 2, 0, density)));
            EXPECT_TRUE(std::ranges::includes(all, before)) << points;
            EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
            EXPECT_GE(all.size(), before.size());
            before = all;
        }
    }
}

/// A relative radius of 0.4 or more at any density: half of what as many points of one level may have.
TEST(RecursivePoints, KeepTheirDistanceAtEveryDensity)
{
    for (const std::uint64_t points : {300ULL, 1100ULL, 1152ULL, 2000ULL, 5000ULL, 12'000ULL}) {
        const PointSet set = recursive_tiling(3).torus_points(uniform(points, 3));
        EXPECT_GT(relative_radius(test::brute_force_min_distance(set), points, 2), 0.47) << points;
    }
}

/// Lagae's dissertation, section 6.14: "Most distributions had a relative radius of less than 0.001". Sets that draw
/// each level's own points have that, since points of a tile are points of its cells as well.
TEST(RecursivePoints, DrawnTwiceLieOnEachOther)
{
    const RecursiveTiling tiling = recursive_tiling(2);
    constexpr std::uint64_t points = 2'400; // 600 a tile, which has 128 of its own, and 37 or 38 of each cell's tile
    const PointSet once = tiling.torus_points(uniform(points, 2));
    const PointSet twice = tiling.torus_points(uniform(points, 2), RecursiveDrawing::twice);
    EXPECT_EQ(twice.size(), points + 4 * tile_points);
    EXPECT_GT(relative_radius(test::brute_force_min_distance(once), once.size(), 2), 0.5);
    EXPECT_LT(relative_radius(test::brute_force_min_distance(twice), twice.size(), 2), 0.001);
    // Below N points a tile nothing is drawn twice: the larger radii of that section.
    const PointSet sparse = tiling.torus_points(uniform(500, 2), RecursiveDrawing::twice);
    EXPECT_EQ(sparse, tiling.torus_points(uniform(500, 2)));
}

/// The density of a block of the square is its integral, within three times the square root of its number.
TEST(RecursivePoints, FollowDensities)
{
    const Density blocks = density_of_values(4, 4, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0}, "blocks");
    constexpr double points = 30'000;
    const PointSet set = recursive_tiling(3).torus_points(RecursiveDensity(30'000, 3, 0, blocks));
    EXPECT_NEAR(static_cast<double>(set.size()), points, 3 * std::sqrt(points));
    std::array<double, 16> counts{};
    for (std::size_t i = 0; i < set.size(); ++i)
        ++counts[static_cast<std::size_t>(set[i][1] * 4) * 4 + static_cast<std::size_t>(set[i][0] * 4)];
    for (std::size_t i = 0; i < 15; ++i) {
        const double expected = points * static_cast<double>(i + 1) / 120;
        EXPECT_NEAR(counts[i], expected, 3 * std::sqrt(expected));
    }
    EXPECT_EQ(counts[15], 0);
}

TEST(RecursivePoints, AreTheSameOnAnyNumberOfThreads)
{
    const RecursiveDensity density(20'000, 2, 0, density_of_formula("1 + x*y", 1, 1));
    const PointSet set = recursive_tiling(2).torus_points(density);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(recursive_tiling(2).torus_points(density), set);
    EXPECT_NE(recursive_tiling(2, 1).torus_points(density), set);
}

TEST(RecursiveDensities, AreExactShares)
{
    const RecursiveDensity density(1000, 3, 0, density_of_values(2, 1, {1, 3}, "two"));
    // The right half has three quarters of the points: 750 in four and a half tiles.
    EXPECT_EQ(density.demand(full_weight, 0), (std::uint64_t{1500} << 32) / 9);
    EXPECT_EQ(density.demand(full_weight, 1), (std::uint64_t{1500} << 32) / 9 / 16);
    EXPECT_EQ(density.demand(0, 0), 0U);
    EXPECT_EQ(density.demand(full_weight, 40), 0U);
    EXPECT_EQ(RecursiveDensity(5, 1, 31, {}).demand(full_weight, 0), std::uint64_t{1} << 63);
    EXPECT_EQ(RecursiveDensity(5, 1, 2, {}).demand(full_weight, 1), std::uint64_t{80} << 32);
    EXPECT_THAT(refusal_of([] { RecursiveDensity(std::uint64_t{1} << 31, 1, 0, {}); }), HasSubstr("less than 2^31"));
}

TEST(RecursiveTileCache, BuildsOnceAndAgainWhatIsDamaged)
{
    const TemporaryFolder folder;
    const auto first = cached_recursive_tiles(tile_points, 1, folder.path());
    EXPECT_FALSE(first.record.cached);
    EXPECT_EQ(first.tiles, recursive_set());
    EXPECT_EQ(first.record.points_per_tile, tile_points);
    ASSERT_TRUE(first.record.build);
    const auto second = cached_recursive_tiles(tile_points, 1, folder.path());
    EXPECT_TRUE(second.record.cached);
    EXPECT_EQ(second.tiles, first.tiles);
    EXPECT_EQ(second.record.build, first.record.build);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        if (entry.path().extension() == ".rtiles") write_whole_file(entry.path(), "RECWANG1 no more");
    const auto third = cached_recursive_tiles(tile_points, 1, folder.path());
    EXPECT_FALSE(third.record.cached);
    EXPECT_EQ(third.tiles, first.tiles);
    EXPECT_FALSE(cached_recursive_tiles(tile_points, 2, folder.path()).record.cached);
}

class RecursiveSamplers : public ::testing::Test
{
protected:
    RecursiveSamplers() { setenv("POISSONLAB_CACHE", cache_.path().c_str(), 1); }
    ~RecursiveSamplers() override { unsetenv("POISSONLAB_CACHE"); }

    static Parameters parameters()
    {
        Parameters given(spec().parameters);
        given.set("points_per_tile", std::int64_t{tile_points}, {"test.toml", 2});
        return given;
    }

    static std::unique_ptr<Sampler> make(const Parameters& given, std::size_t points = 2000)
    {
        return spec().create(given, {points, 2, 1}, Engine::reference, {});
    }

    static std::string refused(const Parameters& given, std::size_t points = 2000)
    {
        return refusal_of([&] { spec().check(given, {points, 2, 1}, {"test.toml", 1}); });
    }

    static const SamplerSpec& spec() { return *find_sampler("recursive-wang-tiles"); }

private:
    TemporaryFolder cache_;
};

TEST_F(RecursiveSamplers, MakeSetsOfTheSizeThatIsAsked)
{
    const auto sampler = make(parameters());
    EXPECT_EQ(sampler->sample(0).size(), 2000U);
    EXPECT_NE(sampler->sample(0), sampler->sample(1));
    EXPECT_EQ(sampler->sample(1), make(parameters())->sample(1));
    EXPECT_FALSE(sampler->traits().sizes_vary);
    EXPECT_EQ(sampler->traits().tiles_along_axis, 4U);
    EXPECT_FALSE(spec().is_deterministic(parameters()));
    Parameters one = parameters();
    one.set("base_tiles", std::int64_t{1});
    EXPECT_TRUE(spec().is_deterministic(one));
    EXPECT_EQ(make(one)->sample(0), make(one)->sample(5));
}

/// Realizations of few tiles are all the tilings that differ, before any comes again.
TEST_F(RecursiveSamplers, MakeDifferentSetsOfFewTiles)
{
    Parameters given = parameters();
    given.set("base_tiles", std::int64_t{2});
    const auto sampler = make(given, 4 * 2 * tile_points);
    std::vector<SetMark> marks;
    const auto is_new = [&](const PointSet& set) {
        SetMarkSums sums;
        sums.add(set);
        const SetMark mark = sums.mark(min_toroidal_distance(set), mean_nearest_distance(set));
        const bool seen = std::ranges::any_of(marks, [&](const SetMark& other) { return are_same_set(mark, other); });
        marks.push_back(mark);
        return !seen;
    };
    for (std::uint32_t k = 0; k < 14; ++k) EXPECT_TRUE(is_new(sampler->sample(k))) << k;
    for (std::uint32_t k = 14; k < 20; ++k) EXPECT_FALSE(is_new(sampler->sample(k))) << k;
    EXPECT_EQ(make(given, 4 * 2 * tile_points)->sample(9), sampler->sample(9)) << "without those before";
}

/// Realization k has the tile set of the seed that is k % sets after the config's, and the tiling of realization k.
TEST_F(RecursiveSamplers, TakeSeveralSetsInTurn)
{
    Parameters given = parameters();
    given.set("sets", std::int64_t{3});
    const auto sampler = make(given);
    EXPECT_EQ(sampler->traits().tile_sets, 3U);
    EXPECT_EQ(make(parameters())->traits().tile_sets, 1U);
    RealizationRoots roots(4, 1);
    for (std::uint32_t k = 0; k < 5; ++k) {
        const RecursiveTileSet tiles = build_recursive_tiles(tile_points, 1 + k % 3);
        const RecursiveTiling tiling(tiles, 4, stream_key(1, Purpose::recursive_tilings, k), roots.of(k));
        EXPECT_EQ(sampler->sample(k), tiling.torus_points(RecursiveDensity(2000, 4, 0, {}))) << k;
    }
    given.set("base_tiles", std::int64_t{1});
    EXPECT_FALSE(spec().is_deterministic(given));
}

TEST_F(RecursiveSamplers, FollowAFormula)
{
    Parameters given = parameters();
    given.set("density", std::string("x < 0 ? 1 : 3"), {"test.toml", 3});
    const auto sampler = make(given);
    EXPECT_TRUE(sampler->traits().sizes_vary);
    const PointSet set = sampler->sample(0);
    std::size_t left = 0;
    for (std::size_t i = 0; i < set.size(); ++i) left += set[i][0] < 0.5;
    EXPECT_NEAR(static_cast<double>(left), 500, 3 * std::sqrt(500));
    EXPECT_NEAR(static_cast<double>(set.size()), 2000, 3 * std::sqrt(2000));
    EXPECT_EQ(refused(given), "accepted");
    EXPECT_NE(spec().outside_input(given), spec().outside_input(parameters()));
}

TEST_F(RecursiveSamplers, RefuseToDrawTwiceWhereThatIsToDrawOnce)
{
    Parameters given = parameters(); // 4 x 4 largest tiles
    given.set("drawing", std::string("twice"), {"test.toml", 3});
    const std::size_t full = std::size_t{16} * tile_points;
    EXPECT_EQ(make(given, full)->sample(0), make(parameters(), full)->sample(0));
    EXPECT_THAT(refused(given, full), StartsWith("test.toml:3: drawing = \"twice\": differs from \"once\" only where"));
    EXPECT_EQ(refused(given, full + 16), "accepted");
    EXPECT_NE(make(given, full + 16)->sample(0).size(), make(parameters(), full + 16)->sample(0).size());
    EXPECT_EQ(refused(parameters(), full), "accepted");
    // The densest place decides.
    given.set("density", std::string("x < 0 ? 1 : 3"), {"test.toml", 4});
    EXPECT_EQ(refused(given, full), "accepted");
}

TEST_F(RecursiveSamplers, RefuseDensitiesThatAreNone)
{
    Parameters given = parameters();
    given.set("density", std::string("1 +"), {"test.toml", 3});
    EXPECT_THAT(refused(given), StartsWith("test.toml:3: density = \"1 +\": "));
    given.set("density", std::string("no-such.png"), {"test.toml", 3});
    EXPECT_THAT(refused(given), HasSubstr("no-such.png: no such file"));
    given.set("density", std::string("x"), {"test.toml", 3});
    EXPECT_THAT(refused(given), HasSubstr("not negative"));
    given.set("density", std::string("x > 0.999 && y > 0.999 ? 1 : 0"), {"test.toml", 3});
    EXPECT_THAT(refused(given, 1'000'000'000),
                StartsWith("test.toml:1: sampler = \"recursive-wang-tiles\": the densest"));
    Parameters channel = parameters();
    channel.set("density_from", std::string("ink"), {"test.toml", 4});
    EXPECT_THAT(refused(channel), StartsWith("test.toml:4: density_from = \"ink\": is for a density"));
}

}
}
