#include "results/run.hpp"

#include "base/files/json_file.hpp"
#include "base/files/stored_object.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace poissonlab {

namespace {

constexpr int supported_format_version = 1;
constexpr auto kind_estimate = "power spectrum estimate";
constexpr auto kind_periodogram = "periodogram";

void check_format(const StoredObject& root)
{
    if (!root.has("format") || root.text("format") != "poissonlab-results")
        throw root.error("format", "must be \"poissonlab-results\"; this file is of another kind");
    if (const auto version = root.integer("format_version", 1); version != supported_format_version)
        throw root.error("format_version", "this program reads version " + std::to_string(supported_format_version));
}

std::optional<Statistic> read_statistic(const StoredObject& series, const std::string& name)
{
    if (!series.has(name)) return std::nullopt;
    const auto object = series.object(name);
    Statistic statistic{object.number("min"), object.number("mean"), object.number("max"), {}};
    if (object.has("each")) statistic.each = object.numbers("each");
    return statistic;
}

NamedTexts read_named_texts(const StoredObject& parent, const std::string& name)
{
    NamedTexts result;
    if (!parent.has(name)) return result;
    const auto object = parent.object(name);
    for (const auto& key : object.names())
        if (object.has(key)) result.emplace_back(key, object.shown(key));
    return result;
}

void read_spectrum_members(const StoredObject& object, Series& series)
{
    if (!object.has("spectrum")) return;
    const auto spectrum = object.object("spectrum");
    const auto kind = spectrum.text("kind");
    if (kind != kind_estimate && kind != kind_periodogram)
        throw spectrum.error("kind", std::string("must be \"") + kind_estimate + "\" or \"" + kind_periodogram + "\"");
    series.is_estimate = kind == kind_estimate;
    if (series.is_estimate && (series.deterministic || series.realizations < 2))
        throw spectrum.error("kind", "one realization has a periodogram, not an estimate");
    series.spectrum_size = spectrum.small_integer("size", 2);
    series.spectrum_file = spectrum.file_name("file");
    if (spectrum.has("volume_file")) series.volume_file = spectrum.file_name("volume_file");
}

IterationSpread read_spread(const StoredObject& object, const std::string& name, std::size_t count)
{
    const auto values = object.object(name);
    const auto read = [&](const char* member) {
        auto numbers = values.numbers(member);
        if (numbers.size() != count) throw values.error(member, "must have a number for each iteration");
        return numbers;
    };
    return {read("min"), read("mean"), read("max")};
}

std::optional<Iterations> read_iterations(const StoredObject& series)
{
    if (!series.has("iterations")) return std::nullopt;
    const auto object = series.object("iterations");
    Iterations iterations;
    iterations.file = object.file_name("file");
    iterations.realizations = object.numbers("realizations");
    const auto count = iterations.realizations.size();
    if (count == 0) throw object.error("realizations", "must have a number for each iteration");
    iterations.relative_radius = read_spread(object, "relative_radius", count);
    iterations.energy = read_spread(object, "energy", count);
    return iterations;
}

std::optional<StoredZonePlate> read_zone_plate_members(const StoredObject& series)
{
    if (!series.has("zone_plate")) return std::nullopt;
    const auto object = series.object("zone_plate");
    const auto whole = read_statistic(object, "rms_error");
    if (!whole) throw object.error("rms_error", "is missing");
    return StoredZonePlate{object.small_integer("size", 1), object.file_name("file"), object.file_name("error_file"),
                           *whole, read_statistic(object, "resolved_rms_error")};
}

StoredTileSet read_tile_set(const StoredObject& object)
{
    StoredTileSet set;
    set.tiles = object.integer("tiles", 1);
    set.points_per_tile = object.integer("points_per_tile", 1);
    if (object.has("build_seconds")) set.build_seconds = object.number("build_seconds");
    if (object.has("device")) set.device = object.text("device");
    if (object.has("cached")) set.cached = object.boolean("cached");
    if (!object.has("regions")) return set;
    const StoredObject regions = object.object("regions");
    for (const char* name : {"corners", "edges", "faces", "interior"})
        if (regions.has(name))
            set.regions.push_back(
                {name, regions.object(name).number("points"), regions.object(name).number("expected")});
    return set;
}

Series read_series(const StoredObject& object)
{
    Series series;
    series.name = object.folder_name("name");
    series.label = object.text("label");
    series.sampler = object.text("sampler");
    series.parameters = read_named_texts(object, "parameters");
    series.defaults = read_named_texts(object, "defaults");
    series.deterministic = object.boolean("deterministic");
    series.points = static_cast<std::size_t>(object.integer("points", 1));
    series.realizations = object.small_integer("realizations", 1);
    if (object.has("points_each")) {
        series.points_each = object.counts("points_each");
        if (series.points_each.size() != static_cast<std::size_t>(series.realizations))
            throw object.error("points_each", "must have a size for each realization");
    }

    series.min_distance = read_statistic(object, "min_distance");
    series.relative_radius = read_statistic(object, "relative_radius");
    series.covered_fraction = read_statistic(object, "covered_fraction");

    read_spectrum_members(object, series);
    if (object.has("radial")) {
        const auto radial = object.object("radial");
        series.radial_file = radial.file_name("file");
        series.background_anisotropy_db = radial.number("background_anisotropy_db");
    } else if (!series.spectrum_file.empty()) {
        throw object.error("radial", "is missing, though there is a spectrum");
    }
    if (object.has("pair_correlation"))
        series.pair_correlation_file = object.object("pair_correlation").file_name("file");
    series.iterations = read_iterations(object);
    series.zone_plate = read_zone_plate_members(object);
    series.measures = read_measures(object);
    series.point_files = object.file_names("point_files");
    if (series.point_files.empty()) throw object.error("point_files", "must name at least one file");

    if (object.has("timing")) {
        const auto timing = object.object("timing");
        if (timing.has("sample_seconds")) series.sample_seconds = timing.numbers("sample_seconds");
        if (timing.has("build_seconds")) series.build_seconds = timing.number("build_seconds");
    }
    if (object.has("tile_set")) series.tile_set = read_tile_set(object.object("tile_set"));
    return series;
}

std::vector<MethodGrid> read_methods(const StoredObject& root)
{
    std::vector<MethodGrid> methods;
    if (!root.has("methods")) return methods;
    for (const auto& object : root.objects("methods")) {
        MethodGrid method;
        method.sampler = object.text("sampler");
        if (object.has("label")) method.label = object.text("label");
        if (object.has("axes"))
            for (const auto& axis : object.objects("axes"))
                method.axes.push_back({axis.text("key"), axis.text("symbol"), axis.texts("values")});
        methods.push_back(std::move(method));
    }
    return methods;
}

// Where a series stands in the grid of its method.
void read_place(const StoredObject& object, const std::vector<MethodGrid>& methods, Series& series)
{
    if (!object.has("method")) return;
    series.method = static_cast<std::size_t>(object.integer("method", 0));
    if (*series.method >= methods.size()) throw object.error("method", "must be the number of one of the methods");
    if (object.has("place")) series.place = object.counts("place");
    const auto& axes = methods[*series.method].axes;
    bool inside = series.place.size() == axes.size();
    for (std::size_t i = 0; inside && i < axes.size(); ++i) inside = series.place[i] < axes[i].values.size();
    if (!inside) throw object.error("place", "must be an index on each axis of the method");
}

std::vector<Series> read_all_series(const StoredObject& root, const std::vector<MethodGrid>& methods)
{
    std::vector<Series> result;
    std::set<std::string> names;
    for (const auto& object : root.objects("series")) {
        result.push_back(read_series(object));
        read_place(object, methods, result.back());
        if (!names.insert(result.back().name).second) throw object.error("name", "is used twice");
    }
    return result;
}

}

std::string Run::machine_member(const std::string& name) const
{
    for (const auto& [key, value] : machine)
        if (key == name) return value;
    return {};
}

Run read_run(const std::filesystem::path& folder)
{
    const auto file = folder / "results.json";
    const auto json = read_json_file(file);
    const StoredObject root(json, file);
    check_format(root);

    Run run;
    run.folder = folder;
    run.title = root.text("title");
    run.version = root.text("version");
    run.command = root.text("command");
    run.config = root.text("config");
    if (root.has("overrides")) run.overrides = root.texts("overrides");
    if (root.has("seed")) run.seed = root.shown("seed");
    if (root.has("engine")) run.engine = root.text("engine");
    run.dimension = root.small_integer("dimension", 2);
    if (run.dimension > 3) throw root.error("dimension", "must be 2 or 3");
    run.machine = read_named_texts(root, "machine");
    run.methods = read_methods(root);
    run.series = read_all_series(root, run.methods);
    run.tilings = read_tilings(root);
    run.constructions = read_constructions(root);
    if (run.series.empty() && run.tilings.empty() && run.constructions.empty())
        throw root.error("series", "must hold at least one series");
    return run;
}

}
