// Gaussian blue noise: both engines give the same bytes, forces are those of all pairs, the energy falls, and waves in
// even sets decay as theory has it.
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

PointSet random_gaussian_start(std::size_t points, int dimension, unsigned seed)
{
    std::mt19937_64 random(seed);
    return test::random_points(points, dimension, random);
}

struct GaussianCase
{
    int dimension;
    std::size_t points;
    double sigma;
};

void PrintTo(const GaussianCase& c, std::ostream* out)
{
    *out << c.dimension << "D, " << c.points << " points, sigma " << c.sigma;
}

class GaussianSets : public ::testing::TestWithParam<GaussianCase>
{
protected:
    GaussianRequest request(std::size_t iterations) const
    {
        const auto [dimension, points, sigma] = GetParam();
        return {.iterations = iterations, .sigma = sigma, .step = usual_gaussian_step(sigma, dimension)};
    }
};

TEST_P(GaussianSets, AreTheSameByKernelAndReference)
{
    const PointSet start = random_gaussian_start(GetParam().points, GetParam().dimension, 4);
    const LloydResult expected = reference::descend(start, request(3));
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
        const LloydResult result = GaussianBlueNoise(Device::open(), group).descend(start, request(3));
        EXPECT_EQ(result.points, expected.points);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(result.iterations[i].energy, expected.iterations[i].energy, 1e-9);
            EXPECT_EQ(result.iterations[i].relative_radius, expected.iterations[i].relative_radius);
        }
    }
}

/// Forces of all pairs and of four images along each axis, in double precision: they differ by what the header states.
TEST_P(GaussianSets, MoveByTheForcesOfAllPairs)
{
    const auto [dimension, points, sigma] = GetParam();
    if (points > 1600) GTEST_SKIP() << "a direct sum takes too long";
    const PointSet start = random_gaussian_start(points, dimension, 5);
    const GaussianRequest one = request(1);
    const LloydResult result = GaussianBlueNoise(Device::open()).descend(start, one);
    const auto axes = static_cast<std::size_t>(dimension);
    const double side = std::pow(static_cast<double>(points), 1.0 / dimension);
    // Forces of some ten neighbours, each of a relative error of a few 2^-23, and what is cut off; in 3D, where wide
    // Gaussians have a hundred neighbours, what the header states for that.
    const double tolerance = dimension == 3 && sigma == 1 ? 2.3e-5 : 4e-6;
    double energy = 0, least = 1;
    for (std::size_t i = 0; i < points; ++i) {
        std::array<double, 3> force{};
        for (std::size_t j = 0; j < points; ++j)
            for (int image = 0; image < (dimension == 2 ? 9 : 27); ++image) {
                std::array<double, 3> d{};
                double squared = 0;
                for (std::size_t k = 0; k < axes; ++k) {
                    const int turn = (image / (k == 0 ? 1 : k == 1 ? 3 : 9)) % 3 - 1;
                    d[k] = (start[j][k] - start[i][k] + turn) * side;
                    squared += d[k] * d[k];
                }
                if (squared == 0) continue;
                least = std::min(least, std::sqrt(squared) / side);
                const double gaussian = std::exp(-squared / (2 * sigma * sigma));
                energy += gaussian;
                for (std::size_t k = 0; k < axes; ++k) force[k] -= d[k] * gaussian / (sigma * sigma);
            }
        for (std::size_t k = 0; k < axes; ++k) {
            const double moved = std::remainder(result.points[i][k] - start[i][k], 1.0) * side;
            EXPECT_NEAR(moved / one.step, force[k], tolerance);
        }
    }
    EXPECT_NEAR(result.iterations[0].energy, gaussian_energy(energy, points, sigma, dimension), 1e-5);
    EXPECT_NEAR(result.iterations[0].relative_radius, relative_radius(least, points, dimension), 1e-5);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, GaussianSets, ::testing::Values(GaussianCase{2, 140, 1.0}, GaussianCase{3, 60, 0.32}));
INSTANTIATE_TEST_SUITE_P(Sizes, GaussianSets,
                         ::testing::Values(GaussianCase{2, 135, 1.0}, GaussianCase{2, 211, 1.0},
                                           GaussianCase{2, 300, 0.7}, GaussianCase{2, 1000, 1.3},
                                           GaussianCase{2, 5000, 1.0}, GaussianCase{3, 1600, 1.0},
                                           GaussianCase{3, 500, 0.5}, GaussianCase{3, 4000, 1.0}));

TEST(GaussianBlueNoiseEnergy, FallsAtEveryStep)
{
    for (const int dimension : {2, 3}) {
        const std::size_t points = dimension == 2 ? 4096 : 3100;
        const PointSet start = random_gaussian_start(points, dimension, 6);
        const GaussianRequest request{
            .iterations = dimension == 2 ? 100u : 25u, .sigma = 1, .step = usual_gaussian_step(1, dimension)};
        const auto records = GaussianBlueNoise(Device::open()).descend(start, request).iterations;
        // Random points have 1: the variance of the mean is that of a sum over pairs, 2 (pi)^(d / 2) / points.
        const double deviation =
            std::sqrt(2 * std::pow(std::numbers::pi, 0.5 * dimension) / static_cast<double>(points));
        EXPECT_NEAR(records[0].energy, 1, test::z_bound(2) * deviation);
        for (std::size_t i = 1; i < records.size(); ++i) EXPECT_LT(records[i].energy, records[i - 1].energy) << i;
        EXPECT_LT(records.back().energy, 0.1);
        EXPECT_GT(records.back().energy, 0);
    }
}

/// A wave of k in an even set meets a resistance of k^2 times the Gaussian's transform, (2 pi) exp(-k^2 / 2), so that a
/// step takes so much of it.
TEST(GaussianBlueNoiseForces, LetWavesDecayAsTheTransformOfTheGaussianSays)
{
    constexpr int n = 32;
    for (const int waves : {1, 3, 7}) {
        PointSet set = test::square_lattice(n, 2);
        const PointSet lattice = set;
        const double k = 2 * std::numbers::pi * waves / n; // a mean distance is 1
        const auto shift = [&](std::size_t i) { return std::sin(k * n * lattice[i][0]); };
        constexpr double height = 1e-3 / n;
        for (std::size_t i = 0; i < set.size(); ++i) {
            double& x = set.coordinates[2 * i];
            x += height * shift(i);
            x -= std::floor(x);
        }
        const PointSet after =
            GaussianBlueNoise(Device::open()).descend(set, {.iterations = 1, .sigma = 1, .step = 0.25}).points;
        double left = 0;
        for (std::size_t i = 0; i < set.size(); ++i)
            left += 2 * std::remainder(after[i][0] - lattice[i][0], 1.0) * shift(i) / height / (n * n);
        // Rounding: forces err by some 1e-6, the height of the wave is 1e-3, and 1,024 points are averaged.
        EXPECT_NEAR(left, 1 - 0.25 * k * k * 2 * std::numbers::pi * std::exp(-k * k / 2), 5e-4) << waves;
    }
}

/// Pairs of points with nothing around them: their forces are single Gaussians, at distances up to beyond the cut-off.
TEST(GaussianBlueNoiseForces, OfAPairErrByLessThanStated)
{
    constexpr std::size_t columns = 6, points = 576;
    constexpr double side = 24, sigma = 0.3, step = 0.01, part = 1.0 / columns;
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto in_fixed_point = [](double c) { return std::floor(c * 0x1p32) * 0x1p-32; };
    for (int repetition = 0; repetition < 20; ++repetition) {
        PointSet set{2, {}};
        for (std::size_t pair = 1; pair < columns * columns; ++pair) {
            const double x = static_cast<double>(pair % columns) * part, y = static_cast<double>(pair / columns) * part;
            const double distance = uniform(random) * 6 * sigma / side, angle = uniform(random) * std::numbers::pi / 2;
            set.coordinates.insert(set.coordinates.end(), {x, y, in_fixed_point(x + distance * std::cos(angle)),
                                                           in_fixed_point(y + distance * std::sin(angle))});
        }
        for (double& c : set.coordinates) c = in_fixed_point(c);
        const std::size_t paired = set.size();
        set.coordinates.resize(2 * points); // all others are in a corner
        const PointSet moved =
            GaussianBlueNoise(Device::open()).descend(set, {.iterations = 1, .sigma = sigma, .step = step}).points;
        for (std::size_t i = 0; i < paired; i += 2) {
            const double x = (set[i + 1][0] - set[i][0]) * side, y = (set[i + 1][1] - set[i][1]) * side;
            const double squared = (x * x + y * y) / (sigma * sigma);
            const double push = std::remainder(moved[i + 1][0] - set[i + 1][0], 1.0) * side * x +
                                std::remainder(moved[i + 1][1] - set[i + 1][1], 1.0) * side * y;
            const double gaussian = push / step / squared;
            // Displacements are exact to 2^-53 of the torus' side.
            EXPECT_NEAR(gaussian, std::exp(-squared / 2), 3e-7 + 0x1p-52 * side / step / std::sqrt(squared)) << squared;
        }
    }
}

TEST(GaussianBlueNoiseSampler, RefusesTorusesThatAreTooNarrow)
{
    const SamplerSpec& spec = *find_sampler("gaussian-blue-noise");
    Parameters parameters(spec.parameters);
    const auto refusal = [&](std::size_t points, int dimension) {
        return refusal_of([&] { spec.check(parameters, {points, dimension, 1}, {"test.toml", 9}); });
    };
    EXPECT_EQ(refusal(135, 2), "accepted");
    EXPECT_THAT(refusal(134, 2), testing::HasSubstr("test.toml:9: Gaussian blue noise needs at least 135 "));
    EXPECT_THAT(refusal(1000, 3), testing::HasSubstr("needs at least 1561 points in 3D"));
    parameters.set("sigma", 2.0, {"test.toml", 10});
    EXPECT_THAT(refusal(500, 2), testing::HasSubstr("test.toml:10: sigma = 2: 500 points are too few"));
}

/// Children at plus and minus a quarter q along each axis multiply the transform of the coarse set by 2 cos(2 pi f q).
TEST(GaussianLevels, SplitPointsKeepTheTransformOfTheCoarseSet)
{
    for (const int dimension : {2, 3}) {
        const std::size_t count = dimension == 2 ? 100 : 64;
        const PointSet coarse = random_gaussian_start(count, dimension, 9);
        const std::size_t children = std::size_t{1} << dimension;
        const PointSet fine = split_points(coarse, children * count);
        ASSERT_EQ(fine.size(), children * count);
        const double quarter = 0.25 / (dimension == 2 ? 10 : 4);
        for (const std::array<int, 3> f : {std::array{1, 0, 0}, std::array{3, -2, 0}, std::array{0, 7, 0}}) {
            std::complex<long double> expected = test::brute_force_transform(coarse, f);
            for (int k = 0; k < dimension; ++k)
                expected *= 2 * std::cos(2 * std::numbers::pi * f[static_cast<std::size_t>(k)] * quarter);
            EXPECT_LT(std::abs(test::brute_force_transform(fine, f) - expected), 1e-10);
        }
        EXPECT_EQ(coarser_points(children * count, dimension), count);
        EXPECT_EQ(coarser_points(children * count - 1, dimension), count);
        EXPECT_EQ(split_points(coarse, children * count - 1).size(), children * count - 1);
    }
}

/// Waves as long as the torus decay by a step as slowly as they are long in mean distances: a coarse set needs fewer.
TEST(GaussianLevels, MakeSetsEvenAtLargeDistancesInFewerSteps)
{
    const SamplerSpec& spec = *find_sampler("gaussian-blue-noise");
    Device device = Device::open();
    const auto low_power = [&](std::int64_t levels, Engine engine) {
        Parameters parameters(spec.parameters);
        parameters.set("iterations", std::int64_t{30});
        parameters.set("levels", levels);
        const auto sampler = spec.create(parameters, {4093, 2, 3}, engine, [&]() -> Device& { return device; });
        const PointSet set = sampler->sample(0);
        EXPECT_EQ(set.size(), 4093u);
        EXPECT_EQ(sampler->traits().iterations.size(), 31 * (static_cast<std::size_t>(levels) + 1));
        double power = 0;
        for (const std::array<int, 3> f : {std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{1, 1, 0},
                                           std::array{1, -1, 0}, std::array{2, 0, 0}, std::array{0, 2, 0}})
            power += test::brute_force_power(set, f) / 6;
        return power;
    };
    // 30 steps leave exp(-30 * 0.25 * k^2 * 2 pi) = 0.65 of a wave's height at k = 2 pi / 64, and of that of a coarse
    // set, which is 4 times as wide, 0.001.
    EXPECT_LT(low_power(2, Engine::opencl), 0.1 * low_power(0, Engine::opencl));
    EXPECT_EQ(low_power(2, Engine::opencl), low_power(2, Engine::reference));
}

TEST(GaussianLevels, TooManyAreSaid)
{
    const SamplerSpec& spec = *find_sampler("gaussian-blue-noise");
    Parameters parameters(spec.parameters);
    parameters.set("levels", std::int64_t{2}, {"test.toml", 4});
    EXPECT_THAT(
        message_of([&] {
            spec.check(parameters, {1000, 2, 1}, {"test.toml", 3});
        }),
        testing::HasSubstr("test.toml:4: levels = 2: the coarsest sets would have 63 points, and need at least 135"));
}

}
}
