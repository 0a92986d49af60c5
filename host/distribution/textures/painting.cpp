#include "host/distribution/textures/painting.hpp"

#include <algorithm>

namespace poissonlab::painting {

PngPixels blank(int width, int height)
{
    PngPixels picture{width, height, 3, {}};
    picture.values.assign(picture.at(0, height, 0), 255);
    return picture;
}

void put(PngPixels& picture, int x, int y, Rgb color)
{
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    std::ranges::copy(color, picture.values.begin() + static_cast<std::ptrdiff_t>(picture.at(x, y, 0)));
}

Rgb color_at(const PngPixels& picture, int x, int y)
{
    const std::size_t at = picture.at(x, y, 0);
    if (picture.channels < 3) return {picture.values[at], picture.values[at], picture.values[at]};
    return {picture.values[at], picture.values[at + 1], picture.values[at + 2]};
}

void put_picture(PngPixels& picture, const PngPixels& other, int left, int top)
{
    for (int y = 0; y < other.height; ++y)
        for (int x = 0; x < other.width; ++x) put(picture, left + x, top + y, color_at(other, x, y));
}

PngPixels colored(const PngPixels& pixels)
{
    PngPixels picture = blank(pixels.width, pixels.height);
    put_picture(picture, pixels, 0, 0);
    return picture;
}

Rgb tinted(Rgb color, Rgb tint)
{
    Rgb mixed{};
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = static_cast<std::uint8_t>((color[c] + tint[c]) / 2);
    return mixed;
}

PngPixels tile_picture(const TextureSet& set, std::size_t tile)
{
    const auto values = set.values_of(tile);
    return {set.size, set.size, set.exemplar.channels, {values.begin(), values.end()}};
}

PngPixels enlarged(const PngPixels& pixels, int factor)
{
    PngPixels large{pixels.width * factor, pixels.height * factor, pixels.channels, {}};
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            for (int c = 0; c < large.channels; ++c)
                large.values.push_back(pixels.values[pixels.at(x / factor, y / factor, c)]);
    return large;
}

}
