#include "host/texture/joint/feature_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab {
namespace {

/// A number for each pixel; places beside the picture are those of its rim.
struct LightnessMap
{
    int width = 0;
    int height = 0;
    std::vector<int> values;

    int at(int x, int y) const
    {
        return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
    }
};

/// 16 times the mean of the channels, smoothed by the binomial filter 1, 2, 1 along both axes.
LightnessMap smoothed_lightness(const PngPixels& exemplar)
{
    LightnessMap light{exemplar.width, exemplar.height, {}}, smooth = light;
    for (int y = 0; y < exemplar.height; ++y)
        for (int x = 0; x < exemplar.width; ++x) {
            int sum = 0;
            for (int c = 0; c < exemplar.channels; ++c) sum += exemplar.values[exemplar.at(x, y, c)];
            light.values.push_back(sum / exemplar.channels);
        }
    const auto row = [&](int x, int y) { return light.at(x - 1, y) + 2 * light.at(x, y) + light.at(x + 1, y); };
    for (int y = 0; y < exemplar.height; ++y)
        for (int x = 0; x < exemplar.width; ++x) smooth.values.push_back(row(x, y - 1) + 2 * row(x, y) + row(x, y + 1));
    return smooth;
}

std::uint8_t slope_byte(int difference, double slopes)
{
    return static_cast<std::uint8_t>(std::clamp(std::lround(128 + slopes * difference / 16), 0L, 255L));
}

}

PngPixels feature_map(const PngPixels& exemplar, double slopes)
{
    if (slopes <= 0) return exemplar;
    const LightnessMap light = smoothed_lightness(exemplar);
    PngPixels features{exemplar.width, exemplar.height, exemplar.channels + 4, {}};
    for (int y = 0; y < exemplar.height; ++y)
        for (int x = 0; x < exemplar.width; ++x) {
            for (int c = 0; c < exemplar.channels; ++c)
                features.values.push_back(exemplar.values[exemplar.at(x, y, c)]);
            for (const int reach : {1, 2}) {
                features.values.push_back(slope_byte(light.at(x + reach, y) - light.at(x - reach, y), slopes));
                features.values.push_back(slope_byte(light.at(x, y + reach) - light.at(x, y - reach), slopes));
            }
        }
    return features;
}

}
