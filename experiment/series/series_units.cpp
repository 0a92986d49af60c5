#include "experiment/series/series_units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

UnitKey identity_of(const SeriesTask& task, const CodeVersions& versions)
{
    UnitKey key("series");
    key.add("code", versions.sampling);
    if (task.identity) return key.add(task.identity());
    return key.add("sampler", task.sampler->name).add("name", task.name);
}

std::string spectrum_text(const AnalysisOptions& options)
{
    if (!options.spectrum) return "none";
    return *options.spectrum == PeriodogramMethod::fast ? "fast" : "exact";
}

}

SeriesUnits::SeriesUnits(const SeriesTask& task, const AnalysisOptions& options, const CodeVersions& versions)
    : realizations_(task.realizations), options_(options), analysis_version_(versions.analysis),
      identity_(identity_of(task, versions))
{}

std::uint32_t SeriesUnits::parts() const { return (realizations_ + realizations_per_part - 1) / realizations_per_part; }

RealizationRange SeriesUnits::part(std::uint32_t number) const
{
    const std::uint32_t first = number * realizations_per_part;
    return {first, std::min(realizations_per_part, realizations_ - first)};
}

UnitKey SeriesUnits::sample_key(std::uint32_t realization) const
{
    return UnitKey("realization").add(identity_).add("realization", realization);
}

UnitKey SeriesUnits::analysis_of(const char* kind, const RealizationRange& range) const
{
    UnitKey key = UnitKey(kind)
                      .add(identity_)
                      .add("analysis code", analysis_version_)
                      .add("first", range.first)
                      .add("count", range.count)
                      .add("spectrum", spectrum_text(options_))
                      .add("spectrum_size", options_.spectrum_size)
                      .add("bin_width", fmt::format("{}", options_.bin_width))
                      .add("volume", options_.volume)
                      .add("zone_plate", options_.zone_plate)
                      .add("tiles", options_.tiles)
                      .add("tile_sets", options_.tile_sets)
                      .add("window", options_.window)
                      .add("periodic", options_.is_periodic)
                      .add("distances_only", options_.distances_only);
    if (options_.keep_spectrum) key.add("keep_spectrum", true);
    if (!options_.box_sides.empty()) key.add("box", fmt::format("{}", options_.box_sides));
    if (options_.region) key.add("region", options_.region->hash).add("envelope", options_.region->envelope);
    return key;
}

UnitKey SeriesUnits::part_key(std::uint32_t number) const { return analysis_of("part of an analysis", part(number)); }

UnitKey SeriesUnits::analysis_key() const { return analysis_of("analysis", {0, realizations_}); }

UnitKey SeriesUnits::times_key(const std::string& conditions) const
{
    return UnitKey("times").add(identity_).add("conditions", conditions);
}

}
