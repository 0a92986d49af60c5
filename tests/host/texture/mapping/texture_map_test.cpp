// Views of endless textures: the kernel against its plain twin, and look-ups against an explicit texture, whose levels
// are means of whole boxes of its pixels.
#include "host/texture/mapping/texture_map.hpp"

#include "base/images/srgb_light.hpp"
#include "host/device/device.hpp"
#include "runtime/texture_tiles.h"
#include "tests/host/texture/mapped_noise.hpp"
#include "tests/support/errors.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

using test::plan_view;

constexpr std::uint32_t tiling_seed = test::mapped_seed;
constexpr int tile_pixels = test::mapped_tile_pixels;

TextureSet noise_tiles(Color colors, int channels, int ring, int stages = 3)
{
    return test::mapped_noise(TextureKind::corner, colors, channels, ring, stages);
}

const TextureSet& ringed_tiles()
{
    static const TextureSet set = noise_tiles(2, 1, 2);
    return set;
}

const TextureSet& wang_tiles()
{
    static const TextureSet set = test::mapped_noise(TextureKind::wang, 3, 1, 2);
    return set;
}

/// A view to the horizon.
TextureView perspective(TextureFilter filter, int width = 60, int height = 44)
{
    TextureCamera camera;
    camera.width = width;
    camera.height = height;
    camera.tile_x = -3;
    camera.tile_y = std::int64_t{1} << 40;
    camera.pitch = 12;
    camera.yaw = 33;
    camera.samples = 2;
    camera.filter = filter;
    return view_of(camera);
}

void expect_same_on_device(const TextureSet& set, const std::vector<std::string>& lookups, const TextureView& plain)
{
    Device device = Device::open();
    const TexturePyramid pyramid = texture_pyramid(set, tiling_seed);
    for (const std::string& lookup : lookups)
        for (const std::string& filter : texture_filters.all()) {
            TextureView view = plain;
            view.filter = static_cast<int>(*texture_filters.find(filter));
            const auto expected = reference_map_texture(pyramid, *texture_lookups.find(lookup), view);
            for (const std::size_t group : {1u, 64u})
                EXPECT_EQ(map_texture(device, pyramid, *texture_lookups.find(lookup), view, group), expected)
                    << lookup << " " << filter;
        }
}

TEST(TextureMap, IsTheSameOnADevice)
{
    const TextureView view = perspective(TextureFilter::nearest);
    expect_same_on_device(ringed_tiles(), texture_lookups.all(), view);
    expect_same_on_device(wang_tiles(), {"packed", "exact"}, view);
    expect_same_on_device(noise_tiles(3, 3, 1), {"exact"}, view);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
class MappedKinds : public testing::TestWithParam<TextureKind>
{
};

/// A few pixels near the horizon, where every level is looked up.
TEST_P(MappedKinds, AreTheSameOnADevice)
{
    expect_same_on_device(GetParam() == TextureKind::wang ? wang_tiles() : ringed_tiles(), {"packed", "exact"},
                          perspective(TextureFilter::nearest, 3, 8));
}

INSTANTIATE_TEST_SUITE_P(Small, MappedKinds, testing::Values(TextureKind::corner, TextureKind::wang));

/// Device memory is foretold before it is taken.
TEST(TextureMap, TakesTheMemoryThatItSays)
{
    Device device = Device::open();
    const TexturePyramid pyramid = texture_pyramid(ringed_tiles(), tiling_seed);
    const TextureView view = perspective(TextureFilter::bilinear);
    const std::uint64_t before = device.memory().total;
    device.watch_memory();
    map_texture(device, pyramid, TextureLookup::exact, view, 64);
    EXPECT_EQ(texture_map_memory(pyramid, view),
              (DeviceMemory{device.peak_memory().largest, device.peak_memory().total - before}));
    // 2^20 samples at a time, of four a pixel, and three channels.
    TextureView large = view;
    large.width = large.height = 16'384;
    EXPECT_EQ(texture_map_memory(pyramid, large).largest, (std::uint64_t{1} << 18) * sizeof(float));
}

/// A window of the endless texture, put together pixel by pixel: light, rows from south to north.
struct ExplicitTexture
{
    explicit ExplicitTexture(const TextureSet& set)
        : side(tiles * set.size), light(static_cast<std::size_t>(side * side))
    {
        const PngPixels atlas = atlas_of(set);
        const auto size = static_cast<std::uint32_t>(set.size);
        for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(side); ++y)
            for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(side); ++x)
                light[y * static_cast<std::uint32_t>(side) + x] = static_cast<double>(
                    light_of_bytes()[atlas.values[(set.kind == TextureKind::wang ? ttiles_wang_texel : ttiles_texel)(
                        tiling_seed, set.colors.horizontal, size, x / size, y / size, x % size, y % size)]]);
    }

    /// The mean of a box of 2^level x 2^level pixels.
    double box(int level, int x, int y) const
    {
        double sum = 0;
        const int size = 1 << level;
        for (int j = y * size; j < (y + 1) * size; ++j)
            for (int i = x * size; i < (x + 1) * size; ++i) sum += light[static_cast<std::size_t>(j * side + i)];
        return sum / (size * size);
    }

    /// Bilinear between boxes, at a place in pixels.
    double bilinear(int level, double x, double y) const
    {
        const double u = x / (1 << level) - 0.5, v = y / (1 << level) - 0.5;
        const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
        const double s = u - i, t = v - j;
        return (1 - t) * ((1 - s) * box(level, i, j) + s * box(level, i + 1, j)) +
               t * ((1 - s) * box(level, i, j + 1) + s * box(level, i + 1, j + 1));
    }

    static constexpr int tiles = 28;
    int side;
    std::vector<double> light;
};

/// Twenty-three pixels along each axis, at each level: they lie at all fractions of texels, on both sides of borders.
void expect_explicit_texture(const TextureSet& set)
{
    const TexturePyramid pyramid = texture_pyramid(set, tiling_seed);
    const ExplicitTexture texture(set);
    const int top = pyramid.levels.top;
    for (int level = 0; level <= top + contract::texture_map::WHOLE_LEVELS; ++level) {
        const double texels = 1 << level;
        const int size = level > top ? 3 : 23 >> std::max(0, level - 3);
        const double start = 4 * tile_pixels + 0.37 * texels;
        TextureView view = plan_view(texels, start, size, TextureFilter::mipmap);
        const auto found = reference_map_texture(pyramid, TextureLookup::exact, view);
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const double x = start + column * texels, y = start + (size - row) * texels;
                // Four products of floats, and sums of up to 2^20 values that are rounded once a level.
                ASSERT_NEAR(static_cast<double>(found[static_cast<std::size_t>(row * size + column)]),
                            texture.bilinear(level, x, y), 65535 * 16 * 0x1p-24)
                    << level << " " << column << " " << row;
            }
    }
}

TEST(TextureMap, IsThatOfAnExplicitTextureAtAllLevels)
{
    expect_explicit_texture(ringed_tiles());
    expect_explicit_texture(wang_tiles());
}

/// Between two powers of two the levels are mixed in proportion.
TEST(TextureMap, MixesTwoLevels)
{
    const TexturePyramid pyramid = texture_pyramid(ringed_tiles(), tiling_seed);
    const ExplicitTexture texture(ringed_tiles());
    const auto found =
        reference_map_texture(pyramid, TextureLookup::exact, plan_view(2.5, 70, 40, TextureFilter::mipmap));
    for (int i = 0; i < 1600; ++i) {
        const double x = 70 + i % 40 * 2.5, y = 70 + (40 - i / 40) * 2.5;
        ASSERT_NEAR(static_cast<double>(found[static_cast<std::size_t>(i)]),
                    0.75 * texture.bilinear(1, x, y) + 0.25 * texture.bilinear(2, x, y), 0.1);
    }
}

/// The pixels of a view that differ between packed and exact look-ups.
std::size_t differences(const TexturePyramid& pyramid, const TextureView& view)
{
    const auto packed = reference_map_texture(pyramid, TextureLookup::packed, view);
    const auto exact = reference_map_texture(pyramid, TextureLookup::exact, view);
    std::size_t count = 0;
    for (std::size_t i = 0; i < packed.size(); ++i) count += packed[i] != exact[i];
    return count;
}

/// The theorem of rings: bit for bit the same up to the level of the ring, and not beyond it; never without a ring.
TEST(TextureMap, IsRightInThePackedAtlasUpToTheLevelOfTheRing)
{
    for (const int ring : {0, 1, 2}) {
        const TexturePyramid pyramid = texture_pyramid(noise_tiles(3, 1, ring, ring == 0 ? 1 : 3), tiling_seed);
        for (int level = 0; level < 3; ++level) {
            const std::size_t count =
                differences(pyramid, plan_view(1 << level, 0.37 * (1 << level), 160 >> level, TextureFilter::mipmap));
            if (1 << level <= ring)
                EXPECT_EQ(count, 0u) << ring << " " << level;
            else
                EXPECT_GT(count, 0u) << ring << " " << level;
        }
    }
}

/// The corner problem of Wang tiles: up to the level of the ring the packed atlas is wrong within a texel of tiles'
/// corners, and nowhere else.
TEST(TextureMap, IsRightInThePackedAtlasOfWangTilesButAtCorners)
{
    const TexturePyramid pyramid = texture_pyramid(wang_tiles(), tiling_seed);
    for (const int level : {0, 1}) {
        const int texels = 1 << level, size = 160 >> level;
        const double start = 0.37 * texels;
        const TextureView view = plan_view(texels, start, size, TextureFilter::mipmap);
        const auto packed = reference_map_texture(pyramid, TextureLookup::packed, view);
        const auto exact = reference_map_texture(pyramid, TextureLookup::exact, view);
        std::size_t at_corners = 0;
        for (int i = 0; i < size * size; ++i) {
            const auto from_line = [&](double place) { // of texels of the level
                const double in_tile = std::remainder(place, tile_pixels);
                return std::abs(in_tile) / texels;
            };
            const double x = start + i % size * texels, y = start + (size - i / size) * texels;
            const bool is_corner = from_line(x) < 1.5 && from_line(y) < 1.5;
            if (!is_corner) {
                ASSERT_EQ(packed[static_cast<std::size_t>(i)], exact[static_cast<std::size_t>(i)]) << x << " " << y;
            }
            at_corners += packed[static_cast<std::size_t>(i)] != exact[static_cast<std::size_t>(i)];
        }
        EXPECT_GT(at_corners, 0u);
    }
}

TEST(TextureMap, ShowsTheBytesOfTheAtlasWhereNothingIsFiltered)
{
    const TextureSet set = noise_tiles(2, 3, 1);
    const PngPixels atlas = atlas_of(set);
    const auto light = reference_map_texture(texture_pyramid(set, tiling_seed), TextureLookup::exact,
                                             plan_view(1, 0.5, 4 * tile_pixels, TextureFilter::nearest));
    const PngPixels seen = encoded_pixels(light, 4 * tile_pixels, 4 * tile_pixels, 3);
    for (std::uint32_t y = 0; y < 4 * tile_pixels; ++y)
        for (std::uint32_t x = 0; x < 4 * tile_pixels; ++x)
            for (std::uint32_t c = 0; c < 3; ++c) {
                // The view's last row is one pixel above its start.
                const std::uint32_t north = y + 1;
                ASSERT_EQ(seen.values[seen.at(static_cast<int>(x), 4 * tile_pixels - 1 - static_cast<int>(y),
                                              static_cast<int>(c))],
                          atlas.values[3 * ttiles_texel(tiling_seed, 2, tile_pixels, x / tile_pixels,
                                                        north / tile_pixels, x % tile_pixels, north % tile_pixels) +
                                       c]);
            }
}

/// The map shows from straight above what `texture tile` draws, texel by texel, also left of and below 0.
TEST(TextureMap, ShowsThePlaneOfTheTiling)
{
    constexpr int tiles = 6;
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const TextureSet set = test::mapped_noise(kind, 3, 3, 1);
        const TextureWindow window = texture_window(set, {-2, -2, tiles + 1, tiles + 1}, tiling_seed);
        const PngPixels drawn = texture_window_pixels(set, window, set.values, 3);
        constexpr int size = tiles * tile_pixels;
        // The view's first row is one texel above so many tiles north of its start.
        const auto light = reference_map_texture(texture_pyramid(set, tiling_seed), TextureLookup::exact,
                                                 plan_view(1, -2 * tile_pixels + 0.5, size, TextureFilter::nearest));
        const PngPixels seen = encoded_pixels(light, size, size, 3);
        for (int y = 0; y < size; ++y)
            for (int i = 0; i < 3 * size; ++i)
                ASSERT_EQ(seen.values[seen.at(0, y, i)], drawn.values[drawn.at(0, y + tile_pixels - 1, i)])
                    << i / 3 << " " << y;
    }
}

/// Tiles far away, and places left of 0: the view from another tile is the same picture.
TEST(TextureMap, CountsTilesWithoutEnd)
{
    const TexturePyramid pyramid = texture_pyramid(ringed_tiles(), tiling_seed);
    const TextureView near = plan_view(0.5, 3.25 * tile_pixels, 96, TextureFilter::bilinear);
    for (const int shift : {-7, 4}) {
        TextureView far = plan_view(0.5, (3.25 + shift) * tile_pixels, 96, TextureFilter::bilinear);
        far.tile_x = far.tile_y = static_cast<std::uint32_t>(-shift);
        EXPECT_EQ(reference_map_texture(pyramid, TextureLookup::exact, far),
                  reference_map_texture(pyramid, TextureLookup::exact, near));
    }
}

/// The mean difference from a view with 8 x 8 bilinear samples a pixel, which are as many as the distance needs here.
double filtering_error(const TexturePyramid& pyramid, TextureFilter filter)
{
    TextureCamera camera;
    camera.width = camera.height = 40;
    camera.pitch = 30;
    camera.field = 25;
    camera.above = 3;
    camera.filter = filter;
    const auto filtered = reference_map_texture(pyramid, TextureLookup::exact, view_of(camera));
    camera.samples = 8;
    camera.filter = TextureFilter::bilinear;
    const auto samples = reference_map_texture(pyramid, TextureLookup::exact, view_of(camera));
    double sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) sum += std::abs(static_cast<double>(filtered[i] - samples[i]));
    return sum / static_cast<double>(samples.size());
}

TEST(TextureMap, IsNearerToManySamplesTheBetterItIsFiltered)
{
    const TexturePyramid pyramid = texture_pyramid(ringed_tiles(), tiling_seed);
    const double mipmap = filtering_error(pyramid, TextureFilter::mipmap);
    EXPECT_LT(filtering_error(pyramid, TextureFilter::anisotropic), mipmap);
    EXPECT_LT(mipmap, filtering_error(pyramid, TextureFilter::bilinear));
    EXPECT_LT(mipmap, filtering_error(pyramid, TextureFilter::nearest));
}

TEST(TextureMap, HasTheMeanOfAllTilesFarAway)
{
    const TexturePyramid pyramid = texture_pyramid(ringed_tiles(), tiling_seed);
    const auto light =
        reference_map_texture(pyramid, TextureLookup::exact, plan_view(1e6, 0, 3, TextureFilter::mipmap));
    double sum = 0;
    for (const std::uint8_t value : ringed_tiles().values) sum += static_cast<double>(light_of_bytes()[value]);
    const double mean = sum / static_cast<double>(ringed_tiles().values.size());
    for (const float value : light) EXPECT_NEAR(static_cast<double>(value), mean, 65535 * 16 * 0x1p-24);
}

TEST(TextureMap, RefusesOtherSets)
{
    TextureSet some = ringed_tiles();
    some.tiles.pop_back();
    EXPECT_THAT(message_of([&] { texture_pyramid(some, 1); }),
                HasSubstr("15 corner tiles: must be a complete set of corner or Wang tiles"));
    TextureSet odd = ringed_tiles();
    odd.size = 12;
    EXPECT_THAT(message_of([&] { texture_pyramid(odd, 1); }), HasSubstr("tile_size = 12: must be a power of two"));
}

TEST(TextureLight, GivesBytesBack)
{
    for (int byte = 0; byte < 256; ++byte)
        EXPECT_EQ(byte_of_light(light_of_bytes()[static_cast<std::size_t>(byte)]), byte);
    EXPECT_EQ(light_of_bytes()[0], 0);
    EXPECT_EQ(light_of_bytes()[255], 65535);
    EXPECT_EQ(byte_of_light(1e9f), 255);
    // IEC 61966-2-1: half of the light is byte 188.
    EXPECT_EQ(byte_of_light(32767.5f), 188);
}

}
}
