#include "experiment/series/exhibit_units.hpp"

#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/programs/interrupt.hpp"
#include "results/pictures/archive.hpp"

#include <fmt/format.h>

namespace poissonlab {

UnitKey ExhibitUnits::key_of(const Exhibit& exhibit) const
{
    const Kind& kind = *exhibit.kind;
    const Workplace& workplace = *experiment_.workplace;
    UnitKey key("exhibit");
    key.add("code", versions_.of_table(kind.table));
    if (kind.uses_device)
        key.add("engine", experiment_.engine).add("device", workplace.identity ? workplace.identity() : "");
    key.add("seed", exhibit.seed).add("table", kind.table).add("keys", exhibit.identity());
    for (const std::filesystem::path& input : exhibit.settings.inputs)
        key.add("input", fmt::format("{:016x}", xxh64_bytes(read_whole_file(input))));
    return key;
}

std::optional<ExhibitUnit> ExhibitUnits::find(std::size_t item) const
{
    const auto unit = store_.find(key_of(experiment_.exhibits[item]));
    if (!unit) return std::nullopt;
    std::tuple<Exhibited, bool> record;
    from_bytes(unit->record, record);
    return ExhibitUnit{std::get<Exhibited>(std::move(record)), std::get<bool>(record), unit->files};
}

std::string ExhibitUnits::identity() const
{
    std::string text;
    for (const Exhibit& exhibit : experiment_.exhibits) text += key_of(exhibit).text();
    return text;
}

void ExhibitUnits::make(std::size_t item)
{
    if (find(item)) return;
    stop_if_interrupted();
    const Exhibit& exhibit = experiment_.exhibits[item];
    const UnitKey key = key_of(exhibit);
    const Workplace& workplace = *experiment_.workplace;
    DistributionPlace place = experiment_.place;
    place.on_step = workplace.on_step;
    DistributionFiles files([&](const std::string& name) { return store_.file(key, name); });
    const Exhibited result = make_exhibit(exhibit, place, files);
    const bool on_device = exhibit.kind->uses_device && workplace.is_device_open && workplace.is_device_open();
    store_.store(key, to_bytes(std::tuple(result, on_device)), files.names());
}

}
