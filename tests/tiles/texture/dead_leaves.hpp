// Pictures of opaque disks over each other, by whole numbers alone, so that novelty.py draws the same.
#pragma once

#include "base/images/png_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace poissonlab::test {

/// The numbers of both programs.
class PlainRandom
{
public:
    explicit PlainRandom(std::uint32_t seed) : state_(seed) {}
    int next()
    {
        state_ = state_ * 1664525u + 1013904223u;
        return static_cast<int>(state_ >> 16);
    }

private:
    std::uint32_t state_;
};

/// Disks of radius `least` to least + 4.
inline PngPixels dead_leaves(int width, int height, int channels, std::uint32_t seed, int count = 900, int least = 4)
{
    PngPixels picture{width, height, channels, {}};
    picture.values.resize(picture.at(0, height, 0));
    PlainRandom random(seed);
    for (int i = 0; i < count; ++i) {
        std::array<int, 6> numbers{};
        for (int& number : numbers) number = random.next();
        const int x0 = numbers[0] % width, y0 = numbers[1] % height, radius = least + numbers[2] % 5;
        const int light = numbers[3] % 192;
        const std::array<int, 3> color{light, light + numbers[4] % 64, light + numbers[5] % 64};
        for (int y = std::max(0, y0 - radius); y < std::min(height, y0 + radius + 1); ++y)
            for (int x = std::max(0, x0 - radius); x < std::min(width, x0 + radius + 1); ++x)
                if ((x - x0) * (x - x0) + (y - y0) * (y - y0) <= radius * radius)
                    for (int c = 0; c < channels; ++c)
                        picture.values[picture.at(x, y, c)] =
                            static_cast<std::uint8_t>(color[static_cast<std::size_t>(c)]);
    }
    return picture;
}

}
