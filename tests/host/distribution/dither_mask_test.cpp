// Masks of thresholds: void-and-cluster against a plain one, and tiles whose pixels have ranks.
#include "host/distribution/masks/dither_mask.hpp"
#include "host/distribution/masks/void_and_cluster.hpp"

#include "tiles/poisson/proof/tile_certificate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace poissonlab {
namespace {

/// The energies of Ulichney's paper, all sums made anew.
class PlainPattern
{
public:
    PlainPattern(std::uint32_t width, std::uint32_t height) : width_(width), height_(height), in(width * height) {}

    std::uint64_t energy(std::uint32_t pixel) const
    {
        std::uint64_t sum = 0;
        for (std::uint32_t other = 0; other < in.size(); ++other) {
            if (!in[other]) continue;
            const int dx = shortest(pixel % width_, other % width_, width_);
            const int dy = shortest(pixel / width_, other / width_, height_);
            if (std::abs(dx) <= 7 && std::abs(dy) <= 7)
                sum += static_cast<std::uint64_t>(std::lround(std::exp(-(dx * dx + dy * dy) / 4.5) * 65'536));
        }
        return sum;
    }

    /// The pixel in the pattern of most energy, or the one out of it of least; of equal ones that of the first block.
    std::uint32_t best(bool cluster) const
    {
        std::tuple<std::int64_t, std::uint32_t, std::uint32_t, std::uint32_t> least{INT64_MAX, 0, 0, 0};
        for (std::uint32_t i = 0; i < in.size(); ++i) {
            if (in[i] != cluster) continue;
            const auto e = static_cast<std::int64_t>(energy(i));
            least = std::min(least, std::tuple{cluster ? -e : e, i / width_ / 16, i % width_ / 16, i});
        }
        return std::get<3>(least);
    }

private:
    static int shortest(std::uint32_t a, std::uint32_t b, std::uint32_t size)
    {
        const int d = (static_cast<int>(a) - static_cast<int>(b) + static_cast<int>(size)) % static_cast<int>(size);
        return d > static_cast<int>(size) / 2 ? d - static_cast<int>(size) : d;
    }

    std::uint32_t width_, height_;

public:
    std::vector<bool> in;
};

TEST(VoidAndCluster, IsThePlainOne)
{
    const std::uint32_t width = 20, height = 17;
    const std::vector<std::uint32_t> ranks = void_and_cluster(width, height, 3);
    // The pattern of the lowest tenth is even: its tightest cluster leaves its largest void.
    PlainPattern pattern(width, height);
    const std::uint32_t first = width * height / 10;
    for (std::uint32_t i = 0; i < ranks.size(); ++i) pattern.in[i] = ranks[i] < first;
    const std::uint32_t cluster = pattern.best(true);
    pattern.in[cluster] = false;
    EXPECT_EQ(pattern.best(false), cluster);
    pattern.in[cluster] = true;
    PlainPattern lower = pattern;
    for (std::uint32_t rank = first; rank-- > 0;) {
        const std::uint32_t pixel = lower.best(true);
        ASSERT_EQ(ranks[pixel], rank);
        lower.in[pixel] = false;
    }
    for (std::uint32_t rank = first; rank < ranks.size(); ++rank) {
        const std::uint32_t pixel = pattern.best(false);
        ASSERT_EQ(ranks[pixel], rank);
        pattern.in[pixel] = true;
    }
}

DitherMaskSettings small_mask(DitherMethod method)
{
    DitherMaskSettings settings;
    settings.size = 128;
    settings.method = method;
    settings.colors = 2;
    settings.tile_pixels = 8;
    return settings;
}

TEST(DitherMask, HasAsManyPixelsOfEachTileBelowAnyThreshold)
{
    const DitherMask mask = dither_mask(small_mask(DitherMethod::tiles), 1);
    ASSERT_EQ(mask.pixels(), 128U * 128);
    EXPECT_EQ(mask.levels, 64U);
    for (std::uint32_t row = 0; row < 128; row += 8)
        for (std::uint32_t column = 0; column < 128; column += 8) {
            std::vector<std::uint32_t> ranks;
            for (std::uint32_t i = 0; i < 64; ++i) ranks.push_back(mask.ranks[(row + i / 8) * 128 + column + i % 8]);
            std::ranges::sort(ranks);
            std::vector<std::uint32_t> all(64);
            std::iota(all.begin(), all.end(), 0U);
            ASSERT_EQ(ranks, all);
        }
    EXPECT_EQ(mask.threshold(0, 256), 4 * mask.ranks[0] + 2);
}

TEST(DitherMask, IsATileSetWhoseDistanceIsProven)
{
    const PoissonTileSet tiles = dither_tiles(small_mask(DitherMethod::tiles), 1);
    const TileCertificate certificate = certify(tiles);
    EXPECT_EQ(certificate.squared_min_distance, std::uint64_t{65'536 / 8} * (65'536 / 8));
    check_promises(tiles.parameters, tiles.squared_min_distance, certificate);
}

TEST(DitherMask, IsEvenBelowThresholds)
{
    for (const DitherMethod method : {DitherMethod::tiles, DitherMethod::void_and_cluster}) {
        const DitherMask mask = dither_mask(small_mask(method), 1);
        for (const std::uint32_t sixteenths : {1U, 4U, 13U}) {
            const ThresholdMeasures measures = threshold_measures(mask, sixteenths);
            EXPECT_EQ(measures.pixels, std::min(sixteenths, 16 - sixteenths) * 128U * 128 / 16);
            EXPECT_LT(measures.low_power, 0.35) << sixteenths; // random pixels have 1 - share, 0.75 and more
            EXPECT_GE(measures.least_distance, sixteenths == 1 ? std::sqrt(2.0) - 1e-6 : 1);
        }
    }
}

/// Pairs of the pixels of the lowest sixteenth that touch, by their sides or corners, counted one by one.
std::size_t touching_pairs(const DitherMask& mask)
{
    std::size_t pairs = 0;
    const auto is_below = [&](std::uint32_t x, std::uint32_t y) {
        return 16 * mask.ranks[std::size_t{y % mask.size} * mask.size + x % mask.size] < mask.levels;
    };
    for (std::uint32_t y = 0; y < mask.size; ++y)
        for (std::uint32_t x = 0; x < mask.size; ++x)
            if (is_below(x, y))
                pairs += is_below(x + 1, y) + is_below(x, y + 1) + is_below(x + 1, y + 1) +
                         is_below(x + mask.size - 1, y + 1);
    return pairs;
}

/// Void-and-cluster leaves no touching pixels; tiles do, so that they make endless masks only.
TEST(DitherMask, TouchesAtLowThresholdsWhereTilesMeetOnly)
{
    EXPECT_EQ(DitherMaskSettings{}.method, DitherMethod::void_and_cluster);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        EXPECT_EQ(touching_pairs(dither_mask(small_mask(DitherMethod::void_and_cluster), seed)), 0u) << seed;
        EXPECT_GT(touching_pairs(dither_mask(small_mask(DitherMethod::tiles), seed)), 0u) << seed;
    }
}

}
}
