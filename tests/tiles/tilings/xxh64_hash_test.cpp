// XXH64 against the library that defines it, and the colours made of it.
#include "tiles/tilings/tile_lattice.hpp"

#include "tests/support/chi_square.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace poissonlab {
namespace {

const StreamKey xxh64_key = stream_key(1, Purpose::tiling_colors, 0);

TEST(Xxh64, GivesWhatXxHashGives)
{
    // XXH64() of libxxhash 0.8.1, of the words' bytes in little-endian order.
    EXPECT_EQ(xxh64({0}, 0), 0x34c96acdcadb1bbbu);
    EXPECT_EQ(xxh64({0, 0}, 0), 0xaf09f71516247c32u);
    EXPECT_EQ(xxh64({0, 0, 0}, 0), 0xbb3302e8a9608868u);
    EXPECT_EQ(xxh64({1, 2}, 3), 0xc3b194463c90e885u);
    EXPECT_EQ(xxh64({1, 2, 3}, 4), 0x5243fe29c51eaceu);
    EXPECT_EQ(xxh64({0xffffffffffffffff, 0xfffffffffffffffe}, 0xfffffffffffffffd), 0x375ec82769c07733u);
    EXPECT_EQ(xxh64({0x8000000000000000, 0x7fffffffffffffff, 0}, 0x9e3779b97f4a7c15), 0x96c6203eb2e0082fu);
    EXPECT_EQ(xxh64({0x1b69b4ba630f34e, 0xf24b25a0b6074b88}, 0x123456789abcdef), 0x6bdf58fee6983b6fu);
}

TEST(Xxh64Hash, ScalesTheUpperWordToTheColors)
{
    const std::uint64_t seed = std::uint64_t{xxh64_key[1]} << 32 | xxh64_key[0];
    for (Color c = 2; c <= max_colors; ++c) {
        const Xxh64Hash hash(c, xxh64_key);
        const auto expected = [&](std::uint64_t h) {
            return static_cast<Color>((h >> 32) * c / (std::uint64_t{1} << 32));
        };
        EXPECT_EQ(hash(-5), expected(xxh64({0xfffffffffffffffb}, seed)));
        EXPECT_EQ(hash(-5, 7), expected(xxh64({0xfffffffffffffffb, 7}, seed)));
        EXPECT_EQ(hash(-5, 7, c), expected(xxh64({0xfffffffffffffffb, 7, c}, seed)));
    }
}

TEST(Xxh64Hash, RowsArePointByPoint)
{
    const Xxh64Hash hash(5, xxh64_key);
    std::vector<std::uint8_t> row(100);
    hash.fill_row(INT64_MAX - 200, 2, -3, row);
    for (std::int64_t i = 0; i < 100; ++i)
        ASSERT_EQ(row[static_cast<std::size_t>(i)], hash(INT64_MAX - 200 + 2 * i, -3));
}

TEST(Xxh64Hash, PointsBesideEachOtherAreIndependent)
{
    // Pairs along each axis and both diagonals, and triples, of neighbouring points: a hash function that is
    // not good enough shows here. Bias of the colours is below 2^-29, which no test sees.
    constexpr std::size_t comparisons = 7 * 5;
    for (Color c = 2; c <= 8; ++c) {
        const Xxh64Hash hash(c, xxh64_key);
        std::vector<std::uint64_t> east(c * c);
        std::vector<std::uint64_t> north(c * c);
        std::vector<std::uint64_t> diagonal(c * c);
        std::vector<std::uint64_t> antidiagonal(c * c);
        std::vector<std::uint64_t> heights(c * c);
        for (std::int64_t x = -300; x < 300; x += 2) {
            for (std::int64_t y = -300; y < 300; y += 2) {
                const Color here = c * hash(x, y);
                ++east[here + hash(x + 1, y)];
                ++north[here + hash(x, y + 1)];
                ++diagonal[here + hash(x + 1, y + 1)];
                ++antidiagonal[here + hash(x + 1, y - 1)];
                ++heights[c * hash(x, y, 0) + hash(x, y, 1)];
            }
        }
        for (const auto& counts : {east, north, diagonal, antidiagonal, heights})
            EXPECT_TRUE(test::are_equally_likely(counts, comparisons)) << c;
    }
}

}
}
