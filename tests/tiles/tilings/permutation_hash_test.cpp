// Permutations and the hash function over one, against their definitions.
#include "tiles/tilings/permutation_hash.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/chi_square.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace poissonlab {
namespace {

const StreamKey permutation_key = stream_key(1, Purpose::tiling_colors, 0);

/// The dissertation's %: the remainder that is not negative.
std::uint32_t modulo(std::int64_t a, std::int64_t n) { return static_cast<std::uint32_t>((a % n + n) % n); }

TEST(RandomPermutation, IsOne)
{
    for (const std::uint32_t size : {1u, 2u, 3u, 24u, 37u, 255u, 256u, 4096u}) {
        auto sorted = random_permutation(size, permutation_key, 0);
        std::ranges::sort(sorted);
        std::vector<std::uint32_t> expected(size);
        std::iota(expected.begin(), expected.end(), 0u);
        EXPECT_EQ(sorted, expected);
    }
}

TEST(RandomPermutation, FollowsFromKeyTableAndSize)
{
    const auto permutation = random_permutation(256, permutation_key, 0);
    EXPECT_EQ(random_permutation(256, permutation_key, 0), permutation);
    EXPECT_NE(random_permutation(256, permutation_key, 1), permutation);
    EXPECT_NE(random_permutation(256, stream_key(2, Purpose::tiling_colors, 0), 0), permutation);
}

TEST(RandomPermutation, AllAreEquallyLikely)
{
    // All 120 of five numbers. Without rejection, 2^32 words cannot be shared out evenly, but no test sees
    // that.
    std::array<std::uint32_t, 5> all{0, 1, 2, 3, 4};
    std::vector<std::array<std::uint32_t, 5>> permutations;
    do permutations.push_back(all);
    while (std::ranges::next_permutation(all).found);
    std::vector<std::uint64_t> counts(permutations.size());
    for (std::uint32_t table = 0; table < 120'000; ++table) {
        const auto found = random_permutation(5, permutation_key, table);
        std::ranges::copy(found, all.begin());
        ++counts[static_cast<std::size_t>(std::ranges::lower_bound(permutations, all) - permutations.begin())];
    }
    EXPECT_TRUE(test::are_equally_likely(counts, 1));
}

TEST(PermutationHash, IsThatOfTheDissertation)
{
    // Equations 3.1, 3.3 and 3.4, modulo the colours, for powers of two and other sizes.
    std::mt19937_64 random(1);
    for (const std::uint32_t n : {7u, 24u, 255u, 256u, 1000u, 65536u}) {
        const auto p = random_permutation(n, permutation_key, 3);
        const PermutationHash hash(5, p);
        for (int i = 0; i < 5000; ++i) {
            // Coordinates lie near the origin, anywhere, and at both ends of their range.
            const std::array<std::int64_t, 4> near{static_cast<std::int64_t>(random()), i - 2500, INT64_MIN + i,
                                                   INT64_MAX - i};
            const std::int64_t x = near[random() % 4];
            const std::int64_t y = near[random() % 4];
            const std::int64_t z = near[random() % 4];
            const std::uint32_t one = p[modulo(x, n)];
            const std::uint32_t two = p[modulo(std::int64_t{one} + modulo(y, n), n)];
            const std::uint32_t three = p[modulo(std::int64_t{two} + modulo(z, n), n)];
            ASSERT_EQ(hash(x), one % 5) << n << " " << x;
            ASSERT_EQ(hash(x, y), two % 5) << n << " " << x << " " << y;
            ASSERT_EQ(hash(x, y, z), three % 5);
        }
    }
}

TEST(PermutationHash, RowsArePointByPoint)
{
    for (const std::uint32_t n : {7u, 256u}) {
        const PermutationHash hash(3, n, permutation_key);
        for (const std::int64_t step : {1, 2, 300}) {
            std::vector<std::uint8_t> row(1000);
            hash.fill_row(-500, step, -3, row);
            for (std::int64_t i = 0; i < 1000; ++i)
                ASSERT_EQ(row[static_cast<std::size_t>(i)], hash(-500 + i * step, -3)) << i;
        }
    }
}

/// The least t >= 1 with h(x + t, y) = h(x, y) everywhere, by trying; `limit` is known to be a period on both
/// axes.
template <class At>
std::uint64_t least_period(std::int64_t limit, const At& at)
{
    for (std::int64_t t = 1; t < limit; ++t) {
        bool repeats = true;
        for (std::int64_t along = 0; along < limit && repeats; ++along) {
            for (std::int64_t across = 0; across < limit && repeats; ++across)
                repeats = at(along, across) == at(along + t, across);
        }
        if (repeats) return static_cast<std::uint64_t>(t);
    }
    return static_cast<std::uint64_t>(limit);
}

void expect_reported_period(const PermutationHash& hash)
{
    const auto n = static_cast<std::int64_t>(hash.permutation().size());
    EXPECT_EQ(hash.period().x, least_period(n, [&](auto x, auto y) { return hash(x, y); }));
    EXPECT_EQ(hash.period().y, least_period(n, [&](auto y, auto x) { return hash(x, y); }));
    for (std::int64_t x = 0; x < n; ++x) {
        for (std::int64_t y = 0; y < n; ++y) ASSERT_EQ(hash(x, y), hash(x - n, y + n));
    }
}

TEST(PermutationHash, HasThePeriodThatItReports)
{
    for (std::uint32_t n = 2; n <= 48; ++n) {
        for (const Color c : {2u, 3u, n}) {
            if (c <= n) expect_reported_period(PermutationHash(c, n, permutation_key));
        }
    }
    for (const Color c : {2u, 7u}) expect_reported_period(PermutationHash(c, permutation_key));
    EXPECT_EQ(PermutationHash(2, permutation_key).period(), (HashPeriod{256, 256}));
    EXPECT_EQ(PermutationHash(7, permutation_key).period(), (HashPeriod{252, 252}));
    // Tables that chance does not make: colours alternate, so that columns are the same or opposite.
    const PermutationHash alternating(2, {0, 3, 2, 1, 4, 5});
    EXPECT_EQ(alternating.period(), (HashPeriod{2, 2}));
    expect_reported_period(alternating);
    const PermutationHash rows(2, {0, 2, 1, 3, 4, 6, 5, 7});
    EXPECT_EQ(rows.period(), (HashPeriod{4, 4}));
    expect_reported_period(rows);
    const PermutationHash different(2, {0, 1, 4, 3, 2, 5, 6, 7});
    expect_reported_period(different);
}

TEST(PermutationHash, ColorsAreAsFrequentWhereTheirNumberDividesTheTable)
{
    for (Color c = 2; c <= 8; ++c) {
        const PermutationHash hash(c, permutation_key);
        const auto n = static_cast<std::int64_t>(hash.permutation().size());
        EXPECT_GT(n + c, 256);
        std::vector<std::int64_t> counts(c);
        for (std::int64_t x = 0; x < n; ++x) {
            for (std::int64_t y = 0; y < n; ++y) ++counts[hash(x, y)];
        }
        for (const std::int64_t count : counts) EXPECT_EQ(count, n * n / c);
    }
}

TEST(PermutationHash, RefusesTablesThatAreTooSmallOrTooLarge)
{
    EXPECT_THROW(PermutationHash(8, 7, permutation_key), InputError);
    EXPECT_THROW(PermutationHash(8, 65537, permutation_key), InputError);
    EXPECT_NO_THROW(PermutationHash(8, 8, permutation_key));
}

}
}
