#include "experiment/series_analysis.hpp"

#include "analysis/distance_statistics.hpp"
#include "errors/errors.hpp"
#include "geometry/relative_radius.hpp"

#include <fmt/format.h>

#include <chrono>

namespace poissonlab {

void SeriesAnalysis::add(const PointSet& points)
{
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t n = points.size();
    const auto problem = [&](const std::string& what) {
        return InputError(fmt::format("{}: realization {} {}", label_, result_.points.size(), what));
    };
    if (n == 0) throw problem("has no points");
    if (points.dimension != 2) throw problem("is not 2D: this version analyses 2D sets only");
    if (!sizes_vary_ && !result_.points.empty() && n != result_.points.front())
        throw problem(fmt::format("has {} points where the first has {}", n, result_.points.front()));

    const double distance = min_toroidal_distance(points);
    result_.points.push_back(n);
    result_.min_distance.push_back(distance);
    result_.relative_radius.push_back(relative_radius(distance, n, points.dimension));
    result_.covered_fraction.push_back(covered_fraction(distance, n, points.dimension));

    if (sum_.size == 0) {
        sum_.size = spectrum_size(n, points.dimension);
        sum_.points = n;
        result_.spectrum_size = sum_.size;
    }
    const std::vector<double> periodogram = exact_periodogram(points, sum_.size);
    sum_.power.resize(periodogram.size());
    for (std::size_t i = 0; i < periodogram.size(); ++i) sum_.power[i] += periodogram[i];
    ++sum_.realizations;
    result_.analysis_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Spectrum SeriesAnalysis::mean_spectrum() const
{
    Spectrum mean = sum_;
    for (double& power : mean.power) power /= static_cast<double>(mean.realizations);
    return mean;
}

}
