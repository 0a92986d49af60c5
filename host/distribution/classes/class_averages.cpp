#include "host/distribution/classes/class_averages.hpp"

#include "analysis/statistics/jackknife.hpp"
#include "base/programs/interrupt.hpp"
#include "host/distribution/classes/class_pictures.hpp"

#include <fmt/format.h>

#include <numeric>

namespace poissonlab {
namespace {

using Curves = std::vector<std::vector<double>>;

/// What combine(values of a place in all sets) says of each place.
template <typename Combine>
Curves combined_curves(const std::vector<CrossSpectra>& sets, Curves CrossSpectra::*member, const Combine& combine)
{
    Curves curves = sets.front().*member;
    std::vector<double> values(sets.size());
    for (std::size_t c = 0; c < curves.size(); ++c)
        for (std::size_t k = 0; k < curves[c].size(); ++k) {
            for (std::size_t s = 0; s < sets.size(); ++s) values[s] = (sets[s].*member)[c][k];
            curves[c][k] = combine(values);
        }
    return curves;
}

double mean_of_values(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void append_columns(std::string& text, const CrossSpectra& spectra, std::size_t bin)
{
    text += fmt::format(",{:.9g}", spectra.power.back()[bin]);
    for (std::size_t i = 0; i + 1 < spectra.power.size(); ++i) text += fmt::format(",{:.9g}", spectra.power[i][bin]);
    for (const std::vector<double>& cross : spectra.cross) text += fmt::format(",{:.9g}", cross[bin]);
}

void append_names(std::string& text, const std::vector<std::uint32_t>& used, const std::string& end)
{
    text += ",all" + end;
    for (const std::uint32_t i : used) text += fmt::format(",class_{}{}", i, end);
    for (std::size_t i = 0; i < used.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) text += fmt::format(",cross_{}_{}{}", used[j], used[i], end);
}

}

ClassSpectra averaged_spectra(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              const ClassSet& first)
{
    std::vector<CrossSpectra> sets{class_spectra(first.points)};
    for (std::uint32_t set = 1; set < settings.sets; ++set) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(fmt::format("spectra: set {} of {}", set + 1, settings.sets));
        sets.push_back(class_spectra(throw_classes(settings, seed, place, set).points, sets.front().bins()));
    }
    ClassSpectra result{settings.sets, sets.front(), {}};
    if (settings.sets == 1) return result;
    result.mean = {combined_curves(sets, &CrossSpectra::power, mean_of_values),
                   combined_curves(sets, &CrossSpectra::cross, mean_of_values)};
    result.error = {combined_curves(sets, &CrossSpectra::power, standard_error_of_mean),
                    combined_curves(sets, &CrossSpectra::cross, standard_error_of_mean)};
    return result;
}

std::string spectra_csv(const ClassedPoints& points, const ClassSpectra& spectra)
{
    const std::vector<std::uint32_t> used = used_classes(points);
    std::string text = "frequency";
    append_names(text, used, "");
    if (spectra.sets > 1) append_names(text, used, "_error");
    text += '\n';
    for (std::size_t k = 0; k < spectra.mean.bins(); ++k) {
        text += fmt::format("{}", k + 1);
        append_columns(text, spectra.mean, k);
        if (spectra.sets > 1) append_columns(text, spectra.error, k);
        text += '\n';
    }
    return text;
}

}
