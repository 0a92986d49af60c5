#include "host/texture/mapping/texture_map.hpp"

#include "base/errors/errors.hpp"
#include "base/images/srgb_light.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// The atlas as light, south first.
std::vector<float> base_level(const PngPixels& atlas)
{
    std::vector<float> light;
    light.reserve(atlas.values.size());
    for (int row = atlas.height; row-- > 0;)
        for (std::size_t i = atlas.at(0, row, 0); i < atlas.at(0, row + 1, 0); ++i)
            light.push_back(light_of_bytes()[atlas.values[i]]);
    return light;
}

/// Appends the level above the one that begins at `below` and is `width` texels wide: means of 2 x 2.
void append_level(std::vector<float>& light, std::size_t below, int width, int channels)
{
    const auto row_values = static_cast<std::size_t>(width * channels);
    const auto step = static_cast<std::size_t>(channels);
    for (std::size_t row = 0; row < static_cast<std::size_t>(width); row += 2)
        for (std::size_t column = 0; column < static_cast<std::size_t>(width); column += 2)
            for (std::size_t c = 0; c < step; ++c) {
                const std::size_t at = below + row * row_values + column * step + c;
                light.push_back(
                    ((light[at] + light[at + step]) + (light[at + row_values] + light[at + row_values + step])) *
                    0.25f);
            }
}

/// Appends the mean of the values from `first` on, which are means of tiles.
void append_mean(std::vector<float>& light, std::size_t first, int channels)
{
    const auto step = static_cast<std::size_t>(channels);
    const std::size_t end = light.size();
    for (std::size_t c = 0; c < step; ++c) {
        double sum = 0;
        for (std::size_t i = first + c; i < end; i += step) sum += static_cast<double>(light[i]);
        light.push_back(static_cast<float>(sum / static_cast<double>((end - first) / step)));
    }
}

/// All levels of a square of n^2 x n^2 tiles.
TexturePyramid pyramid_of(const PngPixels& tiles, int size, int n, std::uint32_t seed)
{
    if (!std::has_single_bit(static_cast<unsigned>(size)))
        throw invalid_value({}, "tile_size", fmt::format("{}", size),
                            "must be a power of two, so that texels of all levels are within tiles");
    TexturePyramid pyramid;
    pyramid.channels = tiles.channels;
    auto& levels = pyramid.levels;
    levels.seed = seed;
    levels.colors = n;
    levels.size = size;
    levels.top = std::countr_zero(static_cast<unsigned>(size));
    pyramid.light = base_level(tiles);
    for (int level = 1; level <= levels.top; ++level) {
        const std::size_t below = levels.offsets[level - 1];
        levels.offsets[level] = static_cast<std::uint32_t>(pyramid.light.size());
        append_level(pyramid.light, below, pyramid.width(level - 1), pyramid.channels);
    }
    levels.offsets[levels.top + 1] = static_cast<std::uint32_t>(pyramid.light.size());
    append_mean(pyramid.light, levels.offsets[levels.top], pyramid.channels);
    return pyramid;
}

double rounded(double value) { return std::round(value * 0x1p40) * 0x1p-40; }

/// A direction in tiles: east, north, up.
using Direction = std::array<double, 3>;

}

TexturePyramid texture_pyramid(const TextureSet& set, std::uint64_t seed)
{
    if (!has_places(set))
        throw InputError(fmt::format("{} {} tiles: must be a complete set of corner or Wang tiles, whose places in the "
                                     "atlas follow from their colours; others are laid in scanlines, one by one",
                                     set.tiles.size(), texture_kinds[set.kind]));
    TexturePyramid pyramid =
        pyramid_of(atlas_of(set), set.size, static_cast<int>(set.colors.horizontal), static_cast<std::uint32_t>(seed));
    pyramid.is_wang = set.kind == TextureKind::wang;
    return pyramid;
}

TexturePyramid laid_pyramid(const TextureSet& set, std::uint64_t seed, int n)
{
    const auto side = static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n);
    if (side * static_cast<std::uint64_t>(set.size) > most_laid_pixels)
        throw InputError(fmt::format("{} x {} tiles of {} pixels: must be at most {} pixels along a side", side, side,
                                     set.size, most_laid_pixels));
    const TextureWindow window = texture_window(set, {0, 0, side, side}, seed);
    const PngPixels laid = texture_window_pixels(set, window, set.values, set.exemplar.channels);
    return pyramid_of(laid, set.size, n, static_cast<std::uint32_t>(seed));
}

TexturePyramid picture_pyramid(const PngPixels& picture, int n)
{
    return pyramid_of(picture, picture.width / (n * n), n, 0);
}

PngPixels level_pixels(const TexturePyramid& pyramid, int level)
{
    const int width = pyramid.width(level);
    PngPixels pixels{width, width, pyramid.channels, {}};
    for (int row = width; row-- > 0;)
        for (std::size_t i = pixels.at(0, row, 0); i < pixels.at(0, row + 1, 0); ++i)
            pixels.values.push_back(byte_of_light(pyramid.light[pyramid.levels.offsets[level] + i]));
    return pixels;
}

TextureView view_of(const TextureCamera& camera)
{
    constexpr double degree = std::numbers::pi / 180;
    const double pitch = camera.pitch * degree, yaw = camera.yaw * degree;
    const Direction ahead{std::sin(yaw), std::cos(yaw), 0}, right{std::cos(yaw), -std::sin(yaw), 0};
    const double down = std::sin(pitch), level = std::cos(pitch);
    const Direction axis{ahead[0] * level, ahead[1] * level, -down}, up{ahead[0] * down, ahead[1] * down, level};
    const double rows = static_cast<double>(camera.height) * camera.samples,
                 columns = static_cast<double>(camera.width) * camera.samples;
    const double half = std::tan(camera.field * degree / 2), step = 2 * half / rows;
    // The direction of a sample is that of the corner plus steps; it meets the plane where it has gone down by `above`.
    TextureView view{};
    std::array<Direction, 3> directions;
    for (std::size_t a = 0; a < 3; ++a)
        directions[a] = {axis[a] - half * columns / rows * right[a] + half * up[a], step * right[a], -step * up[a]};
    const std::array<double, 2> start{camera.start[0] + camera.forward * ahead[0],
                                      camera.start[1] + camera.forward * ahead[1]};
    for (std::size_t i = 0; i < 3; ++i) {
        view.w[i] = rounded(-directions[2][i] / camera.above);
        view.u[i] = rounded(directions[0][i] + start[0] * view.w[i]);
        view.v[i] = rounded(directions[1][i] + start[1] * view.w[i]);
    }
    view.tile_x = static_cast<std::uint32_t>(camera.tile_x);
    view.tile_y = static_cast<std::uint32_t>(camera.tile_y);
    view.width = camera.width;
    view.height = camera.height;
    view.samples = camera.samples;
    view.filter = static_cast<int>(camera.filter);
    return view;
}

DeviceMemory texture_map_memory(const TexturePyramid& pyramid, const TextureView& view)
{
    DeviceMemory memory;
    memory.add(pyramid.light.size() * sizeof(float));
    return memory.add(pixels_at_once(view) * static_cast<std::size_t>(pyramid.channels) * sizeof(float));
}

std::vector<float> map_texture(Device& device, const TexturePyramid& pyramid, TextureLookup lookup,
                               const TextureView& view, std::size_t work_group_size)
{
    Buffer<float> light = device.buffer<float>(pyramid.light.size());
    light.write(pyramid.light);
    Kernel kernel =
        device.kernel(kernel_program("textures/texture_map.cl", {{"LOOKUP", std::to_string(static_cast<int>(lookup))},
                                                                 {"CHANNELS", std::to_string(pyramid.channels)},
                                                                 {"WANG", pyramid.is_wang ? "1" : "0"},
                                                                 {"COLORS", std::to_string(pyramid.levels.colors)}}),
                      "map_texture");
    return picture_in_parts(device, view, pyramid.channels,
                            [&](std::uint32_t first, std::uint32_t count, const Buffer<float>& shown) {
                                kernel.run(count, work_group_size, view, pyramid.levels, first, count, light, shown);
                            });
}

PngPixels encoded_pixels(const std::vector<float>& light, int width, int height, int channels)
{
    PngPixels pixels{width, height, channels, {}};
    for (const float value : light) pixels.values.push_back(byte_of_light(value));
    return pixels;
}

}
