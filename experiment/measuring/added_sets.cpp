// A SeriesAnalysis takes a set, which is in memory or on the disk.
#include "experiment/measuring/series_analysis.hpp"

#include "analysis/borders/border_pairs.hpp"
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/hyperuniformity.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/tilings/tiled_sets.hpp"
#include "base/geometry/relative_radius.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <type_traits>

namespace poissonlab {
namespace {

int dimension_of(const PointSet& points) { return points.dimension; }
int dimension_of(const PointStrips& points) { return points.dimension(); }

/// Calls `what` with all points, in parts.
void for_each_part(const PointSet& points, const auto& what) { what(points); }
void for_each_part(const PointStrips& points, const auto& what)
{
    for (std::size_t strip = 0; strip < points.count(); ++strip) what(points.strip(strip));
}

}

/// Finds the least and the mean nearest distance of a set as a window, or as what the options say.
NearestDistances SeriesAnalysis::distances(const PointSet& points, bool is_window) const
{
    if (region_) return region_->nearest(points);
    const PeriodicBox box = options_.window ? PeriodicBox{} : box_;
    if (is_window) return {min_distance_in_window(points, box), mean_nearest_distance_in_window(points, box)};
    return {min_toroidal_distance(points, box), mean_nearest_distance(points, box)};
}

NearestDistances SeriesAnalysis::distances(const PointStrips& points, bool is_window) const
{
    return nearest_distances(points, is_window);
}

std::uint32_t SeriesAnalysis::next_realization() const
{
    return static_cast<std::uint32_t>(begin_.realization + sets_.size() + repeated_.size());
}

template <class Points>
SeriesAnalysis::SetMeasures SeriesAnalysis::measure_distances(const Points& points) const
{
    const auto [least, mean] = distances(points, options_.window);
    const std::size_t n = points.size();
    const int dimension = dimension_of(points);
    SetMeasures set{n, next_realization(), {}};
    set.min_distance = least;
    set.relative_radius = relative_radius(least, n, dimension);
    set.mean_nearest = mean / max_min_distance(n, dimension);
    set.covered_fraction = covered_fraction(least, n, dimension);
    SetMarkSums sums;
    for_each_part(points, [&](const PointSet& part) { sums.add(part); });
    set.mark = sums.mark(least, set.mean_nearest);
    return set;
}

bool SeriesAnalysis::is_known(const SetMark& mark) const
{
    const auto is_same = [&](const SetMark& other) { return are_same_set(mark, other); };
    return std::ranges::any_of(sets_, is_same, &SetMeasures::mark) || std::ranges::any_of(left_out_, is_same);
}

/// Measures without wrapping, and the pairs that only wrapping makes so close.
template <class Points>
void SeriesAnalysis::measure_border(const Points& points, SetMeasures& set) const
{
    const NearestDistances inside = distances(points, true);
    set.window_radius = relative_radius(inside.least, points.size(), dimension_of(points));
    set.window_nearest = inside.mean / max_min_distance(points.size(), dimension_of(points));
    if constexpr (std::is_same_v<Points, PointSet>)
        set.across = closer_pairs_across(points, inside.least, box_);
    else
        set.across = closer_pairs_across(points, inside.least);
}

/// Measures of the order of points and of their tiles.
template <class Points>
void SeriesAnalysis::measure_order(const Points& points, SetMeasures& set) const
{
    if constexpr (std::is_same_v<Points, PointSet>) // sets on disk have no order
        if (options_.progressive) set.prefix_radius = prefix_radius(points);
    if (options_.tiles > 1)
        set.radius_within =
            relative_radius(min_distance_within_tiles(points, options_.tiles), points.size(), dimension_of(points));
}

/// The least distance of two points: across the borders of a torus, in roots of the area in a region.
double SeriesAnalysis::least_distance(const PointSet& points) const
{
    if (region_) return region_->nearest(points).least;
    return options_.window ? min_distance_in_window(points) : min_toroidal_distance(points, box_);
}

/// Keeps the set for measures of the first one.
void SeriesAnalysis::keep_first(const PointSet& points)
{
    const bool is_triangulated =
        !options_.distances_only && !options_.window && box_.is_unit() && points.size() <= most_points_triangulated;
    if (begin_.realization == 0 && (options_.region || is_triangulated)) first_ = points;
}

template <class Points>
bool SeriesAnalysis::add_set(const Points& points)
{
    const auto begin = std::chrono::steady_clock::now();
    const auto count_seconds = [&] {
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const std::size_t n = points.size();
    check(dimension_of(points), n, next_realization());
    SetMeasures set = measure_distances(points);
    if (is_known(set.mark)) {
        repeated_.push_back(set.realization);
        count_seconds();
        return false;
    }
    if (sets_.empty()) {
        dimension_ = dimension_of(points);
        if (begin_.points == 0) begin_.points = n;
        has_pairs_ = n > 1 && begin_.points > 1 && !options_.distances_only;
        keep_first(points);
        start();
    }
    if (estimate_) {
        add_to_spectrum(points);
        if (!options_.region) {
            const FrequencyRange range = hyperuniform_range(begin_.points, dimension_, options_.tiles, box_);
            shell_powers_.push_back(powers_of(power_shells(estimate_->last_periodogram(), range)));
        }
        if (options_.tiles > 0) {
            set.lattice_shells = lattice_shell_powers(estimate_->last_periodogram(), begin_.points, options_.tiles);
            set.lattice_share = lattice_share(estimate_->last_periodogram(), options_.tiles);
            set.near_lattice = near_lattice_powers(estimate_->last_periodogram(), begin_.points, options_.tiles);
        }
    }
    measure_order(points, set);
    if (finds_border()) measure_border(points, set);
    sets_.push_back(set);
    if (integration_) integration_->add(points);
    if (seams_) for_each_part(points, [&](const PointSet& part) { seams_->add(part); });
    if (folded_) for_each_part(points, [&](const PointSet& part) { folded_->add(part); });
    if (variance_) variance_->add(points);
    if (n < 2) leave_out_pairs();
    if (pairs_) pairs_->add(points);
    if constexpr (std::is_same_v<Points, PointSet>) // sets in regions are in memory
        if (region_) region_->add(points, fmt::format("{}: realization {}", label_, set.realization));
    count_seconds();
    return true;
}

bool SeriesAnalysis::add(const PointSet& points)
{
    const bool is_new = options_.region ? add_set(options_.region->region->framed(
                                              points, fmt::format("{}: realization {}", label_, next_realization())))
                                        : add_set(points);
    if (is_new && options_.zone_plate) zone_plate_.add(points);
    return is_new;
}

bool SeriesAnalysis::add(const PointStrips& points) { return add_set(points); }

/// The smallest relative radius of the first half, the first quarter and the first eighth of a set, as sets of so many
/// points; parts of one point have none.
double SeriesAnalysis::prefix_radius(const PointSet& points) const
{
    double smallest = 1;
    for (std::size_t n = points.size() / 2; n > 1 && 8 * n + 8 > points.size(); n /= 2) {
        PointSet part{points.dimension, {}};
        const auto begin = points.coordinates.begin();
        part.coordinates.assign(begin,
                                begin + static_cast<std::ptrdiff_t>(n * static_cast<std::size_t>(part.dimension)));
        const double distance = least_distance(part);
        smallest = std::min(smallest, relative_radius(distance, n, part.dimension));
    }
    return smallest;
}

}
