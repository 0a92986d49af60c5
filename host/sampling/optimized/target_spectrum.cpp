#include "host/sampling/optimized/target_spectrum.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/nonuniform_transform.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/optimized/row_order.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr double ring_reach = 2;     ///< sqrt(N)
constexpr double longest_move = 0.2; ///< of a coordinate in a step; mean distances
constexpr int most_halvings = 20;
constexpr int rows_at_once = 64; ///< of frequencies

double squared_norm(const std::vector<double>& values)
{
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

PointSet moved_against(const PointSet& points, const std::vector<double>& gradient, double step)
{
    PointSet moved = points;
    for (std::size_t i = 0; i < moved.coordinates.size(); ++i) {
        const double place = moved.coordinates[i] - step * gradient[i];
        const double wrapped = place - std::floor(place);
        moved.coordinates[i] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
    }
    return moved;
}

}

TargetCurve::TargetCurve(std::vector<double> frequencies, std::vector<double> power)
    : frequencies_(std::move(frequencies)), power_(std::move(power))
{}

double TargetCurve::at(double frequency) const
{
    const auto next = std::ranges::upper_bound(frequencies_, frequency);
    if (next == frequencies_.end()) return 1;
    const auto i = static_cast<std::size_t>(next - frequencies_.begin());
    if (i == 0) return power_.front();
    const double part = (frequency - frequencies_[i - 1]) / (frequencies_[i] - frequencies_[i - 1]);
    return power_[i - 1] + part * (power_[i] - power_[i - 1]);
}

TargetCurve step_curve(double frequency, double peak)
{
    std::vector<double> frequencies{frequency - 1e-9}, power{0};
    for (int i = 0; i <= 40; ++i) {
        const double beyond = 0.005 * i, deviations = beyond / 0.05;
        frequencies.push_back(frequency + beyond);
        power.push_back(1 + peak * std::exp(-deviations * deviations / 2));
    }
    return {std::move(frequencies), std::move(power)};
}

struct SpectrumDifference::State
{
    State(std::size_t count, const TargetCurve& target)
        : points(static_cast<double>(count)), reach(static_cast<int>(ring_reach * std::sqrt(points))),
          nonuniform(reach), transform(reach), wanted(static_cast<std::size_t>(reach) + 1), power(wanted.size())
    {
        for (std::size_t k = 0; k < wanted.size(); ++k)
            wanted[k] = target.at(static_cast<double>(k) / std::sqrt(points));
        samples = ring_sums([](int, int) { return 1.0; });
    }

    /// Calls what(u, ring, weight) for a row of frequencies: those with u > 0 stand for their opposites as well.
    template <typename What>
    void for_each_frequency(int v, What&& what) const
    {
        for (int u = 0; u <= reach; ++u) {
            const double squared = static_cast<double>(u) * u + static_cast<double>(v) * v;
            const auto ring = static_cast<std::size_t>(std::sqrt(squared) + 0.5);
            if (ring > 0 && ring < wanted.size()) what(u, ring, u > 0 ? 2.0 : 1.0);
        }
    }

    /// The sums of value(u, v, weight) over each ring. Rows are added up in runs of the same lengths in any case.
    template <typename Value>
    std::vector<double> ring_sums(const Value& value) const
    {
        return tbb::parallel_deterministic_reduce(
            tbb::blocked_range<int>(-reach, reach + 1, rows_at_once), std::vector<double>(wanted.size()),
            [&](const tbb::blocked_range<int>& rows, std::vector<double> sums) {
                for (int v = rows.begin(); v < rows.end(); ++v)
                    for_each_frequency(
                        v, [&](int u, std::size_t ring, double weight) { sums[ring] += weight * value(u, v); });
                return sums;
            },
            [](std::vector<double> sums, const std::vector<double>& others) {
                for (std::size_t ring = 0; ring < sums.size(); ++ring) sums[ring] += others[ring];
                return sums;
            });
    }

    double points;
    int reach;
    NonuniformTransform nonuniform;
    HalfPlane transform;                 ///< of the last set
    std::vector<double> wanted, samples; ///< power and number of frequencies of each ring
    std::vector<double> power;           ///< of the last set
};

SpectrumDifference::SpectrumDifference(std::size_t points, const TargetCurve& target)
    : state_(std::make_unique<State>(points, target))
{}
SpectrumDifference::~SpectrumDifference() = default;

double SpectrumDifference::of(const PointSet& points)
{
    State& s = *state_;
    s.transform = s.nonuniform.forward(points);
    s.power = s.ring_sums([&](int u, int v) { return std::norm(s.transform.at(u, v)); });
    double sum = 0;
    for (std::size_t k = 1; k < s.power.size(); ++k) {
        s.power[k] /= s.points * s.samples[k];
        sum += (s.power[k] - s.wanted[k]) * (s.power[k] - s.wanted[k]) / s.reach;
    }
    return sum;
}

/// d |F(f)|^2 / dx_j is the derivative along x, at x_j, of twice the real part of F(f) exp(2 pi i f.x); both f and -f
/// are summed up.
std::vector<double> SpectrumDifference::gradient(const PointSet& points)
{
    State& s = *state_;
    std::vector<double> by_power(s.power.size());
    for (std::size_t k = 1; k < by_power.size(); ++k)
        by_power[k] = 4 / s.points * (s.power[k] - s.wanted[k]) / s.samples[k] / s.reach;
    HalfPlane coefficients(s.reach);
    tbb::parallel_for(-s.reach, s.reach + 1, [&](int v) {
        s.for_each_frequency(
            v, [&](int u, std::size_t ring, double) { coefficients.at(u, v) = by_power[ring] * s.transform.at(u, v); });
    });
    return s.nonuniform.adjoint_gradient(coefficients, points);
}

LloydResult follow_curve(const PointSet& points, const TargetCurve& target, std::size_t iterations)
{
    SpectrumDifference difference(points.size(), target);
    const RowOrder order(points);
    LloydResult result{order.sorted(points), {}, 0};
    double energy = difference.of(result.points);
    std::vector<double> gradient = difference.gradient(result.points);
    const double longest = longest_move / std::sqrt(static_cast<double>(points.size()));
    double step = 0;
    for (std::size_t iteration = 0;; ++iteration) {
        stop_if_interrupted();
        result.kept = iteration;
        result.iterations.push_back({relative_radius(min_toroidal_distance(result.points), points.size(), 2), energy});
        double steepest = 0;
        for (const double g : gradient) steepest = std::max(steepest, std::abs(g));
        if (iteration == iterations || steepest == 0) break;

        // The first step, and none later, moves a coordinate farther than this.
        step = step > 0 ? std::min(step, longest / steepest) : longest / steepest;
        PointSet next;
        double next_energy = energy;
        for (int halving = 0; halving < most_halvings && !(next_energy < energy); ++halving, step /= 2) {
            next = moved_against(result.points, gradient, step);
            next_energy = difference.of(next);
        }
        if (!(next_energy < energy)) break;
        step *= 2; // what was taken

        energy = next_energy;
        std::vector<double> next_gradient = difference.gradient(next);
        double turned = 0; // (next gradient - gradient) . gradient
        for (std::size_t i = 0; i < gradient.size(); ++i) turned += (gradient[i] - next_gradient[i]) * gradient[i];
        step = turned > 0 ? step * squared_norm(gradient) / turned : 2 * step;
        gradient = std::move(next_gradient);
        result.points = std::move(next);
    }
    result.points = order.restored(result.points);
    return result;
}

}
