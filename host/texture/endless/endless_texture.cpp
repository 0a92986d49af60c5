#include "host/texture/endless/endless_texture.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/device/device.hpp"
#include "host/texture/endless/gaussian_exemplar.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using namespace contract::endless_texture;

/// Channels of pixels in the bytes of a word each, from the lowest.
std::vector<std::uint32_t> words_of_pixels(const PngPixels& picture)
{
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<std::uint32_t> words(picture.values.size() / channels);
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t c = 0; c < channels; ++c)
            words[i] |= static_cast<std::uint32_t>(picture.values[i * channels + c]) << (8 * c);
    return words;
}

/// Sixteen bits a coordinate: a word a pixel of one channel, two of three.
std::vector<std::uint32_t> words_of_numbers(const GaussianExemplar& gaussian)
{
    if (gaussian.channels == 1) return {gaussian.numbers.begin(), gaussian.numbers.end()};
    std::vector<std::uint32_t> words;
    words.reserve(gaussian.numbers.size() / 3 * 2);
    for (std::size_t i = 0; i < gaussian.numbers.size(); i += 3) {
        words.push_back(gaussian.numbers[i] | static_cast<std::uint32_t>(gaussian.numbers[i + 1]) << 16);
        words.push_back(gaussian.numbers[i + 2]);
    }
    return words;
}

int contract_method(EndlessMethod method)
{
    switch (method) {
    case EndlessMethod::repeated:
        return METHOD_REPEATED;
    case EndlessMethod::offsets:
        return METHOD_OFFSETS;
    case EndlessMethod::hexagons:
        return METHOD_HEXAGONS;
    case EndlessMethod::blended:
        return METHOD_BLENDED;
    case EndlessMethod::quilted:
        break;
    }
    throw std::logic_error("a quilted picture is no function of the plane");
}

/// Lattice points, and how far around them pieces of the exemplar are seen.
void set_lattice(EndlessPlane& plane, const EndlessRequest& request, const PngPixels& exemplar)
{
    plane.cell = request.cell_of(exemplar);
    plane.row = request.row_of(exemplar);
    const bool is_whole = request.tileable;
    plane.is_tileable = is_whole ? 1 : 0;
    if (request.has_hexagons()) {
        plane.reach_x = plane.cell;
        plane.reach_y = plane.row;
        plane.inverse_unit = 1.0f / static_cast<float>(2 * plane.cell * plane.row);
        if (request.turn > 0) plane.reach_x = plane.reach_y = plane.cell + 2; // in any direction, and between texels
    } else {
        plane.reach_x = plane.reach_y = 3 * plane.cell / 4 + 1;
        plane.inverse_unit = 1.0f / static_cast<float>(plane.cell);
    }
    if (is_whole) plane.reach_x = plane.reach_y = 0;
    plane.choices_x = exemplar.width - 2 * plane.reach_x;
    plane.choices_y = exemplar.height - 2 * plane.reach_y;
}

/// Cosines, then sines, of angles up to so many half turns to either side. Whole numbers: no last bit of a library
/// decides anything.
std::vector<float> turns_of(double most)
{
    constexpr int turns = TURNS, unit = TURN_UNIT;
    std::vector<float> numbers;
    for (const bool is_sine : {false, true})
        for (int k = 0; k < turns; ++k) {
            const double angle = most * std::numbers::pi * ((2.0 * k + 1) / turns - 1);
            numbers.push_back(static_cast<float>(std::lround(unit * (is_sine ? std::sin(angle) : std::cos(angle)))));
        }
    return numbers;
}

std::int64_t quotient(std::int64_t value, std::int64_t divisor)
{
    return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

/// So many pixels are enqueued at a time: Ctrl-C waits for these.
constexpr std::size_t pixels_of_a_part = std::size_t{1} << 22;

int rows_at_once(const PixelWindow& window)
{
    return std::clamp(static_cast<int>(pixels_of_a_part / static_cast<std::size_t>(window.width)), 1, window.height);
}

Kernel endless_kernel(Device& device, const EndlessTexture& texture)
{
    return device.kernel(kernel_program("textures/endless_texture.cl", {{"METHOD", std::to_string(texture.method)},
                                                                        {"CHANNELS", std::to_string(texture.channels)},
                                                                        {"CELL", std::to_string(texture.plane.cell)},
                                                                        {"ROW", std::to_string(texture.plane.row)},
                                                                        {"EXPONENT", std::to_string(texture.exponent)},
                                                                        {"GAIN", std::to_string(texture.gain)},
                                                                        {"RESTORED", texture.is_restored ? "1" : "0"},
                                                                        {"TURNED", texture.is_turned ? "1" : "0"},
                                                                        {"COLORS", std::to_string(texture.colors)}}),
                         "color_pixels");
}

/// Buffers that a texture is looked up in.
struct EndlessBuffers
{
    EndlessBuffers(Device& device, const EndlessTexture& texture, std::size_t count)
        : texels(device.buffer<std::uint32_t>(texture.texels.size())),
          inverse(device.buffer<float>(texture.inverse.size())), pixels(device.buffer<std::uint32_t>(count))
    {
        texels.write(texture.texels);
        inverse.write(texture.inverse);
    }

    void run(Kernel& kernel, const EndlessTexture& texture, const PixelWindow& window, std::size_t group_size) const
    {
        const auto width = static_cast<std::size_t>(window.width), height = static_cast<std::size_t>(window.height);
        const std::size_t groups = (width + group_size - 1) / group_size;
        kernel.run(groups * height * group_size, group_size, texture.plane, contract_window(texture, window),
                   static_cast<std::uint32_t>(groups), texels, inverse, pixels);
    }

    Buffer<std::uint32_t> texels;
    Buffer<float> inverse;
    Buffer<std::uint32_t> pixels;
};

}

EndlessTexture endless_texture(const EndlessRequest& request, const PngPixels& exemplar)
{
    check(request, exemplar);
    EndlessTexture texture;
    texture.method = contract_method(request.method);
    texture.channels = exemplar.channels;
    EndlessPlane& plane = texture.plane;
    plane.seed = static_cast<std::uint32_t>(request.seed);
    plane.width = exemplar.width;
    plane.height = exemplar.height;
    if (request.method == EndlessMethod::repeated) {
        plane.cell = exemplar.width;
        plane.row = exemplar.height;
    } else {
        set_lattice(plane, request, exemplar);
    }
    if (request.method == EndlessMethod::hexagons) {
        texture.gain = request.gain;
        plane.falloff = static_cast<float>(request.falloff);
        texture.is_turned = request.turn > 0;
        if (texture.is_turned) texture.inverse = turns_of(request.turn);
    }
    if (request.has_hexagons()) texture.exponent = request.exponent_or_default();
    if (request.method == EndlessMethod::blended) {
        GaussianExemplar gaussian = gaussian_exemplar(exemplar);
        std::ranges::copy(gaussian.means, plane.means);
        std::ranges::copy(gaussian.axes, plane.axes);
        texture.texels = words_of_numbers(gaussian);
        texture.inverse = std::move(gaussian.inverse);
        return texture;
    }
    texture.is_restored = request.restored && request.method != EndlessMethod::repeated;
    if (texture.is_restored)
        std::ranges::transform(channel_means(exemplar), plane.means, [](double v) { return static_cast<float>(v); });
    texture.texels = words_of_pixels(exemplar);
    return texture;
}

EndlessTexture endless_tiles(const TextureSet& set, std::uint64_t seed)
{
    const PngPixels atlas = atlas_of(set);
    EndlessTexture texture;
    texture.method = set.kind == TextureKind::wang ? METHOD_WANG_TILES : METHOD_TILES;
    texture.channels = set.exemplar.channels;
    texture.colors = set.colors.horizontal;
    texture.plane.seed = static_cast<std::uint32_t>(seed);
    texture.plane.width = atlas.width;
    texture.plane.height = atlas.height;
    texture.plane.cell = texture.plane.row = set.size;
    texture.texels = words_of_pixels(atlas);
    return texture;
}

std::size_t bytes_of(const EndlessTexture& texture)
{
    const std::size_t channels = static_cast<std::size_t>(texture.channels);
    const std::size_t pixels =
        static_cast<std::size_t>(texture.plane.width) * static_cast<std::size_t>(texture.plane.height);
    if (texture.method == METHOD_BLENDED) return 2 * pixels * channels + texture.inverse.size() * sizeof(float);
    return pixels * channels;
}

EndlessWindow contract_window(const EndlessTexture& texture, const PixelWindow& window)
{
    const EndlessPlane& plane = texture.plane;
    const bool is_tiles = texture.method == METHOD_TILES || texture.method == METHOD_WANG_TILES;
    const bool is_hexagonal = texture.method == METHOD_HEXAGONS || texture.method == METHOD_BLENDED;
    // Tiles count to the north, from the last row.
    const std::int64_t y = is_tiles ? -(window.y + window.height) : window.y;
    const std::int64_t j = quotient(y, plane.row);
    const std::int64_t x = is_hexagonal ? window.x - j * (plane.cell / 2) : window.x;
    const std::int64_t i = quotient(x, plane.cell);
    return {static_cast<std::uint32_t>(i),
            static_cast<std::uint32_t>(j),
            static_cast<int>(x - i * plane.cell),
            static_cast<int>(y - j * plane.row),
            window.width,
            window.height};
}

DeviceMemory endless_memory(const EndlessTexture& texture, const PixelWindow& window)
{
    DeviceMemory memory;
    memory.add(texture.texels.size() * sizeof(std::uint32_t));
    memory.add(texture.inverse.size() * sizeof(float));
    return memory.add(static_cast<std::size_t>(rows_at_once(window)) * static_cast<std::size_t>(window.width) *
                      sizeof(std::uint32_t));
}

PngPixels endless_window(Device& device, const EndlessTexture& texture, const PixelWindow& window,
                         std::size_t work_group_size)
{
    const auto width = static_cast<std::size_t>(window.width);
    const int rows = rows_at_once(window);
    const EndlessBuffers buffers(device, texture, static_cast<std::size_t>(rows) * width);
    Kernel kernel = endless_kernel(device, texture);
    PngPixels picture{window.width, window.height, texture.channels, {}};
    picture.values.reserve(picture.at(0, window.height, 0));
    std::vector<std::uint32_t> words(buffers.pixels.size());
    for (int first = 0; first < window.height; first += rows) {
        stop_if_interrupted();
        const PixelWindow part{window.x, window.y + first, window.width, std::min(rows, window.height - first)};
        buffers.run(kernel, texture, part, work_group_size);
        const auto read = std::span(words).first(static_cast<std::size_t>(part.height) * width);
        buffers.pixels.read(read);
        for (const std::uint32_t word : read)
            for (int c = 0; c < texture.channels; ++c)
                picture.values.push_back(static_cast<std::uint8_t>(word >> (8 * c)));
    }
    return picture;
}

double endless_seconds(Device& device, const EndlessTexture& texture, const PixelWindow& window)
{
    constexpr int times = 9;
    const EndlessBuffers buffers(device, texture,
                                 static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height));
    Kernel kernel = endless_kernel(device, texture);
    std::vector<double> seconds;
    for (int i = -2; i < times; ++i) { // the first ones build the kernel and touch the memory
        const auto begin = std::chrono::steady_clock::now();
        buffers.run(kernel, texture, {window.x, window.y + i, window.width, window.height}, default_work_group_size);
        device.finish();
        if (i >= 0) seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(seconds);
    return seconds[times / 2];
}

}
