// Filtering of endless textures against OpenImageIO, which knows nothing of tiles: its box filter makes the levels of
// an explicit texture, and its interpolation looks them up.
#include "base/images/srgb_light.hpp"
#include "runtime/texture_tiles.h"
#include "tests/host/texture/mapped_noise.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

constexpr int explicit_tiles = 32, explicit_pixels = explicit_tiles * test::mapped_tile_pixels;

/// Rows from north to south, as OpenImageIO has them.
OIIO::ImageBuf light_picture(int width, int height, const std::vector<float>& light)
{
    OIIO::ImageBuf picture(OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::FLOAT));
    picture.set_pixels(OIIO::ROI(0, width, 0, height), OIIO::TypeDesc::FLOAT, light.data());
    return picture;
}

OIIO::ImageBuf explicit_texture(const TextureSet& set)
{
    const PngPixels atlas = atlas_of(set);
    constexpr std::uint32_t size = test::mapped_tile_pixels, side = explicit_pixels;
    std::vector<float> light;
    for (std::uint32_t y = side; y-- > 0;)
        for (std::uint32_t x = 0; x < side; ++x) {
            const auto texel = set.kind == TextureKind::wang ? ttiles_wang_texel : ttiles_texel;
            light.push_back(light_of_bytes()[atlas.values[texel(test::mapped_seed, set.colors.horizontal, size,
                                                                x / size, y / size, x % size, y % size)]]);
        }
    return light_picture(side, side, light);
}

/// Means of boxes of 2^level x 2^level pixels.
OIIO::ImageBuf level_of(const OIIO::ImageBuf& picture, int level)
{
    return OIIO::ImageBufAlgo::resize(
        picture, "box", 0, OIIO::ROI(0, picture.spec().width >> level, 0, picture.spec().height >> level, 0, 1, 0, 1));
}

/// Floats are rounded once for each of the 2^(level + 1) terms of rows and columns, and a few times by weights.
double rounding(int level) { return 65535 * ((2 << level) + 16) * 0x1p-24; }

/// The explicit texture at a place in pixels of level 0 from the south-west, bilinear between boxes.
double looked_up(const OIIO::ImageBuf& picture, int level, double x, double y)
{
    float light = 0;
    picture.interppixel(static_cast<float>(x / (1 << level)), static_cast<float>((explicit_pixels - y) / (1 << level)),
                        &light);
    return static_cast<double>(light);
}

class FilteredKinds : public testing::TestWithParam<TextureKind>
{
};

TEST_P(FilteredKinds, HaveAtlasLevelsThatAreBoxFiltered)
{
    const TextureSet set = test::mapped_noise(GetParam(), 3, 1, 2);
    const TexturePyramid pyramid = texture_pyramid(set, test::mapped_seed);
    const PngPixels atlas = atlas_of(set);
    std::vector<float> light;
    for (const std::uint8_t value : atlas.values) light.push_back(light_of_bytes()[value]);
    const OIIO::ImageBuf picture = light_picture(atlas.width, atlas.height, light);
    for (int level = 1; level <= pyramid.levels.top; ++level) {
        const OIIO::ImageBuf boxes = level_of(picture, level);
        const int width = pyramid.width(level);
        ASSERT_EQ(boxes.spec().width, width);
        for (int row = 0; row < width; ++row)
            for (int column = 0; column < width; ++column)
                ASSERT_NEAR(
                    static_cast<double>(
                        pyramid.light[pyramid.levels.offsets[level] + static_cast<std::size_t>(row * width + column)]),
                    static_cast<double>(boxes.getchannel(column, width - 1 - row, 0, 0)), rounding(level))
                    << level << " " << row << " " << column;
    }
}

/// Pixels 1.25 texels of a level apart, all of whose places floats hold exactly: three quarters of the look-up are that
/// of the level, one quarter that of the next one. Beyond the tile's own levels there are those of 2 x 2 and 4 x 4
/// tiles.
TEST_P(FilteredKinds, HaveTrilinearLookUpsOfTheExplicitTexture)
{
    const TextureSet set = test::mapped_noise(GetParam(), 3, 1, 2);
    const TexturePyramid pyramid = texture_pyramid(set, test::mapped_seed);
    const OIIO::ImageBuf texture = explicit_texture(set);
    for (int level = 0; level < pyramid.levels.top + contract::texture_map::WHOLE_LEVELS; ++level) {
        const OIIO::ImageBuf lower = level_of(texture, level), upper = level_of(texture, level + 1);
        const int texels = 1 << level, margin = 4 * texels; // an image ends, the texture does not
        const int size = std::min(60, static_cast<int>((explicit_pixels - 2 * margin) / (1.25 * texels)));
        ASSERT_GT(size, 3);
        const double start = margin + 0.375 * texels;
        const auto found = reference_map_texture(pyramid, TextureLookup::exact,
                                                 test::plan_view(1.25 * texels, start, size, TextureFilter::mipmap));
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const double x = start + column * 1.25 * texels, y = start + (size - row) * 1.25 * texels;
                ASSERT_NEAR(static_cast<double>(found[static_cast<std::size_t>(row * size + column)]),
                            0.75 * looked_up(lower, level, x, y) + 0.25 * looked_up(upper, level + 1, x, y),
                            rounding(level + 1))
                    << level << " " << column << " " << row;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FilteredKinds, testing::Values(TextureKind::corner, TextureKind::wang));

}
}
