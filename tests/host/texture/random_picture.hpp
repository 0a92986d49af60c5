// Pictures of white noise, of which every window is another one.
#pragma once

#include "base/images/png_file.hpp"

#include <random>

namespace poissonlab::test {

inline PngPixels random_picture(int width, int height, int channels, unsigned seed, int levels = 256)
{
    PngPixels picture{width, height, channels, {}};
    std::mt19937 random(seed);
    for (int i = 0; i < width * height * channels; ++i)
        picture.values.push_back(static_cast<std::uint8_t>(random() % static_cast<unsigned>(levels)));
    return picture;
}

}
