#include "analysis/measures/number_variance.hpp"

#include "analysis/measures/ball_counter.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr int number_of_radii = 24;
constexpr double least_spacings = 0.5, largest_radius = 0.25;
constexpr std::size_t most_centres = 10'000, centres_per_point = 4;

using BallCounts = std::vector<std::vector<std::int64_t>>; ///< of each radius, in the balls

/// The place of the centre of a ball, as shares of what the margins leave: two words of 32 bits, three in space.
std::array<std::uint32_t, 4> words_of(std::size_t i)
{
    static const StreamKey key = stream_key(0, Purpose::variance_windows, 0);
    return philox({static_cast<std::uint32_t>(i), 0, 0, 0}, key);
}

double spacing_of(std::size_t points, int dimension) { return std::pow(static_cast<double>(points), -1.0 / dimension); }

template <int D>
std::array<double, D> centre_of(const std::array<std::uint32_t, 4>& words, double margin)
{
    std::array<double, D> centre;
    for (int k = 0; k < D; ++k)
        centre[k] = margin + (1 - 2 * margin) * static_cast<double>(words[static_cast<std::size_t>(k)]) * 0x1p-32;
    return centre;
}

/// Adds the numbers of points in balls, which in windows keep a radius from the border.
template <int D>
void add_in_window(const BallCounter<D>& counter, const std::vector<double>& radii, std::size_t i, BallCounts& counts)
{
    const auto words = words_of(i);
    for (std::size_t r = 0; r < radii.size(); ++r)
        counts[r][i] += counter.count(centre_of<D>(words, radii[r]), radii[r]);
}

/// Balls on the torus have one centre, whatever their radius: each point near it is looked at once for all small ones.
template <int D>
void add_on_torus(const BallCounter<D>& counter, const BallShells& shells, const std::vector<double>& radii,
                  std::size_t i, BallCounts& counts)
{
    const auto centre = counter.stretched(centre_of<D>(words_of(i), 0));
    std::array<std::int64_t, number_of_radii> numbers{};
    counter.add_to_shells(centre, shells, numbers);
    std::int64_t points = 0;
    for (std::size_t r = 0; r < shells.count(); ++r) counts[r][i] += points += numbers[r];
    for (std::size_t r = shells.count(); r < radii.size(); ++r) counts[r][i] += counter.count(centre, radii[r]);
}

struct Moments
{
    double mean = 0, variance = 0;
};

Moments moments_of(const std::vector<std::int64_t>& counts, double expected, bool is_window)
{
    const auto n = static_cast<double>(counts.size());
    double sum = 0, squares = 0; // of deviations: small numbers
    for (const std::int64_t count : counts) {
        const double deviation = static_cast<double>(count) - expected;
        sum += deviation, squares += deviation * deviation;
    }
    if (!is_window) return {expected, squares / n};
    return {expected + sum / n, (squares - sum * sum / n) / (n - 1)};
}

}

NumberVarianceEstimate::NumberVarianceEstimate(int dimension, std::size_t points, bool is_window,
                                               const PeriodicBox& box)
    : dimension_(dimension), is_window_(is_window), box_(box),
      centres_(std::min(most_centres, centres_per_point * points))
{
    if (dimension != 2 && dimension != 3) throw InputError("number variance: the dimension must be 2 or 3");
    const double largest = largest_radius * box.shortest();
    if (points < least_points(dimension) || spacing_of(points, dimension) > largest * (1 + 1e-9)) return;
    const double least = least_spacings * spacing_of(points, dimension);
    for (int i = 0; i < number_of_radii; ++i)
        radii_.push_back(least * std::pow(largest / least, i / (number_of_radii - 1.0)));
    radii_.back() = largest;
}

/// Adds the points of a set, or of a part of it, to those in the balls.
void NumberVarianceEstimate::count(const PointSet& points, Counts& counts) const
{
    const BallShells shells(radii_, points.size(), dimension_);
    const auto add = [&](const auto& counter) {
        tbb::parallel_for(std::size_t{0}, centres_, [&](std::size_t i) {
            is_window_ ? add_in_window(counter, radii_, i, counts) : add_on_torus(counter, shells, radii_, i, counts);
        });
    };
    counts.resize(radii_.size(), std::vector<std::int64_t>(centres_));
    if (dimension_ == 2) add(BallCounter<2>(points, box_));
    if (dimension_ == 3) add(BallCounter<3>(points, box_));
}

void NumberVarianceEstimate::add_counts(const Counts& counts, std::uint64_t points)
{
    std::vector<double> means, variances;
    for (std::size_t r = 0; r < radii_.size(); ++r) {
        const double expected = static_cast<double>(points) * torus_ball_volume(radii_[r], dimension_, box_);
        const Moments moments = moments_of(counts[r], expected, is_window_);
        means.push_back(moments.mean);
        variances.push_back(moments.variance);
    }
    means_.push_back(std::move(means));
    variances_.push_back(std::move(variances));
}

void NumberVarianceEstimate::add(const PointSet& points)
{
    if (points.dimension != dimension_) throw InputError("number variance: sets differ in dimension");
    if (radii_.empty()) return;
    Counts counts;
    count(points, counts);
    add_counts(counts, points.size());
}

void NumberVarianceEstimate::add(const PointStrips& points)
{
    if (points.dimension() != dimension_) throw InputError("number variance: sets differ in dimension");
    if (radii_.empty()) return;
    Counts counts;
    for (std::size_t strip = 0; strip < points.count(); ++strip) {
        stop_if_interrupted();
        count(points.strip(strip), counts);
    }
    add_counts(counts, points.size());
}

void NumberVarianceEstimate::append(const NumberVarianceEstimate& other)
{
    means_.insert(means_.end(), other.means_.begin(), other.means_.end());
    variances_.insert(variances_.end(), other.variances_.begin(), other.variances_.end());
}

std::vector<NumberVarianceBin> NumberVarianceEstimate::mean(const std::vector<std::size_t>& groups) const
{
    if (variances_.empty()) return {};
    const auto sets = static_cast<double>(variances_.size());
    std::vector<NumberVarianceBin> bins(radii_.size());
    for (std::size_t i = 0; i < bins.size(); ++i) {
        NumberVarianceBin& bin = bins[i];
        bin.radius = radii_[i];
        for (const auto& means : means_) bin.points += means[i] / sets;
        for (const auto& variances : variances_) bin.variance += variances[i] / sets;
    }
    const std::vector<double> errors = errors_of_mean(variances_, groups);
    for (std::size_t i = 0; i < errors.size(); ++i) bins[i].standard_error = errors[i];
    return bins;
}

}
