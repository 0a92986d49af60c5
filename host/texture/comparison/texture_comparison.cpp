#include "host/texture/comparison/texture_comparison.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace poissonlab {

SelfCorrelation::SelfCorrelation(const LightMap& map)
    : width_(map.width), height_(map.height), line_(2 * (static_cast<std::size_t>(width_ + width_ / 4) / 2 + 1))
{
    // Zeros of a quarter of the map's sides keep pairs over opposite borders apart. Transforms are in place.
    const int columns = width_ + width_ / 4, rows = height_ + height_ / 4;
    const double mean =
        std::accumulate(map.values.begin(), map.values.end(), 0.0) / static_cast<double>(map.values.size());
    values_.resize(line_ * static_cast<std::size_t>(rows));
    double squares = 0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const double value = map.at(x, y) - mean;
            values_[static_cast<std::size_t>(y) * line_ + static_cast<std::size_t>(x)] = value;
            squares += value * value;
        }
    if (squares == 0) return;
    auto* const spectrum = reinterpret_cast<std::complex<double>*>(values_.data()); // NOLINT: pairs of numbers
    const auto flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
    const FftwPlan forward = make_fftw_plan(fftw_plan_dft_r2c_2d, rows, columns, values_.data(), fftw(spectrum), flags);
    fftw_execute(forward.get());
    for (std::size_t i = 0; i < values_.size() / 2; ++i) spectrum[i] = std::norm(spectrum[i]);
    const FftwPlan backward =
        make_fftw_plan(fftw_plan_dft_c2r_2d, rows, columns, fftw(spectrum), values_.data(), flags);
    fftw_execute(backward.get());
    const double unit = 1 / (squares * rows * columns);
    for (double& value : values_) value *= unit;
}

double SelfCorrelation::at(int dx, int dy) const
{
    const double pairs = (1 - static_cast<double>(std::abs(dx)) / width_) * (1 - static_cast<double>(dy) / height_);
    const int x = dx < 0 ? dx + width_ + width_ / 4 : dx;
    return values_[static_cast<std::size_t>(dy) * line_ + static_cast<std::size_t>(x)] / pairs;
}

CorrelationPeak correlation_peak(const SelfCorrelation& correlations, int least)
{
    CorrelationPeak peak;
    for (int dy = 0; dy <= correlations.most_dy(); ++dy)
        for (int dx = dy == 0 ? 0 : -correlations.most_dx(); dx <= correlations.most_dx(); ++dx) {
            if (dx * dx + dy * dy < least * least) continue;
            const double value = correlations.at(dx, dy);
            if (value > peak.correlation) peak = {value, dx, dy};
        }
    return peak;
}

double chance_of_peak(const SelfCorrelation& sample, int least, int width, int height)
{
    double squares = 1; // at distance 0
    for (int dy = 0; dy <= std::min(least - 1, sample.most_dy()); ++dy)
        for (int dx = -sample.most_dx(); dx <= sample.most_dx(); ++dx)
            if (dx * dx + dy * dy < least * least && (dy > 0 || dx > 0)) squares += 2 * std::pow(sample.at(dx, dy), 2);
    const double places = static_cast<double>(width) * height;
    const double distances = places / 8 / squares; // that are independent
    return std::sqrt(squares / places) * std::sqrt(2 * std::log(std::max(std::numbers::e, distances)));
}

namespace {

using Shares = std::array<double, 256>;

constexpr std::size_t quantile_count = 128;

/// Counts become a cumulative distribution.
Shares cumulative_shares(const Shares& counts)
{
    Shares shares = counts;
    std::partial_sum(shares.begin(), shares.end(), shares.begin());
    const double all = shares.back();
    for (double& share : shares) share /= all;
    return shares;
}

double area_between(const Shares& one, const Shares& other)
{
    double sum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) sum += std::abs(one[i] - other[i]);
    return sum;
}

std::vector<double> quantiles_of(std::vector<double> values)
{
    std::ranges::sort(values);
    std::vector<double> quantiles;
    for (std::size_t i = 0; i < quantile_count; ++i)
        quantiles.push_back(values[(2 * i + 1) * values.size() / (2 * quantile_count)]);
    return quantiles;
}

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double root_mean_square_between(const std::vector<double>& one, const std::vector<double>& other)
{
    double squares = 0;
    for (std::size_t i = 0; i < one.size(); ++i) squares += (one[i] - other[i]) * (one[i] - other[i]);
    return std::sqrt(squares / static_cast<double>(one.size()));
}

void add_colors(const PngPixels& window, WindowStatistics& statistics)
{
    for (int c = 0; c < window.channels; ++c) {
        Shares counts{};
        for (std::size_t i = static_cast<std::size_t>(c); i < window.values.size();
             i += static_cast<std::size_t>(window.channels))
            ++counts[window.values[i]];
        statistics.colors.push_back(cumulative_shares(counts));
    }
}

void add_steps(const LightMap& light, WindowStatistics& statistics)
{
    Shares counts{};
    double sum = 0, count = 0;
    const auto add = [&](double step) {
        ++counts[static_cast<std::size_t>(std::lround(std::abs(step)))];
        sum += std::abs(step);
        ++count;
    };
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            if (x + 1 < light.width) add(light.at(x + 1, y) - light.at(x, y));
            if (y + 1 < light.height) add(light.at(x, y + 1) - light.at(x, y));
        }
    statistics.steps = cumulative_shares(counts);
    statistics.mean_step = sum / count;
}

/// Statistics of a square's windows, so many along each side.
std::vector<WindowStatistics> statistics_of_windows(const PngPixels& square, int count)
{
    const int side = std::min(square.width, square.height) / count;
    std::vector<WindowStatistics> all(static_cast<std::size_t>(count * count));
    tbb::parallel_for(0, count * count, [&](int i) {
        all[static_cast<std::size_t>(i)] =
            window_statistics(picture_part(square, i % count * side, i / count * side, side, side));
    });
    return all;
}

void add(WindowDistances& sum, const WindowDistances& one, double weight)
{
    sum.colors += weight * one.colors;
    sum.largest += weight * one.largest;
    sum.contrast += weight * one.contrast;
    sum.gradients += weight * one.gradients;
    for (std::size_t scale = 0; scale < pyramid_scales; ++scale) sum.structure[scale] += weight * one.structure[scale];
}

void compare_windows(const PngPixels& exemplar, const PngPixels& square, TextureComparison& result)
{
    const auto natural = statistics_of_windows(exemplar, 2), made = statistics_of_windows(square, 4);
    const auto pairs = static_cast<double>(natural.size() * made.size());
    const auto own_pairs = static_cast<double>(natural.size() * (natural.size() - 1));
    double contrast = 0;
    for (const WindowStatistics& one : natural) {
        for (const WindowStatistics& other : made) {
            add(result.distances, window_distances(other, one), 1 / pairs);
            contrast += contrast_ratio(other, one) / pairs;
        }
        for (const WindowStatistics& other : natural)
            if (&other != &one) add(result.own, window_distances(other, one), 1 / own_pairs);
    }
    result.contrast = contrast;
    result.edges = edge_change(made, natural);
}

}

WindowStatistics window_statistics(const PngPixels& window)
{
    WindowStatistics statistics;
    add_colors(window, statistics);
    const LightMap light = lightness_map(window);
    add_steps(light, statistics);
    for (const int side : contrast_sides) {
        const std::vector<double> contrasts = contrast_map(light, side).values;
        statistics.mean_contrasts.push_back(mean_of(contrasts));
        statistics.contrasts.push_back(quantiles_of(contrasts));
    }
    statistics.correlations = magnitude_correlations(light);
    return statistics;
}

WindowDistances window_distances(const WindowStatistics& window, const WindowStatistics& natural)
{
    WindowDistances distances;
    for (std::size_t c = 0; c < window.colors.size(); ++c) {
        distances.colors +=
            area_between(window.colors[c], natural.colors[c]) / static_cast<double>(window.colors.size());
        for (std::size_t i = 0; i < 256; ++i)
            distances.largest = std::max(distances.largest, std::abs(window.colors[c][i] - natural.colors[c][i]));
    }
    if (natural.mean_step > 0) distances.gradients = area_between(window.steps, natural.steps) / natural.mean_step;
    for (std::size_t s = 0; s < contrast_sides.size(); ++s) {
        double sum = 0;
        for (std::size_t i = 0; i < quantile_count; ++i)
            sum += std::abs(window.contrasts[s][i] - natural.contrasts[s][i]) / quantile_count;
        if (natural.mean_contrasts[s] > 0)
            distances.contrast += sum / natural.mean_contrasts[s] / contrast_sides.size();
    }
    for (std::size_t scale = 0; scale < pyramid_scales; ++scale)
        distances.structure[scale] = root_mean_square_between(window.correlations[scale], natural.correlations[scale]);
    return distances;
}

EdgeChange edge_change(std::span<const WindowStatistics> texture, std::span<const WindowStatistics> natural)
{
    const auto mean_share = [](std::span<const WindowStatistics> windows, std::size_t step) {
        double sum = 0;
        for (const WindowStatistics& window : windows) sum += window.steps[step];
        return sum / static_cast<double>(windows.size());
    };
    // The integral of quantiles is the sum, over all limits, of the shares of steps that exceed the limit.
    double mean = 0, large = 0, made_large = 0, above = 0, excess = 0, most_excess = 0;
    for (std::size_t step = 256; step-- > 0;) {
        const double made = 1 - mean_share(texture, step), own = 1 - mean_share(natural, step);
        mean += own;
        large += std::min(0.1, own);
        made_large += std::min(0.1, made);
        above += std::max(0.0, made - own);
        excess += made - own;
        most_excess = std::max(most_excess, excess);
    }
    constexpr double none = 0.01; // parts of 255: exemplars with a smaller mean have no edges to speak of
    if (mean < none) return {0, most_excess / none};
    const double lost = std::max(0.0, 1 - made_large / large);
    return {lost + std::min(lost, above / mean), most_excess / mean};
}

double contrast_ratio(const WindowStatistics& window, const WindowStatistics& natural)
{
    double logarithms = 0;
    for (std::size_t s = 0; s < contrast_sides.size(); ++s) {
        if (natural.mean_contrasts[s] == 0) return 1;
        logarithms += std::log(window.mean_contrasts[s] / natural.mean_contrasts[s]) / contrast_sides.size();
    }
    return std::exp(logarithms);
}

int compared_side(const PngPixels& exemplar) { return std::min(exemplar.width, exemplar.height) / 2 * 4; }

double natural_edge_change(const TextureComparison& comparison) { return std::max(0.025, comparison.own.gradients); }

double structure_times(const TextureComparison& comparison)
{
    double sum = 0;
    for (std::size_t scale = 0; scale < pyramid_scales; ++scale) {
        const double own = comparison.own.structure[scale];
        sum += own > 0 ? comparison.distances.structure[scale] / own : 1;
    }
    return sum / pyramid_scales;
}

TextureComparison compare_texture(const PngPixels& exemplar, const TextureSquare& texture, int side)
{
    TextureComparison result;
    compare_windows(exemplar, texture(compared_side(exemplar)), result);
    const LightMap natural = lightness_map(exemplar), light = lightness_map(texture(std::min(side, peak_side)));
    const int least = static_cast<int>(least_peak_part * std::min(exemplar.width, exemplar.height));
    result.peak = correlation_peak(SelfCorrelation(light), least).correlation;
    result.chance_peak = chance_of_peak(SelfCorrelation(natural), least, light.width, light.height);
    const LightMap contrasts = contrast_map(light, peak_contrast_side);
    const int least_squares = std::max(2, least / peak_contrast_side);
    result.contrast_peak = correlation_peak(SelfCorrelation(contrasts), least_squares).correlation;
    result.chance_contrast_peak = chance_of_peak(SelfCorrelation(contrast_map(natural, peak_contrast_side)),
                                                 least_squares, contrasts.width, contrasts.height);
    return result;
}

}
