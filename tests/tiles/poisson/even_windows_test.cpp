// Equal moments make numbers of points in windows even. This is counted by brute force: many random tilings of sets
// made by hand, whose moments agree up to a known order, counted in windows of known variance.
//
// The numbers below 2^(m + 1) with an even and with an odd number of ones in binary have equal sums of powers up to m
// (Prouhet 1851; Thue and Morse): points in two rows of these make two tiles that agree up to order m and no further.
#include "tests/support/random_tile_set.hpp"
#include "tests/tiles/poisson/made_up_tilings.hpp"
#include "tiles/poisson/tile_moments.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace poissonlab {
namespace {

constexpr double spacing = 1.0 / 16; ///< of the places in a row, in tiles

/// 2^m points each, at such places on the middle line of the tile.
PoissonTileSet rows_of_prouhet(PoissonTileKind kind, std::uint32_t m)
{
    const std::uint32_t places = 2U << m;
    PoissonTileSet set = random_tile_set(kind, 2, kind == PoissonTileKind::frame ? 1 : 2, places / 2, 2);
    set.points.clear();
    for (std::uint32_t tile = 0; tile < set.parameters.tiles; ++tile) {
        // Corner tiles: whether both their lower corners have colour 1, so that neighbours depend on each other.
        const bool is_odd = kind == PoissonTileKind::frame ? tile == 1 : (tile >> 1 & tile >> 2 & 1U) == 1;
        for (std::uint32_t i = 0; i < places; ++i)
            if ((std::popcount(i) % 2 == 1) == is_odd) {
                const double x = 0.5 + (i - (places - 1) / 2.0) * spacing;
                set.points.push_back(static_cast<std::uint16_t>(x * tile_units));
                set.points.push_back(static_cast<std::uint16_t>(tile_units / 2));
            }
    }
    return set;
}

/// The integral of the square of the j-th derivative along x of exp(-r^2 / (2 R^2)).
double squared_derivative(int j, double radius)
{
    double product = std::numbers::pi * std::pow(radius, 2 - 2 * j);
    for (int i = 1; i <= j; ++i) product *= (2 * i - 1) / 2.0;
    return product;
}

struct SampledVariance
{
    double value = 0;
    double error = 0; ///< standard error, of nearly normal numbers
};

SampledVariance variance_of(const std::vector<double>& values)
{
    double mean = 0, squares = 0;
    const auto n = static_cast<double>(values.size());
    for (const double value : values) mean += value / n;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {squares / (n - 1), squares / (n - 1) * std::sqrt(2 / n)};
}

/// The sum over the points of random tilings of a Gaussian window in their middle.
SampledVariance variance_in_gaussian_windows(const PoissonTileSet& set, double radius)
{
    constexpr unsigned tilings = 3000;
    const int side = static_cast<int>(12 * radius);
    const double middle = side / 2.0;
    const auto window_at = [&](int i, int j, std::uint32_t tile) {
        double sum = 0;
        for (std::uint32_t p = 0; p < set.parameters.points_per_tile; ++p) {
            const UnitPosition at = set.position(tile, p);
            const double x = i + double{1} * at[0] / tile_units - middle,
                         y = j + double{1} * at[1] / tile_units - middle;
            sum += std::exp(-(x * x + y * y) / (2 * radius * radius));
        }
        return sum;
    };
    std::vector<double> of_tiles; // by place and tile
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            for (std::uint32_t tile = 0; tile < set.parameters.tiles; ++tile) of_tiles.push_back(window_at(i, j, tile));
    std::vector<double> sums;
    for (unsigned seed = 0; seed < tilings; ++seed) {
        const MadeUpTiling tiling(set.parameters, side, seed);
        double sum = 0;
        std::size_t place = 0;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i, place += set.parameters.tiles) sum += of_tiles[place + tiling.tile(i, j)];
        sums.push_back(sum);
    }
    return variance_of(sums);
}

class EvenWindows : public testing::TestWithParam<std::uint32_t>
{
};

TEST_P(EvenWindows, MomentsAgreeUpToTheOrderAndNoFurther)
{
    for (const PoissonTileKind kind : {PoissonTileKind::frame, PoissonTileKind::corner})
        EXPECT_EQ(tile_moments(rows_of_prouhet(kind, GetParam())).equal_order(), GetParam());
}

/// Two tiles with the same chance, each place on its own: a place's sum varies by a quarter of the squared difference
/// of the two, which is a product of m + 1 differences over 1, 2, 4 ... places, the derivative of that order. So the
/// variance goes as R^(2 - 2 (m + 1)), which is the theorem's spectrum in such a window.
TEST_P(EvenWindows, OfTemplateTilesVaryAsTheTheoremSays)
{
    const int j = static_cast<int>(GetParam()) + 1;
    for (const double radius : {2.0, 3.0}) {
        const double difference = std::pow(spacing, j) * std::pow(2.0, j * (j - 1) / 2);
        const double expected = difference * difference / 4 * squared_derivative(j, radius);
        const SampledVariance found =
            variance_in_gaussian_windows(rows_of_prouhet(PoissonTileKind::frame, GetParam()), radius);
        // A difference over a places is the derivative but for a^2 / 24 of the second derivative after it; the square
        // of the longest of them, of half the row, changes the variance by less than this.
        const double half_row = spacing * std::pow(2.0, j - 1);
        const double correction = expected * half_row * half_row * (2 * j + 1) / (12 * radius * radius);
        EXPECT_NEAR(found.value, expected, 4 * found.error + correction) << "R = " << radius;
    }
}

/// Tiles whose two lower corners have colour 1 are a quarter of all, and neighbours in a row share a corner: the
/// covariances are 3/16 of a place with itself, and 1/16 with each of these two.
TEST_P(EvenWindows, OfCornerTilesVaryAsTheyDepend)
{
    const int j = static_cast<int>(GetParam()) + 1;
    constexpr double radius = 3;
    const double difference = std::pow(spacing, j) * std::pow(2.0, j * (j - 1) / 2);
    const double unit = difference * difference * squared_derivative(j, radius);
    // The derivative one tile aside is the same but for at most this part of it.
    const double aside = (2 * j + 1) / (4 * radius * radius);
    const SampledVariance found =
        variance_in_gaussian_windows(rows_of_prouhet(PoissonTileKind::corner, GetParam()), radius);
    EXPECT_LT(found.value, unit * 5 / 16 + 4 * found.error);
    EXPECT_GT(found.value, unit * (3 + 2 * (1 - aside)) / 16 - 4 * found.error);
}

INSTANTIATE_TEST_SUITE_P(Orders, EvenWindows, testing::Values(0U, 1U, 2U, 3U),
                         [](const auto& order) { return "Of" + std::to_string(order.param); });

/// Numbers of points in disks anywhere in random tilings.
double variance_in_disks(const PoissonTileSet& set, double radius)
{
    constexpr unsigned disks = 2000;
    const int side = static_cast<int>(2 * radius) + 3;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> in_a_tile(0, 1);
    std::vector<double> numbers;
    for (unsigned seed = 0; seed < disks; ++seed) {
        const double x = radius + 1 + in_a_tile(random), y = radius + 1 + in_a_tile(random);
        const MadeUpTiling tiling(set.parameters, side, seed);
        std::vector<TestPosition> points;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) tiling.append(set, i, j, 0, points);
        double inside = 0;
        for (const TestPosition& point : points)
            inside += std::hypot(static_cast<double>(point[0]) / tile_units - x,
                                 static_cast<double>(point[1]) / tile_units - y) < radius;
        numbers.push_back(inside);
    }
    return variance_of(numbers).value;
}

/// In disks four times as large the variance is four times as large where it goes as the border, and 16 times as large
/// where it goes as the area: the one is told from the other in the middle.
TEST(SharpWindows, VaryAsTheirBorders)
{
    const PoissonTileSet set = rows_of_prouhet(PoissonTileKind::frame, 2);
    const double small = variance_in_disks(set, 2), large = variance_in_disks(set, 8);
    EXPECT_GT(large, 2 * small);
    EXPECT_LT(large, 8 * small);
}

}
}
