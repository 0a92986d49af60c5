// Moments of tiles in whole numbers, against sums of 128 bits, and what is said to follow from them, against sets whose
// spectrum is known.
#include "tiles/poisson/tile_moments.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/random_tile_set.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr std::uint16_t center = 32'768;

__extension__ using Wide = __int128;

/// Two template tiles of four points, which any tiling takes with the same chance: two points on either side of the
/// middle, a to the left and to the right in one tile, above and below in the other; two points that both have.
PoissonTileSet crossed_pairs(std::uint16_t a)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::frame, 2, 1, 4, 2);
    const auto high = static_cast<std::uint16_t>(center + a), low = static_cast<std::uint16_t>(center - a);
    set.points = {high,   center, low,    center, 1000, 2000, 60000, 3000, //
                  center, high,   center, low,    1000, 2000, 60000, 3000};
    return set;
}

TEST(TileMoments, MonomialsAreThoseOfTheirOrders)
{
    EXPECT_EQ(monomials_up_to(1, 2), (std::vector<Monomial>{{1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(monomials_up_to(2, 2), (std::vector<Monomial>{{1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}}));
    EXPECT_EQ(monomials_up_to(3, 2).size(), 9U);
    EXPECT_EQ(monomials_up_to(2, 3).size(), 9U);
    EXPECT_EQ(monomials_up_to(3, 3).size(), 19U);
}

/// Sums as large as they can be: all points of a tile in its corners.
TEST(TileMoments, DoNotOverflow)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::frame, 3, 1, max_points_per_tile, 3);
    for (std::size_t i = 0; i < set.points.size() / 3; ++i) set.points[i] = 0;
    for (std::size_t i = set.points.size() / 3; i < 2 * set.points.size() / 3; ++i) set.points[i] = 65'535;
    const auto monomials = monomials_up_to(3, 3);
    for (std::uint32_t tile = 0; tile < 3; ++tile) {
        const auto moments = moments_of(set, tile, monomials);
        for (std::size_t m = 0; m < monomials.size(); ++m) {
            Wide sum = 0;
            for (std::uint32_t i = 0; i < max_points_per_tile; ++i) {
                Wide product = 1;
                for (std::size_t k = 0; k < 3; ++k)
                    for (int e = 0; e < monomials[m][k]; ++e) product *= int{set.tile(tile)[3 * i + k]} - 32'768;
                sum += product;
            }
            EXPECT_TRUE(sum == moments[m]) << tile << ", " << m;
        }
    }
    EXPECT_EQ(moments_of(set, 0, {{3, 0, 0}}).front(), -4096 * (std::int64_t{1} << 45));
    EXPECT_EQ(tile_moments(set).equal_order(), 0U);
}

TEST(TileMoments, OfCrossedPairsAreKnown)
{
    constexpr double a = 9000.0 / 65'536;
    const PoissonTileSet set = crossed_pairs(9000);
    const TileMoments moments = tile_moments(set);
    EXPECT_EQ(moments.equal_order(), 1U);
    EXPECT_EQ(moments.proven_exponent(), 4U);
    EXPECT_FALSE(moments.orders[1].are_equal);
    EXPECT_EQ(moments.orders[1].difference, 2 * 9000 * 9000);
    EXPECT_NEAR(moments.orders[1].largest_difference, 2 * a * a, 1e-15);
    // The transforms are 2 cos(2 pi a x) and 2 cos(2 pi a y), but for what both have, and each tile is one of the two
    // with the same chance: the power is the square of half their difference over the number of points.
    for (const double k : {0.001, 0.01, 0.1}) {
        const double power = std::pow(std::cos(2 * std::numbers::pi * a * k) - 1, 2) / 4;
        EXPECT_LE(power, moments.orders[1].power * std::pow(k, 4));
        EXPECT_GE(power, 0.45 * moments.orders[1].power * std::pow(k, 4)); // the bound is twice what one direction has
    }
    EXPECT_EQ(moments.orders[0].power, 0);
}

/// The formula of docs/chain-tiles.md, with sums over all d^j products of coordinates, one after the other.
TEST(TileMoments, LeaveThePowerOfTheFormula)
{
    struct Kind
    {
        PoissonTileKind kind;
        int dimension;
        std::uint32_t colors, tiles;
        double dependent;
    };
    const std::array factorials{1.0, 1.0, 2.0, 6.0};
    for (const auto& [kind, d, colors, tiles, dependent] :
         {Kind{PoissonTileKind::corner, 2, 2, 16, 9}, Kind{PoissonTileKind::corner, 3, 2, 256, 27},
          Kind{PoissonTileKind::frame, 2, 1, 5, 1}}) {
        const PoissonTileSet set = random_tile_set(kind, d, colors, 10, tiles);
        const TileMoments moments = tile_moments(set);
        const auto dimension = static_cast<std::size_t>(d);
        std::size_t products = 1;
        for (std::uint32_t j = 1; j <= 3; ++j) {
            products *= dimension;
            double variances = 0;
            for (std::size_t product = 0; product < products; ++product) {
                std::vector<double> of_tiles(set.parameters.tiles);
                for (std::uint32_t tile = 0; tile < set.parameters.tiles; ++tile)
                    for (std::size_t i = 0; i < 10; ++i) {
                        double value = 1;
                        for (std::size_t factor = 0, axes = product; factor < j; ++factor, axes /= dimension)
                            value *= (set.tile(tile)[dimension * i + axes % dimension] - 32'768.0) / 65'536;
                        of_tiles[tile] += value;
                    }
                double sum = 0, squares = 0;
                for (const double moment : of_tiles) sum += moment, squares += moment * moment;
                const double count = set.parameters.tiles;
                variances += squares / count - (sum / count) * (sum / count);
            }
            const double step = std::pow(2 * std::numbers::pi, j) / factorials[j];
            const double power = dependent * step * step * variances / 10;
            // Sums of ten products below 1, of at most 256 tiles: rounding of some 1e-13 of squares near 1.
            EXPECT_NEAR(moments.orders[j - 1].power, power, 1e-10 * power) << d << ", " << j;
        }
    }
}

TEST(TileMoments, OneTileHasTheSameAsItself)
{
    EXPECT_EQ(tile_moments(random_tile_set(PoissonTileKind::corner, 2, 1, 30)).equal_order(), 3U);
}

TEST(TileMoments, AUnitIsEnoughToBreakAPromise)
{
    PoissonTileSet set = crossed_pairs(9000);
    const auto refusal = [&] { return refusal_of([&] { check_moments(set.parameters, tile_moments(set)); }); };
    EXPECT_EQ(refusal(), "accepted");
    set.parameters.equal_moments = 1;
    EXPECT_EQ(refusal(), "accepted");
    set.parameters.equal_moments = 2;
    EXPECT_EQ(refusal(), "equal_moments = 2: must be at most 1: second moments of tile 1 are not those of tile 0");
    set.parameters.equal_moments = 1;
    ++set.points[8];
    EXPECT_EQ(refusal(), "equal_moments = 1: must be at most 0: first moments of tile 1 are not those of tile 0");
    --set.points[10];
    EXPECT_EQ(refusal(), "accepted");
}

/// Beyond the orders that are exact, rounding is allowed, and no more.
TEST(TileMoments, OfHighOrdersMayBeRounded)
{
    PoissonTileSet set = random_tile_set(PoissonTileKind::frame, 2, 1, 4, 2);
    set.parameters.equal_moments = 3;
    set.points = {30'000, 9, 30'001, 9, 30'002, 9, 40'000, 9, 30'000, 9, 30'001, 9, 30'002, 9, 40'000, 9};
    EXPECT_EQ(tile_moments(set).equal_order(), 3U);
    EXPECT_EQ(rounded_moment(1, 32), 32);
    EXPECT_EQ(rounded_moment(3, 32), 3 * 32 * (std::int64_t{1} << 30));
    TileMoments moments = tile_moments(set);
    moments.orders[2] = {.are_equal = false, .odd_tile = 1, .difference = rounded_moment(3, 4)};
    EXPECT_EQ(refusal_of([&] { check_moments(set.parameters, moments); }), "accepted");
    ++moments.orders[2].difference;
    EXPECT_THAT(refusal_of([&] { check_moments(set.parameters, moments); }), HasSubstr("third moments of tile 1"));
}

}
}
