#include "experiment/series/exhibit_units.hpp"

#include "base/files/json_members.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

namespace poissonlab {
namespace {

const std::vector<std::string> result_types{"distribution", "tiling", "construction"}; // in their order in Exhibited

/// The record of a unit: one result, and whether a device made it.
void record_members(JsonMembers& m, const ExhibitUnit& unit)
{
    const std::size_t type = unit.result.index();
    m.word("type", type, result_types);
    m.member("on_device", unit.on_device);
    std::visit([&](const auto& result) { m.object("result", result); }, unit.result);
}

void record_members(JsonMembers& m, ExhibitUnit& unit)
{
    std::size_t type = 0;
    m.word("type", type, result_types);
    m.member("on_device", unit.on_device);
    if (type == 0) unit.result.emplace<0>();
    if (type == 1) unit.result.emplace<1>();
    if (type == 2) unit.result.emplace<2>();
    std::visit([&](auto& result) { m.object("result", result); }, unit.result);
}

}

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
    ExhibitUnit exhibit{{}, false, unit->files};
    read_unplaced(unit->record, "stored exhibit", [&](JsonMembers& m) { record_members(m, exhibit); });
    return exhibit;
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
    ExhibitUnit made{make_exhibit(exhibit, place, files)};
    made.on_device = exhibit.kind->uses_device && workplace.is_device_open && workplace.is_device_open();
    store_.store(key, json_text([&](JsonMembers& m) { record_members(m, std::as_const(made)); }), files.names());
}

}
