#include "host/distribution/masks/mask_picture.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/fftw_plan.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/images/raw_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>

namespace poissonlab {
namespace {

constexpr std::size_t mask_sixteenths = 16;
constexpr std::uint32_t most_mask_side = 4096; // nine arrays of doubles take 1.2 GB

double number_at(const RawPicture& picture, std::size_t pixel, std::size_t channel)
{
    const std::uint8_t* const bytes = picture.bytes.data() + pixel * picture.pixel_bytes();
    if (picture.type == SampleType::byte) return bytes[channel];
    if (picture.type == SampleType::word) {
        std::uint16_t word = 0;
        std::memcpy(&word, bytes + channel * sizeof word, sizeof word);
        return word;
    }
    float real = 0;
    std::memcpy(&real, bytes + channel * sizeof real, sizeof real);
    return real;
}

bool are_alike(const RawPicture& picture, std::size_t a, std::size_t b)
{
    const std::size_t pixels = picture.bytes.size() / picture.pixel_bytes();
    for (std::size_t i = 0; i < pixels; ++i)
        if (number_at(picture, i, a) != number_at(picture, i, b)) return false;
    return true;
}

/// Returns the number of the channel that is measured; `note` says where alpha is left out. Throws InputError.
std::size_t mask_channel(const RawPicture& picture, const MaskPictureSettings& settings, std::string& note)
{
    const std::vector<std::string>& names = picture.channels;
    const std::string file = printable(settings.mask.string());
    if (!settings.channel.empty()) {
        const auto found = std::ranges::find(names, settings.channel);
        if (found == names.end())
            throw InputError(fmt::format("{}: has no channel {}: its channels are {}", file,
                                         printable(settings.channel), fmt::join(names, ", ")));
        return static_cast<std::size_t>(found - names.begin());
    }
    std::vector<std::size_t> colors;
    for (std::size_t c = 0; c < names.size(); ++c)
        if (names[c] != "A") colors.push_back(c);
    if (colors.empty()) return 0;
    for (const std::size_t color : colors)
        if (!are_alike(picture, colors.front(), color))
            throw InputError(fmt::format("{}: its channels {} differ: one must be chosen, as by channel {}", file,
                                         fmt::join(names, ", "), names[colors.front()]));
    if (colors.size() < names.size()) note = "alpha is left out: the mask is the colour";
    return colors.front();
}

/// Measures the pixels below a threshold or, where these are more than half, those that are not.
MaskLevel measured_level(const MaskPicture& mask, double threshold, std::size_t below)
{
    MaskLevel level;
    level.threshold = threshold;
    level.below = below;
    const bool is_below = 2 * below <= mask.pixels();
    const std::array<double, 2> sides{static_cast<double>(mask.width), static_cast<double>(mask.height)};
    PointSet points{2, {}};
    std::vector<double> there(mask.pixels());
    for (std::size_t i = 0; i < mask.pixels(); ++i) {
        if ((mask.values[i] < threshold) != is_below) continue;
        there[i] = 1;
        points.coordinates.push_back((static_cast<double>(i % mask.width) + 0.5) / sides[0]);
        points.coordinates.push_back((static_cast<double>(i / mask.width) + 0.5) / sides[1]);
    }
    level.rings = ring_power(field_power(there, mask.width, mask.height), mask.width, mask.height);
    const double root = root_of_volume(sides), end = principal_frequency(points.size(), 2) / 2 / root;
    level.low_power = mean_power_below(level.rings, end);
    if (points.size() < 2) return level;
    const PeriodicBox box = periodic_box(sides);
    level.least_distance = std::round(min_toroidal_distance(points, box) * root * 1e6) / 1e6;
    level.mean_nearest = mean_nearest_distance(points, box) / max_min_distance(points.size(), 2);
    return level;
}

}

double mean_power_below(const RingPower& rings, double end)
{
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < rings.power.size() && rings.frequency[k] < end; ++k) {
        sum += rings.frequency[k] * rings.power[k];
        weights += rings.frequency[k];
    }
    return weights > 0 ? sum / weights : 0;
}

MaskPicture read_mask_picture(const MaskPictureSettings& settings)
{
    const std::string file = printable(settings.mask.string());
    const PictureHeader header = read_picture_header(settings.mask);
    if (!is_kept_raw(header))
        throw InputError(file + ": must have numbers of 8 or 16 bits or floating point, in at most four channels");
    if (header.width > static_cast<int>(most_mask_side) || header.height > static_cast<int>(most_mask_side))
        throw InputError(fmt::format("{}: is {} x {} pixels; masks have {} along a side at most", file, header.width,
                                     header.height, most_mask_side));
    const RawPicture picture = read_raw_picture(settings.mask);
    MaskPicture mask{static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height), {}};
    const std::size_t channel = mask_channel(picture, settings, mask.note);
    mask.values.resize(std::size_t{mask.width} * mask.height);
    for (std::size_t i = 0; i < mask.pixels(); ++i) {
        mask.values[i] = number_at(picture, i, channel);
        if (!std::isfinite(mask.values[i]))
            throw InputError(
                fmt::format("{}: pixel ({}, {}) is not a finite number", file, i % mask.width, i / mask.width));
    }
    const auto [least, most] = std::ranges::minmax(mask.values);
    if (least == most)
        throw InputError(fmt::format("{}: is {:g} everywhere: no threshold divides its pixels", file, least));
    if (picture.type != SampleType::real) {
        mask.codes = picture.type == SampleType::byte ? 256 : 65'536;
        mask.high = mask.codes - 1;
    } else if (least < 0 || most > 1) {
        mask.low = least;
        mask.high = most;
    }
    return mask;
}

std::vector<double> field_power(const std::vector<double>& values, std::uint32_t width, std::uint32_t height)
{
    const std::size_t half = width / 2 + 1;
    std::vector<double> field = values;
    std::vector<std::complex<double>> transform(half * height);
    const FftwPlan plan = make_fftw_plan(fftw_plan_dft_r2c_2d, static_cast<int>(height), static_cast<int>(width),
                                         field.data(), fftw(transform.data()), FFTW_ESTIMATE);
    fftw_execute(plan.get());
    double squares = 0;
    for (const double value : values) squares += value * value;
    std::vector<double> power(values.size());
    for (std::size_t v = 0; v < height; ++v)
        for (std::size_t u = 0; u < width; ++u) {
            const bool is_kept = u < half;
            const std::size_t at = is_kept ? v * half + u : (height - v) % height * half + (width - u);
            power[v * width + u] = std::norm(transform[at]) / squares;
        }
    return power;
}

RingPower ring_power(const std::vector<double>& power, std::uint32_t width, std::uint32_t height)
{
    struct Sums
    {
        double count = 0, sum = 0, squares = 0;
    };
    const auto rings = std::max<std::size_t>(std::min(width, height) / 2, 1);
    std::vector<Sums> sums(rings);
    for (std::uint32_t v = 0; v <= height / 2; ++v)
        for (std::uint32_t u = 0; u < width; ++u) {
            // One of a frequency and its opposite counts: that in the upper half, or in the first half of a row that is
            // its own opposite.
            const bool is_own_row = v == 0 || 2 * v == height;
            if (is_own_row && 2 * u > width) continue;
            const double x = 2 * u <= width ? u : static_cast<double>(u) - width;
            const double length = std::hypot(x / width, static_cast<double>(v) / height);
            const auto ring = static_cast<std::size_t>(std::llround(length * 2 * static_cast<double>(rings)));
            if (ring == 0 || ring > rings || length > 0.5) continue;
            const double value = power[std::size_t{v} * width + u];
            sums[ring - 1].count += 1;
            sums[ring - 1].sum += value;
            sums[ring - 1].squares += value * value;
        }
    RingPower means;
    for (std::size_t k = 0; k < rings; ++k) {
        if (sums[k].count == 0) continue;
        const double mean = sums[k].sum / sums[k].count;
        const double variance = sums[k].count > 1 ? (sums[k].squares - sums[k].sum * mean) / (sums[k].count - 1) : 0;
        means.frequency.push_back(static_cast<double>(k + 1) / (2 * static_cast<double>(rings)));
        means.power.push_back(mean);
        means.anisotropy.push_back(mean > 0 ? std::max(variance, 0.0) / (mean * mean) : 0);
    }
    return means;
}

std::vector<MaskLevel> mask_levels(const MaskPicture& mask)
{
    std::vector<double> sorted = mask.values;
    std::ranges::sort(sorted);
    std::vector<MaskLevel> levels;
    for (std::size_t i = 1; i < mask_sixteenths; ++i) {
        const std::size_t wanted = i * sorted.size() / mask_sixteenths;
        const auto [first, last] = std::ranges::equal_range(sorted, sorted[wanted]);
        const auto fewer = static_cast<std::size_t>(first - sorted.begin()),
                   more = static_cast<std::size_t>(last - sorted.begin());
        // Pixels of one value are all below a threshold or none is.
        const bool takes_fewer = fewer > 0 && (more == sorted.size() || wanted - fewer <= more - wanted);
        const std::size_t below = takes_fewer ? fewer : more;
        if (below == sorted.size() || (!levels.empty() && levels.back().below == below)) continue;
        levels.push_back(measured_level(mask, sorted[below], below));
    }
    return levels;
}

double histogram_error(const MaskPicture& mask)
{
    std::vector<double> sorted = mask.values;
    std::ranges::sort(sorted);
    const double step = mask.codes > 0 ? 1 : 0, range = mask.high - mask.low + step;
    const auto count = static_cast<double>(sorted.size());
    double error = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double before = (sorted[i] - mask.low) / range, after = (sorted[i] + step - mask.low) / range;
        const bool is_first = i == 0 || sorted[i - 1] != sorted[i];
        const bool is_last = i + 1 == sorted.size() || sorted[i + 1] != sorted[i];
        if (is_first) error = std::max(error, std::abs(static_cast<double>(i) / count - before));
        if (is_last) error = std::max(error, std::abs(static_cast<double>(i + 1) / count - after));
    }
    return error;
}

}
