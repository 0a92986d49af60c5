// kind = "noise": Perlin's noise with a permutation table and with the long-period hash function.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.4, figure 3.9; and section 3.4.2.2 on tables whose
// sizes differ too much. Pictures are slices through noise in space, half-way between two layers of the lattice.
#include "base/images/grey_image.hpp"
#include "host/schemes/perlin_noise.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/permutation_hash.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

constexpr Color noise_range = 16;
constexpr std::uint32_t plain_entries = 256;
constexpr double noise_slice = 0.5;

/// Noise at the middles of pixels, rows from the top.
std::vector<double> noise_values(const auto& hash, const NoiseSettings& settings, double first_x)
{
    std::vector<double> values;
    const double step = static_cast<double>(settings.cells) / settings.pixels;
    for (std::uint32_t row = 0; row < settings.pixels; ++row)
        for (std::uint32_t column = 0; column < settings.pixels; ++column)
            values.push_back(
                perlin_noise(hash, first_x + (column + 0.5) * step, (settings.pixels - row - 0.5) * step, noise_slice));
    return values;
}

GreyImage noise_image(const std::vector<double>& values, std::uint32_t pixels)
{
    GreyImage image(static_cast<int>(pixels), static_cast<int>(pixels), 0);
    for (std::size_t i = 0; i < values.size(); ++i)
        image.pixels[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5 + values[i] / 2, 0.0, 1.0)));
    return image;
}

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The covariance of two lists.
double covariance(const std::vector<double>& a, const std::vector<double>& b)
{
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean_a) * (b[i] - mean_b);
    return sum / static_cast<double>(a.size());
}

/// The correlation of noise with itself, so many cells to the east.
double correlation_at(const auto& hash, const NoiseSettings& settings, double cells)
{
    const auto here = noise_values(hash, settings, 0), there = noise_values(hash, settings, cells);
    return covariance(here, there) / std::sqrt(covariance(here, here) * covariance(there, there));
}

/// The mean distance on the circle between the values of a hash function one period of its large table apart, over that
/// of independent values. D 3.4.2.2: tables of 5 and 251 entries, reduced to one of both sizes.
double likeness_of_parts(std::uint32_t range, std::uint64_t seed)
{
    constexpr std::uint32_t small = 5, large = 251;
    const LongPeriodHash hash(range, {range, {small, large}}, stream_key(seed, Purpose::tiling_colors, 3));
    double apart = 0, independent = 0;
    for (std::int64_t x = 0; x < small * large; ++x) {
        const std::uint32_t difference = (hash(x) + range - hash(x + large)) % range;
        apart += std::min(difference, range - difference);
    }
    for (std::uint32_t d = 0; d < range; ++d) independent += std::min(d, range - d);
    return apart / (small * large) / (independent / range);
}

/// Costs of an evaluation: of both hash functions, then of noise with both.
std::vector<double> noise_costs(const PermutationHash& plain, const LongPeriodHash& combined)
{
    constexpr int evaluations = 1 << 15;
    const auto hashes = [](const auto& hash) {
        return [&hash] {
            volatile std::uint32_t sum = 0;
            for (std::int64_t i = 0; i < evaluations; ++i) sum = sum + hash(3 * i, 5 - i, i / 7);
        };
    };
    const auto noises = [](const auto& hash) {
        return [&hash] {
            volatile double sum = 0;
            for (int i = 0; i < evaluations / 8; ++i) sum = sum + perlin_noise(hash, 0.37 * i, 0.73 * i, 0.11 * i);
        };
    };
    const std::vector<double> hash_times = median_nanoseconds({hashes(plain), hashes(combined)}, evaluations);
    const std::vector<double> noise_times = median_nanoseconds({noises(plain), noises(combined)}, evaluations / 8.0);
    return {hash_times[0], hash_times[1], noise_times[0], noise_times[1]};
}

void add_hash_numbers(const PermutationHash& plain, const LongPeriodHash& combined, DistributionResult& result)
{
    const auto& sizes = combined.design().sizes;
    const double period = static_cast<double>(combined.period().x);
    const double entries = std::accumulate(sizes.begin(), sizes.end(), 0.0);
    result.numbers.push_back({"long_period", "Period, long-period hash", period, "lattice points, found exactly"});
    result.numbers.push_back({"long_entries", "Entries, long-period hash", entries, "of all its tables"});
    result.numbers.push_back(
        {"plain_period", "Period, permutation table", static_cast<double>(plain.period().x), "lattice points"});
    result.numbers.push_back({"period_ratio", "Ratio of periods", period / static_cast<double>(plain.period().x), ""});
    result.numbers.push_back({"entries_ratio", "Ratio of entries", plain_entries / entries, "the plain table has 256"});
}

void add_costs(const PermutationHash& plain, const LongPeriodHash& combined, DistributionResult& result)
{
    const std::vector<double> times = noise_costs(plain, combined);
    const std::size_t first_time = result.numbers.size();
    result.numbers.push_back({"plain_hash_ns", "Permutation table", times[0], "ns an evaluation"});
    result.numbers.push_back({"hash_time_ratio", "Long-period hash", times[1] / times[0], "times as long"});
    result.numbers.push_back({"plain_noise_ns", "Noise, permutation table", times[2], "ns an evaluation"});
    result.numbers.push_back({"noise_time_ratio", "Noise, long-period hash", times[3] / times[2], "times as long"});
    for (std::size_t i = first_time; i < result.numbers.size(); ++i) result.numbers[i].is_time = true;
}

}

DistributionResult make_noise(const NoiseSettings& settings, std::uint64_t seed, DistributionFiles& files)
{
    const PermutationHash plain(noise_range, plain_entries, stream_key(seed, Purpose::tiling_colors, 1));
    const LongPeriodHash combined(noise_range, noise_hash_design(), stream_key(seed, Purpose::tiling_colors, 2));
    DistributionResult result;
    result.facts = {fmt::format("{0} x {0} cells of the lattice", settings.cells),
                    "tables of 11, 13, 16, 17 and 19 entries, against one of 256"};
    const auto add_picture = [&](const std::string& name, const std::string& caption, const auto& hash) {
        const std::vector<double> values = noise_values(hash, settings, 0);
        write_png(files.add(name), noise_image(values, settings.pixels));
        result.pictures.push_back({name, caption});
        return std::sqrt(covariance(values, values));
    };
    const double plain_sd = add_picture("noise-plain.png", "(a) With a permutation table of 256.", plain);
    const double long_sd = add_picture("noise-long.png", "(b) With the long-period hash function.", combined);
    result.numbers.push_back({"plain_deviation", "Standard deviation, permutation table", plain_sd, "of the picture"});
    result.numbers.push_back({"long_deviation", "Standard deviation, long-period hash", long_sd, "of the picture"});
    result.numbers.push_back({"plain_repeat", "Correlation 256 cells away, permutation table",
                              correlation_at(plain, settings, plain_entries), "1: the same picture again"});
    result.numbers.push_back({"long_repeat", "Correlation 256 cells away, long-period hash",
                              correlation_at(combined, settings, plain_entries), ""});
    add_hash_numbers(plain, combined, result);
    result.numbers.push_back({"parts_of_large", "Tables of 5 and 251, range 251: parts differ by",
                              likeness_of_parts(251, seed), "of what independent values differ by"});
    result.numbers.push_back({"parts_of_small", "Tables of 5 and 251, range 5: parts differ by",
                              likeness_of_parts(5, seed), "of what independent values differ by"});
    add_costs(plain, combined, result);
    return result;
}

}
