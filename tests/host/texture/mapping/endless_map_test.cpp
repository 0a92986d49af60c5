// Views of endless textures without tiles: the kernel against its plain twin, the pixels of `texture endless` from
// straight above, levels against sums over the exemplar, and tables back against the normal distribution.
#include "host/texture/mapping/endless_map.hpp"

#include "base/images/srgb_light.hpp"
#include "host/device/device.hpp"
#include "tests/host/texture/mapped_noise.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace poissonlab {
namespace {

using namespace contract::endless_map;
using namespace contract::endless_texture;

/// Requests in which every branch of the kernel is taken.
std::vector<EndlessRequest> mapped_requests()
{
    std::vector<EndlessRequest> requests;
    for (const EndlessMethod method :
         {EndlessMethod::repeated, EndlessMethod::offsets, EndlessMethod::hexagons, EndlessMethod::blended})
        for (const bool is_other : {false, true}) {
            if (is_other && method == EndlessMethod::repeated) continue; // it has no options
            EndlessRequest request;
            request.method = method;
            request.seed = 7;
            request.tileable = is_other;
            request.restored = is_other;
            request.gain = is_other && method == EndlessMethod::hexagons ? 3 : 1;
            request.falloff = is_other ? 0.95 : 0.6;
            if (is_other && method == EndlessMethod::blended) request.exponent = 4;
            requests.push_back(request);
        }
    return requests;
}

const char* name_of(const EndlessRequest& request) { return endless_methods[request.method]; }

TextureView horizon_view(TextureFilter filter, int width, int height)
{
    TextureCamera camera;
    camera.width = width;
    camera.height = height;
    camera.pitch = 12;
    camera.yaw = 33;
    camera.samples = 2;
    camera.filter = filter;
    return view_of(camera);
}

/// Looks straight down: pixels are `texels` apart, the first column's middle `start` texels east of the origin, and the
/// row below the last one as far north.
TextureView plan_of(double texels, double start, int size, TextureFilter filter)
{
    constexpr double part = static_cast<double>(test::mapped_tile_pixels) / static_cast<double>(TILE_TEXELS);
    return test::plan_view(texels * part, start * part, size, filter);
}

void expect_mapped_twin(const EndlessRequest& request, const PngPixels& exemplar, const TextureView& view,
                        std::size_t group)
{
    Device device = Device::open();
    const MappedEndless mapped = mapped_endless(request, exemplar);
    const EndlessWindow origin = mapped.origin(-3, std::int64_t{1} << 40);
    EXPECT_EQ(map_endless(device, mapped, origin, view, group), reference_map_endless(mapped, origin, view))
        << name_of(request) << ", groups of " << group;
}

TEST(EndlessMap, IsTheSameOnADevice)
{
    for (const EndlessRequest& request : mapped_requests())
        expect_mapped_twin(request, test::random_picture(61, 57, 3, 3),
                           horizon_view(TextureFilter::anisotropic, 24, 20), 64);
    EndlessRequest request;
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::mipmap})
        expect_mapped_twin(request, test::random_picture(61, 57, 1, 3), horizon_view(filter, 24, 20), 16);
    request.turn = 1;
    for (const bool is_tileable : {false, true}) {
        request.tileable = is_tileable;
        expect_mapped_twin(request, test::random_picture(61, 57, 3, 3), horizon_view(TextureFilter::bilinear, 24, 20),
                           64);
    }
    request.turn = 0;
    request.method = EndlessMethod::blended;
    expect_mapped_twin(request, test::random_picture(61, 57, 1, 3), horizon_view(TextureFilter::mipmap, 24, 20), 1);
}

/// Lattice numbers count modulo 2^32, and what is beyond 2^30 tiles is no longer the plane.
TEST(EndlessMap, IsTheSameOnADeviceFarAway)
{
    TextureCamera camera;
    camera.width = 8'192;
    camera.height = 64;
    camera.above = 10'000;
    camera.filter = TextureFilter::nearest;
    TextureView view = view_of(camera);
    view.height = 1;
    int of_sky = 0, of_plane = 0;
    for (const double w : {0x1.2p-24, 0x1p-20}) { // a row of pixels just below the horizon
        view.w[0] = w;
        view.w[1] = view.w[2] = 0;
        for (const EndlessMethod method : {EndlessMethod::offsets, EndlessMethod::hexagons, EndlessMethod::blended}) {
            EndlessRequest request;
            request.method = method;
            request.cell = 8;
            request.tileable = true;
            const MappedEndless mapped = mapped_endless(request, test::random_picture(61, 57, 1, 3));
            for (const float light : reference_map_endless(mapped, mapped.origin(0, 0), view))
                ++(light == static_cast<float>(contract::texture_map::SKY_LIGHT) ? of_sky : of_plane);
            expect_mapped_twin(request, test::random_picture(61, 57, 1, 3), view, 64);
        }
    }
    EXPECT_GT(of_sky, 100);
    EXPECT_GT(of_plane, 100);
    // Footprints at the horizon go beyond what is seen.
    camera.filter = TextureFilter::anisotropic;
    camera.pitch = 1e-5;
    camera.width = 65;
    camera.height = 17;
    expect_mapped_twin({}, test::random_picture(61, 57, 1, 3), view_of(camera), 64);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
class MappedEndlessMethods : public testing::TestWithParam<EndlessMethod>
{
};

/// A few pixels near the horizon, where every level is looked up.
TEST_P(MappedEndlessMethods, AreTheSameOnADevice)
{
    EndlessRequest request;
    request.method = GetParam();
    request.restored = true;
    expect_mapped_twin(request, test::random_picture(61, 57, 3, 3), horizon_view(TextureFilter::mipmap, 3, 8), 64);
}

INSTANTIATE_TEST_SUITE_P(Small, MappedEndlessMethods,
                         testing::Values(EndlessMethod::repeated, EndlessMethod::offsets, EndlessMethod::hexagons,
                                         EndlessMethod::blended));

/// From straight above, with a pixel a texel, every filter shows what `texture endless` has at these pixels, but for
/// its rounding to whole numbers and that of light between two of them: within one of 255 steps.
TEST(EndlessMap, ShowsThePixelsOfTheTextureFromAbove)
{
    constexpr int size = 90;
    const PngPixels exemplar = test::random_picture(61, 57, 3, 3);
    for (const EndlessRequest& request : mapped_requests())
        for (const TextureFilter filter :
             {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::anisotropic}) {
            constexpr std::int64_t tile_x = -(std::int64_t{1} << 40), tile_y = 11;
            const MappedEndless mapped = mapped_endless(request, exemplar);
            const PngPixels seen = encoded_pixels(
                reference_map_endless(mapped, mapped.origin(tile_x, tile_y), plan_of(1, 0.5, size, filter)), size, size,
                3);
            // The view's last row is one pixel above its start.
            const PngPixels drawn =
                reference_endless_window(endless_texture(request, exemplar),
                                         {tile_x * TILE_TEXELS, -tile_y * TILE_TEXELS - size - 1, size, size});
            int most = 0;
            for (std::size_t i = 0; i < seen.values.size(); ++i)
                most = std::max(most, std::abs(int{seen.values[i]} - int{drawn.values[i]}));
            EXPECT_LE(most, 1) << name_of(request) << " " << static_cast<int>(filter);
        }
}

/// The mean light of a rectangle of a picture's channel.
double mean_light(const PngPixels& picture, int x, int y, int width, int height, int channel)
{
    double sum = 0;
    for (int j = y; j < y + height; ++j)
        for (int i = x; i < x + width; ++i)
            sum += static_cast<double>(light_of_bytes()[picture.values[picture.at(i, j, channel)]]);
    return sum / (static_cast<double>(width) * height);
}

/// The mean of a level's texels of a channel.
double mean_of_level(const MappedEndless& mapped, int level, int channel)
{
    const std::size_t texels =
        static_cast<std::size_t>(mapped.levels.widths[level]) * static_cast<std::size_t>(mapped.levels.heights[level]);
    double sum = 0;
    for (std::size_t i = 0; i < texels; ++i)
        sum += static_cast<double>(
            mapped.exemplar[mapped.levels.offsets[level] + 3 * i + static_cast<std::size_t>(channel)]);
    return sum / static_cast<double>(texels);
}

/// A level's texels have equal parts of the exemplar: its mean is that of all.
TEST(EndlessMap, HasLevelsOfExemplarsOfAnySize)
{
    const PngPixels exemplar = test::random_picture(61, 37, 3, 3);
    EndlessRequest request;
    const MappedEndless mapped = mapped_endless(request, exemplar);
    EXPECT_EQ(mapped.levels.top, 6);
    for (int level = 0; level <= mapped.levels.top; ++level) {
        const int size = 1 << level;
        ASSERT_EQ(mapped.levels.widths[level], (61 + size - 1) / size);
        ASSERT_EQ(mapped.levels.heights[level], (37 + size - 1) / size);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(mean_of_level(mapped, level, c), mean_light(exemplar, 0, 0, 61, 37, c), 65535 * level * 0x1p-24)
                << level; // a float a level
    }
    // Texel 1 of 31 begins in pixel 1 of 61 and ends in pixel 3, and so in rows of 37, of which 19 are made.
    const auto part = [](int pixel, double size) {
        return std::min(pixel + 1.0, 2 * size) - std::max<double>(pixel, size);
    };
    double sum = 0;
    for (int y = 1; y <= 3; ++y)
        for (int x = 1; x <= 3; ++x)
            sum += part(x, 61.0 / 31) * part(y, 37.0 / 19) * mean_light(exemplar, x, y, 1, 1, 2);
    EXPECT_NEAR(static_cast<double>(mapped.exemplar[mapped.levels.offsets[1] + 3 * (31 + 1) + 2]),
                sum / (61.0 / 31 * 37.0 / 19), 65535 * 0x1p-24);
}

/// A line of light at the border of a picture of any width has its part of the light at all levels, when it is repeated
/// and looked up at each of its columns.
TEST(EndlessMap, FiltersPicturesOfAnySize)
{
    constexpr int side = 129;
    PngPixels line{side, 20, 1, std::vector<std::uint8_t>(side * 20)};
    for (int row = 0; row < 20; ++row) line.values[line.at(side - 1, row, 0)] = 255;
    EndlessRequest request;
    request.method = EndlessMethod::repeated;
    const MappedEndless mapped = mapped_endless(request, line);
    for (int level = 0; level <= mapped.levels.top; ++level) {
        // A step of a power of two comes to each of an odd number of columns.
        const std::vector<float> seen =
            reference_map_endless(mapped, mapped.origin(0, 0), plan_of(1 << level, 0.5, side, TextureFilter::mipmap));
        const double mean = std::accumulate(seen.begin(), seen.end(), 0.0) / (side * side);
        // Hats of texels that are no whole number of columns wide add up to 1 within the square of one over that width.
        EXPECT_NEAR(mean / (65'535.0 / side), 1, 0.02) << level;
    }
}

/// Plain repetition of a picture whose sides are powers of two is filtered as the plane that it covers.
TEST(EndlessMap, FiltersPlainRepetition)
{
    const PngPixels exemplar = test::random_picture(64, 32, 1, 3);
    EndlessRequest request;
    request.method = EndlessMethod::repeated;
    const MappedEndless mapped = mapped_endless(request, exemplar);
    for (const int level : {1, 3, 5}) {
        const int size = 1 << level, pixels = 24;
        const std::vector<float> seen = reference_map_endless(mapped, mapped.origin(0, 0),
                                                              plan_of(size, 0.5 * size, pixels, TextureFilter::mipmap));
        for (int row = 0; row < pixels; ++row)
            for (int column = 0; column < pixels; ++column) {
                const int y = -(pixels - row + 1) * size; // the box's upper row
                ASSERT_NEAR(static_cast<double>(seen[static_cast<std::size_t>(row * pixels + column)]),
                            mean_light(exemplar, column * size % 64, (y % 32 + 32) % 32, size, size, 0),
                            65535 * (level + 1) * 0x1p-24)
                    << level << " " << row << " " << column;
            }
    }
}

/// The light of encoded numbers, by the curve itself.
TEST(EndlessMap, EncodesLightAndBack)
{
    const std::vector<float> encoded = encoded_numbers();
    ASSERT_EQ(encoded.size(), std::size_t{ENCODED_ENTRIES});
    for (int light = 0; light <= 65'535; light += 7) {
        const double root = std::sqrt(light) * static_cast<double>(ENCODED_STEPS);
        const auto entry = static_cast<std::size_t>(root);
        const double low = static_cast<double>(encoded[entry]), high = static_cast<double>(encoded[entry + 1]);
        // An eighth of the second derivative, 0.1 at most, times the square of a step, and what entries are rounded by.
        ASSERT_NEAR(low + (high - low) * (root - static_cast<double>(entry)), 255 * srgb_of_light(light / 65535.0),
                    0.1 / 8 / (ENCODED_STEPS * ENCODED_STEPS) + 0x1p-13)
            << light;
    }
}

constexpr float one_deviation = GAUSSIAN_STEPS;

/// Numbers of two levels, of which the upper one has a quarter of the variance.
LevelValues two_levels()
{
    LevelValues numbers = level_values(2, 1, 1, {1.5f * one_deviation, -0.5f * one_deviation});
    EXPECT_EQ(numbers.levels.top, 1);
    EXPECT_EQ(numbers.values.back(), 0.5f * one_deviation); // its square is 1/4, and the mean of squares is 5/4
    return numbers;
}

/// A step becomes the normal distribution whose variance is what a level lost, a slope stays as it is.
TEST(EndlessMap, BlursTablesByWhatALevelLost)
{
    static_assert(INVERSE_ENTRIES == 2048 && GAUSSIAN_STEPS == 4096); // 128 entries in a deviation
    std::vector<float> step(INVERSE_ENTRIES), slope(INVERSE_ENTRIES);
    for (std::size_t i = 0; i < step.size(); ++i) {
        step[i] = i < INVERSE_ENTRIES / 2 ? 0 : 1;
        slope[i] = static_cast<float>(i);
    }
    const double lost = std::sqrt(1 - 1.0 / 5);
    const std::vector<float> steps = level_tables(two_levels(), step), slopes = level_tables(two_levels(), slope);
    ASSERT_EQ(steps.size(), std::size_t{4 * INVERSE_ENTRIES}); // means and variances of two levels
    for (std::size_t i = 0; i < INVERSE_ENTRIES; ++i) {
        EXPECT_EQ(steps[i], step[i]);
        EXPECT_EQ(steps[INVERSE_ENTRIES + i], 0);
        const double deviations = (static_cast<double>(i) + 0.5 - 1024) / 128;
        // Half an entry, 1/256 of a deviation, and tails beyond five deviations.
        ASSERT_NEAR(static_cast<double>(steps[2 * INVERSE_ENTRIES + i]),
                    0.5 * std::erfc(-deviations / lost / std::sqrt(2)), 0.4 / 256 / lost + 1e-6)
            << i;
        if (std::abs(deviations) < 3) {
            ASSERT_NEAR(static_cast<double>(slopes[2 * INVERSE_ENTRIES + i]), static_cast<double>(i), 1e-3) << i;
        }
    }
}

/// Soft spots, a few of them bright, on black: the median is far from the mean.
PngPixels spotted_picture()
{
    constexpr int width = 96, height = 80, reach = 4;
    const PngPixels noise = test::random_picture(width, height, 1, 3);
    PngPixels picture = noise;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int j = -reach; j <= reach; ++j)
                for (int i = -reach; i <= reach; ++i)
                    sum += noise.values[noise.at((x + i + width) % width, (y + j + height) % height, 0)];
            // A mean of 81 numbers from 0 to 255 has a deviation of 8.2.
            const double deviations = (sum / 81 - 127.5) / 8.2;
            picture.values[picture.at(x, y, 0)] =
                static_cast<std::uint8_t>(std::min(255.0, 60 * std::exp(0.6 * deviations)));
        }
    return picture;
}

/// A view of a level from straight above, and the light of the texture's own pixels, averaged by the boxes that it
/// sees.
struct SeenAndDrawn
{
    std::vector<double> seen, drawn;
};

SeenAndDrawn seen_and_drawn(const EndlessRequest& request, const PngPixels& exemplar, int level, int pixels)
{
    const int size = 1 << level;
    const MappedEndless mapped = mapped_endless(request, exemplar);
    const std::vector<float> light =
        reference_map_endless(mapped, mapped.origin(0, 0), plan_of(size, 0.5 * size, pixels, TextureFilter::mipmap));
    // The view's last row is one pixel above its start.
    const PngPixels plane = reference_endless_window(endless_texture(request, exemplar),
                                                     {0, -(pixels + 1) * size, pixels * size, pixels * size});
    SeenAndDrawn result{{light.begin(), light.end()}, {}};
    for (int y = 0; y < pixels; ++y)
        for (int x = 0; x < pixels; ++x) result.drawn.push_back(mean_light(plane, x * size, y * size, size, size, 0));
    return result;
}

double mean_of_values(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// At a level the blend of means is near the mean of the blend, at the same places and as bright. Blends are means of
/// encoded numbers, which need not be equal; where pieces were half a texel beside their places, differences would grow
/// to half of the contrast at the first level, and without the tables of levels, by-example noise is a fifth darker.
TEST(EndlessMap, IsNearTheMeansOfTheTexture)
{
    for (const EndlessRequest& request : mapped_requests())
        for (const int level : {1, 2}) {
            const SeenAndDrawn both = seen_and_drawn(request, spotted_picture(), level, 40);
            const double mean = mean_of_values(both.drawn);
            double differences = 0, variance = 0;
            for (std::size_t i = 0; i < both.seen.size(); ++i) {
                differences += (both.seen[i] - both.drawn[i]) * (both.seen[i] - both.drawn[i]);
                variance += (both.drawn[i] - mean) * (both.drawn[i] - mean);
            }
            const bool is_plain = request.method == EndlessMethod::repeated;
            EXPECT_NEAR(mean_of_values(both.seen) / mean, 1, is_plain ? 1e-4 : 0.05) << name_of(request) << level;
            EXPECT_LT(std::sqrt(differences / variance), is_plain ? 1e-3 : 0.2 * (1 + level))
                << name_of(request) << level;
        }
}

/// The mean light of a picture follows from the mean and the variance of its numbers but for at most this, in parts of
/// `all`: a sixth of the third derivative of light times the third moment. Signs of the next derivatives alternate.
double third_order(const PngPixels& picture, double all)
{
    double mean = 0, third = 0;
    const auto count = static_cast<double>(picture.values.size());
    for (const std::uint8_t value : picture.values) mean += value / count;
    for (const std::uint8_t value : picture.values) third += std::pow(value - mean, 3) / count;
    const double derivative =
        65'535 * 2.4 * 1.4 * 0.4 / std::pow(1.055 * 255, 3) * std::pow((mean / 255 + 0.055) / 1.055, -0.6);
    return derivative * third / 6 / all;
}

/// Far away one colour is left, as bright as the exemplar.
TEST(EndlessMap, IsAsBrightAsItsExemplarFarAway)
{
    const PngPixels exemplar = spotted_picture();
    const double all = mean_light(exemplar, 0, 0, exemplar.width, exemplar.height, 0);
    for (const EndlessRequest& request : mapped_requests()) {
        const MappedEndless mapped = mapped_endless(request, exemplar);
        const std::vector<float> seen =
            reference_map_endless(mapped, mapped.origin(0, 0), plan_of(1 << 12, 3, 4, TextureFilter::anisotropic));
        const double lacking = request.method == EndlessMethod::blended ? third_order(exemplar, all) : 0;
        EXPECT_LT(lacking, 0.05);
        for (const float light : seen)
            EXPECT_NEAR(static_cast<double>(light) / all, 1 - lacking / 2, lacking / 2 + 2e-3) << name_of(request);
    }
}

TEST(EndlessMap, TakesTheMemoryThatItSays)
{
    Device device = Device::open();
    EndlessRequest request;
    request.method = EndlessMethod::blended;
    const MappedEndless mapped = mapped_endless(request, test::random_picture(61, 57, 3, 3));
    const TextureView view = horizon_view(TextureFilter::bilinear, 40, 30);
    const std::uint64_t before = device.memory().total;
    device.watch_memory();
    map_endless(device, mapped, mapped.origin(0, 0), view, 64);
    EXPECT_EQ(endless_map_memory(mapped, view),
              (DeviceMemory{device.peak_memory().largest, device.peak_memory().total - before}));
}

}
}
