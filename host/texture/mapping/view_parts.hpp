// Views that a device draws part by part, so that Ctrl-C need not wait for all of one.
#pragma once

#include "base/programs/interrupt.hpp"
#include "host/device/device.hpp"
#include "kernels/common/fields/texture_map.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Pixels of a view that are drawn at a time: with 2^20 samples.
inline std::size_t pixels_at_once(const contract::texture_map::TextureView& view)
{
    constexpr std::size_t samples_at_once = std::size_t{1} << 20;
    const std::size_t count = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
                      samples = static_cast<std::size_t>(view.samples) * static_cast<std::size_t>(view.samples);
    return std::max<std::size_t>(1, std::min(count, samples_at_once / samples));
}

/// The picture of a view: `draw(first, count, shown)` enqueues the kernel that draws `count` pixels from `first` on.
/// Throws Interrupted.
template <typename Draw>
std::vector<float> picture_in_parts(Device& device, const contract::texture_map::TextureView& view, int channels,
                                    Draw draw)
{
    const std::size_t count = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
                      values = static_cast<std::size_t>(channels), at_once = pixels_at_once(view);
    const Buffer<float> shown = device.buffer<float>(at_once * values);
    std::vector<float> pixels(count * values);
    for (std::size_t first = 0; first < count; first += at_once) {
        stop_if_interrupted();
        const std::size_t part = std::min(at_once, count - first);
        draw(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(part), shown);
        shown.read(std::span(pixels).subspan(first * values, part * values));
    }
    return pixels;
}

}
