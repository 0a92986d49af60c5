#include "analysis/regions/region_curves.hpp"

#include "analysis/statistics/jackknife.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double distances_shown = 4; ///< largest possible minimum distances
constexpr double rows_per_distance = 50;

/// Curves end where a region that is moved so far has less than this share of itself in common with where it was.
constexpr double least_overlap = 0.1;

/// The half width of the kernel of g over the mean spacing (Stoyan, Stoyan, Fractals, Random Shapes and Point Fields,
/// 1994).
constexpr double stoyan = 0.15;

/// Places for F: so many for each point, and at least.
constexpr std::size_t places_a_point = 4, fewest_places = 1 << 13;

std::vector<double> mean_curve(const std::vector<std::vector<double>>& curves)
{
    std::vector<double> mean(curves.front().size());
    for (const auto& curve : curves)
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += curve[k] / static_cast<double>(curves.size());
    return mean;
}

double quotient_of_what_is_left(double g, double f, double j) { return std::isnan(j) ? j : (1 - g) / (1 - f); }

}

RegionCurves::RegionCurves(std::shared_ptr<const FramedRegion> region, std::shared_ptr<const RegionDensity> density,
                           std::size_t points, std::uint32_t envelope)
    : region_(std::move(region)), density_(std::move(density)), points_(points), envelope_(envelope),
      covariance_(region_->boundary().edges())
{
    const double unit = region_->unit_length(), n = static_cast<double>(points);
    distances_.step = max_min_distance(points, 2) * unit / rows_per_distance;
    distances_.half_width = stoyan * unit / std::sqrt(n);
    const double reach = covariance_.reach(least_overlap, distances_shown * rows_per_distance * distances_.step);
    distances_.count = static_cast<std::size_t>(reach / distances_.step * (1 + 1e-9));
    const double pairs = n * std::min(n, n * std::numbers::pi * reach * reach / region_->area()) / 2;
    covariance_.expect(pairs * (1 + envelope), reach + distances_.half_width);
    places_ = std::make_shared<RegionPlaces>(*region_, std::max(places_a_point * points, fewest_places), 2 * reach);
}

RegionCurves::Values RegionCurves::measure(const PointSet& points, const std::string& name, PairCurves& pairs,
                                           bool is_isotropic) const
{
    std::vector<double> intensity;
    if (density_) intensity = density_->intensities(points, *region_, name);
    pairs = region_pairs(points, *region_, covariance_, distances_, intensity, is_isotropic);
    DistanceCurves distances = region_distances(points, *region_, *places_, distances_.step, distances_.count);
    return {pairs.g_smooth, pairs.k_translation, std::move(distances.g), std::move(distances.f),
            std::move(distances.j)};
}

void RegionCurves::add(const PointSet& points, const std::string& name)
{
    PairCurves pairs;
    values_.push_back(measure(points, name, pairs, true));
    pairs_.push_back(std::move(pairs.pairs));
    g_of_bin_.push_back(std::move(pairs.g_of_bin));
    k_isotropic_.push_back(std::move(pairs.k_isotropic));
}

void RegionCurves::append(const RegionCurves& other)
{
    const auto add_to = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    add_to(pairs_, other.pairs_);
    add_to(g_of_bin_, other.g_of_bin_);
    add_to(k_isotropic_, other.k_isotropic_);
    add_to(values_, other.values_);
}

std::vector<RegionCurveRow> RegionCurves::rows() const
{
    if (values_.empty()) return {};
    std::vector<RegionCurveRow> rows(distances_.count);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto k_at = static_cast<std::size_t>(RegionFunction::k), j_at = static_cast<std::size_t>(RegionFunction::j);
    const double side = region_->side();
    const std::vector<double> k_isotropic = mean_curve(k_isotropic_);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].distance = side * distances_.step * static_cast<double>(k + 1);
        rows[k].k_isotropic = k_isotropic[k] * side * side;
        rows[k].low.fill(none);
        rows[k].high.fill(none);
        for (const Values& values : values_)
            for (std::size_t f = 0; f < region_functions; ++f)
                rows[k].value[f] += values[f][k] / static_cast<double>(values_.size());
        double& j = rows[k].value[j_at];
        j = quotient_of_what_is_left(rows[k].of(RegionFunction::nearest), rows[k].of(RegionFunction::empty_space), j);
    }
    const RandomInRegion random(*region_, density_.get());
    for (std::uint32_t e = 0; e < envelope_; ++e) {
        stop_if_interrupted();
        PairCurves pairs;
        const Values values = measure(random.points(points_, e), "random points", pairs, false);
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (std::size_t f = 0; f < region_functions; ++f) {
                rows[k].low[f] = std::fmin(rows[k].low[f], values[f][k]);
                rows[k].high[f] = std::fmax(rows[k].high[f], values[f][k]);
            }
    }
    for (RegionCurveRow& row : rows)
        for (auto* const part : {&row.value, &row.low, &row.high}) (*part)[k_at] *= side * side;
    return rows;
}

std::vector<PairCorrelationBin> RegionCurves::pair_correlation(const std::vector<std::size_t>& groups) const
{
    if (g_of_bin_.empty()) return {};
    const std::vector<double> g = mean_curve(g_of_bin_), pairs = mean_curve(pairs_);
    const std::vector<double> errors = errors_of_mean(g_of_bin_, groups);
    std::vector<PairCorrelationBin> bins(distances_.count);
    for (std::size_t k = 0; k < bins.size(); ++k) {
        bins[k] = {(static_cast<double>(k) + 0.5) * distances_.step / region_->unit_length(), g[k],
                   errors.empty() ? 0 : errors[k], pairs[k]};
    }
    return bins;
}

}
