#include "experiment/measuring/series_analysis.hpp"

#include "analysis/borders/border_pairs.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/measures/off_lattice_anisotropy.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "analysis/spectra/radial_bin.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/side_by_side.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

constexpr double distances_shown = 4; // in units of the largest possible minimum distance, with
constexpr double bins_per_distance = 50;
constexpr std::uint64_t shift_seed = 0; // the same shifts of every series, so that errors compare
constexpr int integration_shifts = 16;

/// One annulus of the unit torus ends before frequency M/2.
double largest_bin_width(int size, const PeriodicBox& box)
{
    if (box.is_unit()) return size / 2 - 1;
    return (0.5 * size - 0.5) / box.longest() - 0.5;
}

/// Rings are one cycle wide.
bool ends_within(const FrequencyRange& range, const std::vector<RadialBin>& radial)
{
    return !radial.empty() && range.end < radial.back().frequency + 1;
}

}

bool SeriesAnalysis::reaches_as_asked() const
{
    return estimate_ && spectrum_size_ >= size_asked_for(sets_.front().points, dimension_, box_);
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
    if (options_.tiles > 0) seams_.emplace(dimension_, options_.tiles, begin_.points);
    if (options_.tiles > 0 && dimension_ == 2) folded_.emplace(options_.tiles, begin_.points);
    if (region_) {
        if (has_pairs_) region_->start_curves(begin_.points);
        return;
    }
    if (begin_.points >= NumberVarianceEstimate::least_points(dimension_))
        variance_.emplace(dimension_, begin_.points, options_.window, box_);
    if (options_.distances_only) return;
    if (!options_.window && box_.is_unit())
        integration_.emplace(dimension_, shift_seed, integration_shifts, begin_.realization);
    if (has_pairs_) start_pairs();
}

void SeriesAnalysis::start_pairs()
{
    const double step = max_min_distance(begin_.points, dimension_) / bins_per_distance;
    const double largest = box_.is_unit() ? largest_toroidal_distance(dimension_) : box_.shortest() / 2;
    const double end = std::min(distances_shown * bins_per_distance * step, largest);
    pairs_.emplace(dimension_, end, static_cast<std::size_t>(std::ceil(end / step)), options_.window, box_);
}

void SeriesAnalysis::start_spectrum()
{
    spectrum_size_ =
        options_.spectrum_size > 0 ? options_.spectrum_size : spectrum_size(begin_.points, dimension_, box_);
    if (options_.region) spectrum_size_ = std::min(spectrum_size_, largest_region_spectrum);
    if (RadialBins(spectrum_size_, options_.bin_width, box_).count() < 2)
        throw InputError(fmt::format("{}: bin_width = {}: must be at most {}, so that one {} fits into the spectrum of "
                                     "size {}",
                                     label_, options_.bin_width, largest_bin_width(spectrum_size_, box_),
                                     dimension_ == 2 ? "annulus" : "shell", spectrum_size_));
    estimate_.emplace(dimension_, spectrum_size_, sizes_vary_, *options_.spectrum, options_.bin_width);
    estimate_->lie_in(box_);
    if (region_) region_->start_spectrum(*estimate_, spectrum_size_, *options_.spectrum);
}

void SeriesAnalysis::add_to_spectrum(const PointSet& points)
{
    if (region_)
        region_->add_to(*estimate_, points);
    else
        estimate_->add(points);
}

/// A set of one point has no pairs, and a mean over some of the sets would mislead.
void SeriesAnalysis::leave_out_pairs()
{
    pairs_.reset();
    if (region_) region_->leave_out_curves();
    has_pairs_ = false;
}

bool SeriesAnalysis::repeats(const SeriesAnalysis& earlier) const
{
    return std::ranges::any_of(
        sets_, [&](const SetMark& mark) { return earlier.is_known(mark); }, &SetMeasures::mark);
}

void SeriesAnalysis::leave_out(const SeriesAnalysis& earlier)
{
    for (const SetMeasures& set : earlier.sets_) left_out_.push_back(set.mark);
}

void SeriesAnalysis::append(const SeriesAnalysis& next)
{
    if (next.repeats(*this)) throw std::invalid_argument("SeriesAnalysis::append: a set is there already");
    for (const SetMeasures& set : next.sets_) check(next.dimension_, set.points, set.realization);
    repeated_.insert(repeated_.end(), next.repeated_.begin(), next.repeated_.end());
    seconds_ += next.seconds_;
    if (next.sets_.empty()) return;
    sets_.insert(sets_.end(), next.sets_.begin(), next.sets_.end());
    shell_powers_.insert(shell_powers_.end(), next.shell_powers_.begin(), next.shell_powers_.end());
    if (estimate_) estimate_->append(next.estimate_.value());
    if (!next.pairs_ && !(next.region_ && next.region_->has_curves())) leave_out_pairs();
    if (pairs_) pairs_->append(*next.pairs_);
    if (integration_) integration_->append(next.integration_.value());
    if (seams_) seams_->append(next.seams_.value());
    if (folded_) folded_->append(next.folded_.value());
    if (variance_) variance_->append(next.variance_.value());
    if (region_) region_->append(*next.region_);
    if (options_.zone_plate) zone_plate_.append(next.zone_plate_);
}

std::optional<Statistic> SeriesAnalysis::statistic(double SetMeasures::*member) const
{
    std::vector<double> each;
    for (const SetMeasures& set : sets_) each.push_back(set.*member);
    return statistic_of(each);
}

/// The mean over the sets, and its standard error where there are several.
Estimate SeriesAnalysis::mean_of(double SetMeasures::*member) const
{
    std::vector<double> each;
    for (const SetMeasures& set : sets_) each.push_back(set.*member);
    Estimate mean{std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size()), {}};
    const auto groups = group_means(each, independent_groups());
    if (groups.size() > 1) mean.standard_error = standard_error_of_mean(groups);
    if (mean.standard_error && !std::isfinite(*mean.standard_error)) mean.standard_error.reset();
    return mean;
}

/// The sets' border, whose closest pairs are those of all sets together.
BorderResult SeriesAnalysis::border_result() const
{
    BorderResult border;
    std::size_t fewest = sets_.front().points;
    for (const SetMeasures& set : sets_) {
        border.pairs_across += set.across;
        fewest = std::min(fewest, set.points);
    }
    border.chance = chance_of_pairs_across(border.pairs_across, sets_.size(), fewest, dimension_, options_.tiles, box_);
    border.relative_radius = mean_of(&SetMeasures::window_radius).value;
    border.mean_nearest_distance = mean_of(&SetMeasures::window_nearest).value;
    return border;
}

Series SeriesAnalysis::result() const
{
    Series series;
    std::vector<std::size_t> sizes;
    for (const SetMeasures& set : sets_) sizes.push_back(set.points);
    series.set_sizes(sizes);
    series.repeated = repeated_;
    series.min_distance = statistic(&SetMeasures::min_distance);
    series.relative_radius = statistic(&SetMeasures::relative_radius);
    series.covered_fraction = statistic(&SetMeasures::covered_fraction);
    series.measures = measures_;
    series.measures.numbers.insert(numbers_of_first_.begin(), numbers_of_first_.end());
    if (series.relative_radius) series.measures.numbers["mean_nearest_distance"] = mean_of(&SetMeasures::mean_nearest);
    if (finds_border() && series.relative_radius) series.border = border_result();
    if (options_.progressive) series.measures.numbers["prefix_relative_radius"] = mean_of(&SetMeasures::prefix_radius);
    if (options_.tiles > 1)
        if (const Estimate within = mean_of(&SetMeasures::radius_within); std::isfinite(within.value))
            series.measures.numbers["relative_radius_within_tiles"] = within;
    if (integration_) series.measures.integration = integration_->mean(independent_groups());
    if (reaches_as_asked() && options_.tiles > 0)
        series.measures.numbers["lattice_share"] = mean_of(&SetMeasures::lattice_share);
    if (seams_) {
        if (const auto deviation = seams_->largest_deviation())
            series.measures.numbers["seam_density"] = {*deviation, {}};
        if (const auto density = seams_->border_density()) series.measures.numbers["border_density"] = {*density, {}};
    }
    series.is_window = options_.window;
    if (!options_.box_sides.empty()) series.box = BoxResult{options_.box_sides};
    series.spectrum_size = spectrum_size_;
    if (region_) series.region = region_->result();
    if (!region_picture_.empty()) series.region->picture_file = file_names::region_picture;
    if (region_ ? !series.region->file.empty() : has_pairs_)
        series.pair_correlation_file = file_names::pair_correlation;
    if (!number_variance().empty()) series.number_variance_file = file_names::number_variance;
    if (folded_) series.folded_density = {folded_->size(), file_names::folded_density};
    if (options_.zone_plate) series.zone_plate = zone_plate_.result();
    series.analysis_seconds = seconds_ + zone_plate_.seconds();
    return series;
}

void SeriesAnalysis::measure_first()
{
    const PointSet first = std::exchange(first_, {});
    if (first.size() == 0) return;
    if (region_) {
        region_picture_ = region_->picture(first);
        return;
    }
    if (first.size() > most_points_triangulated) return; // not of millions of points
    do_side_by_side([&] { measures_.largest_empty = largest_empty_ball(first); },
                    [&] {
                        if (first.dimension == 2) measures_.voronoi = voronoi_statistics(voronoi_diagram(first));
                    });
}

void SeriesAnalysis::measure_spectrum(const Spectrum& mean)
{
    // Measures are defined on bins one sample wide, whatever the curve has.
    const std::vector<RadialBin> radial = radial_statistics(mean);
    const std::size_t n = sets_.front().points;
    if (const auto nyquist = effective_nyquist_frequency(radial, n, mean.dimension))
        measures_.numbers["effective_nyquist"] = {*nyquist, {}};
    const FrequencyRange low = low_frequency_range(n, mean.dimension);
    if (ends_within(low, radial)) {
        measures_.low_frequency_power = low_frequency_power(radial, low);
        if (const auto power = mean_power_in(radial, low)) measures_.numbers["low_frequency_mean"] = {*power, {}};
        if (!options_.region) measure_hyperuniformity(mean);
    }
    if (reaches_as_asked()) measure_whole(radial, mean);
    measure_errors(radial, mean);
    measure_peak_error(radial, mean);
}

/// The measures that look at all frequencies, and are others where a spectrum ends early.
void SeriesAnalysis::measure_whole(const std::vector<RadialBin>& radial, const Spectrum& mean)
{
    measures_.oscillation = oscillation(radial, sets_.front().points, mean.dimension);
    measures_.peak_anisotropy = peak_anisotropy(radial);
    // Curves of tapers are not independent of each other: what chance gives is not known.
    if (const auto above = anisotropy_above_chance_db(radial, mean.realizations); above && !has_tapers())
        measures_.numbers["anisotropy_above_chance"] = {*above, {}};
    if (options_.tiles > 0) {
        measures_.lattice_peaks = lattice_peaks(mean, options_.tiles);
        if (const auto near = near_lattice_peaks(mean, options_.tiles)) {
            measures_.numbers["near_lattice_peaks"] = {near->mean_ratio, {}};
            measures_.numbers["lattice_excess"] = {near->excess_share, {}};
        }
        if (const auto db = off_lattice_anisotropy_db(mean, options_.tiles))
            measures_.numbers["off_lattice_anisotropy"] = {*db, {}};
    }
}

void SeriesAnalysis::measure_hyperuniformity(const Spectrum& mean)
{
    const std::size_t n = sets_.front().points;
    const int realizations = static_cast<int>(sets_.size());
    const auto low = power_shells(mean, hyperuniform_range(n, mean.dimension, options_.tiles, box_));
    if (const auto exponent = hyperuniformity_exponent(low, realizations, zero_power(mean))) {
        measures_.numbers["hyperuniformity_exponent"] = {exponent->value, exponent->standard_error};
        measure_exponent_error(low, realizations, zero_power(mean));
    }
    const auto lowest = power_shells(mean, hyperuniformity_test_range(n, mean.dimension, options_.tiles, box_));
    if (const auto p = hyperuniformity_p_value(lowest, realizations, zero_power(mean)))
        measures_.numbers["hyperuniformity_p_value"] = {*p, {}};
}

std::vector<PairCorrelationBin> SeriesAnalysis::pair_correlation() const
{
    if (region_) return region_->pair_correlation(independent_groups());
    return pairs_ ? pairs_->mean(independent_groups()) : std::vector<PairCorrelationBin>{};
}

std::vector<RegionCurveRow> SeriesAnalysis::region_curves() const
{
    return region_ ? region_->rows() : std::vector<RegionCurveRow>{};
}

std::vector<NumberVarianceBin> SeriesAnalysis::number_variance() const
{
    return variance_ ? variance_->mean(independent_groups()) : std::vector<NumberVarianceBin>{};
}

std::optional<SquareImage> SeriesAnalysis::folded_density() const
{
    return folded_ ? std::optional(folded_->densities()) : std::nullopt;
}

Spectrum SeriesAnalysis::mean_spectrum() const { return estimate_.value().mean(); }

std::vector<RadialBin> SeriesAnalysis::radial_curve(const Spectrum& mean) const
{
    std::vector<RadialBin> bins = radial_statistics(mean, options_.bin_width);
    std::vector<double> errors = estimate_.value().radial_errors(independent_groups(curves_of_set()));
    if (has_tapers() && sets_.size() == 1) errors = region_->ring_errors(bins, spectrum_size_, options_.bin_width);
    for (std::size_t k = 0; k < errors.size(); ++k) bins[k].power_error = errors[k];
    return bins;
}

}
