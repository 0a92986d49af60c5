// Power diagrams by kernel and reference, against CGAL's Voronoi cells and a fine raster; and sets of equal areas.
#include "host/sampling/optimized/equal_areas.hpp"

#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/settings/sampler_registry.hpp"
#include "kernels/common/optimized/power_cells.h"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

namespace poissonlab {
namespace {

PointSet random_power_points(std::size_t points, unsigned seed)
{
    std::mt19937_64 random(seed);
    return test::random_points(points, 2, random);
}

/// Weights of up to a part of the mean area.
std::vector<double> random_weights(std::size_t points, double part, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::vector<double> weights(points);
    for (double& weight : weights) weight = part * test::uniform(random) / static_cast<double>(points);
    return weights;
}

/// Weights that change little from point to point and much across the torus, as those of equal areas do.
std::vector<double> wave_weights(const PointSet& points)
{
    std::vector<double> weights;
    for (std::size_t i = 0; i < points.size(); ++i)
        weights.push_back(0.005 * std::cos(2 * std::numbers::pi * (points[i][0] + points[i][1])));
    return weights;
}

/// The contents of the neighbour lists, without what is behind their ends.
std::vector<std::pair<std::uint32_t, double>> neighbours_of(const PowerCells& cells, std::size_t point)
{
    using contract::power_cells::MAX_NEIGHBORS;
    std::vector<std::pair<std::uint32_t, double>> neighbours;
    for (std::size_t k = point * MAX_NEIGHBORS; k < (point + 1) * MAX_NEIGHBORS; ++k) {
        if (cells.neighbours[k] == UINT32_MAX) break;
        neighbours.emplace_back(cells.neighbours[k], cells.exchanges[k]);
    }
    return neighbours;
}

class PowerDiagrams : public ::testing::TestWithParam<std::size_t>
{
};

TEST_P(PowerDiagrams, AreTheSameByKernelAndReference)
{
    const std::size_t n = GetParam();
    const PointSet points = random_power_points(n, 3);
    for (const auto& weights :
         {random_weights(n, 0, 4), random_weights(n, 0.5, 4), random_weights(n, 3, 4), wave_weights(points)}) {
        const PowerCells expected = reference::power_cells(points, weights);
        for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
            const PowerCells cells = PowerDiagram(Device::open(), n, group).cells(points, weights);
            EXPECT_EQ(cells.areas, expected.areas);
            EXPECT_EQ(cells.displacements, expected.displacements);
            EXPECT_EQ(cells.energies, expected.energies);
            for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(neighbours_of(cells, i), neighbours_of(expected, i)) << i;
        }
        EXPECT_NEAR(std::accumulate(expected.areas.begin(), expected.areas.end(), 0.0), 1, 1e-12);
    }
}

TEST_P(PowerDiagrams, AreThoseOfVoronoiWithoutWeights)
{
    const std::size_t n = GetParam();
    const PointSet points = random_power_points(n, 5);
    const PowerCells cells = PowerDiagram(Device::open(), n).cells(points, std::vector<double>(n));
    const VoronoiCells voronoi = reference::voronoi_cells(points);
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_NEAR(cells.areas[i], voronoi.volumes[i], 1e-13);
        EXPECT_NEAR(cells.energies[i], voronoi.energies[i], 1e-13);
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(cells.displacements[2 * i + k], voronoi.displacements[2 * i + k], 1e-10);
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, PowerDiagrams, ::testing::Values(1u, 3u, 20u));
INSTANTIATE_TEST_SUITE_P(Sizes, PowerDiagrams, ::testing::Values(2u, 100u, 3000u));

/// The definition, on a raster: each place belongs to the point of the smallest squared distance less weight.
TEST(PowerDiagram, TakesPlacesBySquaredDistanceLessWeight)
{
    constexpr std::size_t n = 25;
    constexpr int raster = 600;
    const PointSet points = random_power_points(n, 6);
    const auto weights = random_weights(n, 2, 7);
    const PowerCells cells = reference::power_cells(points, weights);
    std::vector<double> areas(n);
    for (int y = 0; y < raster; ++y)
        for (int x = 0; x < raster; ++x) {
            double least = 2;
            std::size_t owner = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const double dx = std::remainder((x + 0.5) / raster - points[i][0], 1.0);
                const double dy = std::remainder((y + 0.5) / raster - points[i][1], 1.0);
                const double power = dx * dx + dy * dy - weights[i];
                if (power >= least) continue;
                least = power;
                owner = i;
            }
            areas[owner] += 1.0 / raster / raster;
        }
    // Squares that a border of a cell crosses, of which there are at most 2 x its width and height, are half wrong.
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(cells.areas[i], areas[i], 1.0 / raster) << i;
}

/// The derivative of areas by weights, by differences.
TEST(PowerDiagram, ExchangesAreaWithNeighboursAsSaid)
{
    constexpr std::size_t n = 60;
    const PointSet points = random_power_points(n, 8);
    auto weights = random_weights(n, 0.2, 9);
    const PowerCells before = reference::power_cells(points, weights);
    constexpr double change = 1e-8;
    weights[7] += change;
    const PowerCells after = reference::power_cells(points, weights);
    double given = 0;
    for (const auto& [neighbour, exchange] : neighbours_of(before, 7)) {
        EXPECT_NEAR((before.areas[neighbour] - after.areas[neighbour]) / change, exchange, 1e-5);
        given += exchange;
    }
    EXPECT_NEAR((after.areas[7] - before.areas[7]) / change, given, 1e-5);
}

TEST(EqualAreas, HaveThem)
{
    // From random points Newton's method has the farthest way to go: for a large set that is enough.
    for (const auto& [n, moves] : std::map<std::size_t, std::size_t>{{3, 20}, {50, 20}, {1000, 20}, {16384, 1}}) {
        PowerDiagram diagram(Device::open(), n);
        const EqualAreas result = equalize_areas(
            random_power_points(n, 10), moves,
            [&](const PointSet& set, const std::vector<double>& weights) { return diagram.cells(set, weights); });
        const PowerCells cells = reference::power_cells(result.points, result.weights);
        double variance = 0;
        for (const double area : cells.areas) variance += std::pow(area * static_cast<double>(n) - 1, 2);
        EXPECT_LT(variance / static_cast<double>(n), 1e-8) << n;
        ASSERT_EQ(result.iterations.size(), moves + 1);
        EXPECT_LT(result.iterations.back().energy, result.iterations.front().energy);
    }
}

TEST(EqualAreas, EnginesGiveTheSameBytes)
{
    const SamplerSpec& spec = *find_sampler("equal-areas");
    Parameters parameters(spec.parameters);
    parameters.set("iterations", std::int64_t{5}, {"test.toml", 2});
    Device device = Device::open();
    const auto kernel = spec.create(parameters, {300, 2, 5}, Engine::opencl, [&]() -> Device& { return device; });
    const auto plain = spec.create(parameters, {300, 2, 5}, Engine::reference, {});
    EXPECT_EQ(kernel->sample(1), plain->sample(1));
    EXPECT_EQ(kernel->traits().iterations.size(), 6u);
}

/// A lattice has equal areas, and its points are at their centroids: nothing moves.
TEST(EqualAreas, LeaveLatticesAsTheyAre)
{
    const PointSet lattice = test::staggered_lattice(8, 8);
    const EqualAreas result = equalize_areas(lattice, 3, reference::power_cells);
    for (std::size_t i = 0; i < lattice.coordinates.size(); ++i)
        EXPECT_NEAR(std::remainder(result.points.coordinates[i] - lattice.coordinates[i], 1.0), 0, 1e-14);
    for (const double weight : result.weights) EXPECT_EQ(weight, 0);
}

}
}
