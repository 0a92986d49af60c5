// Quilted pictures: copies of the exemplar, cut where windows agree, without a lattice.
#include "host/texture/endless/quilting.hpp"

#include "host/texture/comparison/texture_comparison.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

namespace poissonlab {
namespace {

QuiltedPicture quilted(const PngPixels& exemplar, int side, std::uint64_t seed = 1, int block = 24)
{
    EndlessRequest request;
    request.method = EndlessMethod::quilted;
    request.block = block;
    request.seed = seed;
    return quilted_picture(request, exemplar, side, side, [](int, int) {});
}

/// Noise whose values are means over 3 x 3 pixels, so that windows agree more or less.
PngPixels smooth_noise(int side)
{
    const PngPixels noise = test::random_picture(side + 2, side + 2, 1, 4);
    PngPixels smooth{side, side, 1, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            int sum = 0;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) sum += noise.values[noise.at(x + i, y + j, 0)];
            smooth.values.push_back(static_cast<std::uint8_t>(sum / 9));
        }
    return smooth;
}

TEST(QuiltedPicture, ShowsItsSources)
{
    const PngPixels exemplar = smooth_noise(96);
    const QuiltedPicture picture = quilted(exemplar, 150);
    ASSERT_EQ(picture.sources.size(), 150u * 150);
    for (std::size_t i = 0; i < picture.sources.size(); ++i)
        EXPECT_EQ(picture.pixels.values[i],
                  exemplar.values[exemplar.at(picture.sources[i].x, picture.sources[i].y, 0)]);
}

TEST(QuiltedPicture, IsTheSameOnOneThread)
{
    const PngPixels exemplar = smooth_noise(80);
    const QuiltedPicture picture = quilted(exemplar, 100);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(quilted(exemplar, 100).pixels.values, picture.pixels.values);
    EXPECT_NE(quilted(exemplar, 100, 2).pixels.values, picture.pixels.values);
}

/// Steps over seams are smaller than those between windows that were put side by side without looking.
TEST(QuiltedPicture, CutsWhereWindowsAgree)
{
    const PngPixels exemplar = smooth_noise(96);
    const QuiltedPicture picture = quilted(exemplar, 200);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x + 1 < 200; ++x) {
            const auto at = static_cast<std::size_t>(y * 200 + x);
            const SourcePixel p = picture.sources[at], q = picture.sources[at + 1];
            if (q.x == p.x + 1 && q.y == p.y) continue;
            sum += std::abs(picture.pixels.values[at + 1] - picture.pixels.values[at]);
            ++count;
        }
    double natural = 0, unrelated = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 48; ++x) {
            const auto value = [&](int column) { return int{exemplar.values[exemplar.at(column, y, 0)]}; };
            natural += std::abs(value(x + 1) - value(x)) / (96.0 * 48);
            unrelated += std::abs(value(x + 48) - value(x)) / (96.0 * 48);
        }
    ASSERT_GT(count, 1000);
    EXPECT_LT(sum / count, (natural + unrelated) / 2);
}

/// Blocks of 24 pixels begin every 20; a lattice would correlate these distances.
TEST(QuiltedPicture, HasNoLattice)
{
    const PngPixels exemplar = smooth_noise(128);
    const LightMap light = lightness_map(quilted(exemplar, 320).pixels);
    const SelfCorrelation correlations(light);
    const double chance = chance_of_peak(SelfCorrelation(lightness_map(exemplar)), 8, 320, 320);
    for (const auto& [dx, dy] : {std::pair{20, 0}, {0, 20}, {20, 20}, {-20, 20}, {40, 0}, {0, 40}})
        EXPECT_LT(correlations.at(dx, dy), chance) << dx << " " << dy;
}

}
}
