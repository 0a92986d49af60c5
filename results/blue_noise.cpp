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
constexpr double spike = 4;         ///< mean power of a spike's frequencies; random points have 1
constexpr double most_leaked = 0.3; ///< perimeter / area in mean distances: adds a quarter of `quiet`
constexpr int few_sets = 3;         ///< standard errors of so few are too small in every few cases

std::optional<double> number_of(const Series& series, const char* key)
{
    const auto found = series.measures.numbers.find(key);
    return found == series.measures.numbers.end() ? std::nullopt : std::optional(found->second.value);
}

/// The standard error of the power at low frequencies: that of exponential powers, of as many pairs f and -f as there
/// are up to root N / 4, or as measured; the larger one of few sets.
double error_of(const Estimate& low, const Series& series, int dimension)
{
    const double measured = low.standard_error.value_or(0);
    if (low.standard_error && series.realizations > few_sets) return measured;
    const double pairs = static_cast<double>(series.points) * std::numbers::pi / (dimension == 2 ? 32 : 96);
    return std::max(measured, low.value / std::sqrt(std::max(1.0, pairs * series.realizations)));
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

/// True where they are few enough for a lattice, and are spikes.
bool are_spikes(double frequencies, const PeakAnisotropy& peak, int dimension)
{
    return frequencies <= (dimension == 2 ? most_of_a_lattice_2d : most_of_a_lattice_3d) &&
           peak.power * static_cast<double>(peak.samples) > spike * frequencies;
}

/// The mean width of the region, 2 area / perimeter, in mean distances, if the region is so narrow that its boundary
/// blurs the spectrum. Tapers keep power from leaking far, but a narrow region blurs theirs as well.
std::optional<double> blurring_width(const Series& series)
{
    if (!series.region) return std::nullopt;
    const double mean_distance = series.region->unit_length / std::sqrt(static_cast<double>(series.points));
    if (series.region->perimeter * mean_distance <= most_leaked * series.region->area) return std::nullopt;
    return 2 * series.region->area / series.region->perimeter / mean_distance;
}

/// The reason why nothing can be said; empty where something can.
std::string unknown_because(const Series& series, int dimension)
{
    if (series.border && series.border->is_not_periodic())
        return "the sets are not periodic but were measured as if they were: use --periodic no";
    if (series.is_window) return "the border of a window leaves a cross in the spectrum";
    if (const auto width = blurring_width(series))
        return fmt::format("the region's boundary blurs its spectrum (its mean width is {:.2g} mean distances)",
                           *width);
    const auto& numbers = series.measures.numbers;
    const bool has_numbers = numbers.contains("low_frequency_mean") && numbers.contains("mean_nearest_distance");
    if (has_numbers && series.measures.peak_anisotropy) return {};
    if (!short_spectrum_words(series, dimension).empty()) return "the spectrum ends too early to show all peaks";
    return has_numbers ? fmt::format("no {} of its spectrum has {} frequencies and power",
                                     dimension == 2 ? "ring" : "shell", least_peak_samples)
                       : "there are too few points";
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
    if (frequencies && are_spikes(*frequencies, *series.measures.peak_anisotropy, dimension))
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
    const std::string apart_words =
        nearest < apart
            ? fmt::format("the spectrum rises late and steeply (effective Nyquist frequency {:.2f})", nyquist)
            : fmt::format("points keep apart (mean nearest distance {:.2f})", nearest);
    if (!number_of(series, "anisotropy_above_chance"))
        return BlueNoiseVerdict{"unknown", fmt::format("{} and {}, but {}", power, apart_words,
                                                       series.region && series.region->tapers > 0
                                                           ? "a mean over tapers hides any peaks and directions"
                                                           : "peaks and directions could not be tested")};
    return BlueNoiseVerdict{"yes",
                            fmt::format("{}, {}, and no peaks or directions rise above chance", power, apart_words)};
}

bool reaches_as_asked(const Series& series, int dimension)
{
    return series.spectrum_size >= asked_size(series, dimension);
}

std::string short_spectrum_words(const Series& series, int dimension)
{
    if (series.spectrum_size == 0) return {};
    const int asked = asked_size(series, dimension);
    const bool is_whole = reaches_as_asked(series, dimension),
               has_rise = number_of(series, "effective_nyquist").has_value();
    if (is_whole && has_rise) return {};
    std::vector<std::string> missing;
    if (!number_of(series, "low_frequency_mean")) missing.emplace_back("power at low frequencies");
    if (!has_rise) missing.emplace_back("effective Nyquist frequency");
    if (!is_whole) missing.emplace_back("oscillation, anisotropy and lattice peaks");
    const double root = std::pow(static_cast<double>(series.points), 1.0 / dimension), reach = spectrum_reach(series);
    const int most = dimension == 3  ? most_frequencies_3d
                     : series.region ? largest_region_spectrum
                                     : most_frequencies_2d;
    const bool can_be_set = asked <= most;
    return fmt::format(
        "The spectrum ends at frequency {:.4g} ({:.2g} {}), too early for these measures, which are left "
        "out: {}.{}",
        reach, reach / root, dimension == 2 ? "√N" : "∛N", fmt::join(missing, ", "),
        is_whole || !can_be_set ? "" : fmt::format(" They need spectrum_size = {} or more.", asked));
}

}
