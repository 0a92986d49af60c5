// Every tile of a set is as frequent as every other.
//
// Tiles beside each other share colours, so counts of all tiles of a region are not those of independent
// draws. Tiles at random places of the plane, of which hardly any are near each other, are.
#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/tiling.hpp"

#include "tests/support/chi_square.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

/// All chi-square tests of this file: 7 numbers of colours for four algorithms, two hash functions, and two
/// pairs for two algorithms; permutation tables; dominoes and cubes.
constexpr std::size_t comparisons = 4 * 7 * 2 + 2 * 2 * 2 + 4 * 7 + 2 * 7 + 2 * 2;

/// The number of times that each tile of the set is at `samples` random places.
std::vector<std::uint64_t> counts_at_random_places(const Tiling& tiling, std::uint64_t samples)
{
    std::mt19937_64 random(17);
    std::vector<std::uint64_t> counts(tiling.tile_set().size());
    for (std::uint64_t i = 0; i < samples; ++i) {
        const auto x = static_cast<std::int64_t>(random());
        const auto y = static_cast<std::int64_t>(random());
        const auto position = tiling.tile_set().position(tiling.tile(x, y));
        EXPECT_TRUE(position);
        ++counts[position.value_or(0)];
    }
    return counts;
}

// Colours by XXH64 are biased by less than 2^-29, and those at the corners of a tile by long-period tables
// are dependent only as far as all seven tables are: relative frequencies of tiles are off by some 1e-4 (the
// sum of the squared Fourier coefficients of their distribution is about 1e-8), which raises chi-square by
// far less than 1.
TEST(TilingStatistics, EveryTileIsAsFrequent)
{
    for (const auto algorithm : {DirectAlgorithm::corner, DirectAlgorithm::wang_two_hashes,
                                 DirectAlgorithm::wang_one_hash, DirectAlgorithm::wang_edge_hash}) {
        for (const HashKind hash : {HashKind::long_period, HashKind::xxh64}) {
            for (Color c = 2; c <= 8; ++c) {
                const Tiling tiling(algorithm, {c, c}, hash, c);
                const std::uint64_t samples = 50 * std::max<std::uint64_t>(tiling.tile_set().size(), 1000);
                const auto counts = counts_at_random_places(tiling, samples);
                EXPECT_TRUE(test::are_equally_likely(counts, comparisons)) << static_cast<int>(algorithm) << " " << c;
            }
        }
    }
}

TEST(TilingStatistics, EveryTileIsAsFrequentWithTwoNumbersOfColors)
{
    for (const auto algorithm : {DirectAlgorithm::wang_two_hashes, DirectAlgorithm::wang_edge_hash}) {
        for (const HashKind hash : {HashKind::long_period, HashKind::xxh64}) {
            for (const WangColors c : {WangColors{2, 3}, WangColors{7, 4}}) {
                const Tiling tiling(algorithm, c, hash, 1);
                EXPECT_TRUE(test::are_equally_likely(counts_at_random_places(tiling, 50'000), comparisons));
            }
        }
    }
}

// One permutation table of 256 entries has few entries for each pair of neighbouring colours, so that in one
// tiling tiles are not as frequent. Over tilings of many seeds they are, but for what distinct entries do:
// two points look up the same entry with a probability of at most 2 / N, else different ones, whose colours
// then repel each other by 1 / (N - 1). That is a squared Fourier coefficient of at most (2 / N)^2 for C - 1
// colours of six pairs.
TEST(TilingStatistics, EveryTileIsAsFrequentOverManyPermutationTables)
{
    for (const auto algorithm : {DirectAlgorithm::corner, DirectAlgorithm::wang_two_hashes,
                                 DirectAlgorithm::wang_one_hash, DirectAlgorithm::wang_edge_hash}) {
        for (Color c = 2; c <= 8; ++c) {
            const TileSet set = Tiling(algorithm, {c, c}, HashKind::permutation, 0).tile_set();
            const std::uint64_t samples = 10 * std::max<std::uint64_t>(set.size(), 200);
            std::vector<std::uint64_t> counts(set.size());
            for (std::uint64_t seed = 0; seed < samples; ++seed) {
                const Tiling tiling(algorithm, {c, c}, HashKind::permutation, seed);
                ++counts[set.position(tiling.tile(12, 345)).value()];
            }
            const double excess = static_cast<double>(samples) * 6 * (c - 1) * std::pow(2.0 / 252, 2);
            EXPECT_TRUE(test::are_equally_likely(counts, comparisons, excess))
                << static_cast<int>(algorithm) << " " << c;
        }
    }
}

TEST(TilingStatistics, EveryDominoIsAsFrequent)
{
    for (const HashKind hash : {HashKind::long_period, HashKind::xxh64}) {
        for (Color c = 2; c <= 8; ++c) {
            const DominoTiling tiling(c, hash, c);
            std::mt19937_64 random(18);
            std::vector<std::uint64_t> counts(c * c);
            for (int i = 0; i < 20'000; ++i) ++counts[tiling.tile(static_cast<std::int64_t>(random()))];
            EXPECT_TRUE(test::are_equally_likely(counts, comparisons)) << c;
        }
    }
}

TEST(TilingStatistics, EveryCubeIsAsFrequent)
{
    for (const HashKind hash : {HashKind::long_period, HashKind::xxh64}) {
        for (const Color c : {2u, 3u}) {
            const CubeTiling tiling(c, hash, c);
            std::mt19937_64 random(19);
            std::vector<std::uint64_t> counts(tiling.tile_set().size());
            for (std::size_t i = 0; i < 100 * counts.size(); ++i)
                ++counts[tiling.tile(static_cast<std::int64_t>(random()), static_cast<std::int64_t>(random()),
                                     static_cast<std::int64_t>(random()))];
            EXPECT_TRUE(test::are_equally_likely(counts, comparisons)) << c;
        }
    }
}

}
}
