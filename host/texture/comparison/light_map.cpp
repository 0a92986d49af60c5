#include "host/texture/comparison/light_map.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

LightMap lightness_map(const PngPixels& picture)
{
    LightMap map{picture.width, picture.height, {}};
    const auto channels = static_cast<std::size_t>(picture.channels);
    map.values.reserve(picture.values.size() / channels);
    for (std::size_t i = 0; i < picture.values.size(); i += channels) {
        const std::uint8_t* const v = &picture.values[i];
        map.values.push_back(channels == 1 ? v[0] : 0.299 * v[0] + 0.587 * v[1] + 0.114 * v[2]);
    }
    return map;
}

LightMap contrast_map(const LightMap& map, int side)
{
    LightMap contrasts{map.width / side, map.height / side, {}};
    const double count = static_cast<double>(side) * side;
    for (int top = 0; top + side <= map.height; top += side)
        for (int left = 0; left + side <= map.width; left += side) {
            double sum = 0, squares = 0;
            for (int y = top; y < top + side; ++y)
                for (int x = left; x < left + side; ++x) {
                    const double value = map.at(x, y);
                    sum += value;
                    squares += value * value;
                }
            contrasts.values.push_back(std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count))));
        }
    return contrasts;
}

PngPixels picture_part(const PngPixels& picture, int left, int top, int width, int height)
{
    PngPixels part{width, height, picture.channels, {}};
    part.values.reserve(part.at(0, height, 0));
    for (int y = top; y < top + height; ++y) {
        const auto first = picture.values.begin() + static_cast<std::ptrdiff_t>(picture.at(left, y, 0));
        part.values.insert(part.values.end(), first, first + static_cast<std::ptrdiff_t>(width) * picture.channels);
    }
    return part;
}

}
