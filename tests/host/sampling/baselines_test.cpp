// Random, regular and jittered sets: size, range, uniformity, and one point a cell.
#include "host/sampling/baselines.hpp"

#include "tests/support/chi_square.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {
namespace {

PointSet sample(const SamplerSpec& spec, const SampleRequest& request, std::uint32_t realization = 0)
{
    return spec.create({}, request, Engine::reference, {})->sample(realization);
}

std::vector<SamplerSpec> all_baselines() { return {random_sampler(), regular_sampler(), jittered_sampler()}; }

/// The index of the cell of a point, of side^dimension cells, x fastest. Exact: x is a multiple of 2^-32.
std::size_t cell_of(std::span<const double> point, std::uint64_t side)
{
    std::size_t index = 0;
    for (std::size_t axis = point.size(); axis-- > 0;) {
        const auto u = static_cast<std::uint64_t>(point[axis] * 0x1p32);
        index = index * side + (u * side >> 32);
    }
    return index;
}

/// The standard deviations by which a chi-square statistic of equally likely bins is above its mean
/// (Wilson and Hilferty 1931: its cube root is normal; good to two digits from 30 bins on).
double chi_square_z(const std::vector<std::uint64_t>& counts)
{
    const double degrees = static_cast<double>(counts.size()) - 1;
    const double variance = 2 / (9 * degrees);
    return (std::cbrt(test::chi_square(counts) / degrees) - (1 - variance)) / std::sqrt(variance);
}

TEST(Baselines, KeepTheirPromises)
{
    for (const SamplerSpec& spec : all_baselines()) {
        for (const int dimension : {2, 3}) {
            const SampleRequest request{.points = 4096, .dimension = dimension, .seed = 7}; // 64^2 and 16^3
            const PointSet points = sample(spec, request, 3);
            EXPECT_EQ(points.size(), 4096U) << spec.name;
            EXPECT_EQ(points.dimension, dimension);
            for (const double x : points.coordinates) {
                ASSERT_GE(x, 0);
                ASSERT_LT(x, 1);
                ASSERT_EQ(x * 0x1p32, std::floor(x * 0x1p32)) << "no multiple of 2^-32";
            }
            EXPECT_EQ(sample(spec, request, 3), points) << "not the same twice";
            EXPECT_EQ(sample(spec, request, 4) == points, spec.deterministic) << spec.name;
            EXPECT_EQ(sample(spec, {4096, dimension, 8}, 3) == points, spec.deterministic) << spec.name;
            EXPECT_EQ(sample(spec, {4096, dimension, 7 + (std::uint64_t{1} << 32)}, 3) == points, spec.deterministic)
                << "the seed has 64 bits";
        }
    }
}

TEST(Baselines, DoNotShareRandomNumbers)
{
    const PointSet random = sample(random_sampler(), {.points = 1, .dimension = 2, .seed = 1});
    const PointSet jittered = sample(jittered_sampler(), {.points = 1, .dimension = 2, .seed = 1});
    EXPECT_NE(random, jittered); // with one cell, both are one uniform point
}

TEST(LatticeSide, GivesTheNearestSquareOrCube)
{
    const auto power = [](std::uint64_t side, int dimension) {
        return static_cast<std::int64_t>(dimension == 2 ? side * side : side * side * side);
    };
    for (const int dimension : {2, 3}) {
        for (const std::size_t points : {1, 2, 3, 6, 7, 14, 15, 100, 999, 1000, 1001, 16384, 1000000, 100000000}) {
            const std::uint32_t side = lattice_side(points, dimension);
            const auto off = [&](std::uint64_t s) {
                return std::abs(power(s, dimension) - static_cast<std::int64_t>(points));
            };
            EXPECT_LT(off(side), off(side + 1)) << points;
            EXPECT_LT(off(side), side > 1 ? off(side - 1) : std::int64_t{1} << 62) << points;
        }
    }
}

TEST(Random, IsUniformAndIndependent)
{
    // Three tests of uniformity for each of ten sets in both dimensions.
    const double bound = test::z_bound(10 * 2 * 3);
    for (const int dimension : {2, 3}) {
        const std::uint64_t side = dimension == 2 ? 32 : 10;
        for (std::uint32_t realization = 0; realization < 10; ++realization) {
            const PointSet points = sample(random_sampler(), {65536, dimension, 1}, realization);
            std::vector<std::size_t> cells(static_cast<std::size_t>(std::pow(side, dimension)));
            std::vector<std::size_t> low_bits(1024);
            std::vector<std::size_t> neighbours(1024);
            for (std::size_t i = 0; i < points.size(); ++i) {
                ++cells[cell_of(points[i], side)];
                // The last ten bits of x.
                ++low_bits[static_cast<std::uint64_t>(points[i][0] * 0x1p32) % 1024];
                // x of this point and of the next.
                const std::vector<double> pair{points[i][0], points[(i + 1) % points.size()][0]};
                ++neighbours[cell_of(pair, 32)];
            }
            EXPECT_LT(std::abs(chi_square_z(cells)), bound);
            EXPECT_LT(std::abs(chi_square_z(low_bits)), bound);
            EXPECT_LT(std::abs(chi_square_z(neighbours)), bound);
        }
    }
}

TEST(Random, HasAsManyPointsAsAsked)
{
    for (const std::size_t points : {1, 2, 1000, 16383}) {
        EXPECT_EQ(sample(random_sampler(), {points, 3, 1}).size(), points);
    }
}

TEST(Regular, LiesAtTheCentresOfCells)
{
    EXPECT_EQ(sample(regular_sampler(), {4, 2, 1}), (PointSet{2, {0.25, 0.25, 0.75, 0.25, 0.25, 0.75, 0.75, 0.75}}));
    const PointSet cube = sample(regular_sampler(), {27, 3, 1});
    ASSERT_EQ(cube.size(), 27U);
    for (std::size_t i = 0; i < 27; ++i) {
        // Fixed point is at most 2^-32 away from (k + 1/2) / 3.
        const std::vector<std::size_t> k{i % 3, i / 3 % 3, i / 9};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(cube[i][axis], (static_cast<double>(k[axis]) + 0.5) / 3, 0x1p-32);
        }
    }
}

TEST(Jittered, HasOnePointInEachCellInOrder)
{
    for (const auto& [points, dimension] : {std::pair{10000U, 2}, {16129U, 2}, {1U, 2}, {1000U, 3}, {29791U, 3}}) {
        const PointSet set = sample(jittered_sampler(), {points, dimension, 1}, 2);
        ASSERT_EQ(set.size(), points);
        const std::uint32_t side = lattice_side(points, dimension);
        for (std::size_t i = 0; i < set.size(); ++i) ASSERT_EQ(cell_of(set[i], side), i);
    }
}

TEST(Jittered, IsUniformWithinItsCells)
{
    const double bound = test::z_bound(4);
    for (const int dimension : {2, 3}) {
        for (std::uint32_t realization = 0; realization < 2; ++realization) {
            const PointSet set = sample(jittered_sampler(), {64000, dimension, 1}, realization); // 253^2, 40^3
            const std::uint64_t side = lattice_side(64000, dimension);
            const std::uint64_t bins = dimension == 2 ? 16 : 6;
            std::vector<std::size_t> counts(static_cast<std::size_t>(std::pow(bins, dimension)));
            for (std::size_t i = 0; i < set.size(); ++i) {
                std::vector<double> within;
                for (const double x : set[i])
                    within.push_back(x * static_cast<double>(side) - std::floor(x * static_cast<double>(side)));
                ++counts[cell_of(within, bins)];
            }
            EXPECT_LT(std::abs(chi_square_z(counts)), bound);
        }
    }
}

}
}
