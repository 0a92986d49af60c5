#include "host/sampling/optimized/target_spectrum.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/nonuniform_transform.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

constexpr double ring_reach = 2;     ///< sqrt(N)
constexpr double longest_move = 0.2; ///< of a coordinate in a step; mean distances
constexpr int most_halvings = 20;

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
        : points(static_cast<double>(count)), reach(static_cast<int>(ring_reach * std::sqrt(points))), transform(reach),
          wanted(static_cast<std::size_t>(reach) + 1), samples(wanted.size())
    {
        for (std::size_t k = 0; k < wanted.size(); ++k)
            wanted[k] = target.at(static_cast<double>(k) / std::sqrt(points));
        for_each_frequency([&](int, int, std::size_t ring, double weight) { samples[ring] += weight; });
    }

    /// Calls what(u, v, ring, weight): frequencies with u > 0 stand for those opposite to them as well.
    template <typename What>
    void for_each_frequency(What&& what) const
    {
        for (int v = -reach; v <= reach; ++v)
            for (int u = 0; u <= reach; ++u) {
                const auto ring = static_cast<std::size_t>(std::lround(std::hypot(u, v)));
                if (ring > 0 && ring < wanted.size()) what(u, v, ring, u > 0 ? 2.0 : 1.0);
            }
    }

    double points;
    int reach;
    NonuniformTransform transform;
    std::vector<double> wanted, samples; ///< power and number of frequencies of each ring
};

SpectrumDifference::SpectrumDifference(std::size_t points, const TargetCurve& target)
    : state_(std::make_unique<State>(points, target))
{}
SpectrumDifference::~SpectrumDifference() = default;

double SpectrumDifference::of(const PointSet& points, std::vector<double>* gradient)
{
    State& s = *state_;
    const HalfPlane transform = s.transform.forward(points);
    std::vector<double> power(s.wanted.size());
    s.for_each_frequency([&](int u, int v, std::size_t ring, double weight) {
        power[ring] += weight * std::norm(transform.at(u, v)) / s.points / s.samples[ring];
    });
    double sum = 0;
    for (std::size_t k = 1; k < power.size(); ++k) sum += (power[k] - s.wanted[k]) * (power[k] - s.wanted[k]) / s.reach;
    if (gradient == nullptr) return sum;

    // d |F(f)|^2 / dx_j is twice the real part of 2 pi i f F(f) exp(2 pi i f.x_j); both f and -f are summed up.
    for (const int axis : {0, 1}) {
        HalfPlane coefficients(s.reach);
        s.for_each_frequency([&](int u, int v, std::size_t ring, double) {
            const double by_power = 2 * (power[ring] - s.wanted[ring]) / s.samples[ring] / s.reach;
            coefficients.at(u, v) =
                std::complex<double>(0, 4 * std::numbers::pi / s.points * by_power * (axis == 0 ? u : v)) *
                transform.at(u, v);
        });
        const std::vector<double> along_axis = s.transform.adjoint(coefficients, points);
        gradient->resize(points.coordinates.size());
        for (std::size_t j = 0; j < points.size(); ++j)
            (*gradient)[2 * j + static_cast<std::size_t>(axis)] = along_axis[j];
    }
    return sum;
}

LloydResult follow_curve(const PointSet& points, const TargetCurve& target, std::size_t iterations)
{
    SpectrumDifference difference(points.size(), target);
    LloydResult result{points, {}, 0};
    std::vector<double> gradient;
    double energy = difference.of(result.points, &gradient);
    const double longest = longest_move / std::sqrt(static_cast<double>(points.size()));
    double step = 0;
    for (std::size_t iteration = 0;; ++iteration) {
        stop_if_interrupted();
        result.kept = iteration;
        result.iterations.push_back({relative_radius(min_toroidal_distance(result.points), points.size(), 2), energy});
        double steepest = 0;
        for (const double g : gradient) steepest = std::max(steepest, std::abs(g));
        if (iteration == iterations || steepest == 0) return result;

        // The first step, and none later, moves a coordinate farther than this.
        step = step > 0 ? std::min(step, longest / steepest) : longest / steepest;
        PointSet next;
        double next_energy = energy;
        for (int halving = 0; halving < most_halvings && !(next_energy < energy); ++halving, step /= 2) {
            next = moved_against(result.points, gradient, step);
            next_energy = difference.of(next, nullptr);
        }
        if (!(next_energy < energy)) return result;
        step *= 2; // what was taken

        std::vector<double> next_gradient;
        energy = difference.of(next, &next_gradient);
        double turned = 0; // (next gradient - gradient) . gradient
        for (std::size_t i = 0; i < gradient.size(); ++i) turned += (gradient[i] - next_gradient[i]) * gradient[i];
        step = turned > 0 ? step * squared_norm(gradient) / turned : 2 * step;
        gradient = std::move(next_gradient);
        result.points = std::move(next);
    }
}

}
