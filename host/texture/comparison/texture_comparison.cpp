#include "host/texture/comparison/texture_comparison.hpp"

#include "host/texture/comparison/correlation_peak.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace poissonlab {
namespace {

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
}

}

int compared_side(const PngPixels& exemplar) { return std::min(exemplar.width, exemplar.height) / 2 * 4; }

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
