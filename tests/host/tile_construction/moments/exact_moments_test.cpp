// The search for equal moments in whole numbers finds what it should, within its reach.
#include "host/tile_construction/moments/exact_moments.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

std::vector<StoredFromMiddle> random_points(std::size_t count, int dimension, std::mt19937_64& random)
{
    std::vector<StoredFromMiddle> points(count);
    for (StoredFromMiddle& point : points)
        for (int k = 0; k < dimension; ++k)
            point[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(random() % 24'000) - 12'000;
    return points;
}

std::vector<std::int64_t> sums_of(const std::vector<StoredFromMiddle>& points, std::uint32_t order, int dimension)
{
    std::vector<std::int64_t> sums;
    for (const Monomial& monomial : monomials_up_to(order, dimension)) {
        sums.push_back(0);
        for (const StoredFromMiddle& at : points) sums.back() += value_of(monomial, at);
    }
    return sums;
}

/// The moments that are wanted are as far off as rounding of coordinates makes it.
std::vector<std::int64_t> wanted_near(std::vector<StoredFromMiddle> points, std::uint32_t order, int dimension,
                                      std::mt19937_64& random)
{
    for (StoredFromMiddle& point : points)
        for (int k = 0; k < dimension; ++k)
            point[static_cast<std::size_t>(k)] += static_cast<std::int64_t>(random() % 2);
    return sums_of(points, order, dimension);
}

std::int64_t longest_move(const std::vector<StoredFromMiddle>& a, const std::vector<StoredFromMiddle>& b)
{
    std::int64_t longest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, std::abs(a[i][k] - b[i][k]));
    return longest;
}

TEST(ExactMoments, FirstAndSecondMomentsAreMet)
{
    std::mt19937_64 random(1);
    for (const std::size_t count : {18, 20, 21, 40, 200}) {
        for (int i = 0; i < 3; ++i) {
            const auto before = random_points(count, 2, random);
            const auto wanted = wanted_near(before, 2, 2, random);
            auto points = before;
            ASSERT_TRUE(make_moments_exact(points, wanted, 2, 2)) << count;
            EXPECT_EQ(sums_of(points, 2, 2), wanted);
            EXPECT_LE(longest_move(points, before), exact_reach);
        }
    }
}

TEST(ExactMoments, FirstMomentsAreMetByAFewPoints)
{
    std::mt19937_64 random(2);
    for (const int dimension : {2, 3})
        for (const std::size_t count : {1, 2, 5, 30}) {
            const auto before = random_points(count, dimension, random);
            const auto wanted = wanted_near(before, 1, dimension, random);
            auto points = before;
            ASSERT_TRUE(make_moments_exact(points, wanted, 1, dimension)) << count;
            EXPECT_EQ(sums_of(points, 1, dimension), wanted);
            EXPECT_LE(longest_move(points, before), exact_reach);
        }
}

TEST(ExactMoments, WhatCannotBeReachedIsRefused)
{
    std::vector<StoredFromMiddle> points{{100, 0, 0}, {-50, 20, 0}, {7, -900, 0}};
    std::vector<std::int64_t> wanted = sums_of(points, 2, 2);
    wanted[0] += 10; // three points, of which each moves by 3
    EXPECT_FALSE(make_moments_exact(points, {wanted[0], wanted[1]}, 1, 2));
    wanted[0] -= 10;
    wanted[2] += 2'000'000;
    EXPECT_FALSE(make_moments_exact(points, wanted, 2, 2));
    std::vector<StoredFromMiddle> none;
    EXPECT_TRUE(make_moments_exact(none, {0, 0}, 1, 2));
    EXPECT_FALSE(make_moments_exact(none, {1, 0}, 1, 2));
}

}
}
