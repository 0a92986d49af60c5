#include "host/series/distribution_units.hpp"

#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/programs/interrupt.hpp"
#include "host/distribution/distribution_run.hpp"
#include "results/pictures/archive.hpp"

#include <fmt/format.h>

namespace poissonlab {

UnitKey DistributionUnits::key_of(const DistributionTask& task) const
{
    const DistributionConfig& config = task.config;
    const Workplace& workplace = *experiment_.workplace;
    UnitKey key("distribution");
    key.add("code", versions_.distributions)
        .add("engine", experiment_.engine)
        .add("device", workplace.identity ? workplace.identity() : "")
        .add("seed", config.seed)
        .add("table", config.text);
    for (const std::filesystem::path& input : config.inputs)
        key.add("input", fmt::format("{:016x}", xxh64_bytes(read_whole_file(input))));
    return key;
}

std::optional<DistributionUnit> DistributionUnits::find(std::size_t item) const
{
    const auto unit = store_.find(key_of(experiment_.distributions[item]));
    if (!unit) return std::nullopt;
    std::tuple<DistributionResult, bool> record;
    from_bytes(unit->record, record);
    return DistributionUnit{std::get<DistributionResult>(record), std::get<bool>(record), unit->files};
}

std::string DistributionUnits::identity() const
{
    std::string text;
    for (const DistributionTask& task : experiment_.distributions) text += key_of(task).text();
    return text;
}

void DistributionUnits::make(std::size_t item)
{
    if (find(item)) return;
    stop_if_interrupted();
    const DistributionTask& task = experiment_.distributions[item];
    const UnitKey key = key_of(task);
    const Workplace& workplace = *experiment_.workplace;
    DistributionPlace place = experiment_.distribution_place;
    place.on_step = workplace.on_step;
    DistributionFiles files([&](const std::string& name) { return store_.file(key, name); });
    const DistributionResult result = make_distribution(task.config, place, files);
    const bool on_device = workplace.is_device_open && workplace.is_device_open();
    store_.store(key, to_bytes(std::tuple(result, on_device)), files.names());
}

}
