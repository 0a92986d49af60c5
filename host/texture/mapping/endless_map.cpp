#include "host/texture/mapping/endless_map.hpp"

#include "base/images/srgb_light.hpp"
#include "host/texture/mapping/exemplar_levels.hpp"
#include "host/texture/mapping/view_parts.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace poissonlab {
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
                                                                    {"RESTORED", texture.is_restored ? "1" : "0"}}),
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
        mapped.inverse = {0};
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
