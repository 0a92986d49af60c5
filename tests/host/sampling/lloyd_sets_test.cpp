// Lloyd relaxation of sets side by side: the bits of relaxing them one after the other.
#include "host/sampling/lloyd_sets.hpp"

#include "host/settings/sampler_registry.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <map>

namespace poissonlab {
namespace {

void expect_equal(const LloydResult& result, const LloydResult& expected)
{
    EXPECT_EQ(result.points, expected.points);
    EXPECT_EQ(result.kept, expected.kept);
    ASSERT_EQ(result.iterations.size(), expected.iterations.size());
    for (std::size_t i = 0; i < result.iterations.size(); ++i) {
        EXPECT_EQ(result.iterations[i].energy, expected.iterations[i].energy) << i;
        EXPECT_EQ(result.iterations[i].relative_radius, expected.iterations[i].relative_radius) << i;
    }
}

/// Random points, crowded ones, points on a line, and points that all coincide.
std::vector<PointSet> different_sets(std::size_t points)
{
    std::mt19937_64 random(points);
    PointSet line = test::random_points(points, 2, random);
    for (std::size_t i = 0; i < points; ++i) line.coordinates[2 * i + 1] = 0.25;
    return {test::random_points(points, 2, random), test::clustered_points(points, 2, 3, 0.01, random), line,
            PointSet{2, std::vector<double>(2 * points, 0.75)}, test::random_points(points, 2, random)};
}

class LloydSetsOf : public ::testing::TestWithParam<std::size_t>
{
};

INSTANTIATE_TEST_SUITE_P(Points, LloydSetsOf, ::testing::Values(1, 2, 3, 10, 64, 257, 700));

TEST_P(LloydSetsOf, HaveTheBitsOfEachAlone)
{
    const std::vector<PointSet> sets = different_sets(GetParam());
    for (const unsigned threads : {0u, 1u}) {
        Device device = Device::open({}, threads);
        for (const std::size_t iterations : {0, 1, 12}) {
            const std::vector<LloydResult> results = LloydSets(device).relax(sets, iterations);
            ASSERT_EQ(results.size(), sets.size());
            for (std::size_t k = 0; k < sets.size(); ++k)
                expect_equal(results[k], LloydRelaxation(device, 16).relax(sets[k], {}, {iterations}));
        }
    }
}

TEST(LloydSets, HaveTheBitsOfEachAloneAfterManyBatches)
{
    const std::vector<PointSet> sets{different_sets(100)[0], different_sets(100)[4]};
    const std::vector<LloydResult> results = LloydSets(Device::open()).relax(sets, 500);
    for (std::size_t k = 0; k < sets.size(); ++k)
        expect_equal(results[k], LloydRelaxation(Device::open()).relax(sets[k], {}, {500}));
}

TEST(LloydSets, AreFasterOnProcessorsWhereThreadsHaveSetsOfFewPoints)
{
    DeviceInfo device;
    device.type = "CPU";
    device.compute_units = 8;
    EXPECT_TRUE(LloydSets::are_faster(device, 1, 256));
    EXPECT_FALSE(LloydSets::are_faster(device, 1, 1024)); // seven threads would have nothing to do
    EXPECT_TRUE(LloydSets::are_faster(device, 8, 1024));
    EXPECT_FALSE(LloydSets::are_faster(device, 4, 4096));
    EXPECT_FALSE(LloydSets::are_faster(device, 33, 256)); // they would be too many to make at once
    device.compute_units = 2;
    EXPECT_TRUE(LloydSets::are_faster(device, 4, 4096));
    EXPECT_FALSE(LloydSets::are_faster(device, 3, 4096)); // the last one would keep a thread waiting
    EXPECT_FALSE(LloydSets::are_faster(device, 5, 4096));
    EXPECT_FALSE(LloydSets::are_faster(device, 2, 4097));
    device.type = "GPU";
    EXPECT_FALSE(LloydSets::are_faster(device, 8, 256));
}

struct SetsCase
{
    std::string start;
    std::string keep;
    std::size_t points;
    int dimension;
    std::int64_t iterations;
};

TEST(LloydSets, AreTheRealizationsOfTheSampler)
{
    Device device = Device::open();
    const SamplerSpec& spec = *find_sampler("lloyd");
    const SetsCase cases[] = {
        {"random", "last", 300, 2, 9},  {"dart-throwing", "last", 300, 2, 9}, // to saturation: sizes differ
        {"random", "best", 300, 2, 9},  {"random", "last", 300, 3, 3},
        {"random", "last", 5000, 2, 3}, {"random", "last", 1, 2, 3}};
    for (const SetsCase& c : cases) {
        Parameters start(find_sampler(c.start)->parameters);
        if (c.start == "dart-throwing") start.set("stop", std::string("saturation"), {});
        Parameters parameters(spec.parameters);
        parameters.set("iterations", c.iterations, {});
        parameters.set("keep", c.keep, {});
        parameters.set("start", std::make_shared<const SamplerChoice>(SamplerChoice{find_sampler(c.start), start}), {});
        const auto create = [&] {
            return spec.create(parameters, {.points = c.points, .dimension = c.dimension, .seed = 5}, Engine::opencl,
                               [&]() -> Device& { return device; });
        };
        const auto alone = create();
        const auto expected = create();
        expected->expect(2, 5);
        for (const std::uint32_t realization :
             {2, 3, 5, 6, 7, 4}) { // one is left out, and one comes that nobody expects
            EXPECT_EQ(expected->sample(realization), alone->sample(realization)) << c.start << realization;
            EXPECT_EQ(expected->traits().iterations, alone->traits().iterations) << c.start << realization;
            EXPECT_GE(expected->traits().shared_seconds.value(), 0);
        }
    }
}

/// Random points, none for realization 4, and from 6 on one more in each set than in the one before.
class StartThatFails final : public Sampler
{
public:
    PointSet sample(std::uint32_t realization) override
    {
        if (realization == 4) throw InputError("no points for 4");
        std::mt19937_64 random(realization);
        return test::random_points(realization < 6 ? 200 : 194 + realization, 2, random);
    }
    void expect(std::uint32_t, std::uint32_t) override { ADD_FAILURE() << "times of sets would be those of others"; }
};

TEST(LloydSets, AreMadeBeforeAStartThatFails)
{
    Device device = Device::open();
    SamplerSpec start;
    start.create = [](const auto&, const auto&, Engine, const auto&) { return std::make_unique<StartThatFails>(); };
    for (const std::string name : {"lloyd", "gaussian-blue-noise"}) {
        const SamplerSpec& spec = *find_sampler(name);
        Parameters parameters(spec.parameters);
        parameters.set("iterations", std::int64_t{3}, {});
        parameters.set("start", std::make_shared<const SamplerChoice>(SamplerChoice{&start, {}}), {});
        const auto create = [&] {
            return spec.create(parameters, {.points = 200, .dimension = 2, .seed = 5}, Engine::opencl,
                               [&]() -> Device& { return device; });
        };
        const auto alone = create(), sampler = create();
        for (const std::uint32_t realization : {1, 2, 3, 5, 6, 7, 8}) {
            sampler->expect(realization, 9 - realization);
            EXPECT_EQ(sampler->sample(realization), alone->sample(realization)) << name << realization;
        }
        EXPECT_THROW(sampler->sample(4), InputError);
    }
}

}
}
