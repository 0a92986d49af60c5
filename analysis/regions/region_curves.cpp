#include "analysis/regions/region_curves.hpp"

#include "analysis/regions/plane_neighbours.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double least_share = 0.01; ///< Ripley's weights are at most one over it
constexpr std::size_t chunks = 64;   ///< fixed, so that sums are the same with any number of threads

/// Sums over pairs of points.
struct PairSums
{
    explicit PairSums(std::size_t count) : pairs(count), translation(count), isotropic(count), smooth(count) {}

    void add(const PairSums& other)
    {
        const auto add_to = [](std::vector<double>& sum, const std::vector<double>& part) {
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
        };
        add_to(pairs, other.pairs);
        add_to(translation, other.translation);
        add_to(isotropic, other.isotropic);
        add_to(smooth, other.smooth);
    }

    std::vector<double> pairs, translation, isotropic, smooth;
};

class PairCollector
{
public:
    PairCollector(const PlaneNeighbours& points, const FramedRegion& region, const SetCovariance& covariance,
                  const PairDistances& distances, std::vector<double> inverse_intensity, bool is_isotropic)
        : points_(points), region_(region), covariance_(covariance), distances_(distances),
          inverse_(std::move(inverse_intensity)), is_isotropic_(is_isotropic)
    {}

    PairSums collect(std::size_t first, std::size_t end) const
    {
        PairSums sums(distances_.count);
        for (std::size_t i = first; i < end; ++i) add_pairs_of(i, sums);
        return sums;
    }

private:
    /// Each pair is met from both of its points: those of the translation correction count from the first.
    void add_pairs_of(std::size_t i, PairSums& sums) const
    {
        const auto place = points_.place(i);
        const double reach = distances_.reach();
        double boundary = 0;
        std::vector<RegionEdge> edges;
        if (is_isotropic_) {
            boundary = region_.boundary().distance(place, reach);
            if (boundary < reach) edges = region_.boundary().edges_near(place, reach);
        }
        points_.for_each_near(place, reach + distances_.half_width, [&](std::size_t j, double squared) {
            if (i == j) return;
            const double distance = std::sqrt(squared), weight = inverse_[i] * inverse_[j];
            if (is_isotropic_ && distance <= reach) {
                const double share = distance <= boundary ? 1 : share_of_circle(place, distance, edges);
                sums.isotropic[bin_of(distance)] += weight / std::max(share, least_share);
            }
            if (j < i) add_translation(place, points_.place(j), distance, weight, sums);
        });
    }

    void add_translation(const std::array<double, 2>& a, const std::array<double, 2>& b, double distance, double weight,
                         PairSums& sums) const
    {
        const double common = covariance_.at(a[0] - b[0], a[1] - b[1]);
        const double w = common > covariance_.least_common_area() ? 2 * weight / common : 0;
        if (distance <= distances_.reach()) {
            sums.translation[bin_of(distance)] += w;
            ++sums.pairs[bin_of(distance)];
        }
        if (distance == 0) return;
        const double step = distances_.step, half = distances_.half_width;
        const auto first = static_cast<std::size_t>(std::max(1.0, std::ceil((distance - half) / step)));
        const auto last = static_cast<std::size_t>((distance + half) / step);
        for (std::size_t k = first; k <= std::min(last, distances_.count); ++k) {
            const double t = (static_cast<double>(k) * step - distance) / half;
            sums.smooth[k - 1] += w * std::max(0.0, 1 - t * t) / distance;
        }
    }

    /// The bin whose end is the first of at least that distance.
    std::size_t bin_of(double distance) const
    {
        const auto bin = static_cast<std::size_t>(std::max(1.0, std::ceil(distance / distances_.step)));
        return std::min(bin, distances_.count) - 1;
    }

    const PlaneNeighbours& points_;
    const FramedRegion& region_;
    const SetCovariance& covariance_;
    PairDistances distances_;
    std::vector<double> inverse_;
    bool is_isotropic_;
};

/// One over the intensity, in the order of the neighbours' grid.
std::vector<double> inverse_intensities(const PlaneNeighbours& sorted, const PointSet& points, double area,
                                        std::span<const double> intensity)
{
    const auto n = static_cast<double>(points.size());
    if (intensity.empty()) return std::vector<double>(points.size(), area / n);
    std::vector<double> inverse(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) inverse[sorted.number_of(i)] = 1 / intensity[i];
    return inverse;
}

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

PairCurves region_pairs(const PointSet& points, const FramedRegion& region, const SetCovariance& covariance,
                        const PairDistances& distances, std::span<const double> intensity, bool is_isotropic)
{
    const PlaneNeighbours sorted(points, region.area());
    const PairCollector collector(sorted, region, covariance, distances,
                                  inverse_intensities(sorted, points, region.area(), intensity), is_isotropic);
    const std::size_t n = points.size();
    std::vector<PairSums> parts(chunks, PairSums(distances.count));
    tbb::parallel_for(std::size_t{0}, chunks,
                      [&](std::size_t c) { parts[c] = collector.collect(n * c / chunks, n * (c + 1) / chunks); });
    PairSums sums(distances.count);
    for (const PairSums& part : parts) sums.add(part);

    PairCurves curves;
    curves.pairs = sums.pairs;
    const double all = static_cast<double>(n) / (static_cast<double>(n) - 1);
    double translation = 0, isotropic = 0;
    for (std::size_t k = 0; k < distances.count; ++k) {
        translation += all * sums.translation[k];
        isotropic += all * sums.isotropic[k] / region.area();
        curves.k_translation.push_back(translation);
        if (is_isotropic) curves.k_isotropic.push_back(isotropic);
        const double ring = std::numbers::pi * distances.step * distances.step * (2 * static_cast<double>(k) + 1);
        curves.g_of_bin.push_back(all * sums.translation[k] / ring);
        curves.g_smooth.push_back(all * sums.smooth[k] * 0.75 / distances.half_width / (2 * std::numbers::pi));
    }
    return curves;
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
