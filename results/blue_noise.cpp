#include "results/blue_noise.hpp"

#include "analysis/spectra/spectrum.hpp"
#include "results/series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

constexpr double quiet = 0.1; ///< mean power at low frequencies, that of Heck's effective Nyquist frequency
constexpr double noisy = 0.5; ///< half of what random points have
constexpr double errors_apart = 2;
constexpr double apart = 0.7;            ///< mean nearest distance, half-way from jittered points to saturated darts
constexpr double wide = 0.47;            ///< effective Nyquist frequency, half-way as well
constexpr int most_of_a_lattice_2d = 12; ///< frequencies that the symmetries of a lattice make equal
constexpr int most_of_a_lattice_3d = 48;

std::optional<double> number_of(const Series& series, const char* key)
{
    const auto found = series.measures.numbers.find(key);
    return found == series.measures.numbers.end() ? std::nullopt : std::optional(found->second.value);
}

/// The standard error of the power at low frequencies: as measured, or that of exponential powers, of as many pairs f
/// and -f as there are up to root N / 4.
double error_of(const Estimate& low, const Series& series, int dimension)
{
    if (low.standard_error) return *low.standard_error;
    const double pairs = static_cast<double>(series.points) * std::numbers::pi / (dimension == 2 ? 32 : 96);
    return low.value / std::sqrt(std::max(1.0, pairs * series.realizations));
}

std::string percent(double part)
{
    if (part < 1e-4) return "less than 0.01 %";
    return part < 0.0995 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}

/// The number of frequencies that would hold all power of the ring in which the spectrum is least even.
std::optional<double> frequencies_with_power(const Series& series)
{
    const auto& peak = series.measures.peak_anisotropy;
    if (!peak || !(number_of(series, "anisotropy_above_chance").value_or(0) > 0)) return std::nullopt;
    return static_cast<double>(peak->samples) / (1 + std::pow(10, peak->db / 10));
}

/// The reason why nothing can be said; empty where something can.
std::string unknown_because(const Series& series, int dimension)
{
    if (series.border && series.border->is_not_periodic())
        return "the sets are not periodic but were measured as if they were: use --periodic no";
    if (series.is_window) return "the border of a window leaves a cross in the spectrum";
    const auto& numbers = series.measures.numbers;
    const bool has_numbers = numbers.contains("low_frequency_mean") && numbers.contains("mean_nearest_distance");
    if (has_numbers && series.measures.peak_anisotropy) return {};
    return short_spectrum_words(series, dimension).empty() ? "there are too few points"
                                                           : "the spectrum ends too early to show all peaks";
}

int asked_size(const Series& series, int dimension)
{
    return size_asked_for(series.points_of_first(), dimension, series.box ? series.box->box() : PeriodicBox{});
}

}

std::string BlueNoiseVerdict::words() const { return fmt::format("Blue noise: {}, because {}.", answer, because); }

std::optional<BlueNoiseVerdict> blue_noise_verdict(const Series& series, int dimension)
{
    if (series.spectrum_size == 0 || (series.region && series.region->has_density)) return std::nullopt;
    if (const std::string reason = unknown_because(series, dimension); !reason.empty())
        return BlueNoiseVerdict{"unknown", reason};
    const Estimate low = series.measures.numbers.at("low_frequency_mean");
    const double error = error_of(low, series, dimension), nearest = *number_of(series, "mean_nearest_distance");
    const std::string power =
        fmt::format("its power at low frequencies is {}{} of that of random points", percent(low.value),
                    low.value > quiet && low.value < noisy ? fmt::format(" (± {})", percent(error)) : "");
    std::vector<std::string> against;
    if (low.value + errors_apart * error >= noisy)
        against.push_back(low.value >= noisy ? power
                                             : fmt::format("{}, which is not safely below {}", power, percent(noisy)));
    const auto frequencies = frequencies_with_power(series);
    if (frequencies && *frequencies <= (dimension == 2 ? most_of_a_lattice_2d : most_of_a_lattice_3d))
        against.push_back(fmt::format("its spectrum has spikes like that of a lattice: {:.0f} of {} frequencies hold "
                                      "the power of a {}",
                                      std::max(1.0, *frequencies), series.measures.peak_anisotropy->samples,
                                      dimension == 2 ? "ring" : "shell"));
    if (!against.empty()) return BlueNoiseVerdict{"no", fmt::format("{}", fmt::join(against, ", and "))};

    if (low.value - errors_apart * error > quiet) against.push_back(power + ", above " + percent(quiet));
    const double nyquist = number_of(series, "effective_nyquist").value_or(0);
    if (nearest < apart && nyquist < wide)
        against.push_back(fmt::format("many points have a near neighbour (mean nearest distance {:.2f}, below {:.2f}) "
                                      "and the spectrum rises early",
                                      nearest, apart));
    if (frequencies)
        against.push_back(fmt::format("the spectrum has directions or peaks, {:.1f} dB above chance",
                                      *number_of(series, "anisotropy_above_chance")));
    if (!against.empty()) return BlueNoiseVerdict{"weakly", fmt::format("{}", fmt::join(against, ", and "))};
    return BlueNoiseVerdict{
        "yes", fmt::format("{}, {}, and {}", power,
                           nearest < apart ? fmt::format("the spectrum rises late and steeply (effective "
                                                         "Nyquist frequency {:.2f})",
                                                         nyquist)
                                           : fmt::format("points keep apart (mean nearest distance {:.2f})", nearest),
                           number_of(series, "anisotropy_above_chance") ? "no peaks or directions rise above chance"
                                                                        : "a mean over tapers hides any directions")};
}

std::string short_spectrum_words(const Series& series, int dimension)
{
    if (series.spectrum_size == 0) return {};
    const int asked = asked_size(series, dimension);
    const bool is_whole = series.spectrum_size >= asked, has_rise = number_of(series, "effective_nyquist").has_value();
    if (is_whole && has_rise) return {};
    std::vector<std::string> missing;
    if (!number_of(series, "low_frequency_mean")) missing.emplace_back("power at low frequencies");
    if (!has_rise) missing.emplace_back("effective Nyquist frequency");
    if (!is_whole) missing.emplace_back("oscillation, anisotropy and lattice peaks");
    const double root = std::pow(static_cast<double>(series.points), 1.0 / dimension), reach = spectrum_reach(series);
    const bool can_be_set = asked <= (dimension == 2 ? largest_spectrum_2d : largest_spectrum_3d) && !series.region;
    return fmt::format(
        "The spectrum ends at frequency {:.4g} ({:.2g} {}), too early for these measures, which are left "
        "out: {}.{}",
        reach, reach / root, dimension == 2 ? "√N" : "∛N", fmt::join(missing, ", "),
        is_whole || !can_be_set ? "" : fmt::format(" They need spectrum_size = {} or more.", asked));
}

}
