// The hash function with a table for each coordinate against equation 3.2, brute force and closed forms; tables of
// sizes that users choose.
#include "tiles/tilings/tile_lattice.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"
#include "tiles/tilings/tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace poissonlab {
namespace {

const StreamKey two_table_key = stream_key(3, Purpose::tiling_colors, 0);

std::size_t remainder_of(std::int64_t a, std::int64_t n) { return static_cast<std::size_t>((a % n + n) % n); }

TEST(TwoTableHash, IsThatOfTheDissertation)
{
    for (const std::uint32_t n : {2u, 3u, 7u, 24u, 256u, 65536u})
        for (const Color c : {1u, 2u}) {
            const TwoTableHash hash(c, n, two_table_key);
            const auto &px = hash.table(0), &py = hash.table(1), &pz = hash.table(2);
            EXPECT_TRUE(n < 7 || px != py);
            for (const std::int64_t x : {INT64_MIN, INT64_MIN + 5, std::int64_t{-1}, std::int64_t{0}, INT64_MAX})
                for (const std::int64_t y : {INT64_MAX - 1, INT64_MIN, std::int64_t{-257}, std::int64_t{1}}) {
                    const std::uint32_t one = px[remainder_of(x, n)], two = one + py[remainder_of(y, n)];
                    ASSERT_EQ(hash(x), one % c);
                    ASSERT_EQ(hash(x, y), two % n % c);
                    ASSERT_EQ(hash(x, y, 9), (two + pz[9 % n]) % n % c);
                }
            for (const std::int64_t step : {1, 2, 300}) {
                std::vector<std::uint8_t> row(500);
                hash.fill_row(-70, step, -3, row);
                for (std::int64_t i = 0; i < 500; ++i)
                    ASSERT_EQ(row[static_cast<std::size_t>(i)], hash(-70 + i * step, -3));
            }
        }
}

/// The least shift along x (along y) that changes no colour, by trying all.
std::uint64_t least_shift(const TwoTableHash& hash, std::int64_t n, bool is_along_y)
{
    for (std::int64_t shift = 1;; ++shift) {
        bool repeats = true;
        for (std::int64_t i = 0; i < n * n && repeats; ++i)
            repeats = hash(i % n, i / n) == hash(i % n + (is_along_y ? 0 : shift), i / n + (is_along_y ? shift : 0));
        if (repeats) return static_cast<std::uint64_t>(shift);
    }
}

TEST(TwoTableHash, HasThePeriodThatItReports)
{
    int shorter = 0;
    for (std::uint32_t n = 1; n <= 16; ++n)
        for (Color c = 1; c <= n; ++c)
            for (std::uint64_t seed = 0; seed < 4; ++seed) {
                const TwoTableHash hash(c, n, stream_key(seed, Purpose::tiling_colors, 0));
                ASSERT_EQ(hash.period().x, least_shift(hash, n, false)) << n << " " << c;
                ASSERT_EQ(hash.period().y, least_shift(hash, n, true)) << n << " " << c;
                shorter += c > 1 && hash.period().x < n;
            }
    EXPECT_GT(shorter, 0);
    EXPECT_EQ(TwoTableHash(3, 255, two_table_key).period(), (HashPeriod{255, 255}));
}

/// Corner colours obey NE - NW = SE - SW modulo C: C^3 of the C^4 tiles are left, and all of these occur.
TEST(TwoTableHash, MakesCornerTilesWhoseRowsDifferByAShift)
{
    for (Color c = 2; c <= 4; ++c) {
        std::set<TileIndex> tiles;
        const Tiling tiling(DirectAlgorithm::corner, {c, c}, HashKind::two_tables, 1);
        for (std::int64_t i = 0; i < 256 * 256; ++i) tiles.insert(tiling.tile(i % 256, i / 256));
        EXPECT_EQ(tiles.size(), c * c * c);
    }
}

/// The period of tables of one's own is their size; that of several tables is the product of coprime sizes.
TEST(ColorHash, HasTablesOfSizesOfOnesOwn)
{
    const auto period = [](HashKind kind, std::vector<std::uint32_t> entries) {
        return period_of(make_color_hash({kind, std::move(entries)}, 4, 1)).x;
    };
    EXPECT_EQ(period(HashKind::permutation, {}), 256);
    EXPECT_EQ(period(HashKind::permutation, {4096}), 4096);
    EXPECT_EQ(period(HashKind::two_tables, {1000}), 1000);
    EXPECT_EQ(period(HashKind::long_period, {}), 5'930'659'848);
    EXPECT_EQ(period(HashKind::long_period, {16, 11, 13, 17, 19}), 739'024); // section 3.4.4
    EXPECT_EQ(period(HashKind::long_period, {256, 257, 251}), 256ull * 257 * 251);
    const auto message = [&](HashKind kind, std::vector<std::uint32_t> entries) {
        return message_of([&] { period(kind, std::move(entries)); });
    };
    EXPECT_THAT(message(HashKind::permutation, {3}), testing::HasSubstr("must have from 4"));
    EXPECT_THAT(message(HashKind::two_tables, {8, 9}), testing::HasSubstr("two-tables has tables of one size"));
    EXPECT_THAT(message(HashKind::xxh64, {8}), testing::HasSubstr("xxh64 has none"));
    EXPECT_THAT(message(HashKind::long_period, {24, 16}), testing::HasSubstr("coprime"));
    EXPECT_THAT(message(HashKind::long_period, {17, 24}), testing::HasSubstr("multiple of the 4 colors"));
}

}
}
