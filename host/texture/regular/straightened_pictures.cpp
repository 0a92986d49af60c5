// Numbers of straightened pictures, between those of their sources: the same on any number of threads.
#include "host/texture/regular/straightening.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace poissonlab {
namespace {

/// Weights of the pixels one before to two after a place between two pixels: Catmull and Rom.
std::array<double, 4> cubic_weights(double t)
{
    return {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((4 - 3 * t) * t + 1) * t / 2,
            (t - 1) * t * t / 2};
}

/// The pixels along an axis around a place, the outermost ones again beyond the picture, and their weights.
struct Taps
{
    std::array<std::size_t, 4> at{};
    std::array<double, 4> weights;

    Taps(double place, int pixels) : weights(cubic_weights(place - std::floor(place)))
    {
        const int first = static_cast<int>(std::floor(place)) - 1;
        for (int i = 0; i < 4; ++i)
            at[static_cast<std::size_t>(i)] = static_cast<std::size_t>(std::clamp(first + i, 0, pixels - 1));
    }
};

/// Pixels of numbers of one type, in bytes.
template <class Sample>
struct Samples
{
    const std::vector<std::uint8_t>& bytes;
    int width, height;
    std::size_t channels;

    double at(std::size_t x, std::size_t y, std::size_t channel) const
    {
        Sample sample{};
        const std::size_t index = (y * static_cast<std::size_t>(width) + x) * channels + channel;
        std::memcpy(&sample, &bytes[index * sizeof(Sample)], sizeof(Sample));
        return static_cast<double>(sample);
    }

    /// The number at a place between pixels, in the range of those around.
    Sample between(const Taps& columns, const Taps& rows, std::size_t channel) const
    {
        double sum = 0, lowest = at(columns.at[0], rows.at[0], channel), highest = lowest;
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 4; ++i) {
                const double value = at(columns.at[i], rows.at[j], channel);
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
                sum += columns.weights[i] * rows.weights[j] * value;
            }
        const double value = std::clamp(sum, lowest, highest);
        return static_cast<Sample>(std::is_integral_v<Sample> ? std::round(value) : value);
    }
};

template <class Sample>
std::vector<std::uint8_t> straightened_bytes(const Samples<Sample>& source, const Straightening& map)
{
    const std::array<double, 9>& m = map.to_source;
    const std::size_t row_bytes = static_cast<std::size_t>(map.width) * source.channels * sizeof(Sample);
    std::vector<std::uint8_t> made(static_cast<std::size_t>(map.height) * row_bytes);
    tbb::parallel_for(0, map.height, [&](int y) {
        std::uint8_t* next = &made[static_cast<std::size_t>(y) * row_bytes];
        for (int x = 0; x < map.width; ++x) {
            const double w = m[6] * x + m[7] * y + m[8];
            const Taps columns((m[0] * x + m[1] * y + m[2]) / w, source.width),
                rows((m[3] * x + m[4] * y + m[5]) / w, source.height);
            for (std::size_t c = 0; c < source.channels; ++c, next += sizeof(Sample)) {
                const Sample sample = source.between(columns, rows, c);
                std::memcpy(next, &sample, sizeof(Sample));
            }
        }
    });
    return made;
}

}

PngPixels straightened(const PngPixels& picture, const Straightening& map)
{
    const Samples<std::uint8_t> source{picture.values, picture.width, picture.height,
                                       static_cast<std::size_t>(picture.channels)};
    return {map.width, map.height, picture.channels, straightened_bytes(source, map)};
}

RawPicture straightened(const RawPicture& picture, const Straightening& map)
{
    RawPicture made{map.width, map.height, picture.type, picture.channels, {}};
    const std::size_t channels = picture.channels.size();
    switch (picture.type) {
    case SampleType::byte:
        made.bytes =
            straightened_bytes(Samples<std::uint8_t>{picture.bytes, picture.width, picture.height, channels}, map);
        break;
    case SampleType::word:
        made.bytes =
            straightened_bytes(Samples<std::uint16_t>{picture.bytes, picture.width, picture.height, channels}, map);
        break;
    case SampleType::real:
        made.bytes = straightened_bytes(Samples<float>{picture.bytes, picture.width, picture.height, channels}, map);
        break;
    }
    return made;
}

}
