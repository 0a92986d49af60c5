// The equations of equal areas, against waves on a lattice, whose weights are known, and by putting weights in.
#include "host/sampling/optimized/area_exchange.hpp"

#include "host/sampling/optimized/power_cells.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

/// Square cells: each exchanges half of a unit with its four neighbours.
AreaExchange square_lattice(std::uint32_t side)
{
    AreaExchange exchange;
    exchange.starts.push_back(0);
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            for (const std::uint32_t neighbour : {y * side + (x + 1) % side, y * side + (x + side - 1) % side,
                                                  (y + 1) % side * side + x, (y + side - 1) % side * side + x}) {
                exchange.neighbours.push_back(neighbour);
                exchange.exchanges.push_back(0.5);
            }
            exchange.starts.push_back(static_cast<std::uint32_t>(exchange.neighbours.size()));
        }
    return exchange;
}

/// A wave of u and v periods changes areas by (1 - cos(2 pi u / side)) + (1 - cos(2 pi v / side)) times its weights.
/// The error of weights is at most that of areas, over the least of these factors.
TEST(ExchangeSolver, KnowsTheWavesOfALattice)
{
    constexpr std::uint32_t side = 48;
    constexpr double tolerance = 1e-10;
    const double turn = 2 * std::numbers::pi / side;
    ExchangeSolver solver(square_lattice(side));
    for (const auto& [u, v] : {std::pair{1, 0}, {0, 7}, {5, 23}, {24, 24}}) {
        const double factor = (1 - std::cos(turn * u)) + (1 - std::cos(turn * v));
        std::vector<double> wanted;
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) wanted.push_back(factor * std::cos(turn * (u * x + v * y)));
        const std::vector<double> weights = solver.weights_for(wanted, tolerance);
        const double norm = std::sqrt(side * side) * factor;
        for (std::size_t i = 0; i < weights.size(); ++i)
            EXPECT_NEAR(weights[i], wanted[i] / factor, tolerance * norm / (1 - std::cos(turn))) << u << ' ' << v;
    }
}

/// Areas change as wanted, by the sums themselves, and the number of steps does not grow with that of the cells, as it
/// would without levels. (Two cells are equal by symmetry: nothing would be wanted.)
TEST(ExchangeSolver, ChangesAreasAsWantedInFewSteps)
{
    constexpr double tolerance = 1e-4;
    for (const std::size_t n : {3u, 10u, 1000u, 16000u}) {
        std::mt19937_64 random(n);
        const PowerCells cells = reference::power_cells(test::random_points(n, 2, random), std::vector<double>(n));
        std::vector<double> wanted;
        for (const double area : cells.areas) wanted.push_back(1 / static_cast<double>(n) - area);
        const AreaExchange exchange = area_exchange(cells);
        ExchangeSolver solver(exchange);
        const std::vector<double> weights = solver.weights_for(wanted, tolerance);
        double squared_error = 0, squared = 0;
        for (std::size_t i = 0; i < n; ++i) {
            double change = 0;
            for (std::size_t k = exchange.starts[i]; k < exchange.starts[i + 1]; ++k)
                change += exchange.exchanges[k] * (weights[i] - weights[exchange.neighbours[k]]);
            squared_error += (change - wanted[i]) * (change - wanted[i]);
            squared += wanted[i] * wanted[i];
        }
        EXPECT_LE(std::sqrt(squared_error / squared), 1.01 * tolerance) << n;
        EXPECT_LE(solver.steps(), 16u) << n;
    }
}

}
}
