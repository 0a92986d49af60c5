#include "host/texture/comparison/light_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

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

ReducedPicture reduced_picture(const PngPixels& picture, std::size_t most, int most_factor)
{
    const double pixels = static_cast<double>(picture.width) * picture.height;
    const double least = std::ceil(std::sqrt(pixels / static_cast<double>(most)));
    const int factor = std::clamp(static_cast<int>(least), 1, std::min({picture.width, picture.height, most_factor}));
    if (factor == 1) return {picture, 1};
    PngPixels small{picture.width / factor, picture.height / factor, picture.channels, {}};
    small.values.resize(small.at(0, small.height, 0));
    const int area = factor * factor;
    tbb::parallel_for(0, small.height, [&](int y) {
        std::vector<int> columns(picture.at(small.width * factor, 0, 0));
        for (int row = y * factor; row < (y + 1) * factor; ++row)
            std::transform(columns.begin(), columns.end(), &picture.values[picture.at(0, row, 0)], columns.begin(),
                           std::plus{});
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < picture.channels; ++c) {
                int sum = area / 2;
                for (int i = 0; i < factor; ++i) sum += columns[picture.at(x * factor + i, 0, c)];
                small.values[small.at(x, y, c)] = static_cast<std::uint8_t>(sum / area);
            }
    });
    return {std::move(small), factor};
}

}
