#include "host/measuring/series_analysis.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/packing_fraction.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "analysis/spectra/radial_bin.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::size_t most_points_triangulated = 300'000;
constexpr double distances_shown = 4; // in units of the largest possible minimum distance, with
constexpr double bins_per_distance = 50;
constexpr std::uint64_t shift_seed = 0; // the same shifts of every series, so that errors compare
constexpr int integration_shifts = 16;

}

/// A set must be like the first one.
void SeriesAnalysis::check(int dimension, std::size_t points, std::size_t realization) const
{
    const std::string name = fmt::format("{}: realization {}", label_, realization);
    if (points == 0) throw InputError(name + " has no points");
    if (begin_.points == 0) return;
    if (dimension_ > 0 && dimension != dimension_)
        throw InputError(fmt::format("{} has dimension {} where the first has {}", name, dimension, dimension_));
    if (!sizes_vary_ && points != begin_.points)
        throw InputError(fmt::format("{} has {} points where the first has {}", name, points, begin_.points));
}

/// Makes the averages over sets, for sets like the first one.
void SeriesAnalysis::start()
{
    has_started_ = true;
    if (has_spectrum()) start_spectrum();
    if (options_.distances_only) return;
    integration_.emplace(dimension_, shift_seed, integration_shifts, begin_.realization);
    if (result_.has_pair_correlation) start_pairs();
}

void SeriesAnalysis::start_pairs()
{
    const double step = max_min_distance(begin_.points, dimension_) / bins_per_distance;
    const double end = std::min(distances_shown * bins_per_distance * step, largest_toroidal_distance(dimension_));
    pairs_.emplace(dimension_, end, static_cast<std::size_t>(std::ceil(end / step)));
}

void SeriesAnalysis::start_spectrum()
{
    result_.spectrum_size =
        options_.spectrum_size > 0 ? options_.spectrum_size : spectrum_size(begin_.points, dimension_);
    if (RadialBins(result_.spectrum_size, options_.bin_width).count() < 2)
        throw InputError(fmt::format("{}: bin_width = {}: must be at most {}, so that one {} fits into the spectrum of "
                                     "size {}",
                                     label_, options_.bin_width, result_.spectrum_size / 2 - 1,
                                     dimension_ == 2 ? "annulus" : "shell", result_.spectrum_size));
    estimate_.emplace(dimension_, result_.spectrum_size, sizes_vary_, *options_.spectrum, options_.bin_width);
}

void SeriesAnalysis::add(const PointSet& points)
{
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t n = points.size();
    check(points.dimension, n, begin_.realization + result_.points.size());
    const bool is_first = result_.points.empty();
    result_.points.push_back(n);
    if (is_first) {
        dimension_ = points.dimension;
        if (begin_.points == 0) begin_.points = n;
        result_.has_pair_correlation = n > 1 && begin_.points > 1 && !options_.distances_only;
        if (begin_.realization == 0 && !options_.distances_only) first_ = points;
        start();
    }
    if (estimate_) {
        estimate_->add(points);
        if (options_.tiles > 0)
            peak_ratios_.push_back(lattice_peaks(estimate_->last_periodogram(), n, options_.tiles).mean_ratio);
    }
    if (integration_) integration_->add(points);
    if (n < 2) leave_out_pairs();
    if (pairs_) pairs_->add(points);
    const double distance = min_toroidal_distance(points);
    result_.min_distance.push_back(distance);
    result_.relative_radius.push_back(relative_radius(distance, n, points.dimension));
    result_.covered_fraction.push_back(covered_fraction(distance, n, points.dimension));
    if (integration_) result_.measures.integration = integration_->mean();
    result_.analysis_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A set of one point has no pairs, and a mean over some of the sets would mislead.
void SeriesAnalysis::leave_out_pairs()
{
    pairs_.reset();
    result_.has_pair_correlation = false;
}

void SeriesAnalysis::append(const SeriesAnalysis& next)
{
    const SeriesResult& more = next.result_;
    for (std::size_t i = 0; i < more.points.size(); ++i)
        check(next.dimension_, more.points[i], next.begin_.realization + i);
    const auto append_to = [](auto& values, const auto& others) {
        values.insert(values.end(), others.begin(), others.end());
    };
    append_to(result_.points, more.points);
    append_to(result_.min_distance, more.min_distance);
    append_to(result_.relative_radius, more.relative_radius);
    append_to(result_.covered_fraction, more.covered_fraction);
    append_to(peak_ratios_, next.peak_ratios_);
    if (estimate_) estimate_->append(next.estimate_.value());
    if (!next.pairs_) leave_out_pairs();
    if (pairs_) pairs_->append(*next.pairs_);
    if (integration_) {
        integration_->append(next.integration_.value());
        result_.measures.integration = integration_->mean();
    }
    result_.analysis_seconds += more.analysis_seconds;
}

void SeriesAnalysis::measure_first()
{
    const PointSet first = std::exchange(first_, {});
    if (first.size() == 0) return;
    SeriesMeasures& measures = result_.measures;
    if (first.size() > 1) measures.packing_fraction = packing_fraction(first);
    if (first.size() > most_points_triangulated) return; // not of millions of points
    tbb::parallel_invoke([&] { measures.largest_empty = largest_empty_ball(first); },
                         [&] {
                             if (first.dimension == 2) measures.voronoi = voronoi_statistics(voronoi_diagram(first));
                         });
}

void SeriesAnalysis::measure_spectrum(const Spectrum& mean)
{
    // Measures are defined on bins one sample wide, whatever the curve has.
    const std::vector<RadialBin> radial = radial_statistics(mean);
    const std::size_t n = result_.points.front();
    SeriesMeasures& measures = result_.measures;
    measures.effective_nyquist = effective_nyquist_frequency(radial, n, mean.dimension);
    measures.oscillation = oscillation(radial, n, mean.dimension, static_cast<int>(result_.points.size()));
    measures.peak_anisotropy = peak_anisotropy(radial, static_cast<int>(result_.points.size()));
    measures.low_frequency_power = low_frequency_power(radial, low_frequency_range(n, mean.dimension));
    if (options_.tiles > 0) measures.lattice_peaks = lattice_peaks(mean, options_.tiles);
    if (result_.points.size() > 1) measure_errors(radial, mean.dimension);
}

/// Standard errors from how much the measures depend on single realizations.
void SeriesAnalysis::measure_errors(std::vector<RadialBin> radial, int dimension)
{
    const std::size_t n = result_.points.front();
    const int others = static_cast<int>(result_.points.size()) - 1;
    const auto with_power = [&](const std::vector<double>& power) -> const std::vector<RadialBin>& {
        for (std::size_t k = 0; k < radial.size(); ++k) radial[k].power = power[k];
        return radial;
    };
    const auto& curves = estimate_.value().radial_curves();
    SeriesMeasures& measures = result_.measures;
    measures.effective_nyquist_error = jackknife_error(curves, [&](const std::vector<double>& power) {
        return effective_nyquist_frequency(with_power(power), n, dimension);
    });
    measures.oscillation_error = jackknife_error(curves, [&](const std::vector<double>& power) {
        return oscillation(with_power(power), n, dimension, others).value;
    });
    if (!peak_ratios_.empty()) measures.lattice_peaks_error = standard_error_of_mean(peak_ratios_);
}

std::vector<PairCorrelationBin> SeriesAnalysis::pair_correlation() const
{
    return pairs_ ? pairs_->mean() : std::vector<PairCorrelationBin>{};
}

Spectrum SeriesAnalysis::mean_spectrum() const { return estimate_.value().mean(); }

std::vector<RadialBin> SeriesAnalysis::radial_curve(const Spectrum& mean) const
{
    std::vector<RadialBin> bins = radial_statistics(mean, options_.bin_width);
    const std::vector<double> errors = estimate_.value().radial_errors();
    for (std::size_t k = 0; k < errors.size(); ++k) bins[k].power_error = errors[k];
    return bins;
}

}
