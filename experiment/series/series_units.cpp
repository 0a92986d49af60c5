#include "experiment/series/series_units.hpp"

#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "results/records/archive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

namespace poissonlab {
namespace {

constexpr const char* points_file = "points.dat";
constexpr const char* tile_set_file = "tile-set.ptiles";

std::string tile_set_of(const SetTraits& traits)
{
    std::string bytes = traits.tile_set_file ? traits.tile_set_file() : "";
    return bytes.size() <= most_tile_set_bytes ? bytes : "";
}

std::optional<std::filesystem::path> stored_file(const UnitStore& store, const UnitKey& key, const char* name)
{
    const auto unit = store.find(key);
    if (!unit || !unit->files.contains(name)) return std::nullopt;
    return unit->files.at(name);
}

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

Sample SamplerSlot::make(const SeriesTask& task, const RealizationRange& range, const Workplace& workplace)
{
    const std::uint32_t realization = range.first;
    if (task_ != &task) {
        clear();
        sampler_ = task.create();
        task_ = &task;
    }
    sampler_->expect(range.first, range.count);
    const double built_before = sampler_->build_seconds();
    const auto begin = std::chrono::steady_clock::now();
    Sample sample;
    sample.points = sampler_->sample(realization);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

    SampleRecord& record = sample.record;
    const double built = sampler_->build_seconds();
    record.traits = sampler_->traits();
    const double prepared = record.traits.preparation_seconds;
    record.points = sample.points.size();
    record.seconds = record.traits.shared_seconds.value_or(std::max(0.0, seconds - (built - built_before)));
    record.conditions = workplace.conditions();
    record.on_device = workplace.is_device_open && workplace.is_device_open();
    record.build_seconds = built - build_seconds_;
    record.preparation_seconds = prepared - preparation_seconds_;
    build_seconds_ = built;
    preparation_seconds_ = prepared;
    if (realization == 0) sample.tile_set = tile_set_of(record.traits);
    record.traits.tile_set_file = {}; // the sampler may go before the record
    return sample;
}

void SamplerSlot::clear()
{
    sampler_.reset();
    task_ = nullptr;
    build_seconds_ = preparation_seconds_ = 0;
}

void store_sample(UnitStore& store, const UnitKey& key, const Sample& sample, bool with_points,
                  const std::string& comment)
{
    std::vector<std::string> files;
    if (with_points) {
        write_points(store.file(key, points_file), sample.points, comment);
        files.emplace_back(points_file);
    }
    if (!sample.tile_set.empty()) {
        write_whole_file(store.file(key, tile_set_file), sample.tile_set);
        files.emplace_back(tile_set_file);
    }
    store.store(key, to_bytes(sample.record), files);
}

std::optional<SampleRecord> stored_sample(const UnitStore& store, const UnitKey& key)
{
    const auto unit = store.find(key);
    if (!unit) return std::nullopt;
    SampleRecord record;
    from_bytes(unit->record, record);
    return record;
}

std::optional<std::filesystem::path> stored_points(const UnitStore& store, const UnitKey& key)
{
    return stored_file(store, key, points_file);
}

std::optional<std::filesystem::path> stored_tile_set(const UnitStore& store, const UnitKey& key)
{
    return stored_file(store, key, tile_set_file);
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
