// Tests of salience, against marks that were put into an exemplar.
#include "host/texture/salience.hpp"

#include "host/texture/corner_patches.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace poissonlab {
namespace {

constexpr int window_size = 32, reach = 6;

/// Noise with a dark square of a side, whose upper left corner is at (60, 50).
PngPixels marked_noise(int channels, int side)
{
    PngPixels picture = test::random_picture(120, 110, channels, 7);
    for (int y = 50; y < 50 + side; ++y)
        for (int x = 60; x < 60 + side; ++x)
            for (int c = 0; c < channels; ++c) picture.values[picture.at(x, y, c)] = 0;
    return picture;
}

/// The window whose middle is at a place.
ExemplarWindow around(int x, int y) { return {x - window_size / 2, y - window_size / 2, window_size}; }

/// Squares of 2 x 2 pixels and 4 x 4 are those that reach to 6 looks at.
TEST(Salience, SeesAMarkWhereverItLiesInTheMiddle)
{
    for (const int channels : {1, 3})
        for (const int side : {4, 8}) {
            const Salience salience(marked_noise(channels, side), {0, 120}, window_size, reach);
            // A square of 4 x 4 of the mark lies in the middle, which is 12 x 12.
            for (const int dx : {-4, 0, 4})
                for (const int dy : {-4, 0, 4}) {
                    EXPECT_GT(salience.rank(around(62 + dx, 52 + dy)), 0.95) << channels << " " << side;
                }
        }
}

/// A mark beside the middle, where tiles show something else, is none.
TEST(Salience, LooksAtTheMiddleAlone)
{
    const PngPixels plain = test::random_picture(120, 110, 1, 7), marked = marked_noise(1, 4);
    const Salience before(plain, {0, 120}, window_size, reach), after(marked, {0, 120}, window_size, reach);
    // The mark begins where the middle ends: the rank falls a little, as those with the mark overtake it.
    const ExemplarWindow beside = around(60 - reach, 52);
    EXPECT_LE(after.rank(beside), before.rank(beside) + 0.02);
    EXPECT_LT(before.rank(beside) - after.rank(beside), 0.06);
}

TEST(Salience, RanksAreThePartOfWindowsThatStandOutLess)
{
    const Salience salience(marked_noise(1, 4), {10, 100}, window_size, reach);
    double sum = 0;
    int count = 0;
    for (int y = 0; y + window_size <= 110; ++y)
        for (int x = 10; x + window_size <= 100; ++x, ++count) sum += salience.rank({x, y, window_size});
    // Ranks are even but for ties: windows that share their largest deviation, some tens of several thousand.
    EXPECT_NEAR(sum / count, 0.5, 0.05);
}

TEST(Salience, OfOneColorIsNone)
{
    const PngPixels grey{80, 80, 1, std::vector<std::uint8_t>(80 * 80, 90)};
    EXPECT_EQ(Salience(grey, {0, 80}, window_size, reach).rank({9, 9, window_size}), 0);
}

/// The quarter of windows that stand out least has room, so that every patch is of it, whatever the seed.
TEST(CornerPatches, DoNotStandOut)
{
    const PngPixels picture = marked_noise(3, 8);
    TextureRequest request;
    request.size = window_size;
    request.colors = {3, 3};
    request.attempts = 4;
    const Salience salience(picture, {0, picture.width}, window_size, window_size / 5);
    for (request.seed = 1; request.seed <= 20; ++request.seed)
        for (const ExemplarWindow& patch : chosen_patches(picture, request, 4))
            EXPECT_LE(salience.rank(patch), most_salience) << request.seed;
}

}
}
