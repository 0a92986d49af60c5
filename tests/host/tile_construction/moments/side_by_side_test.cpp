// Systems that are solved side by side have the bits of those that are solved one by one.
#include "host/tile_construction/moments/moment_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace poissonlab {
namespace {

class SideBySide : public testing::TestWithParam<std::size_t>
{
};

TEST_P(SideBySide, SystemsHaveTheSolutionsThatTheyHaveAlone)
{
    const std::size_t rows = GetParam(), size = rows * (rows + 1) / 2;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> factors(side_by_side * size), values(side_by_side * rows), expected(side_by_side * rows);
    for (std::size_t system = 0; system < side_by_side; ++system) {
        // A row that depends on others has no pivot: a factor of 0.
        std::vector<double> factor(size), solution(rows);
        for (double& x : factor) x = normal(random);
        for (std::size_t i = 0; i < rows; ++i)
            factor[i * (i + 1) / 2 + i] = i % 4 == system % 4 ? 0 : 1 + std::abs(normal(random));
        for (double& x : solution) x = normal(random);
        for (std::size_t i = 0; i < size; ++i) factors[i * side_by_side + system] = factor[i];
        for (std::size_t i = 0; i < rows; ++i) values[i * side_by_side + system] = solution[i];
        solve(factor, solution);
        for (std::size_t i = 0; i < rows; ++i) expected[i * side_by_side + system] = solution[i];
    }
    solve_side_by_side(factors, values);
    EXPECT_EQ(values, expected);
}

INSTANTIATE_TEST_SUITE_P(Rows, SideBySide, testing::Values(0, 1, 2, 5, 9, 37));

}
}
