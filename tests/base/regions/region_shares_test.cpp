// The parts of squares that lie in a region: against areas and places, and of regions thinner than any grid of places.
#include "base/regions/region_shares.hpp"

#include "base/regions/region_text.hpp"
#include "tests/support/random_region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::uint32_t share_shift = 25; ///< 64 squares along the longest side

std::vector<double> shares_of(const FixedRegion& region)
{
    return region_shares(region, {{},
                                  1u << share_shift,
                                  (region.extent().high[0] >> share_shift) + 1,
                                  (region.extent().high[1] >> share_shift) + 1});
}

TEST(RegionShares, AddUpToTheArea)
{
    for (const PlaneRegion& plane :
         {test::star_with_holes(3, 300, 0x1p31), read_region("disk 5 5 2"), read_region("rectangle 0 0 20000 1"),
          read_region("POLYGON ((0 0, 30000 10000, 30001 10001, 0 0.5, 0 0))")}) {
        const FixedRegion region(plane);
        const std::vector<double> shares = shares_of(region);
        const double cell = std::pow(region.unit() * std::ldexp(1, share_shift), 2);
        EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0) * cell / region.area(), 1, 1e-5);
    }
}

/// Some of the squares alone have the shares that they have among all.
TEST(RegionShares, OfSomeSquaresAreThoseOfAll)
{
    const FixedRegion region(test::star_with_holes(5, 300, 0x1p31));
    const std::vector<double> all = shares_of(region);
    const std::uint32_t columns = (region.extent().high[0] >> share_shift) + 1;
    const std::uint32_t rows = (region.extent().high[1] >> share_shift) + 1;
    std::vector<std::array<std::uint32_t, 2>> squares;
    std::vector<double> expected;
    for (std::uint32_t square = 0; square < all.size(); square += 1 + square % 5) {
        squares.push_back({square % columns, square / columns});
        expected.push_back(all[square]);
    }
    EXPECT_EQ(region_shares(region, {{}, 1u << share_shift, columns, rows}, squares), expected);
}

TEST(RegionShares, AreThoseOfPlacesInEachSquare)
{
    const FixedRegion region(test::star_with_holes(4, 200, 0x1p31));
    const std::vector<double> shares = shares_of(region);
    constexpr std::uint32_t places = 24, step = (1u << share_shift) / places;
    for (std::uint32_t cell = 0; cell < 64 * 64; ++cell) {
        int inside = 0;
        for (std::uint32_t i = 0; i < places * places; ++i)
            inside += region.contains({((cell % 64) << share_shift) + i % places * step + step / 2,
                                       ((cell / 64) << share_shift) + i / places * step + step / 2});
        // An edge through a square passes places of a row of them; a few edges may.
        EXPECT_NEAR(shares[cell], inside / double{places * places}, 0.08) << cell;
    }
}

}
}
