// Gaussian blue noise of a density: blurs, widths and pulls against closed forms, kernel and twin, forces against
// direct sums, and where the points come to lie.
#include "host/sampling/optimized/gaussian_field.hpp"

#include "base/densities/density_text.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/optimized/torus_map.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using std::numbers::pi;

TorusMap map_of_wave(std::size_t size, int waves_x, int waves_y)
{
    TorusMap map{size, {}};
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column < size; ++column)
            map.values.push_back(std::cos(
                2 * pi * (waves_x * (static_cast<double>(column) + 0.5) + waves_y * (static_cast<double>(row) + 0.5)) /
                static_cast<double>(size)));
    return map;
}

/// The transform of a Gaussian is one: a wave of k cycles keeps exp(-2 pi^2 sigma^2 k^2) of its height. What is cut off
/// beyond six sigma is 2e-9 of the sum.
TEST(TorusMap, BlursWavesByTheTransformOfTheGaussian)
{
    constexpr std::size_t n = 64;
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{2, 5}, std::pair{-3, 9}})
        for (const double sigma : {1.5, 4.0, 10.5}) {
            const TorusMap wave = map_of_wave(n, x, y), soft = blurred(wave, sigma);
            const double k2 = (x * x + y * y) / double{n * n};
            const double kept = std::exp(-2 * pi * pi * sigma * sigma * k2);
            for (std::size_t i = 0; i < n * n; ++i) ASSERT_NEAR(soft.values[i], kept * wave.values[i], 1e-8);
        }
}

/// Differences of fourth order err by k^5 h^4 / 30 for a wave of k radians.
TEST(TorusMap, HasTheSlopesOfWaves)
{
    constexpr std::size_t n = 128;
    const TorusMap wave = map_of_wave(n, 3, -2), x = slope_along_x(wave), y = slope_along_y(wave);
    for (std::size_t i = 0; i < n * n; ++i) {
        const auto column = static_cast<double>(i % n), row = static_cast<double>(i / n);
        const double phase = 2 * pi * (3 * (column + 0.5) - 2 * (row + 0.5)) / n;
        ASSERT_NEAR(x.values[i], -6 * pi * std::sin(phase), 1.01 * std::pow(6 * pi, 5) / std::pow(n, 4) / 30);
        ASSERT_NEAR(y.values[i], 4 * pi * std::sin(phase), 1.01 * std::pow(4 * pi, 5) / std::pow(n, 4) / 30);
    }
}

TEST(TorusMap, IsLinearBetweenMiddles)
{
    const TorusMap map{2, {1, 3, 5, 11}};
    EXPECT_EQ(map.between(0.25, 0.25), 1);
    EXPECT_EQ(map.between(0.5, 0.25), 2);
    EXPECT_EQ(map.between(0.0, 0.75), 8);
    EXPECT_EQ(map.between(0.5, 0.5), 5);
    EXPECT_EQ(halved(map).values, std::vector{5.0});
}

/// One wave over the torus of height a, along x.
constexpr const char* wave_density = "1 + 0.8*cos(pi*x)";
constexpr double wave_height = 0.8;

/// The squared width of a cell's Gaussian, in squared mean distances of so many points: its exponent is -log2(e) / 2
/// over it, in squared units of 2^-32 of the torus' side.
double squared_width(const contract::gaussian_blue_noise::DensityCell& cell, std::size_t points)
{
    return -0.5 * std::numbers::log2e / double{cell.exponent} * 0x1p-64 * static_cast<double>(points);
}

/// A place's Gaussian has as much of the density under it as one of sigma mean distances has of an even one, or would
/// have if the density were that of the place, and the pull is the slope of the density blurred by it.
TEST(GaussianField, OfAWaveHasTheWidthsAndPullsOfItsBlur)
{
    constexpr std::size_t points = 1024;
    constexpr double step = 0.25, side = 32;
    const GaussianField field = gaussian_field(density_of_formula(wave_density, 1, 1), 1, step, points);
    const auto size = static_cast<std::size_t>(field.shape.size);
    const double widest = std::pow(2, field.shape.widest / 2.0);
    std::size_t wide = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const contract::gaussian_blue_noise::DensityCell& cell = field.cells[size * (size / 3) + i];
        // The formula's x goes from -1 to 1.
        const double phase = 2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(size) - pi;
        const double squared = squared_width(cell, points);
        const double blur = wave_height * std::exp(-2 * pi * pi * squared / (side * side));
        // Maps have cells of a quarter of the Gaussian and less, linear between their middles: an error of h^2 / 8 of
        // the second derivative, (2 pi / 64)^2 / 8 of the wave's height on the coarsest. What is under a Gaussian is
        // taken as linear between squared widths w a factor of sqrt(2) apart, for which it is w (1 + h exp(-c w)), c =
        // 0.02: it errs by (0.3 w)^2 / 8 * 2 h c.
        constexpr double tolerance = 0.0013;
        const double under_tolerance = squared * tolerance + 0.0004 * squared * squared;
        const double under = squared * (1 + blur * std::cos(phase));
        EXPECT_NEAR(under, 1 + cell.excess / (2 * pi), under_tolerance) << i;
        if (squared < 0.99 * widest) {
            const double if_as_the_place = squared * (1 + wave_height * std::cos(phase));
            EXPECT_NEAR(std::max(under, if_as_the_place), 1, under_tolerance) << i;
        }
        const double pull = step * 2 * pi * squared * squared / (side * side);
        EXPECT_NEAR(cell.x, -pull * blur * 2 * pi * std::sin(phase), pull * 2 * pi * tolerance) << i;
        EXPECT_NEAR(cell.y, 0, 1e-12);
        wide += squared > 1;
    }
    EXPECT_GT(wide, size / 4); // half of the wave is below its mean
}

TEST(GaussianField, OfAConstantDensityPullsNowhere)
{
    const GaussianField field = gaussian_field(density_of_formula("0.3", 1, 1), 1, 0.25, 1000);
    EXPECT_EQ(field.shape.narrowest, 0);
    for (const auto& cell : field.cells) {
        ASSERT_EQ(cell.x, 0);
        ASSERT_EQ(cell.y, 0);
        ASSERT_EQ(cell.excess, 0);
        ASSERT_EQ(cell.exponent, gaussian_exponent(1e-3));
    }
}

struct AdaptiveCase
{
    std::size_t points;
    double sigma;
    const char* density;
};

void PrintTo(const AdaptiveCase& c, std::ostream* out)
{
    *out << c.points << " points, sigma " << c.sigma << ", " << c.density;
}

class AdaptiveSets : public ::testing::TestWithParam<AdaptiveCase>
{
protected:
    AdaptiveSets()
    {
        std::mt19937_64 random(12);
        start_ = test::random_points_with_borders(GetParam().points, 2, random);
    }

    GaussianRequest request(std::size_t iterations) const
    {
        const auto& [points, sigma, density] = GetParam();
        const double step = usual_gaussian_step(sigma, 2);
        return {.iterations = iterations,
                .sigma = sigma,
                .step = step,
                .field = std::make_shared<const GaussianField>(
                    gaussian_field(density_of_formula(density, 1, 1), sigma, step, points))};
    }

    PointSet start_;
};

TEST_P(AdaptiveSets, AreTheSameByKernelAndReference)
{
    const LloydResult expected = reference::descend(start_, request(3));
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
        const LloydResult result = GaussianBlueNoise(Device::open(), group).descend(start_, request(3));
        EXPECT_EQ(result.points, expected.points);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(result.iterations[i].energy, expected.iterations[i].energy, 1e-9);
            EXPECT_EQ(result.iterations[i].relative_radius, expected.iterations[i].relative_radius);
        }
    }
}

// Oclgrind interprets this as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, AdaptiveSets, ::testing::Values(AdaptiveCase{140, 1.0, "1 + 0.9*cos(pi*x)*cos(pi*y)"}));
INSTANTIATE_TEST_SUITE_P(Sizes, AdaptiveSets,
                         ::testing::Values(AdaptiveCase{500, 1.0, "exp(-10*(x^2+y^2)) + 0.01"},
                                           AdaptiveCase{777, 0.6, "x < 0 ? 1 : 0"},
                                           AdaptiveCase{600, 1.3, "gauss-and-waves"},
                                           AdaptiveCase{300, 1.0, "abs(x) < 0.1 && abs(y) < 0.1 ? 1 : 0.01"}));

/// With a field that pulls nowhere, the same bytes as without one.
TEST(AdaptiveGaussians, OfAConstantDensityAreThoseWithoutOne)
{
    for (const std::size_t points : {std::size_t{140}, std::size_t{3000}}) {
        std::mt19937_64 random(13);
        const PointSet start = test::random_points(points, 2, random);
        GaussianRequest request{.iterations = 5, .sigma = 1, .step = 0.25};
        const LloydResult plain = GaussianBlueNoise(Device::open()).descend(start, request);
        request.field = std::make_shared<const GaussianField>(
            gaussian_field(density_of_formula("7", 1, 1), request.sigma, request.step, points));
        const LloydResult constant = GaussianBlueNoise(Device::open()).descend(start, request);
        EXPECT_EQ(constant.points, plain.points);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(constant.iterations[i].energy, plain.iterations[i].energy);
    }
}

/// The pull of the wave on a point, for a unit step: by the width of each of the two cells beside it, linear between
/// their middles; in mean distances.
double pull_of_wave(const GaussianField& field, double x, double side)
{
    const auto size = static_cast<double>(field.shape.size);
    const double left = std::floor(x * size - 0.5), part = x * size - 0.5 - left, wave = 2 * pi / side;
    const auto at_middle = [&](double column) {
        const double wrapped = column < 0 ? column + size : column >= size ? column - size : column;
        const double squared =
            squared_width(field.cells[static_cast<std::size_t>(wrapped)], static_cast<std::size_t>(side * side));
        return -2 * pi * squared * squared * wave_height * wave * std::sin(2 * pi * (wrapped + 0.5) / size - pi) *
               std::exp(-0.5 * wave * wave * squared);
    };
    return at_middle(left) * (1 - part) + at_middle(left + 1) * part;
}

/// A step against sums over all points, with the width of the point's own cell, and the pull of the density's wave.
TEST(AdaptiveGaussians, MoveByTheForcesOfAllPairsAndOfTheDensity)
{
    constexpr std::size_t points = 400;
    constexpr double side = 20, step = 0.25;
    std::mt19937_64 random(14);
    const PointSet start = test::random_points(points, 2, random);
    const auto field =
        std::make_shared<const GaussianField>(gaussian_field(density_of_formula(wave_density, 1, 1), 1, step, points));
    const LloydResult result =
        GaussianBlueNoise(Device::open()).descend(start, {.iterations = 1, .sigma = 1, .step = step, .field = field});
    const auto cell_number = [&](double c) { return static_cast<std::size_t>(c * field->shape.size); };
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t cell = cell_number(start[i][1]) * field->shape.size + cell_number(start[i][0]);
        const double squared = squared_width(field->cells[cell], points);
        double force[2] = {};
        for (std::size_t j = 0; j < points; ++j)
            for (int image = 0; image < 9 && j != i; ++image) {
                const double dx = (start[j][0] - start[i][0] + image % 3 - 1) * side;
                const double dy = (start[j][1] - start[i][1] + image / 3 - 1) * side;
                const double gaussian = std::exp(-(dx * dx + dy * dy) / (2 * squared));
                force[0] -= dx * gaussian;
                force[1] -= dy * gaussian;
            }
        // Pairs: as without a density. The density: as its pull above; widths of cells beside each other are alike.
        const double of_pairs = 1e-5, of_density = 1.2 * 2 * pi * squared * squared * 2 * pi / side * 0.0013;
        const double moved_x = std::remainder(result.points[i][0] - start[i][0], 1.0) * side;
        const double moved_y = std::remainder(result.points[i][1] - start[i][1], 1.0) * side;
        EXPECT_NEAR(moved_x / step, force[0] + pull_of_wave(*field, start[i][0], side), of_pairs + of_density) << i;
        EXPECT_NEAR(moved_y / step, force[1], of_pairs) << i;
    }
}

/// The sampler's sets for a density.
class AdaptiveSampler
{
public:
    AdaptiveSampler(std::size_t points, const std::string& density, std::int64_t iterations = 300)
        : parameters_(spec_.parameters), request_{points, 2, 21}
    {
        parameters_.set("density", density);
        parameters_.set("iterations", iterations);
        sampler_ = spec_.create(parameters_, request_, Engine::opencl, [this]() -> Device& { return device_; });
    }

    PointSet set(std::uint32_t realization) { return sampler_->sample(realization); }

private:
    const SamplerSpec& spec_ = *find_sampler("gaussian-blue-noise");
    Parameters parameters_;
    SampleRequest request_;
    Device device_ = Device::open();
    std::unique_ptr<Sampler> sampler_;
};

/// Counts of points in windows of a 4 x 4 grid.
std::vector<double> window_counts(const PointSet& set)
{
    std::vector<double> counts(16);
    for (std::size_t i = 0; i < set.size(); ++i)
        ++counts[static_cast<std::size_t>(set[i][1] * 4) * 4 + static_cast<std::size_t>(set[i][0] * 4)];
    return counts;
}

/// The mean of cos(pi x) over the windows' columns, x from -1 to 1: differences of sin(pi x) / pi.
double wave_in_column(std::size_t column)
{
    const auto primitive = [](double x) { return std::sin(pi * x) / pi; };
    const double low = static_cast<double>(column) / 2 - 1;
    return (primitive(low + 0.5) - primitive(low)) / 0.5;
}

TEST(AdaptiveGaussians, HaveAsManyPointsInWindowsAsTheDensity)
{
    constexpr std::size_t points = 2048;
    constexpr int sets = 8;
    AdaptiveSampler sampler(points, "1 + 0.8*cos(pi*x)*cos(pi*y)");
    std::vector<double> sums(16);
    double spread = 0;
    const auto expected = [&](std::size_t window) {
        return points / 16.0 * (1 + wave_height * wave_in_column(window % 4) * wave_in_column(window / 4));
    };
    for (std::uint32_t k = 0; k < sets; ++k) {
        const std::vector<double> counts = window_counts(sampler.set(k));
        for (std::size_t i = 0; i < 16; ++i) {
            sums[i] += counts[i];
            spread += std::pow(counts[i] - expected(i), 2) / expected(i) / (16 * sets);
        }
    }
    // Independent points would have 1, with a deviation of sqrt(2 / 128). Even ones differ at the border alone: of the
    // some 4 sqrt(n) points there, each is in or out with a variance of at most 1/4 of it, in n points: 1 / sqrt(n).
    EXPECT_LT(spread, 1 / std::sqrt(expected(0)));
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_NEAR(sums[i] / sets, expected(i), test::z_bound(16) * std::sqrt(std::sqrt(expected(i)) / sets)) << i;
}

/// Mean distances to the nearest points of a set, in local mean distances, within a range of x; away from borders.
test::Mean local_spacing(const PointSet& set, double low, double high, double density)
{
    std::vector<double> distances;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set[i][0] < low || set[i][0] > high) continue;
        double nearest = 1;
        for (std::size_t j = 0; j < set.size(); ++j) {
            const double dx = std::remainder(set[j][0] - set[i][0], 1.0),
                         dy = std::remainder(set[j][1] - set[i][1], 1.0);
            if (j != i) nearest = std::min(nearest, dx * dx + dy * dy);
        }
        distances.push_back(std::sqrt(nearest * static_cast<double>(set.size()) * density));
    }
    return test::mean_of(distances);
}

/// Four times the density on one side: half the distances there, and each side as even as a set of its own density.
TEST(AdaptiveGaussians, HaveTheSpacingOfTheLocalDensity)
{
    AdaptiveSampler sampler(2000, "x < 0 ? 4 : 1"), even(2000, "1");
    const PointSet set = sampler.set(0);
    const test::Mean dense = local_spacing(set, 0.1, 0.4, 4 / 2.5), sparse = local_spacing(set, 0.65, 0.85, 1 / 2.5);
    const test::Mean uniform = local_spacing(even.set(0), 0, 1, 1);
    EXPECT_LT(std::abs(test::z_score(dense, uniform)), test::z_bound(2)) << dense.value << ' ' << uniform.value;
    EXPECT_LT(std::abs(test::z_score(sparse, uniform)), test::z_bound(2)) << sparse.value << ' ' << uniform.value;
    EXPECT_LT(dense.standard_error, 0.01); // a wrong density by a tenth would be 5 % in distances
}

/// Gaussians of the density around alone are too wide on the dense side of a border, and points come to lie on top of
/// each other: the nearest two of this set would be at 0.08 of the mean distance there. Even sets of as many points and
/// steps have 0.45 to 0.54, three of them.
TEST(AdaptiveGaussians, KeepPointsApartAtBorders)
{
    AdaptiveSampler sampler(2000, "x < 0 ? 4 : 1", 600);
    const PointSet set = sampler.set(0);
    double nearest = 1;
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            nearest = std::min(nearest, std::hypot(std::remainder(set[i][0] - set[j][0], 1.0),
                                                   std::remainder(set[i][1] - set[j][1], 1.0)));
    const double dense_spacing = 1 / std::sqrt(2000 * 4 / 2.5);
    EXPECT_GT(nearest, 0.4 * dense_spacing);
}

TEST(AdaptiveGaussians, LeaveEmptyPlacesEmpty)
{
    AdaptiveSampler sampler(1500, "x^2 + y^2 < 0.5 ? 1 : 0");
    const PointSet set = sampler.set(0);
    // The field's cells are 1 / 256 wide and more: their diagonal is 0.011 of the formula's x.
    for (std::size_t i = 0; i < set.size(); ++i)
        EXPECT_LT(std::hypot(2 * set[i][0] - 1, 2 * set[i][1] - 1), std::sqrt(0.5) + 0.012) << i;
}

TEST(AdaptiveGaussians, OfAConstantDensityAreTheUniformMethod)
{
    AdaptiveSampler constant(500, "3", 20);
    const SamplerSpec& spec = *find_sampler("gaussian-blue-noise");
    Parameters parameters(spec.parameters);
    parameters.set("iterations", std::int64_t{20});
    Device device = Device::open();
    const auto uniform = spec.create(parameters, {500, 2, 21}, Engine::opencl, [&]() -> Device& { return device; });
    EXPECT_EQ(constant.set(3), uniform->sample(3));
}

TEST(AdaptiveGaussians, AreRefusedWhereTheyCannotBe)
{
    const SamplerSpec& spec = *find_sampler("gaussian-blue-noise");
    const auto refusal = [&](const std::string& density, int dimension, std::int64_t levels) {
        Parameters parameters(spec.parameters);
        parameters.set("density", density, {"test.toml", 5});
        if (levels > 0) parameters.set("levels", levels, {"test.toml", 6});
        return refusal_of([&] { spec.check(parameters, {8192, dimension, 1}, {"test.toml", 4}); });
    };
    EXPECT_EQ(refusal("1 + x", 2, 0), "accepted");
    EXPECT_THAT(refusal("1 + x", 3, 0), testing::HasSubstr("test.toml:5: density = \"1 + x\": is for sets in 2D"));
    EXPECT_THAT(refusal("1 + x", 2, 1),
                testing::HasSubstr("test.toml:6: levels = 1: cannot be combined with a density"));
    EXPECT_THAT(refusal("1 +", 2, 0), testing::HasSubstr("test.toml:5: density"));
    EXPECT_THAT(refusal("x", 2, 0), testing::HasSubstr("must be a number that is not negative"));
}

}
}
