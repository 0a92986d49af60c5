#include "experiment/series_analysis.hpp"

#include "analysis/distance_statistics.hpp"
#include "analysis/packing_fraction.hpp"
#include "errors/errors.hpp"
#include "geometry/relative_radius.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace poissonlab {
namespace {

constexpr std::size_t most_points_triangulated = 300'000;

}

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
    if (result_.points.empty()) measure_first(points);
    result_.points.push_back(n);
    result_.min_distance.push_back(distance);
    result_.relative_radius.push_back(relative_radius(distance, n, points.dimension));
    result_.covered_fraction.push_back(covered_fraction(distance, n, points.dimension));
    result_.analysis_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// These take Delaunay triangulations: of one set only, and not of millions of points.
void SeriesAnalysis::measure_first(const PointSet& points)
{
    SeriesMeasures& measures = result_.measures;
    if (points.size() > 1) measures.packing_fraction = packing_fraction(points);
    if (points.size() > most_points_triangulated) return;
    measures.largest_empty = largest_empty_ball(points);
    if (points.dimension == 2) measures.voronoi = voronoi_statistics(voronoi_diagram(points));
}

void SeriesAnalysis::measure_spectrum(const std::vector<RadialBin>& radial)
{
    const std::size_t n = result_.points.front();
    const int dimension = estimate_.value().dimension();
    SeriesMeasures& measures = result_.measures;
    measures.effective_nyquist = effective_nyquist_frequency(radial, n, dimension);
    measures.oscillation = oscillation(radial, n, dimension, static_cast<int>(result_.points.size()));
    measures.low_frequency_power = low_frequency_power(radial, low_frequency_range(n, dimension));
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
