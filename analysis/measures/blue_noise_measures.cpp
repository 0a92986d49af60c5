#include "analysis/measures/blue_noise_measures.hpp"

#include "base/errors/errors.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr double low_power = 0.1;
constexpr double risen_power = 0.5;
constexpr double nearly_one = 0.98;
constexpr double peaks = 10; ///< b - a in units of s / 2

/// s, the points along an axis of the square lattice. The one place where sizes are checked.
double points_per_axis(std::size_t points, int dimension)
{
    if (dimension != 2 && dimension != 3) throw InputError("radial power: the dimension must be 2 or 3");
    if (points == 0) throw InputError("radial power: a point set without points has no spectrum");
    return std::pow(static_cast<double>(points), 1.0 / dimension);
}

/// C at the outer ends of the bins: bins are one wide, and weigh by the volume of their shells.
std::vector<double> mean_power_up_to(const std::vector<RadialBin>& radial, int dimension)
{
    std::vector<double> means;
    double power = 0, volume = 0;
    for (const RadialBin& bin : radial) {
        const double shell = std::pow(bin.frequency + 0.5, dimension) - std::pow(bin.frequency - 0.5, dimension);
        power += shell * bin.power;
        volume += shell;
        means.push_back(power / volume);
    }
    return means;
}

/// The largest f in bin i with C(f) <= low_power, which C exceeds at the bin's end but not at its beginning.
double crossing(const RadialBin& bin, double mean_before, int dimension)
{
    // Volumes relative to the first bin's inner sphere, which is left out: C(f) v(f) = C0 v0 + P (v(f) - v0).
    const double left_out = std::pow(0.5, dimension);
    const double before = std::pow(bin.frequency - 0.5, dimension) - left_out;
    const double volume = before * (bin.power - mean_before) / (bin.power - low_power);
    return std::pow(volume + left_out, 1.0 / dimension);
}

}

std::optional<double> effective_nyquist_frequency(const std::vector<RadialBin>& radial, std::size_t points,
                                                  int dimension)
{
    const double s = points_per_axis(points, dimension);
    const std::vector<double> means = mean_power_up_to(radial, dimension);
    std::size_t i = 0;
    while (i < radial.size() && !(radial[i].frequency + 0.5 >= s / 2 && means[i] > risen_power)) ++i;
    if (i == radial.size()) return std::nullopt;
    while (i > 0 && means[i - 1] >= low_power) --i;
    if (i == 0) return 0.0;
    return crossing(radial[i], means[i - 1], dimension) / s;
}

Oscillation oscillation(const std::vector<RadialBin>& radial, std::size_t points, int dimension)
{
    const double s = points_per_axis(points, dimension);
    if (radial.empty()) return {};

    auto beyond = std::ranges::find_if(radial, [&](const RadialBin& bin) { return bin.frequency >= s / 2; });
    if (beyond == radial.end()) beyond = radial.begin();
    auto first = std::find_if(beyond, radial.end(), [](const RadialBin& bin) { return bin.power >= nearly_one; });
    if (first == radial.end())
        first = std::max_element(beyond, radial.end(),
                                 [](const RadialBin& a, const RadialBin& b) { return a.power < b.power; });

    Oscillation result;
    result.begin = first->frequency;
    double squares = 0, samples = 0;
    for (auto bin = first; bin != radial.end() && bin->frequency <= result.begin + peaks * s / 2; ++bin) {
        const auto n = static_cast<double>(bin->samples);
        squares += n * (bin->power - 1) * (bin->power - 1);
        samples += n;
        result.end = bin->frequency;
    }
    result.value = 10 * std::sqrt(squares / samples);
    return result;
}

}
