#include "analysis/classes/class_pairs.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/regions/plane_neighbours.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random_words.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::size_t chunks = 64; ///< fixed, so that sums are the same with any number of threads
constexpr double rows_per_distance = 50;
constexpr double distances_shown = 4; ///< times the distance of the densest packing
constexpr double stoyan = 0.15;       ///< the half width of the kernel over the mean spacing
constexpr double least_overlap = 0.1; ///< curves end where a region and its moved copy have less in common
constexpr double first_margin = 8;    ///< mean spacings within which nearly all points have a nearest one

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// A grid of points in a region, or on a torus with copies of points beyond the border up to a margin.
class ClassNeighbours
{
public:
    ClassNeighbours(const PointSet& points, const ClassPlace& place, double margin)
        : sides_(place.box().sides), margin_(place.region() ? 0 : margin),
          scale_(place.region() ? 1 : 1 / (place.box().longest() + 2 * margin)), own_(points.size()),
          grid_(framed(points), std::min(1.0, place.region() ? place.area() : scale_ * scale_))
    {
        std::vector<std::uint32_t> owners(grid_.size());
        for (std::size_t i = 0; i < owners_.size(); ++i) owners[grid_.number_of(i)] = owners_[i];
        owners_ = std::move(owners);
    }

    std::size_t size() const { return own_; } ///< the number of points without copies

    /// Returns the place in the grid of a point with the coordinates of its set.
    std::array<double, 2> place_of(std::span<const double> point) const
    {
        if (margin_ == 0 && scale_ == 1) return {point[0], point[1]};
        return {(point[0] * sides_[0] + margin_) * scale_, (point[1] * sides_[1] + margin_) * scale_};
    }

    /// Calls what(number of a point in its set, its place in the grid, distance in lengths of the place).
    template <class What>
    void for_each_near(const std::array<double, 2>& at, double reach, const What& what) const
    {
        grid_.for_each_near(at, reach * scale_, [&](std::size_t j, double squared) {
            what(owners_[j], grid_.place(j), std::sqrt(squared) / scale_);
        });
    }

    /// The distance from the nearest point that is not number `left_out` of the set. Copies of that point count.
    double nearest(const std::array<double, 2>& at, std::size_t left_out) const
    {
        return grid_.nearest(at, left_out < own_ ? grid_.number_of(left_out) : PlaneNeighbours::none) / scale_;
    }

private:
    /// Returns the points, followed by their copies, in the unit square.
    PointSet framed(const PointSet& points)
    {
        owners_.resize(points.size());
        std::iota(owners_.begin(), owners_.end(), 0u);
        PointSet all{2, {}};
        for (std::size_t i = 0; i < points.size(); ++i)
            for (const double coordinate : place_of(points[i])) all.coordinates.push_back(coordinate);
        if (margin_ == 0) return all;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int across = -1; across <= 1; ++across)
                for (int up = -1; up <= 1; ++up) add_copy(points, i, across, up, all);
        return all;
    }

    void add_copy(const PointSet& points, std::size_t i, int across, int up, PointSet& all)
    {
        if (across == 0 && up == 0) return;
        const std::array moved{points[i][0] + across, points[i][1] + up};
        for (std::size_t k = 0; k < 2; ++k)
            if (moved[k] * sides_[k] < -margin_ || moved[k] * sides_[k] > sides_[k] + margin_) return;
        for (const double coordinate : place_of(moved)) all.coordinates.push_back(coordinate);
        owners_.push_back(static_cast<std::uint32_t>(i));
    }

    std::array<double, 3> sides_;
    double margin_, scale_;
    std::size_t own_;
    std::vector<std::uint32_t> owners_; ///< numbers of points in the set
    PlaneNeighbours grid_;
};

/// Returns the numbers of points in the order of cells, so that neighbours follow each other in memory.
std::vector<std::uint32_t> order_by_place(const PointSet& points)
{
    std::vector<std::uint32_t> order(points.size());
    const PlaneNeighbours grid(points, 1);
    for (std::size_t i = 0; i < points.size(); ++i) order[grid.number_of(i)] = static_cast<std::uint32_t>(i);
    return order;
}

/// Calls add(k, value) for the curve's places k from 0 on that the kernel around a distance covers.
template <class Add>
void add_kernel(double distance, double weight, const ClassDistanceSteps& steps, const Add& add)
{
    const auto count = static_cast<double>(steps.count);
    const auto first =
        static_cast<std::size_t>(std::clamp(std::ceil((distance - steps.half_width) / steps.step), 1.0, count + 1));
    const auto last = static_cast<std::size_t>(std::min((distance + steps.half_width) / steps.step, count));
    for (std::size_t k = first; k <= last; ++k) {
        const double t = (static_cast<double>(k) * steps.step - distance) / steps.half_width;
        add(k - 1, weight * std::max(0.0, 1 - t * t) / distance);
    }
}

/// Calls what(i, j, distance, 1 / common area) for pairs whose first point is in a chunk of `order`; pairs of a single
/// set come once each.
template <class What>
void visit_pairs(const PointSet& a, std::span<const std::uint32_t> order, const ClassNeighbours& b, bool is_same,
                 const ClassPlace& place, double reach, const What& what)
{
    for (const std::uint32_t i : order) {
        stop_if_interrupted(); // points of a cluster have all others of it within reach
        const std::array<double, 2> at = b.place_of(a[i]);
        b.for_each_near(at, reach, [&](std::uint32_t j, const std::array<double, 2>& other, double distance) {
            if (distance == 0 || (is_same && j >= i)) return;
            const double common = place.common_area(at[0] - other[0], at[1] - other[1]);
            if (common > place.least_common_area()) what(i, j, distance, 1 / common);
        });
    }
}

/// Returns sums over pairs; `collect(part of the order)` returns those of a part.
template <class Collect>
std::vector<double> sum_of_chunks(const std::vector<std::uint32_t>& order, const Collect& collect)
{
    std::vector<std::vector<double>> parts(chunks);
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
        const std::size_t first = order.size() * c / chunks, end = order.size() * (c + 1) / chunks;
        parts[c] = collect(std::span(order).subspan(first, end - first));
    });
    std::vector<double> sums = parts.front();
    for (std::size_t c = 1; c < chunks; ++c)
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += parts[c][k];
    return sums;
}

/// Returns for each point its class, then its class in each of `labellings` permutations (Fisher and Yates).
std::vector<std::uint8_t> labels_of(std::span<const std::uint8_t> classes, std::uint32_t labellings)
{
    const std::size_t n = classes.size(), stride = labellings + 1;
    std::vector<std::uint8_t> labels(n * stride);
    for (std::uint32_t l = 0; l <= labellings; ++l) {
        std::vector<std::uint8_t> some(classes.begin(), classes.end());
        // The seed is fixed, so that envelopes can be compared.
        RandomWords words(stream_key(0, Purpose::class_labels, l), 0);
        if (l > 0)
            for (std::size_t i = n; i > 1; --i)
                std::swap(some[i - 1], some[words.below(static_cast<std::uint32_t>(i))]);
        for (std::size_t i = 0; i < n; ++i) labels[i * stride + l] = some[i];
    }
    return labels;
}

/// The probability that two points of the set are of one class.
double chance_of_one_class(std::span<const std::uint8_t> classes)
{
    std::array<double, 256> counts{};
    for (const std::uint8_t each : classes) ++counts[each];
    double pairs = 0;
    for (const double count : counts) pairs += count * (count - 1);
    const auto n = static_cast<double>(classes.size());
    return pairs / (n * (n - 1));
}

}

double ClassPlace::reach(double most) const
{
    return region_ ? covariance_->reach(least_overlap, std::min(most, std::numbers::sqrt2))
                   : std::min(most, box_.shortest() / 2);
}

ClassDistanceSteps class_distance_steps(const ClassPlace& place, std::size_t points, double reach)
{
    const double unit = place.unit_length();
    ClassDistanceSteps steps;
    steps.half_width = stoyan * unit / std::sqrt(static_cast<double>(points));
    const double packed = max_min_distance(points, 2) * unit;
    const double end = place.reach(reach > 0 ? reach : distances_shown * packed);
    steps.count = static_cast<std::size_t>(distances_shown * rows_per_distance);
    steps.step = end / static_cast<double>(steps.count);
    return steps;
}

std::vector<double> class_pair_correlation(const PointSet& a, const PointSet& b, const ClassPlace& place,
                                           const ClassDistanceSteps& steps, double* summed)
{
    const bool is_same = &a == &b;
    const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
    const double pairs = is_same ? n * (n - 1) / 2 : n * m;
    if (summed) *summed = 0;
    if (!(pairs > 0)) return std::vector<double>(steps.count, not_known);
    const double reach = steps.reach() + steps.half_width;
    const ClassNeighbours neighbours(b, place, reach);
    std::vector<double> g = sum_of_chunks(order_by_place(a), [&](std::span<const std::uint32_t> part) {
        std::vector<double> sums(steps.count + 1); // the last one is the number of pairs
        visit_pairs(a, part, neighbours, is_same, place, reach, [&](auto, auto, double distance, double weight) {
            ++sums.back();
            add_kernel(distance, weight, steps, [&](std::size_t k, double value) { sums[k] += value; });
        });
        return sums;
    });
    if (summed) *summed = g.back();
    g.pop_back();
    const double factor = place.area() * place.area() / pairs * 0.75 / steps.half_width / (2 * std::numbers::pi);
    for (double& value : g) value *= factor;
    return g;
}

CrossNearest cross_nearest(const PointSet& a, const PointSet& b, const ClassPlace& place)
{
    const bool is_same = &a == &b;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (a.size() == 0 || b.size() < (is_same ? 2u : 1u)) return {infinity, infinity};
    // On a long torus a point may be nearer to its own copies than to other points: these functions leave them out.
    if (is_same && !place.region())
        return {min_toroidal_distance(a, place.box()), mean_nearest_distance(a, place.box())};
    const double all = place.box().longest() / 2; // a nearest point on a torus is not farther away along an axis
    double margin = std::min(all, first_margin / std::sqrt(static_cast<double>(b.size())));
    for (;; margin = all) {
        const ClassNeighbours neighbours(b, place, margin);
        std::vector<double> distances(a.size());
        tbb::parallel_for(std::size_t{0}, a.size(), [&](std::size_t i) {
            stop_if_interrupted();
            distances[i] = neighbours.nearest(neighbours.place_of(a[i]), is_same ? i : PlaneNeighbours::none);
        });
        const double farthest = *std::ranges::max_element(distances);
        if (!place.region() && farthest > margin && margin < all) continue;
        return {*std::ranges::min_element(distances),
                std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(a.size())};
    }
}

MarkCorrelation mark_correlation(const PointSet& points, std::span<const std::uint8_t> classes, const ClassPlace& place,
                                 const ClassDistanceSteps& steps, std::uint32_t labellings)
{
    MarkCorrelation result;
    const double chance = points.size() > 1 ? chance_of_one_class(classes) : 0;
    if (!(chance > 0)) {
        result.values.assign(steps.count, not_known);
        return result;
    }
    const std::size_t stride = labellings + 1;
    const std::vector<std::uint8_t> labels = labels_of(classes, labellings);
    const double reach = steps.reach() + steps.half_width;
    const ClassNeighbours neighbours(points, place, reach);
    // Each distance has the sum over all pairs, then for each labelling the sum over pairs of one class.
    const std::vector<double> sums = sum_of_chunks(order_by_place(points), [&](std::span<const std::uint32_t> part) {
        std::vector<double> some(steps.count * (stride + 1)), is_one(stride);
        visit_pairs(points, part, neighbours, true, place, reach, [&](auto i, auto j, double distance, double w) {
            const std::uint8_t *first = &labels[i * stride], *second = &labels[j * stride];
            for (std::size_t l = 0; l < stride; ++l) is_one[l] = first[l] == second[l] ? 1 : 0;
            add_kernel(distance, w, steps, [&](std::size_t k, double value) {
                double* row = &some[k * (stride + 1)];
                row[0] += value;
                for (std::size_t l = 0; l < stride; ++l) row[l + 1] += value * is_one[l];
            });
        });
        return some;
    });
    std::vector<double> deviations(stride);
    for (std::size_t k = 0; k < steps.count; ++k) {
        const double* row = &sums[k * (stride + 1)];
        if (row[0] > 0)
            for (std::size_t l = 0; l < stride; ++l)
                deviations[l] += row[0] * std::pow(row[l + 1] / row[0] / chance - 1, 2);
        const auto at = [&](std::size_t l) { return row[0] > 0 ? row[l + 1] / row[0] / chance : not_known; };
        result.values.push_back(at(0));
        if (labellings == 0) continue;
        double low = not_known, high = not_known;
        for (std::size_t l = 1; l < stride; ++l) low = std::fmin(low, at(l)), high = std::fmax(high, at(l));
        result.low.push_back(low);
        result.high.push_back(high);
    }
    const auto as_far = std::ranges::count_if(deviations, [&](double each) { return each >= deviations.front(); });
    result.p_value = static_cast<double>(as_far) / static_cast<double>(stride);
    return result;
}

}
