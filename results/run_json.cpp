// results.json, written and read: every complaint names the file and the member.
#include "base/files/json_file.hpp"
#include "base/files/json_members.hpp"
#include "results/file_names.hpp"
#include "results/run.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace poissonlab {

void members(JsonMembers& m, Stored<MethodAxis> auto& axis)
{
    m.member("key", axis.key);
    m.member("symbol", axis.symbol);
    m.member("values", axis.values);
}

void members(JsonMembers& m, Stored<MethodGrid> auto& method)
{
    m.member("sampler", method.sampler);
    m.or_none("label", method.label);
    m.objects_or_none("axes", method.axes);
}

void members(JsonMembers& m, Stored<Machine> auto& machine)
{
    m.if_any("device", machine.device);
    m.if_any("platform", machine.platform);
    m.if_any("driver", machine.driver);
    m.if_any("device_version", machine.device_version);
    m.if_any("compute_units", machine.compute_units);
    m.if_any("threads", machine.threads);
    m.if_any("processes", machine.processes);
}

void members(JsonMembers& m, Stored<Run> auto& run)
{
    m.member("version", run.version);
    m.member("title", run.title);
    m.member("command", run.command);
    m.member("config", run.config);
    m.or_none("overrides", run.overrides);
    m.json("seed", run.seed);
    m.if_any("engine", run.engine);
    m.member("dimension", run.dimension, 2);
    m.if_any("realizations", run.realizations);
    m.object_or_none("machine", run.machine);
    m.objects_if_any("methods", run.methods);
    m.objects("series", run.series);
    m.objects_if_any("tilings", run.tilings);
    m.objects_if_any("constructions", run.constructions);
    m.objects_if_any("distributions", run.distributions);
    m.objects_if_any("schemes", run.schemes);
    m.if_any("missing", run.missing);
}

namespace {

constexpr const char* run_format = "poissonlab-results";
constexpr int run_format_version = 1;

void check_places(const StoredObject& root, const Run& run)
{
    const auto objects = root.objects("series");
    std::set<std::string> names;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (!names.insert(run.series[i].name).second) throw objects[i].error("name", "is used twice");
        const auto& place = run.series[i].place;
        if (!place) continue;
        if (place->method >= run.methods.size())
            throw objects[i].error("method", "must be the number of one of the methods");
        const auto& axes = run.methods[place->method].axes;
        bool inside = place->indices.size() == axes.size();
        for (std::size_t k = 0; inside && k < axes.size(); ++k) inside = place->indices[k] < axes[k].values.size();
        if (!inside) throw objects[i].error("place", "must be an index on each axis of the method");
    }
}

}

std::string run_json(const Run& run)
{
    const auto write = [&](JsonMembers& root) {
        root.format(run_format, run_format_version);
        members(root, run);
    };
    return json_text(write, 2) + "\n";
}

Run read_run(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / file_names::results;
    std::error_code unknown; // of a name that is too long: it is that of no file
    if (!std::filesystem::exists(folder, unknown)) throw InputError::at({folder.string()}, "no such folder");
    if (!std::filesystem::exists(file, unknown))
        throw InputError::at({folder.string()}, "has no results.json: must be a folder that `run` or `analyze` wrote");
    const nlohmann::json json = read_json_file(file);
    JsonMembers root(StoredObject(json, file));
    root.format(run_format, run_format_version);
    Run run;
    run.folder = folder;
    members(root, run);
    if (run.dimension > 3) throw root.stored().error("dimension", "must be 2 or 3");
    check_places(root.stored(), run);
    if (run.series.empty() && run.tilings.empty() && run.constructions.empty() && run.distributions.empty() &&
        run.schemes.empty())
        throw root.stored().error("series", "must hold at least one series");
    return run;
}

}
