#include "host/texture/mapping/endless_map.hpp"

#include "base/images/srgb_light.hpp"
#include "host/texture/endless/gaussian_exemplar.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "kernels/common/fields/endless_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <span>
#include <string>
#include <utility>

namespace poissonlab {
namespace {

using namespace contract::endless_map;
using namespace contract::endless_texture;

/// The parts of texels of a level of `below` texels that texel `at` of the `size` above covers, from the first one on.
struct Coverage
{
    int first = 0;
    std::vector<double> parts;
};

Coverage coverage(int at, int size, int below)
{
    const double begin = static_cast<double>(at) * below / size, end = static_cast<double>(at + 1) * below / size;
    Coverage covered{static_cast<int>(begin), {}};
    for (int texel = covered.first; texel < below && texel < end; ++texel)
        covered.parts.push_back(std::min<double>(texel + 1, end) - std::max<double>(texel, begin));
    return covered;
}

/// Appends the level above the last one, whose texels divide the exemplar evenly again, into half as many.
void append_level(LevelValues& of)
{
    ExemplarLevels& levels = of.levels;
    const int below = levels.top++, level = levels.top;
    const int width = (levels.widths[below] + 1) / 2, height = (levels.heights[below] + 1) / 2;
    levels.widths[level] = width;
    levels.heights[level] = height;
    levels.offsets[level] = static_cast<std::uint32_t>(of.values.size());
    const auto channels = static_cast<std::size_t>(of.channels);
    std::vector<Coverage> columns;
    for (int column = 0; column < width; ++column) columns.push_back(coverage(column, width, levels.widths[below]));
    for (int row = 0; row < height; ++row) {
        const Coverage rows = coverage(row, height, levels.heights[below]);
        for (const Coverage& across : columns)
            for (std::size_t c = 0; c < channels; ++c) {
                double sum = 0, area = 0;
                for (std::size_t j = 0; j < rows.parts.size(); ++j)
                    for (std::size_t i = 0; i < across.parts.size(); ++i) {
                        const std::size_t texel =
                            of.texel(below, across.first + static_cast<int>(i), rows.first + static_cast<int>(j));
                        const double part = rows.parts[j] * across.parts[i];
                        sum += part * static_cast<double>(of.values[texel + c]);
                        area += part;
                    }
                of.values.push_back(static_cast<float>(sum / area));
            }
    }
}

/// The number from 0 to 255 of light from 0 to 65535.
double encoded_number(double light) { return 255 * srgb_of_light(light / 65535); }

/// The mean product of texels of a level that are (dx, dy) apart and inside; a single one is its own neighbour.
double mean_product(const LevelValues& numbers, int level, std::size_t coordinate, int dx, int dy)
{
    const int width = numbers.levels.widths[level], height = numbers.levels.heights[level];
    if (width == 1) dx = 0;
    if (height == 1) dy = 0;
    const auto value = [&](int x, int y) {
        return static_cast<double>(numbers.values[numbers.texel(level, x, y) + coordinate]);
    };
    double sum = 0;
    for (int y = std::max(0, -dy); y < std::min(height, height - dy); ++y)
        for (int x = std::max(0, -dx); x < std::min(width, width - dx); ++x) sum += value(x, y) * value(x + dx, y + dy);
    return sum / (static_cast<double>(width - std::abs(dx)) * (height - std::abs(dy)));
}

/// The part of the variance of a coordinate that look-ups of a level have left. Pieces lie at any whole pixels, so that
/// texels of levels above the first are looked up anywhere between their middles, where bilinear look-ups average them:
/// (1 - t) a + t b has the mean square (a^2 + a b + b^2) / 3.
double variance_left(const LevelValues& numbers, int level, std::size_t coordinate, double whole)
{
    if (level == 0) return 1;
    const auto weight = [](int d) { return d == 0 ? 2.0 / 3 : 1.0 / 6; };
    double variance = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            variance += weight(dx) * weight(dy) * mean_product(numbers, level, coordinate, dx, dy);
    return std::clamp(variance / whole, 0.0, 1.0);
}

/// Appends a table's means over a normal distribution of so many deviations around each entry, and then the variances.
/// A deviation of less than a tenth of an entry changes nothing.
void append_blurred(std::vector<float>& tables, std::span<const float> table, double deviations)
{
    constexpr double entries_of_one =
        static_cast<double>(GAUSSIAN_STEPS) * static_cast<double>(INVERSE_ENTRIES) / 65'536;
    const double entries = deviations * entries_of_one;
    const int reach = entries < 0.1 ? 0 : std::min<int>(INVERSE_ENTRIES, static_cast<int>(std::ceil(5 * entries)));
    std::vector<double> weights{1}; // from -reach to reach
    if (reach > 0) weights.clear();
    for (int d = -reach; reach > 0 && d <= reach; ++d)
        weights.push_back(normal_probability((d + 0.5) / entries) - normal_probability((d - 0.5) / entries));
    std::vector<float> variances;
    for (int entry = 0; entry < INVERSE_ENTRIES; ++entry) {
        double sum = 0, squares = 0, all = 0;
        for (int d = -reach; d <= reach; ++d) {
            const double weight = weights[static_cast<std::size_t>(d + reach)],
                         value = static_cast<double>(
                             table[static_cast<std::size_t>(std::clamp(entry + d, 0, INVERSE_ENTRIES - 1))]);
            sum += weight * value;
            squares += weight * value * value;
            all += weight;
        }
        const double mean = sum / all;
        tables.push_back(static_cast<float>(mean));
        variances.push_back(reach == 0 ? 0.0f : static_cast<float>(std::max(0.0, squares / all - mean * mean)));
    }
    tables.insert(tables.end(), variances.begin(), variances.end());
}

}

std::size_t LevelValues::texel(int level, int x, int y) const
{
    return begin(level) + (static_cast<std::size_t>(y) * static_cast<std::size_t>(levels.widths[level]) +
                           static_cast<std::size_t>(x)) *
                              static_cast<std::size_t>(channels);
}

LevelValues level_values(int width, int height, int channels, std::vector<float> values)
{
    LevelValues result;
    result.channels = channels;
    values.reserve(values.size() / 2 * 3);
    result.values = std::move(values);
    result.levels.widths[0] = width;
    result.levels.heights[0] = height;
    while (result.levels.widths[result.levels.top] > 1 || result.levels.heights[result.levels.top] > 1)
        append_level(result);
    return result;
}

std::vector<float> encoded_numbers()
{
    std::vector<float> numbers;
    for (int entry = 0; entry < ENCODED_ENTRIES; ++entry) {
        const double root = static_cast<double>(entry) / static_cast<double>(ENCODED_STEPS);
        // No last bit of a power decides anything.
        numbers.push_back(static_cast<float>(std::round(encoded_number(root * root) * 4096) / 4096));
    }
    return numbers;
}

std::vector<float> light_of_numbers()
{
    std::vector<float> light(light_of_bytes().begin(), light_of_bytes().end());
    for (int number = 0; number < 256; ++number) {
        const double value = number / 255.0; // of sRGB, whose curve begins with a straight line
        const double bent = value <= 0.04045 ? 0 : 2.4 * 1.4 / (1.055 * 1.055) * std::pow((value + 0.055) / 1.055, 0.4);
        light.push_back(static_cast<float>(std::round(65535 * bent / 2 / (255.0 * 255.0) * 4096) / 4096));
    }
    return light;
}

std::vector<float> encoded_means(const LevelValues& light)
{
    const auto channels = static_cast<std::size_t>(light.channels);
    std::vector<float> means;
    for (int level = 0; level <= light.levels.top; ++level) {
        std::array<double, 3> sums{};
        for (std::size_t at = light.begin(level); at < light.end(level); ++at)
            sums[(at - light.begin(level)) % channels] += encoded_number(static_cast<double>(light.values[at]));
        const auto texels = static_cast<double>((light.end(level) - light.begin(level)) / channels);
        for (const double sum : sums) means.push_back(static_cast<float>(std::round(sum / texels * 4096) / 4096));
    }
    return means;
}

std::vector<float> level_tables(const LevelValues& numbers, const std::vector<float>& inverse)
{
    const auto channels = static_cast<std::size_t>(numbers.channels);
    std::vector<double> whole;
    for (std::size_t k = 0; k < channels; ++k) whole.push_back(mean_product(numbers, 0, k, 0, 0));
    std::vector<float> tables;
    for (int level = 0; level <= numbers.levels.top; ++level)
        for (std::size_t k = 0; k < channels; ++k)
            append_blurred(tables, std::span(inverse).subspan(k * INVERSE_ENTRIES, INVERSE_ENTRIES),
                           std::sqrt(1 - variance_left(numbers, level, k, whole[k])));
    return tables;
}

namespace {

using namespace contract::endless_map;
using namespace contract::endless_texture;

LevelValues light_levels(const PngPixels& exemplar)
{
    std::vector<float> light;
    light.reserve(exemplar.values.size());
    for (const std::uint8_t byte : exemplar.values) light.push_back(light_of_bytes()[byte]);
    return level_values(exemplar.width, exemplar.height, exemplar.channels, std::move(light));
}

/// Levels of a Gaussian exemplar's numbers, which count from the mean on.
LevelValues number_levels(const EndlessTexture& texture)
{
    const auto channels = static_cast<std::size_t>(texture.channels), words = (channels + 1) / 2;
    std::vector<float> numbers;
    numbers.reserve(texture.texels.size() / words * channels);
    for (std::size_t texel = 0; texel < texture.texels.size(); texel += words)
        for (std::size_t k = 0; k < channels; ++k)
            numbers.push_back(static_cast<float>(
                static_cast<int>(texture.texels[texel + k / 2] >> (16 * (k % 2)) & 65'535u) - GAUSSIAN_ZERO));
    return level_values(texture.plane.width, texture.plane.height, texture.channels, std::move(numbers));
}

Kernel endless_map_kernel(Device& device, const EndlessTexture& texture)
{
    return device.kernel(kernel_program("textures/endless_map.cl", {{"METHOD", std::to_string(texture.method)},
                                                                    {"CHANNELS", std::to_string(texture.channels)},
                                                                    {"EXPONENT", std::to_string(texture.exponent)},
                                                                    {"GAIN", std::to_string(texture.gain)},
                                                                    {"RESTORED", texture.is_restored ? "1" : "0"},
                                                                    {"TURNED", texture.is_turned ? "1" : "0"}}),
                         "map_endless");
}

}

EndlessWindow MappedEndless::origin(std::int64_t tile_x, std::int64_t tile_y) const
{
    // Tiles count to the north, pixels to the south.
    return contract_window(texture, {tile_x * TILE_TEXELS, -tile_y * TILE_TEXELS, 0, 0});
}

MappedEndless mapped_endless(const EndlessRequest& request, const PngPixels& exemplar)
{
    MappedEndless mapped;
    mapped.texture = endless_texture(request, exemplar);
    mapped.encoded = encoded_numbers();
    mapped.light = light_of_numbers();
    if (request.method == EndlessMethod::blended) {
        LevelValues numbers = number_levels(mapped.texture);
        for (int level = 0; level <= numbers.levels.top; ++level)
            std::ranges::copy(mapped.texture.plane.means, std::back_inserter(mapped.means));
        mapped.inverse = level_tables(numbers, mapped.texture.inverse);
        mapped.levels = numbers.levels;
        mapped.exemplar = std::move(numbers.values);
    } else {
        LevelValues light = light_levels(exemplar);
        mapped.means = mapped.texture.is_restored
                           ? encoded_means(light)
                           : std::vector<float>(static_cast<std::size_t>(3 * (light.levels.top + 1)));
        mapped.levels = light.levels;
        mapped.inverse = mapped.texture.inverse; // of turned hexagons, their angles
        mapped.exemplar = std::move(light.values);
    }
    mapped.texture.texels = {};
    return mapped;
}

DeviceMemory endless_map_memory(const MappedEndless& mapped, const TextureView& view)
{
    DeviceMemory memory;
    for (const auto* const buffer : {&mapped.exemplar, &mapped.encoded, &mapped.light, &mapped.means, &mapped.inverse})
        memory.add(buffer->size() * sizeof(float));
    return memory.add(pixels_at_once(view) * static_cast<std::size_t>(mapped.texture.channels) * sizeof(float));
}

std::vector<float> map_endless(Device& device, const MappedEndless& mapped, const EndlessWindow& origin,
                               const TextureView& view, std::size_t work_group_size)
{
    const auto buffer_of = [&](const std::vector<float>& values) {
        Buffer<float> buffer = device.buffer<float>(values.size());
        buffer.write(values);
        return buffer;
    };
    const Buffer<float> exemplar = buffer_of(mapped.exemplar), encoded = buffer_of(mapped.encoded),
                        light = buffer_of(mapped.light), means = buffer_of(mapped.means),
                        inverse = buffer_of(mapped.inverse);
    Kernel kernel = endless_map_kernel(device, mapped.texture);
    return picture_in_parts(device, view, mapped.texture.channels,
                            [&](std::uint32_t first, std::uint32_t count, const Buffer<float>& shown) {
                                kernel.run(count, work_group_size, view, mapped.texture.plane, origin, mapped.levels,
                                           first, count, exemplar, encoded, light, means, inverse, shown);
                            });
}

}
