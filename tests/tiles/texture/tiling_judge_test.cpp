// Sizes of features and numbers of fragments, against their definitions; judgements of sets by hand.
#include "tiles/texture/tiling_judge.hpp"

#include "tests/host/texture/random_picture.hpp"
#include "tests/tiles/texture/dead_leaves.hpp"
#include "tests/tiles/texture/quartered_set.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

double variance_of_means(const PngPixels& picture, int side)
{
    double sum = 0, squares = 0, count = 0;
    for (int top = 0; top + side <= picture.height; ++top)
        for (int left = 0; left + side <= picture.width; ++left, ++count) {
            double mean = 0;
            for (int y = top; y < top + side; ++y)
                for (int x = left; x < left + side; ++x)
                    for (int c = 0; c < picture.channels; ++c)
                        mean += picture.values[picture.at(x, y, c)] / (static_cast<double>(side) * side);
            sum += mean;
            squares += mean * mean;
        }
    return squares / count - sum / count * (sum / count);
}

TEST(TilingJudge, FeaturesKeepHalfOfTheVariance)
{
    for (const int channels : {1, 3}) {
        const PngPixels picture = test::dead_leaves(90, 70, channels, 4);
        const int side = feature_side(picture);
        EXPECT_LE(variance_of_means(picture, side), variance_of_means(picture, 1) / 2);
        EXPECT_GT(variance_of_means(picture, side - 1), variance_of_means(picture, 1) / 2);
    }
    EXPECT_EQ(feature_side(test::random_picture(40, 40, 1, 3)), 2) << "noise: a quarter of the variance";
    EXPECT_EQ(feature_side({40, 30, 1, std::vector<std::uint8_t>(1200, 9)}), 1);
}

/// Flood fills, from each pixel that none has reached.
std::size_t filled_fragments(const std::vector<SourcePixel>& sources, int width, std::size_t pixels)
{
    const int height = static_cast<int>(sources.size()) / width;
    std::vector<bool> is_seen(sources.size());
    std::size_t found = 0;
    for (int start = 0; start < width * height; ++start) {
        if (is_seen[static_cast<std::size_t>(start)]) continue;
        std::vector<int> waiting{start};
        is_seen[static_cast<std::size_t>(start)] = true;
        bool is_at_border = false;
        std::size_t size = 0;
        while (!waiting.empty()) {
            const int at = waiting.back(), x = at % width, y = at / width;
            waiting.pop_back();
            ++size;
            is_at_border = is_at_border || x == 0 || y == 0 || x + 1 == width || y + 1 == height;
            for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
                if (x + dx < 0 || y + dy < 0 || x + dx >= width || y + dy >= height) continue;
                const auto to = static_cast<std::size_t>(at + dx + dy * width);
                const SourcePixel one = sources[static_cast<std::size_t>(at)], other = sources[to];
                if (is_seen[to] || other.x - one.x != dx || other.y - one.y != dy) continue;
                is_seen[to] = true;
                waiting.push_back(static_cast<int>(to));
            }
        }
        if (!is_at_border && size < pixels) ++found;
    }
    return found;
}

TEST(TilingJudge, CountsSmallFragments)
{
    std::mt19937 random(5);
    std::vector<SourcePixel> sources;
    std::vector<int> shifts;
    for (int i = 0; i < 40 * 30; ++i) shifts.push_back(static_cast<int>(random() % 3));
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x)
            sources.push_back(
                {static_cast<std::uint16_t>(x + 50 * shifts[static_cast<std::size_t>(y / 2 * 20 + x / 2)]),
                 static_cast<std::uint16_t>(y)});
    for (const std::size_t pixels : {1u, 4u, 5u, 9u, 30u, 2000u})
        EXPECT_EQ(small_fragments(sources, 40, pixels), filled_fragments(sources, 40, pixels)) << pixels;
    EXPECT_GT(small_fragments(sources, 40, 5), 0u);
}

/// Quarters of patches that are cut nowhere: no fragments. New patches are those of a picture without sources, which
/// numpy holds, at every fourth pixel of 16 x 16 tiles; of a smoothed set, at every eighth.
TEST(TilingJudge, JudgesQuarters)
{
    TextureSet set = test::quartered_set(test::dead_leaves(150, 140, 1, 6, 1500), 32, {{10, 10}, {100, 60}});
    const TilingJudge judge(set.exemplar, 32);
    const PngPixels picture =
        texture_window_pixels(set, texture_window(set, {0, 0, 16, 16}, 3), set.values, set.exemplar.channels);
    TilingJudgement quarters = judge.judge(set, 3);
    EXPECT_EQ(quarters.fragments, 0);
    EXPECT_EQ(quarters.feature, feature_side(set.exemplar));
    EXPECT_EQ(quarters.sides, (std::array{9, 27, 41}));
    const std::array patches{PatchNovelty(set.exemplar, 9), PatchNovelty(set.exemplar, 27)};
    for (const int step : {4, 8}) {
        for (std::size_t i = 0; i < patches.size(); ++i) {
            ASSERT_TRUE(quarters.novelty[i]);
            EXPECT_EQ(*quarters.novelty[i], patches[i].share(picture, step)) << i << " " << step;
        }
        EXPECT_GT(*quarters.novelty[0], 0);
        EXPECT_FALSE(quarters.novelty[2]) << "it does not fit";
        set.is_smoothed = true;
        quarters = judge.judge(set, 3);
    }
    EXPECT_FALSE(TilingJudge(test::random_picture(100, 100, 1, 1), 32).judge(set, 3).novelty[1]) << "too small";
    set.classes = 2;
    EXPECT_FALSE(judged_tiling(set, 3)) << "two exemplars side by side";
}

/// Features larger than half of a tile are in no tile as a whole, so that fragments mean nothing.
TEST(TilingJudge, CountsFragmentsOfFeaturesWithinTiles)
{
    PngPixels ramp{100, 100, 1, {}};
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) ramp.values.push_back(static_cast<std::uint8_t>(x + y));
    const TextureSet set = test::quartered_set(ramp, 32, {{10, 10}, {60, 60}});
    const TilingJudgement found = TilingJudge(set.exemplar, 32, false).judge(set, 1);
    EXPECT_GT(found.feature, 16);
    EXPECT_FALSE(found.fragments);
    EXPECT_TRUE(TilingJudge(set.exemplar, 2 * found.feature, false).judge(set, 1).fragments);
    EXPECT_FALSE(TilingJudge(set.exemplar, 2 * found.feature - 1, false).judge(set, 1).fragments);
}

}
}
