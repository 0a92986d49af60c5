#include "host/distribution/textures/plane_picture.hpp"

#include "host/device/device.hpp"
#include "host/device/kernel.hpp"
#include "host/texture/comparison/light_map.hpp"
#include "results/statistic.hpp"
#include "results/texture_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>

namespace poissonlab {
namespace {

/// The camera of all views over tiles of so many pixels.
TextureView shown_view(int tile)
{
    TextureCamera camera;
    camera.width = frame_width;
    camera.height = frame_height;
    camera.above *= static_cast<double>(contract::endless_map::TILE_TEXELS) / tile;
    return view_of(camera);
}

PngPixels pyramid_picture(const TexturePyramid& pyramid, TextureLookup lookup, int tile, const DistributionPlace& place)
{
    const TextureView view = shown_view(tile);
    if (place.engine == Engine::opencl)
        check_fits("the view of the plane", texture_map_memory(pyramid, view), place.device().info());
    return encoded_pixels(place.engine == Engine::reference
                              ? reference_map_texture(pyramid, lookup, view)
                              : map_texture(place.device(), pyramid, lookup, view, default_work_group_size),
                          frame_width, frame_height, pyramid.channels);
}

/// The window has as many tiles along each side as the square of this. Omega tiles recur in twos.
int laid_root(const TextureSet& set)
{
    const bool is_large = 25 * set.size > static_cast<int>(most_laid_pixels);
    return is_large || set.kind == TextureKind::omega ? 4 : 5;
}

}

PngPixels plane_picture(const TextureSet& set, std::uint64_t seed, const DistributionPlace& place)
{
    return has_places(set)
               ? pyramid_picture(texture_pyramid(set, seed), TextureLookup::exact, set.size, place)
               : pyramid_picture(laid_pyramid(set, seed, laid_root(set)), TextureLookup::repeated, set.size, place);
}

std::string plane_caption(const TextureSet& set)
{
    if (has_places(set)) return "The endless plane, with anisotropic filtering.";
    const int tiles = laid_root(set) * laid_root(set);
    return fmt::format("A window of {} x {} tiles, repeated, with anisotropic filtering.", tiles, tiles);
}

PngPixels plane_picture(const MappedEndless& mapped, const DistributionPlace& place)
{
    const TextureView view = shown_view(contract::endless_map::TILE_TEXELS);
    if (place.engine == Engine::opencl)
        check_fits("the view of the plane", endless_map_memory(mapped, view), place.device().info());
    const auto origin = mapped.origin(0, 0);
    return encoded_pixels(place.engine == Engine::reference
                              ? reference_map_endless(mapped, origin, view)
                              : map_endless(place.device(), mapped, origin, view, default_work_group_size),
                          frame_width, frame_height, mapped.texture.channels);
}

PngPixels plane_picture(const PngPixels& picture, const DistributionPlace& place)
{
    constexpr int root = 4; // 16 x 16 tiles
    const auto side = std::bit_floor(static_cast<unsigned>(std::min(picture.width, picture.height)));
    return pyramid_picture(
        picture_pyramid(picture_part(picture, 0, 0, static_cast<int>(side), static_cast<int>(side)), root),
        TextureLookup::repeated, static_cast<int>(side) / (root * root), place);
}

namespace {

TextureView timed_view(int frame)
{
    TextureCamera camera;
    camera.width = frame_width;
    camera.height = frame_height;
    camera.filter = TextureFilter::mipmap;
    camera.forward = frame;
    return view_of(camera);
}

/// Frames a second of views that are filtered between levels, each a tile ahead of the one before.
template <typename Draw>
double frames_a_second_of(Device& device, const DeviceMemory& memory, Draw draw)
{
    constexpr int timed_frames = 9;
    check_fits("timing views of the plane", memory, device.info());
    std::vector<double> rates;
    for (int frame = -1; frame < timed_frames; ++frame) { // the first one builds the kernel
        const TextureView view = timed_view(frame);
        const auto begin = std::chrono::steady_clock::now();
        draw(view);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (frame >= 0) rates.push_back(1 / seconds);
    }
    return median(std::move(rates));
}

}

double frames_a_second(Device& device, const TexturePyramid& pyramid)
{
    return frames_a_second_of(device, texture_map_memory(pyramid, timed_view(0)), [&](const TextureView& view) {
        map_texture(device, pyramid, TextureLookup::packed, view, default_work_group_size);
    });
}

double frames_a_second(Device& device, const MappedEndless& mapped)
{
    return frames_a_second_of(device, endless_map_memory(mapped, timed_view(0)), [&](const TextureView& view) {
        map_endless(device, mapped, mapped.origin(0, 0), view, default_work_group_size);
    });
}

DistributionNumber time_number(const std::string& key, double value)
{
    DistributionNumber number = texture_number(key, value, std::nullopt);
    number.is_time = true;
    return number;
}

std::vector<DistributionNumber> time_numbers(Device& device, const EndlessTexture& texture)
{
    const PixelWindow window{0, 0, timed_width, timed_height};
    check_fits("timing pixels of the plane", endless_memory(texture, window), device.info());
    const double seconds = endless_seconds(device, texture, window);
    return {time_number("pixel_nanoseconds", seconds * 1e9 / (static_cast<double>(timed_width) * timed_height)),
            time_number("plain_frames", 1 / seconds)};
}

}
