#include "host/distribution/classes/class_averages.hpp"

#include "base/programs/interrupt.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_tiling.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

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
    std::vector<UsedSpectra> sets{{used_classes(first.points), class_spectra(first.points)}};
    const std::size_t bins = sets.front().spectra.bins();
    for (std::uint32_t number = 1; number < settings.sets; ++number) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(fmt::format("spectra: set {} of {}", number + 1, settings.sets));
        const ClassSet set = first.tiles ? classes_by_tiles(first.tiles, settings, seed, place, number)
                                         : throw_classes(settings, seed, place, number);
        sets.push_back({used_classes(set.points), class_spectra(set.points, bins)});
    }
    return mean_spectra(sets);
}

std::string spectra_csv(const ClassSpectra& spectra)
{
    std::string text = "frequency";
    append_names(text, spectra.classes, "");
    if (spectra.sets > 1) append_names(text, spectra.classes, "_error");
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
