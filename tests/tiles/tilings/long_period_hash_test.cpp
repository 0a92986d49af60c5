// Long-period hash functions against their definition, and their periods in full.
#include "tiles/tilings/long_period_hash.hpp"

#include "base/errors/errors.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace poissonlab {
namespace {

const StreamKey long_period_key = stream_key(1, Purpose::tiling_colors, 0);

/// For Perlin's noise (dissertation, section 3.4.4): range 16, and two primes on either side.
const LongPeriodDesign noise_design{16, {11, 13, 16, 17, 19}};

/// The data that the device is given: tag, colours, number of tables, sizes, entries.
struct Tables
{
    explicit Tables(const LongPeriodHash& hash)
    {
        const auto words = hash.device_words();
        std::size_t at = 3 + words[2];
        for (std::uint32_t table = 0; table < words[2]; ++table) {
            const std::uint32_t size = words[3 + table];
            entries.emplace_back(words.begin() + static_cast<std::ptrdiff_t>(at),
                                 words.begin() + static_cast<std::ptrdiff_t>(at + size));
            at += size;
        }
        EXPECT_EQ(at, words.size());
    }

    /// Equations 3.5 to 3.7, as they are written.
    std::uint32_t value(const std::vector<std::int64_t>& coordinates, std::uint32_t range) const
    {
        std::uint32_t sum = 0;
        for (const auto& table : entries) {
            const auto n = static_cast<std::int64_t>(table.size());
            std::uint32_t entry = 0;
            for (const std::int64_t coordinate : coordinates)
                entry = table[static_cast<std::size_t>((entry + (coordinate % n + n) % n) % n)];
            sum += entry;
        }
        return sum % range;
    }

    /// The entries of all tables together.
    std::size_t count() const
    {
        std::size_t sum = 0;
        for (const auto& table : entries) sum += table.size();
        return sum;
    }

    std::vector<std::vector<std::uint32_t>> entries;
};

TEST(LongPeriodHash, DesignsAreThoseOfTheDissertation)
{
    const LongPeriodDesign tiling{24, {17, 19, 23, 24, 29, 31, 37}};
    for (const Color c : {2u, 3u, 4u, 6u, 8u}) EXPECT_EQ(tiling_hash_design(c), tiling);
    // The recipe holds for numbers of colours that do not divide 24 as well.
    EXPECT_EQ(tiling_hash_design(5), (LongPeriodDesign{25, {17, 19, 23, 25, 29, 31, 37}}));
    EXPECT_EQ(tiling_hash_design(7), (LongPeriodDesign{21, {13, 17, 19, 21, 23, 29, 31}}));
    for (Color c = 2; c <= max_colors; ++c) EXPECT_NO_THROW(LongPeriodHash(c, long_period_key)) << c;
}

TEST(LongPeriodHash, PeriodsAndEntriesAreThoseOfTheDissertation)
{
    for (const Color c : {2u, 3u, 4u, 6u, 8u, 24u}) {
        const LongPeriodHash hash(c, long_period_key);
        EXPECT_EQ(hash.period(), (HashPeriod{5'930'659'848, 5'930'659'848}));
        EXPECT_EQ(Tables(hash).count(), 180u);
        EXPECT_EQ(hash.range(), 24u);
    }
    const LongPeriodHash noise(16, noise_design, long_period_key);
    EXPECT_EQ(noise.period(), (HashPeriod{739'024, 739'024}));
    EXPECT_EQ(Tables(noise).count(), 76u);
    EXPECT_EQ(LongPeriodHash(5, long_period_key).period().x, 5'930'659'848 / 24 * 25);
    EXPECT_EQ(LongPeriodHash(7, long_period_key).period().x, 5'930'659'848 / 24 / 37 * 21 * 13);
}

TEST(LongPeriodHash, IsThatOfTheDissertation)
{
    std::mt19937_64 random(1);
    for (const Color c : {2u, 5u, 7u, 8u, 251u, 256u}) {
        const LongPeriodHash hash(c, long_period_key);
        const Tables tables(hash);
        for (int i = 0; i < 10'000; ++i) {
            const std::array<std::int64_t, 4> near{static_cast<std::int64_t>(random()), i - 2500, INT64_MIN + i,
                                                   INT64_MAX - i};
            const std::int64_t x = near[random() % 4];
            const std::int64_t y = near[random() % 4];
            const std::int64_t z = near[random() % 4];
            ASSERT_EQ(hash(x), tables.value({x}, hash.range()) % c);
            ASSERT_EQ(hash(x, y), tables.value({x, y}, hash.range()) % c) << x << " " << y;
            ASSERT_EQ(hash(x, y, z), tables.value({x, y, z}, hash.range()) % c);
        }
    }
}

TEST(LongPeriodHash, RowsArePointByPoint)
{
    const LongPeriodHash hash(3, long_period_key);
    for (const std::int64_t x : {std::int64_t{-1500}, std::int64_t{5'930'659'000}, INT64_MIN}) {
        for (const std::int64_t step : {1, 2, 1000}) {
            std::vector<std::uint8_t> row(3000); // several of the pieces that are summed at once
            hash.fill_row(x, step, -3, row);
            for (std::int64_t i = 0; i < 3000; ++i)
                ASSERT_EQ(row[static_cast<std::size_t>(i)], hash(x + i * step, -3)) << i;
        }
    }
}

TEST(LongPeriodHash, HasThePeriodThatItReportsInFull)
{
    // Every shift up to the product of the sizes, at every point.
    for (const LongPeriodDesign& design :
         {LongPeriodDesign{4, {3, 4, 5}}, LongPeriodDesign{6, {5, 6, 7}}, LongPeriodDesign{8, {8, 9}}}) {
        for (Color c = 2; c <= design.range; ++c) {
            if (design.range % c != 0) continue;
            const LongPeriodHash hash(c, design, long_period_key);
            const std::int64_t product =
                std::accumulate(design.sizes.begin(), design.sizes.end(), std::int64_t{1}, std::multiplies<>());
            const auto repeats = [&](std::int64_t dx, std::int64_t dy) {
                for (std::int64_t x = 0; x < product; ++x) {
                    for (std::int64_t y = 0; y < product; ++y) {
                        if (hash(x, y) != hash(x + dx, y + dy)) return false;
                    }
                }
                return true;
            };
            std::int64_t x_period = 1;
            while (x_period <= product && !repeats(x_period, 0)) ++x_period;
            std::int64_t y_period = 1;
            while (y_period <= product && !repeats(0, y_period)) ++y_period;
            EXPECT_EQ(hash.period(),
                      (HashPeriod{static_cast<std::uint64_t>(x_period), static_cast<std::uint64_t>(y_period)}));
        }
    }
}

TEST(LongPeriodHash, HasNoShorterPeriodThanItReports)
{
    // A shorter one would divide the period, and so the period over one of its primes. Points where colours
    // differ show that it does not; that the period is one, sampled points.
    std::mt19937_64 random(2);
    for (const Color c : {2u, 3u, 5u, 7u, 8u}) {
        const LongPeriodHash hash(c, long_period_key);
        const auto period = static_cast<std::int64_t>(hash.period().x);
        for (std::int64_t prime = 2; prime <= 37; ++prime) {
            if (period % prime != 0) continue;
            const std::int64_t t = period / prime;
            bool x_differs = false;
            bool y_differs = false;
            for (std::int64_t i = 0; i < 100; ++i) {
                x_differs = x_differs || hash(i, i * i) != hash(i + t, i * i);
                y_differs = y_differs || hash(i, i * i) != hash(i, i * i + t);
            }
            EXPECT_TRUE(x_differs && y_differs) << c << " " << prime;
        }
        for (int i = 0; i < 100'000; ++i) {
            const auto x = static_cast<std::int64_t>(random() >> 2);
            const auto y = static_cast<std::int64_t>(random() >> 2);
            ASSERT_EQ(hash(x, y), hash(x - period, y + period));
        }
    }
}

TEST(LongPeriodHash, ColorsAreAsFrequentOverAPeriod)
{
    const LongPeriodDesign design{12, {5, 7, 12}};
    for (const Color c : {2u, 3u, 4u, 6u, 12u}) {
        const LongPeriodHash hash(c, design, long_period_key);
        std::vector<int> counts(c);
        for (std::int64_t x = 0; x < 420; ++x) {
            for (std::int64_t y = 0; y < 420; ++y) ++counts[hash(x, y)];
        }
        for (const int count : counts) EXPECT_EQ(count, 420 * 420 / static_cast<int>(c));
    }
    // One row of the noise function, all of its period.
    std::vector<int> counts(16);
    const LongPeriodHash noise(16, noise_design, long_period_key);
    for (std::int64_t x = 0; x < 739'024; ++x) ++counts[noise(x, 5)];
    for (const int count : counts) EXPECT_EQ(count, 739'024 / 16);
}

TEST(LongPeriodHash, RefusesDesignsThatDoNotKeepItsPromises)
{
    const auto make = [](Color c, LongPeriodDesign design) {
        return LongPeriodHash(c, std::move(design), long_period_key);
    };
    EXPECT_THROW(make(5, {24, {23, 24, 25}}), InputError); // 24 is no multiple of 5
    EXPECT_THROW(make(2, {24, {17, 19, 23}}), InputError); // the range is not there
    EXPECT_THROW(make(2, {24, {24, 27}}), InputError);     // not coprime
    EXPECT_THROW(make(2, {24, {1, 24}}), InputError);
    EXPECT_THROW(make(2, {2, {2, 65537}}), InputError);
    EXPECT_THROW(make(2, {65536, {65536, 65535, 65533, 65521}}), InputError); // 2^64 and more
    EXPECT_NO_THROW(make(2, {65536, {65536, 65535, 65533}}));
    EXPECT_NO_THROW(make(24, {24, {24}}));
}

}
}
