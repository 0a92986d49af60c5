// New patches: the shares that novelty.py finds with numpy, and what must be found in pictures that are spoiled on
// purpose.
#include "tiles/texture/patch_novelty.hpp"

#include "tests/tiles/texture/dead_leaves.hpp"
#include "tests/tiles/texture/novelty_numbers.hpp"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <numeric>

namespace poissonlab {
namespace {

constexpr int tested_side = 15, tested_step = 4;

template <class Source>
PngPixels picked(const PngPixels& picture, int width, int height, const Source& source)
{
    PngPixels result{width, height, picture.channels, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [sx, sy] = source(x, y);
            for (int c = 0; c < picture.channels; ++c) result.values.push_back(picture.values[picture.at(sx, sy, c)]);
        }
    return result;
}

/// Squares in another order.
PngPixels shuffled(const PngPixels& picture, int side, std::uint32_t seed)
{
    const int rows = picture.height / side, columns = picture.width / side;
    std::vector<int> order(static_cast<std::size_t>(rows * columns));
    std::iota(order.begin(), order.end(), 0);
    test::PlainRandom random(seed);
    for (std::size_t i = order.size() - 1; i > 0; --i)
        std::swap(order[i], order[static_cast<std::size_t>(random.next()) % (i + 1)]);
    return picked(picture, columns * side, rows * side, [&](int x, int y) {
        const int at = order[static_cast<std::size_t>(y / side * columns + x / side)];
        return std::pair(at % columns * side + x % side, at / columns * side + y % side);
    });
}

PngPixels repeated(const PngPixels& picture)
{
    return picked(picture, 3 * 48, 3 * 48, [](int x, int y) { return std::pair(20 + x % 48, 10 + y % 48); });
}

/// Numbers with 24 bits: thresholds to some 2,000 roundings, and of some 700 to 1,000 patches one that lies on the
/// threshold may fall on its other side.
TEST(PatchNovelty, IsThatOfNumpy)
{
    for (const int channels : {1, 3}) {
        const PngPixels exemplar = test::dead_leaves(120, 100, channels, 1);
        const PatchNovelty novelty(exemplar, tested_side);
        const double* const expected = novelty_numbers[channels / 2];
        EXPECT_NEAR(novelty.threshold(), expected[0], 1e-4 * expected[0]);
        EXPECT_NEAR(expected[1], natural_novelty, 1e-3) << "by construction";
        const std::array pictures{repeated(exemplar), test::dead_leaves(120, 100, channels, 2),
                                  shuffled(exemplar, 5, 5)};
        for (std::size_t i = 0; i < pictures.size(); ++i)
            EXPECT_NEAR(novelty.share(pictures[i], tested_step), expected[2 + i], 1.5 / 700) << i;
        // A spoiled picture has several times as many new patches as another picture by the same law.
        EXPECT_GT(expected[4], 4 * expected[3]);
        EXPECT_LT(expected[2], expected[3]);
    }
}

TEST(PatchNovelty, KnowsTheExemplar)
{
    const PngPixels exemplar = test::dead_leaves(120, 100, 1, 1);
    for (const int side : {7, 15, 25}) EXPECT_EQ(PatchNovelty(exemplar, side).share(exemplar, 1), 0) << side;
    const PngPixels plain{100, 100, 1, std::vector<std::uint8_t>(10'000, 7)};
    const PatchNovelty novelty(plain, 15);
    EXPECT_EQ(novelty.share(plain, 3), 0);
    EXPECT_EQ(novelty.share(exemplar, 3), 1) << "nothing of it is in a plain picture";
}

/// Sources are a short way to the same answer where all patches of the exemplar are known.
TEST(PatchNovelty, IsTheSameBySources)
{
    const PngPixels exemplar = test::dead_leaves(120, 100, 3, 1);
    const PatchNovelty novelty(exemplar, tested_side);
    std::vector<SourcePixel> sources;
    const auto source = [](int x, int y) { return std::pair((x / 9 * 31 + x) % 120, (y / 13 * 17 + y) % 100); };
    const PngPixels mosaic = picked(exemplar, 150, 130, [&](int x, int y) {
        const auto [sx, sy] = source(x, y);
        sources.push_back({static_cast<std::uint16_t>(sx), static_cast<std::uint16_t>(sy)});
        return std::pair(sx, sy);
    });
    const double share = novelty.share(mosaic, 2);
    EXPECT_GT(share, 0.01);
    EXPECT_EQ(novelty.share(mosaic, 2, sources), share);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(PatchNovelty(exemplar, tested_side).share(mosaic, 2, sources), share);
}

/// Larger exemplars are compared by a part of their patches; patches that are whole in the exemplar count as known.
TEST(PatchNovelty, KnowsWholePatchesOfLargeExemplars)
{
    const PngPixels exemplar = test::dead_leaves(330, 310, 1, 3, 9000);
    const PatchNovelty novelty(exemplar, 9);
    std::vector<SourcePixel> sources;
    const PngPixels part = picked(exemplar, 100, 90, [&](int x, int y) {
        sources.push_back({static_cast<std::uint16_t>(x + 31), static_cast<std::uint16_t>(y + 33)});
        return std::pair(x + 31, y + 33);
    });
    EXPECT_EQ(novelty.share(part, 2, sources), 0);
    EXPECT_GT(novelty.share(part, 2), 0) << "sharp disks, a pixel away from all that are compared";
}

TEST(PatchNovelty, NeedsRoom)
{
    EXPECT_TRUE(patch_fits({60, 64, 1, {}}, 15));
    EXPECT_FALSE(patch_fits({59, 64, 1, {}}, 15));
}

}
}
