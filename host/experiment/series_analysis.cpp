#include "experiment/series_analysis.hpp"

#include "analysis/distance_statistics.hpp"
#include "errors/errors.hpp"
#include "geometry/relative_radius.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace poissonlab {

void SeriesAnalysis::add(const PointSet& points)
{
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t n = points.size();
    if (!estimate_) {
        result_.spectrum_size = spectrum_size(std::max<std::size_t>(n, 1), points.dimension);
        estimate_.emplace(points.dimension, result_.spectrum_size, sizes_vary_, method_);
    }
    try {
        estimate_->add(points);
    } catch (const InputError& error) {
        throw InputError(label_ + ": " + error.what());
    }
    const double distance = min_toroidal_distance(points);
    result_.points.push_back(n);
    result_.min_distance.push_back(distance);
    result_.relative_radius.push_back(relative_radius(distance, n, points.dimension));
    result_.covered_fraction.push_back(covered_fraction(distance, n, points.dimension));
    result_.analysis_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Spectrum SeriesAnalysis::mean_spectrum() const { return estimate_.value().mean(); }

std::vector<RadialBin> SeriesAnalysis::radial_curve(const Spectrum& mean) const
{
    std::vector<RadialBin> bins = radial_statistics(mean);
    const std::vector<double> errors = estimate_.value().radial_errors();
    for (std::size_t k = 0; k < errors.size(); ++k) bins[k].power_error = errors[k];
    return bins;
}

}
