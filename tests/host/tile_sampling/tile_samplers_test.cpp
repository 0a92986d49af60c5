// Values that the samplers of Poisson disk tiles accept and refuse, and the sets that they make.
#include "host/tile_sampling/tile_samplers.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/device/device.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace poissonlab {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using Values = std::initializer_list<std::pair<std::string, ParameterValue>>;

Parameters parameters_of(const SamplerSpec& spec, Values values)
{
    Parameters result(spec.parameters);
    int line = 10;
    for (const auto& [key, value] : values) result.set(key, value, {"test.toml", line++});
    return result;
}

ParameterValue whole(std::int64_t value) { return value; }

class TileSamplers : public testing::Test
{
protected:
    TileSamplers() { setenv("POISSONLAB_CACHE", cache_.path().c_str(), 1); }
    ~TileSamplers() override { unsetenv("POISSONLAB_CACHE"); }

    std::unique_ptr<Sampler> create(const std::string& name, Values values, std::size_t points,
                                    Engine engine = Engine::opencl, std::uint64_t seed = 7)
    {
        const SamplerSpec& spec = *find_sampler(name);
        return spec.create(parameters_of(spec, values), {points, spec.dimensions.front(), seed}, engine,
                           [this]() -> Device& { return device_; });
    }

    static std::string refusal(const std::string& name, Values values)
    {
        const SamplerSpec& spec = *find_sampler(name);
        return refusal_of([&] {
            spec.check(parameters_of(spec, values), {4096, spec.dimensions.front(), 1}, {"test.toml", 9});
        });
    }

    static bool is_deterministic(const std::string& name, const std::string& key, std::int64_t value)
    {
        const SamplerSpec& spec = *find_sampler(name);
        return spec.is_deterministic(parameters_of(spec, {{key, value}}));
    }

private:
    TemporaryFolder cache_;
    Device device_ = Device::open();
};

TEST_F(TileSamplers, KeepTheRelativeRadiusOfTheSet)
{
    struct Case
    {
        const char* sampler;
        std::pair<std::string, ParameterValue> size;
    };
    for (const Case& c : {Case{"corner-tiles", {"colors", whole(3)}}, Case{"edge-tiles", {"colors", whole(1)}},
                          Case{"template-tiles", {"tiles", whole(5)}}}) {
        const auto sampler =
            create(c.sampler, {c.size, {"points_per_tile", whole(16)}, {"relative_radius", 0.7}}, 1024);
        for (std::uint32_t realization = 0; realization < 2; ++realization) {
            const PointSet set = sampler->sample(realization);
            EXPECT_EQ(set.size(), 1024u) << c.sampler;
            EXPECT_GE(relative_radius(test::brute_force_min_distance(set), 1024, 2), 0.7) << c.sampler;
        }
        EXPECT_EQ(sampler->traits().tiles_along_axis, 8u);
    }
    const auto spheres = create("sphere-tiles",
                                {{"colors", whole(1)},
                                 {"points_per_tile", whole(32)},
                                 {"relative_radius", 0.5},
                                 {"lloyd_iterations", whole(2)}},
                                800);
    const PointSet set = spheres->sample(0);
    EXPECT_EQ(set.size(), 27u * 32);
    EXPECT_GE(relative_radius(test::brute_force_min_distance(set), set.size(), 3), 0.5);
}

TEST_F(TileSamplers, RealizationsAreOtherTilingsOfTheSameSet)
{
    const Values values{{"colors", whole(2)}, {"points_per_tile", whole(16)}, {"relative_radius", 0.7}};
    const auto sampler = create("corner-tiles", values, 1024);
    const PointSet first = sampler->sample(0);
    EXPECT_NE(sampler->sample(1), first);
    EXPECT_EQ(sampler->sample(0), first);
    EXPECT_EQ(create("corner-tiles", values, 1024)->sample(0), first) << "from the cache";
}

TEST_F(TileSamplers, BothEnginesMakeTheSamePoints)
{
    const Values values{{"colors", whole(2)},
                        {"points_per_tile", whole(12)},
                        {"relative_radius", 0.65},
                        {"lloyd_iterations", whole(2)}};
    EXPECT_EQ(create("corner-tiles", values, 700)->sample(3),
              create("corner-tiles", values, 700, Engine::reference)->sample(3));
}

TEST_F(TileSamplers, MakeTheNumberOfPointsThatIsNearest)
{
    EXPECT_EQ(tiling_side(16384, 64, 2), 16u);
    EXPECT_EQ(tiling_side(16384, 32, 2), 23u); // 16,928 points; 22 x 22 tiles have 15,488
    EXPECT_EQ(tiling_side(65536, 128, 3), 8u);
    EXPECT_EQ(tiling_side(1, 64, 2), 1u);
}

TEST_F(TileSamplers, OfOneTileAreDeterministic)
{
    EXPECT_TRUE(is_deterministic("corner-tiles", "colors", 1));
    EXPECT_FALSE(is_deterministic("corner-tiles", "colors", 2));
    EXPECT_TRUE(is_deterministic("template-tiles", "tiles", 1));
}

/// With ranks, sparser sets are parts of denser ones that have as many points in every tile; without, chance leaves
/// points out.
TEST_F(TileSamplers, GetSparser)
{
    const auto sample = [&](double density, bool ranked, Engine engine = Engine::opencl) {
        // Always 8 x 8 tiles.
        return create("corner-tiles",
                      {{"colors", whole(2)},
                       {"points_per_tile", whole(16)},
                       {"relative_radius", 0.7},
                       {"ranked", ranked},
                       {"density", density}},
                      static_cast<std::size_t>(std::lround(1024 * density)), engine)
            ->sample(2);
    };
    const auto is_part_of = [](const PointSet& part, const PointSet& whole_set) {
        std::size_t next = 0;
        for (std::size_t i = 0; i < whole_set.size() && next < part.size(); ++i)
            next += whole_set.coordinates[2 * i] == part.coordinates[2 * next] &&
                    whole_set.coordinates[2 * i + 1] == part.coordinates[2 * next + 1];
        return next == part.size();
    };
    const PointSet all = sample(1, true);
    const PointSet half = sample(0.5, true), quarter = sample(0.25, true);
    EXPECT_EQ(half.size(), 512u);
    EXPECT_EQ(quarter.size(), 256u);
    EXPECT_TRUE(is_part_of(half, all));
    EXPECT_TRUE(is_part_of(quarter, half));
    EXPECT_EQ(sample(0.5, true, Engine::reference), half);
    const PointSet random_half = sample(0.5, false);
    EXPECT_NE(random_half, half);
    EXPECT_NEAR(static_cast<double>(random_half.size()), 512, 5 * 16); // deviations of a binomial distribution
    EXPECT_TRUE(is_part_of(random_half, sample(1, false)));
}

TEST_F(TileSamplers, RefuseDensitiesThatLeaveNothing)
{
    const Values values{{"colors", whole(2)}, {"points_per_tile", whole(16)}, {"ranked", true}, {"density", 0.03}};
    EXPECT_THAT(refusal("corner-tiles", values), HasSubstr("density = 0.03: must be more than 0.03125"));
    EXPECT_FALSE(is_deterministic("corner-tiles", "colors", 2));
}

TEST_F(TileSamplers, ChainsBringWhatTheyNeedButOverruleNothing)
{
    const std::pair<std::string, ParameterValue> colors{"colors", whole(2)}, chains{"border", std::string("chain")};
    EXPECT_EQ(refusal("corner-tiles", {colors, chains}), "accepted");
    EXPECT_THAT(refusal("corner-tiles", {colors, chains, {"repulsion", false}}),
                HasSubstr("repulsion = false: must be true for tiles with chains"));
    EXPECT_EQ(refusal("corner-tiles", {colors, {"joint_iterations", whole(3)}}), "accepted");
    EXPECT_THAT(refusal("corner-tiles", {colors, {"null_peaks", true}}),
                HasSubstr("null_peaks = true: must be false without joint iterations"));
}

TEST_F(TileSamplers, RefuseWhatCannotBe)
{
    EXPECT_EQ(refusal("corner-tiles", {{"colors", whole(2)}}), "accepted");
    EXPECT_THAT(refusal("corner-tiles", {}), AllOf(StartsWith("test.toml:9"), HasSubstr("needs colors")));
    EXPECT_THAT(refusal("template-tiles", {}), HasSubstr("needs tiles"));
    EXPECT_THAT(
        refusal("corner-tiles", {{"colors", whole(2)}, {"points_per_tile", whole(4)}, {"relative_radius", 0.8}}),
        AllOf(StartsWith("test.toml:12: relative_radius = 0.8"), HasSubstr("at most 0.54")));
    EXPECT_THAT(refusal("corner-tiles", {{"colors", whole(32)}, {"points_per_tile", whole(4096)}}),
                HasSubstr("more than 4 GiB"));
}

/// The places of a tiling's points in their tiles, of 8 tiles along each axis.
std::set<std::pair<double, double>> places_in_tiles(const PointSet& tiling)
{
    std::set<std::pair<double, double>> places;
    for (std::size_t i = 0; i < tiling.coordinates.size(); i += 2) {
        const double x = 8 * tiling.coordinates[i], y = 8 * tiling.coordinates[i + 1];
        places.emplace(x - std::floor(x), y - std::floor(y));
    }
    return places;
}

TEST_F(TileSamplers, TakeSeveralSetsInTurn)
{
    const auto sampler = [&](std::int64_t sets, Engine engine, std::uint64_t seed) {
        return create("corner-tiles", {{"colors", whole(2)}, {"points_per_tile", whole(16)}, {"sets", whole(sets)}},
                      1024, engine, seed);
    };
    const auto first = sampler(1, Engine::opencl, 7), second = sampler(1, Engine::opencl, 8);
    const auto all = sampler(3, Engine::opencl, 7), twin = sampler(3, Engine::reference, 7);
    EXPECT_EQ(first->traits().tile_sets, 1);
    EXPECT_EQ(all->traits().tile_sets, 3);
    std::set<std::pair<double, double>> of_second;
    for (std::uint32_t k = 0; k < 8; ++k) of_second.merge(places_in_tiles(second->sample(k)));
    for (std::uint32_t k = 0; k < 5; ++k) {
        const PointSet tiling = all->sample(k);
        EXPECT_EQ(twin->sample(k), tiling) << k;
        EXPECT_EQ(first->sample(k) == tiling, k % 3 == 0) << "the first set is that of the seed, realization " << k;
        EXPECT_EQ(std::ranges::includes(of_second, places_in_tiles(tiling)), k % 3 == 1)
            << "the second set is that of the seed after it, realization " << k;
    }
}

}
}
