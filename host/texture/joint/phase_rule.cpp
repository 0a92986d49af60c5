#include "host/texture/joint/phase_rule.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace poissonlab {
namespace {

/// Periods of a window from the exemplar's corner to its middle.
double periods_to(const RegularWave& wave, const ExemplarWindow& window)
{
    return wave.x * (window.x + window.size / 2.0) + wave.y * (window.y + window.size / 2.0);
}

/// Parts of a period, about a pixel each.
std::size_t phase_bins(const RegularWave& wave) { return static_cast<std::size_t>(std::ceil(wave.period())); }

std::size_t phase_bin(const RegularWave& wave, int x, int y)
{
    const double periods = wave.x * x + wave.y * y;
    const auto bin = static_cast<std::size_t>((periods - std::floor(periods)) * static_cast<double>(phase_bins(wave)));
    return std::min(bin, phase_bins(wave) - 1);
}

std::vector<std::uint8_t> lightness_bytes(const LightMap& map)
{
    std::vector<std::uint8_t> bytes;
    for (const double value : map.values) bytes.push_back(static_cast<std::uint8_t>(std::lround(value)));
    return bytes;
}

/// Sums by parts of a period.
struct BinSums
{
    std::vector<double> products, counts;
};

/// Adds products of values of a row and of others at the same distance on both sides of each of its places.
void add_products(const LightMap& differences, const RegularWave& wave, int y, BinSums& sums)
{
    const double period = wave.period(), east = wave.x * period, south = wave.y * period;
    const auto width = static_cast<std::size_t>(differences.width);
    std::vector<double> products(width), counts(width);
    for (int away = 2; 2 * away <= period; ++away) {
        const int dx = static_cast<int>(std::lround(away * east)), dy = static_cast<int>(std::lround(away * south));
        if (y < std::abs(dy) || y + std::abs(dy) >= differences.height) continue;
        const double* const before = &differences.values[differences.index(0, y - dy)];
        const double* const after = &differences.values[differences.index(0, y + dy)];
        for (int x = std::abs(dx); x + std::abs(dx) < differences.width; ++x) {
            products[static_cast<std::size_t>(x)] += before[x - dx] * after[x + dx];
            ++counts[static_cast<std::size_t>(x)];
        }
    }
    for (int x = 0; x < differences.width; ++x) {
        const std::size_t bin = phase_bin(wave, x, y);
        sums.products[bin] += products[static_cast<std::size_t>(x)];
        sums.counts[bin] += counts[static_cast<std::size_t>(x)];
    }
}

/// The place in a period around which values at the same distance on both sides, up to half of a period, have the
/// smallest mean product. Bricks differ from the next course's, and are one brick on both sides of their middle. The
/// same on any number of threads: strips of rows are added up in their order.
double phase_between_courses(const LightMap& differences, const RegularWave& wave)
{
    constexpr int rows_a_strip = 64;
    const std::size_t bins = phase_bins(wave);
    std::vector<BinSums> strips(static_cast<std::size_t>((differences.height + rows_a_strip - 1) / rows_a_strip));
    tbb::parallel_for(std::size_t{0}, strips.size(), [&](std::size_t i) {
        strips[i] = {std::vector<double>(bins), std::vector<double>(bins)};
        const int first = static_cast<int>(i) * rows_a_strip;
        for (int y = first; y < std::min(first + rows_a_strip, differences.height); ++y)
            add_products(differences, wave, y, strips[i]);
    });
    std::vector<double> means;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        double product = 0, count = 0;
        for (const BinSums& strip : strips) {
            product += strip.products[bin];
            count += strip.counts[bin];
        }
        means.push_back(count > 0 ? product / count : std::numeric_limits<double>::infinity());
    }
    const auto least = std::ranges::min_element(means) - means.begin();
    // Bins count from the middle of the first pixel, places from its corner.
    return (static_cast<double>(least) + 0.5) / static_cast<double>(bins) + (wave.x + wave.y) / 2;
}

double from_whole(double number) { return std::abs(number - std::round(number)); }

}

PhaseMeans::PhaseMeans(const PngPixels& exemplar, std::vector<RegularWave> waves)
    : waves_(std::move(waves)), channels_(static_cast<std::size_t>(exemplar.channels))
{
    std::size_t bins = channels_;
    for (const RegularWave& wave : waves_) bins *= phase_bins(wave);
    // Whole numbers have the same sums in any order.
    using Sums = std::vector<std::uint64_t>;
    tbb::enumerable_thread_specific<std::pair<Sums, Sums>> of_threads{std::pair{Sums(bins), Sums(bins)}};
    tbb::parallel_for(0, exemplar.height, [&](int y) {
        auto& [sums, counts] = of_threads.local();
        for (int x = 0; x < exemplar.width; ++x) {
            const std::size_t first = bin(x, y, 0);
            for (std::size_t c = 0; c < channels_; ++c) {
                sums[first + c] += exemplar.values[exemplar.at(x, y, static_cast<int>(c))];
                ++counts[first + c];
            }
        }
    });
    Sums sums(bins), counts(bins);
    for (const auto& [its, number] : of_threads)
        for (std::size_t i = 0; i < bins; ++i) {
            sums[i] += its[i];
            counts[i] += number[i];
        }
    for (std::size_t i = 0; i < bins; ++i)
        means_.push_back(static_cast<double>(sums[i]) / static_cast<double>(std::max<std::uint64_t>(1, counts[i])));
}

std::size_t PhaseMeans::bin(int x, int y, int channel) const
{
    std::size_t bin = 0;
    for (const RegularWave& wave : waves_) bin = bin * phase_bins(wave) + phase_bin(wave, x, y);
    return bin * channels_ + static_cast<std::size_t>(channel);
}

namespace {

/// Returns what waves leave of the lightness.
LightMap differences_from_means(const PngPixels& exemplar, const std::vector<RegularWave>& waves)
{
    LightMap map = lightness_map(exemplar);
    const PngPixels light{map.width, map.height, 1, lightness_bytes(map)};
    const PhaseMeans means(light, waves);
    tbb::parallel_for(0, map.height, [&](int y) {
        for (int x = 0; x < map.width; ++x) map.values[map.index(x, y)] -= means.at(x, y, 0);
    });
    return map;
}

}

PhaseRule::PhaseRule(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size)
{
    if (waves.empty()) return;
    const LightMap differences = differences_from_means(exemplar, waves);
    for (const RegularWave& wave : waves)
        waves_.push_back({wave, std::round(wave.x * size) / size, std::round(wave.y * size) / size,
                          phase_between_courses(differences, wave)});
}

bool PhaseRule::holds(const ExemplarWindow& window, double x, double y, double slack) const
{
    return std::ranges::all_of(waves_, [&](const Phase& phase) {
        const double periods = periods_to(phase.wave, window) - phase.tile_x * x - phase.tile_y * y - phase.start;
        return from_whole(periods) * phase.wave.period() <= most_crest_offset + slack;
    });
}

ExemplarWindow PhaseRule::nearest(const ExemplarWindow& window, const PngPixels& exemplar, double x, double y) const
{
    ExemplarWindow best = window;
    int least = -1;
    if (is_empty()) return best;
    const int reach = window.size; // at least a period of every wave
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const ExemplarWindow other{window.x + dx, window.y + dy, window.size};
            const int away = dx * dx + dy * dy;
            if ((least >= 0 && away >= least) || other.x < 0 || other.y < 0 || other.x + other.size > exemplar.width ||
                other.y + other.size > exemplar.height || !holds(other, x, y))
                continue;
            least = away;
            best = other;
        }
    return best;
}

std::vector<RegularWave> fitting_waves(const PngPixels& exemplar, int size)
{
    std::vector<RegularWave> waves = regular_waves(lightness_map(exemplar));
    std::erase_if(waves, [&](const RegularWave& wave) { return !fits_tiles(wave, size); });
    return waves;
}

}
