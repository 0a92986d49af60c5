#include "host/texture/flattening.hpp"

#include "base/gaussian_taps.hpp"
#include "host/texture/comparison/light_map.hpp"
#include "host/texture/seam_blending.hpp"
#include "tiles/texture/square_means.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace poissonlab {
namespace {

/// Weights of the pixels from `first` on whose sum is the mean around a place.
struct MeanAround
{
    int first = 0;
    std::vector<double> weights;
};

/// Fits the straight line to a row of `pixels` by weighted least squares, with weights of a Gaussian, and returns the
/// weights that give its value at `place`. Inside of the row these are the Gaussian's own weights.
MeanAround mean_around(int place, int pixels, const std::vector<double>& taps)
{
    const int reach = static_cast<int>(taps.size()) - 1;
    MeanAround mean{std::max(0, place - reach), {}};
    double sum = 0, first = 0, second = 0;
    for (int x = mean.first; x <= std::min(pixels - 1, place + reach); ++x) {
        const double d = x - place, weight = taps[static_cast<std::size_t>(std::abs(x - place))];
        mean.weights.push_back(weight);
        sum += weight;
        first += weight * d;
        second += weight * d * d;
    }
    for (std::size_t i = 0; i < mean.weights.size(); ++i) {
        const double d = mean.first + static_cast<double>(i) - place;
        mean.weights[i] *= (second - first * d) / (sum * second - first * first);
    }
    return mean;
}

/// Means are taken at every so many pixels, and are linear between them: a sixteenth of a tile, an eighth of the
/// Gaussian's standard deviation, so that a step of 255 levels errs by less than 0.25.
constexpr int places_a_tile = 16;

/// The means around every `step`-th pixel of each row, and of one beyond; columns become rows.
LightMap means_of_rows(const LightMap& plane, int step, const std::vector<double>& taps)
{
    const int places = (plane.width - 1) / step + 2;
    LightMap means{plane.height, places,
                   std::vector<double>(static_cast<std::size_t>(places) * static_cast<std::size_t>(plane.height))};
    tbb::parallel_for(0, places, [&](int i) {
        const MeanAround around = mean_around(i * step, plane.width, taps);
        const auto weigh_rows = [&]<std::size_t rows>(int y, std::integral_constant<std::size_t, rows>) {
            std::array<double, rows> sums{};
            const double* values = &plane.values[plane.index(around.first, y)];
            for (const double weight : around.weights) {
                for (std::size_t row = 0; row < rows; ++row)
                    sums[row] += weight * values[row * static_cast<std::size_t>(plane.width)];
                ++values;
            }
            std::ranges::copy(sums, &means.values[means.index(y, i)]);
        };
        constexpr int at_once = 8; // whose sums do not wait for each other
        int y = 0;
        for (; y + at_once <= plane.height; y += at_once) weigh_rows(y, std::integral_constant<std::size_t, at_once>{});
        for (; y < plane.height; ++y) weigh_rows(y, std::integral_constant<std::size_t, 1>{});
    });
    return means;
}

/// Subtracts the mean around each pixel, and adds the mean of the plane.
void flatten(LightMap& plane, double size)
{
    const int step = std::max(1, static_cast<int>(size / places_a_tile));
    const std::vector<double> taps = gaussian_taps(size / 2);
    const LightMap means = means_of_rows(means_of_rows(plane, step, taps), step, taps);
    double mean = 0;
    for (const double value : plane.values) mean += value / static_cast<double>(plane.values.size());
    tbb::parallel_for(0, plane.height, [&](int y) {
        const double v = static_cast<double>(y % step) / step;
        for (int x = 0; x < plane.width; ++x) {
            const double u = static_cast<double>(x % step) / step;
            const int i = x / step, j = y / step;
            const double north = means.at(i, j) + u * (means.at(i + 1, j) - means.at(i, j)),
                         south = means.at(i, j + 1) + u * (means.at(i + 1, j + 1) - means.at(i, j + 1));
            plane.values[plane.index(x, y)] += mean - (north + v * (south - north));
        }
    });
}

/// The whole number of a plane's value; counts those that are out of range.
template <class Sample>
Sample whole_number(double value, std::size_t& clipped)
{
    const double rounded = std::floor(value + 0.5), most = std::numeric_limits<Sample>::max();
    if (rounded < 0 || rounded > most) ++clipped;
    return static_cast<Sample>(std::clamp(rounded, 0.0, most));
}

/// The number of a plane's value. Light does not become negative: counts what would be.
float light_number(double value, float before, std::size_t& clipped)
{
    if (value >= 0 || before < 0) return static_cast<float>(value);
    ++clipped;
    return 0;
}

/// Flattens a channel of samples of one type that lie `stride` samples from each other.
template <class Sample>
void flatten_channel(std::uint8_t* bytes, std::size_t stride, int width, int height, int size, std::size_t& clipped)
{
    LightMap plane{width, height,
                   std::vector<double>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        Sample sample{};
        std::memcpy(&sample, bytes + i * stride * sizeof(Sample), sizeof(Sample));
        plane.values[i] = static_cast<double>(sample);
    }
    flatten(plane, size);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        Sample sample{};
        if constexpr (std::is_integral_v<Sample>) {
            sample = whole_number<Sample>(plane.values[i], clipped);
        } else {
            std::memcpy(&sample, bytes + i * stride * sizeof(Sample), sizeof(Sample));
            sample = light_number(plane.values[i], sample, clipped);
        }
        std::memcpy(bytes + i * stride * sizeof(Sample), &sample, sizeof(Sample));
    }
}

/// Light is measured by means over boxes of pixels. The first number is that of all boxes, approximately; the second is
/// the least number of boxes along each side of a tile.
constexpr std::size_t most_boxes = std::size_t{1} << 20;
constexpr int least_boxes_a_tile = 16;

/// The part of all power below which nobody sees light that is uneven.
constexpr double least_seen_power = 0.05;

/// The number of frequencies below one over `period` pixels, without the mean.
int slow_frequencies(const PngPixels& picture, double period)
{
    int count = -1;
    const int most_u = static_cast<int>(picture.width / period), most_v = static_cast<int>(picture.height / period);
    for (int u = -most_u; u <= most_u; ++u)
        for (int v = -most_v; v <= most_v; ++v) {
            const double x = static_cast<double>(u) / picture.width, y = static_cast<double>(v) / picture.height;
            if (x * x + y * y < 1 / (period * period)) ++count;
        }
    return count;
}

/// Returns the value that one in a thousand chi-squared variates with so many degrees of freedom exceeds, divided by
/// their mean (Wilson and Hilferty, The distribution of chi-square, 1931).
double largest_mean(int degrees)
{
    if (degrees == 0) return 0;
    const double variance = 2.0 / (9 * degrees), root = 1 - variance + 3.0902 * std::sqrt(variance);
    return root * root * root;
}

/// Returns the variance of the sums over channels. Sums of whole numbers are exact.
double variance_of_sums(const PngPixels& picture)
{
    std::int64_t sum = 0, squares = 0;
    for (auto value = picture.values.begin(); value != picture.values.end(); value += picture.channels) {
        const std::int64_t pixel = std::accumulate(value, value + picture.channels, 0);
        sum += pixel;
        squares += pixel * pixel;
    }
    const double pixels = static_cast<double>(picture.width) * picture.height, mean = static_cast<double>(sum) / pixels;
    return static_cast<double>(squares) / pixels - mean * mean;
}

/// Returns feature_side() of a picture without slow light, from means over boxes of `reduced.factor` pixels. Within
/// boxes, flattening changes only the slope of slow light, so that the picture's variance there is added to that of the
/// means.
double flat_feature_side(const PngPixels& picture, const ReducedPicture& reduced, double size)
{
    const PngPixels& small = reduced.pixels;
    LightMap light{small.width, small.height, channel_sums(small)};
    const double within = std::max(0.0, variance_of_sums(picture) - variance_of_sums(small));
    flatten(light, size);
    const SquareMeans means(light.values, light.width);
    const double of_boxes = means.variance(1), least = (of_boxes + within) / 2;
    if (of_boxes <= least) return reduced.factor; // at most
    const double most = std::min(small.width, small.height) / 2;
    return std::ceil(means.side_of_variance(least).value_or(most) * reduced.factor);
}

}

PngPixels flattened(const PngPixels& picture, int size, std::size_t& clipped)
{
    clipped = 0;
    PngPixels flat = picture;
    for (int c = 0; c < picture.channels; ++c)
        flatten_channel<std::uint8_t>(&flat.values[static_cast<std::size_t>(c)],
                                      static_cast<std::size_t>(picture.channels), picture.width, picture.height, size,
                                      clipped);
    return flat;
}

RawPicture flattened(const RawPicture& picture, int size, std::size_t& clipped)
{
    clipped = 0;
    RawPicture flat = picture;
    const auto flatten_as = picture.type == SampleType::byte   ? flatten_channel<std::uint8_t>
                            : picture.type == SampleType::word ? flatten_channel<std::uint16_t>
                                                               : flatten_channel<float>;
    const std::size_t channels = picture.channels.size(), bytes = picture.pixel_bytes() / channels;
    std::vector<std::size_t> shown;
    for (std::size_t c = 0; c < channels; ++c)
        if (picture.channels[c] != "A" && !picture.channels[c].ends_with(".A")) shown.push_back(c);
    shown.resize(shown.size() >= 3 ? 3 : std::min<std::size_t>(1, shown.size()));
    for (const std::size_t c : shown)
        flatten_as(&flat.bytes[c * bytes], channels, picture.width, picture.height, size, clipped);
    return flat;
}

bool UnevenLight::is_uneven() const { return share > std::max(least_seen_power, most); }

UnevenLight uneven_light(const PngPixels& picture, int size)
{
    const ReducedPicture reduced = reduced_picture(picture, most_boxes, std::max(1, size / least_boxes_a_tile));
    const double tile = static_cast<double>(size) / reduced.factor, all = variance_of_channels(picture);
    if (!(all > 0)) return {};
    const double side = flat_feature_side(picture, reduced, tile) / size;
    const double by_chance = 0.89 * side * side;
    const double most = is_smooth(picture) ? 0 : by_chance * largest_mean(slow_frequencies(reduced.pixels, 2 * tile));
    const double share = slow_power(reduced.pixels, 2 * tile) * variance_of_channels(reduced.pixels) / all;
    return {share, by_chance, most};
}

}
