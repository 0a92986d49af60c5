// Sector darts: regions against counting random places, exact distances, sets that nothing fits into any more, and
// kernels against their twin.
#include "host/sampling/sectors/sector_darts.hpp"

#include "analysis/measures/largest_empty_ball.hpp"
#include "host/sampling/reference/scalloped_region.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/chi_square.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using reference::PolarPlace;
using reference::ScallopedRegion;

struct Disk
{
    PolarPlace centre;
    double radius;
};

void cut_off(ScallopedRegion& region, const Disk& disk)
{
    region.subtract(disk.centre.distance * std::cos(disk.centre.angle),
                    disk.centre.distance * std::sin(disk.centre.angle), disk.radius);
}

/// Disks as neighbours make them: of one radius from one away on, of two radii from two on.
std::vector<Disk> random_disks(std::mt19937& random, int count)
{
    std::uniform_real_distribution<double> angle(-4, 4), distance(1, 4);
    std::vector<Disk> disks;
    for (int i = 0; i < count; ++i) {
        const double away = distance(random);
        disks.push_back({{angle(random), away}, i % 3 == 0 && away > 1.5 ? 2.0 : 1.0});
    }
    return disks;
}

bool is_left(double x, double y, const std::vector<Disk>& disks)
{
    const double squared = x * x + y * y;
    if (squared < 1 || squared > 4) return false;
    return std::ranges::none_of(disks, [&](const Disk& disk) {
        return std::hypot(x - disk.centre.distance * std::cos(disk.centre.angle),
                          y - disk.centre.distance * std::sin(disk.centre.angle)) < disk.radius;
    });
}

TEST(ScallopedRegion, HasTheAreaThatIsLeft)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-2, 2);
    for (int i = 0; i < 40; ++i) {
        const auto disks = random_disks(random, i % 7);
        ScallopedRegion region(1);
        for (const Disk& disk : disks) cut_off(region, disk);
        constexpr int count = 40'000;
        int inside = 0;
        for (int k = 0; k < count; ++k) inside += is_left(place(random), place(random), disks);
        const double part = static_cast<double>(inside) / count;
        EXPECT_NEAR(region.area(), 16 * part, 16 * 5 * std::sqrt(part * (1 - part) / count) + 1e-9) << i;
        EXPECT_EQ(region.is_empty(), region.area() == 0);
    }
    EXPECT_NEAR(ScallopedRegion(2).area(), 3 * std::acos(-1.0) * 4, 1e-12);
}

TEST(ScallopedRegion, SamplesAreUniformAndInside)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    const std::vector<Disk> disks{{{0.3, 1.2}, 1}, {{2.5, 1.8}, 1}, {{-2, 2.6}, 2}};
    ScallopedRegion region(1);
    for (const Disk& disk : disks) cut_off(region, disk);
    // Counts in a grid over the region, against how much of each of its squares is left.
    constexpr int side = 12, samples = 60'000, darts = 600'000;
    std::vector<double> counts(side * side), expected(side * side);
    const auto square = [&](double x, double y) {
        return static_cast<std::size_t>((x + 2) / 4 * side) + side * static_cast<std::size_t>((y + 2) / 4 * side);
    };
    for (int i = 0; i < samples; ++i) {
        const PolarPlace place = region.sample(unit(random), unit(random));
        const double x = place.distance * std::cos(place.angle), y = place.distance * std::sin(place.angle);
        ASSERT_TRUE(is_left(x * (1 + 1e-9), y * (1 + 1e-9), disks) || is_left(x * (1 - 1e-9), y * (1 - 1e-9), disks));
        counts[square(x, y)] += 1;
    }
    int left = 0;
    for (int i = 0; i < darts; ++i) {
        const double x = 4 * unit(random) - 2, y = 4 * unit(random) - 2;
        if (!is_left(x, y, disks)) continue;
        ++left;
        expected[square(x, y)] += 1;
    }
    double chi_square = 0;
    int squares = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const double mean = expected[k] * samples / left;
        if (mean < 50) continue;
        // Both counts are random.
        chi_square += (counts[k] - mean) * (counts[k] - mean) / (mean * (1 + static_cast<double>(samples) / left));
        ++squares;
    }
    EXPECT_GT(squares, 30);
    EXPECT_LT(chi_square, squares + 5 * std::sqrt(2.0 * squares));
}

class SectorDartSets : public testing::TestWithParam<const char*>
{
protected:
    static PointSet sample(double distance, std::uint32_t realization)
    {
        const SamplerSpec spec = sector_dart_sampler();
        Parameters parameters(spec.parameters);
        parameters.set("variant", std::string(GetParam()), {"test.toml", 1});
        parameters.set("min_distance", distance, {"test.toml", 1});
        return spec.create(parameters, {1, 2, 11}, Engine::reference, {})->sample(realization);
    }
};

/// Exactly the distance that is asked for or more, and no circle of that radius is empty, but for the rounding of
/// darts.
TEST_P(SectorDartSets, KeepTheirDistanceAndAreMaximal)
{
    for (const double distance : {0.124, 0.1, 0.03}) {
        for (std::uint32_t realization = 0; realization < 3; ++realization) {
            const PointSet set = sample(distance, realization);
            EXPECT_GE(test::brute_force_min_distance(set), distance);
            EXPECT_LT(largest_empty_ball(set).radius, distance * (1 + 1e-5) + 4 * 0x1p-32);
        }
    }
    EXPECT_EQ(sample(0.05, 1), sample(0.05, 1));
    EXPECT_NE(sample(0.05, 1), sample(0.05, 2));
}

INSTANTIATE_TEST_SUITE_P(Variants, SectorDartSets, testing::Values("logarithmic", "linear", "boundary"),
                         [](const auto& variant) { return std::string(variant.param); });

/// Darts at the least distance pack closer than others, and all have about as many points as are asked for.
TEST(SectorDartVariants, HaveTheNumberOfPointsThatIsAskedFor)
{
    const SamplerSpec spec = sector_dart_sampler();
    for (const char* variant : {"logarithmic", "linear", "boundary"}) {
        Parameters parameters(spec.parameters);
        parameters.set("variant", std::string(variant), {"test.toml", 1});
        const auto sampler = spec.create(parameters, {4096, 2, 11}, Engine::reference, {});
        const auto size = static_cast<double>(sampler->sample(0).size());
        EXPECT_NEAR(size, 4096, 60) << variant;
        EXPECT_LE(size, static_cast<double>(spec.most_points(parameters, {4096, 2, 11})));
    }
}

std::vector<StreamKey> streams_of(std::uint32_t count)
{
    std::vector<StreamKey> streams;
    for (std::uint32_t i = 0; i < count; ++i) streams.push_back(stream_key(7, Purpose::sector_darts, i));
    return streams;
}

/// Compares `count` sets that are made side by side with the twin's, made one after the other.
void expect_same_sets(const SectorDartRequest& request, std::uint32_t count)
{
    static Device device = Device::open();
    const auto streams = streams_of(count);
    const auto sets = SectorDarts(device).throw_darts(request, streams);
    ASSERT_EQ(sets.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(sets[i], reference::throw_sector_darts(request, streams[i])) << i;
}

class SectorDartKernels : public testing::TestWithParam<SectorVariant>
{
};

TEST_P(SectorDartKernels, MakeTheSameFewPoints) { expect_same_sets({0.125, GetParam()}, 2); }

INSTANTIATE_TEST_SUITE_P(Small, SectorDartKernels,
                         testing::Values(SectorVariant::logarithmic, SectorVariant::linear, SectorVariant::boundary));

class ManySectorDartKernels : public SectorDartKernels
{
};

/// Far more points than the steps of a call, so that sets go on where they stopped.
TEST_P(ManySectorDartKernels, MakeTheSamePoints)
{
    expect_same_sets({0.0123, GetParam()}, 3);
    expect_same_sets({0.05, GetParam()}, 5);
}

INSTANTIATE_TEST_SUITE_P(Variants, ManySectorDartKernels,
                         testing::Values(SectorVariant::logarithmic, SectorVariant::linear, SectorVariant::boundary));

/// Sets that are made side by side are those that are made alone, and share the time.
TEST(SectorDartSampler, MakesExpectedSetsSideBySide)
{
    Device device = Device::open();
    const SamplerSpec spec = sector_dart_sampler();
    Parameters parameters(spec.parameters);
    const auto made = [&](Engine engine) {
        return spec.create(parameters, {2048, 2, 3}, engine, [&]() -> Device& { return device; });
    };
    const auto alone = made(Engine::reference), some = made(Engine::opencl);
    EXPECT_FALSE(alone->traits().shared_seconds);
    EXPECT_EQ(some->sample(4), alone->sample(4)); // not expected
    some->expect(5, 20);                          // more than are made at once
    double first = 0;
    for (std::uint32_t k = 5; k < 26; ++k) {
        EXPECT_EQ(some->sample(k), alone->sample(k)) << k;
        ASSERT_TRUE(some->traits().shared_seconds);
        const double share = *some->traits().shared_seconds;
        if (k == 5) first = share;
        EXPECT_EQ(share == first, k <= 20) << k;
    }
    EXPECT_EQ(some->sample(7), alone->sample(7)); // once more
}

}
}
