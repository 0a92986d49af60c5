#include "host/distribution/textures/frame_rate.hpp"

#include "host/device/device.hpp"
#include "results/statistic.hpp"
#include "results/texture_measures.hpp"

#include <chrono>

namespace poissonlab {

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
