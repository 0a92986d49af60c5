#include "host/texture/comparison/steerable_pyramid.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

using Complexes = std::vector<std::complex<double>>;

/// Transforms `values` in place.
void transform(Complexes& values, int width, int height, int direction)
{
    const FftwPlan plan = make_fftw_plan(fftw_plan_dft_2d, height, width, fftw(values.data()), fftw(values.data()),
                                         direction, FFTW_ESTIMATE | FFTW_UNALIGNED);
    fftw_execute(plan.get());
}

/// Cycles a pixel, from -1/2 to 1/2.
double frequency(int index, int count)
{
    return static_cast<double>(2 * index > count ? index - count : index) / count;
}

/// The part that filters let pass at a frequency: an octave to either side of a quarter of a cycle a pixel over
/// 2^scale, and within a quarter of a turn of their direction.
double response(double fx, double fy, int scale, int orientation)
{
    const double radius = std::hypot(fx, fy);
    if (radius == 0) return 0;
    const double octaves = std::log2(radius * 4) + scale;
    if (std::abs(octaves) >= 1) return 0;
    const double angle = std::atan2(fy, fx) - std::numbers::pi * orientation / pyramid_orientations;
    const double along = std::cos(angle);
    return along <= 0 ? 0 : std::cos(std::numbers::pi / 2 * octaves) * along * along * along;
}

/// Two maps where both have values away from the border, one moved by (dx, dy).
double correlation(const LightMap& one, const LightMap& other, int border, int dx = 0, int dy = 0)
{
    double sum = 0, other_sum = 0, squares = 0, other_squares = 0, products = 0, count = 0;
    const int far_x = std::abs(dx), far_y = std::abs(dy);
    for (int y = border + far_y; y < one.height - border - far_y; ++y)
        for (int x = border + far_x; x < one.width - border - far_x; ++x) {
            const double a = one.at(x, y), b = other.at(x + dx, y + dy);
            sum += a;
            other_sum += b;
            squares += a * a;
            other_squares += b * b;
            products += a * b;
            ++count;
        }
    const double product = (squares / count - sum / count * (sum / count)) *
                           (other_squares / count - other_sum / count * (other_sum / count));
    return product > 0 ? (products / count - sum / count * (other_sum / count)) / std::sqrt(product) : 0;
}

int border_of(const LightMap& map, int scale) { return std::min(4 << scale, std::min(map.width, map.height) / 4); }

}

std::vector<LightMap> pyramid_magnitudes(const LightMap& map)
{
    const double mean =
        std::accumulate(map.values.begin(), map.values.end(), 0.0) / static_cast<double>(map.values.size());
    Complexes spectrum;
    for (const double value : map.values) spectrum.emplace_back(value - mean);
    transform(spectrum, map.width, map.height, FFTW_FORWARD);
    std::vector<LightMap> magnitudes;
    for (int scale = 0; scale < pyramid_scales; ++scale)
        for (int orientation = 0; orientation < pyramid_orientations; ++orientation) {
            Complexes band = spectrum;
            for (int y = 0; y < map.height; ++y)
                for (int x = 0; x < map.width; ++x)
                    band[map.index(x, y)] *=
                        response(frequency(x, map.width), frequency(y, map.height), scale, orientation);
            transform(band, map.width, map.height, FFTW_BACKWARD);
            LightMap magnitude{map.width, map.height, {}};
            const double unit = 1 / static_cast<double>(band.size());
            for (const std::complex<double>& value : band) magnitude.values.push_back(std::abs(value) * unit);
            magnitudes.push_back(std::move(magnitude));
        }
    return magnitudes;
}

std::vector<std::vector<double>> magnitude_correlations(const LightMap& map)
{
    const std::vector<LightMap> magnitudes = pyramid_magnitudes(map);
    const auto of = [&](int scale, int orientation) -> const LightMap& {
        return magnitudes[static_cast<std::size_t>(scale * pyramid_orientations + orientation)];
    };
    std::vector<std::vector<double>> correlations(pyramid_scales);
    for (int scale = 0; scale < pyramid_scales; ++scale)
        for (int k = 0; k < pyramid_orientations; ++k) {
            const LightMap& band = of(scale, k);
            std::vector<double>& found = correlations[static_cast<std::size_t>(scale)];
            const int border = border_of(map, scale), far = 2 << scale;
            for (int other = k + 1; other < pyramid_orientations; ++other)
                found.push_back(correlation(band, of(scale, other), border));
            for (const auto& [dx, dy] : {std::pair{far, 0}, {0, far}, {far, far}, {far, -far}})
                found.push_back(correlation(band, band, std::max(0, border - far), dx, dy));
            for (int other = 0; scale + 1 < pyramid_scales && other < pyramid_orientations; ++other)
                found.push_back(correlation(band, of(scale + 1, other), border_of(map, scale + 1)));
        }
    return correlations;
}

}
