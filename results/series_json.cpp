// The members of a series in results.json.
#include "base/files/json_members.hpp"
#include "results/periodograms.hpp"
#include "results/series.hpp"

namespace poissonlab {

void members(JsonMembers& m, Stored<Statistic> auto& statistic)
{
    m.member("min", statistic.min);
    m.member("mean", statistic.mean);
    m.member("max", statistic.max);
    m.or_none("each", statistic.each);
}

void members(JsonMembers& m, Stored<IterationSpread> auto& spread)
{
    m.member("min", spread.min);
    m.member("mean", spread.mean);
    m.member("max", spread.max);
}

void members(JsonMembers& m, Stored<Iterations> auto& iterations)
{
    m.file_name("file", iterations.file);
    m.member("realizations", iterations.realizations);
    m.object("relative_radius", iterations.relative_radius);
    m.object("energy", iterations.energy);
    m.object("relative_radius_within_tiles", iterations.relative_radius_within_tiles);
}

void members(JsonMembers& m, Stored<ZonePlateResult> auto& plate)
{
    m.member("size", plate.size, 1);
    m.file_name("file", plate.file);
    m.file_name("error_file", plate.error_file);
    m.object("rms_error", plate.rms_error);
    m.object_or_null("resolved_rms_error", plate.resolved_rms_error);
}

void members(JsonMembers& m, Stored<FoldedDensityFile> auto& folded)
{
    m.member("size", folded.size, 1);
    m.file_name("file", folded.file);
}

void members(JsonMembers& m, Stored<RegionResult> auto& region)
{
    m.member("name", region.name);
    m.member("area", region.area);
    m.member("unit_length", region.unit_length);
    m.if_any("perimeter", region.perimeter);
    m.member("polygons", region.polygons, 1);
    m.member("corners", region.corners, 3);
    m.if_any("is_in_metres", region.is_in_metres);
    m.if_any("has_density", region.has_density);
    m.if_any("envelope", region.envelope);
    m.if_any("tapers", region.tapers);
    m.if_any("covariance_error", region.covariance_error);
    m.if_any("notes", region.notes);
    if (m.is_there("file", !region.file.empty())) m.file_name("file", region.file);
    if (m.is_there("picture_file", !region.picture_file.empty())) m.file_name("picture_file", region.picture_file);
}

void members(JsonMembers& m, Stored<BoxResult> auto& box)
{
    m.member("sides", box.sides);
    m.check([&](const StoredObject& object) {
        const bool are_positive = std::ranges::all_of(box.sides, [](double side) { return side > 0; });
        if (!are_positive || box.sides.size() < 2 || box.sides.size() > 3)
            throw object.error("sides", "must be two or three numbers above 0");
    });
}

void members(JsonMembers& m, Stored<BorderResult> auto& border)
{
    m.member("pairs_across", border.pairs_across);
    m.member("chance", border.chance);
    m.member("relative_radius", border.relative_radius);
    m.member("mean_nearest_distance", border.mean_nearest_distance);
}

void members(JsonMembers& m, Stored<BlueNoiseVerdict> auto& blue_noise)
{
    m.member("answer", blue_noise.answer);
    m.member("because", blue_noise.because);
}

void members(JsonMembers& m, Stored<RegionPoints> auto& region)
{
    m.member("points", region.points);
    m.member("expected", region.expected);
}

void members(JsonMembers& m, Stored<TileSetBuild> auto& build)
{
    m.member("build_seconds", build.seconds);
    m.if_any("device", build.device);
    m.if_any("threads", build.threads);
}

void members(JsonMembers& m, Stored<GridPlace> auto& place)
{
    m.member("method", place.method);
    m.or_none("place", place.indices);
}

namespace {

const std::string null = "null";

/// Regions are members by their names.
void regions(JsonMembers& m, const std::vector<RegionPoints>& regions)
{
    for (const RegionPoints& region : regions) m.object(region.name, region);
}

void regions(JsonMembers& m, std::vector<RegionPoints>& regions)
{
    for (const char* name : {"corners", "edges", "faces", "interior"})
        if (m.stored().has(name)) m.object(name, regions.emplace_back(RegionPoints{name, 0, 0}));
}

/// The part of a value that is there, whose members stand among those of another one.
template <class T>
const T& present_value(const std::optional<T>& value)
{
    return *value;
}
template <class T>
T& present_value(std::optional<T>& value)
{
    return value.emplace();
}

void shown_members(const StoredObject& series, const char* name, NamedTexts& shown)
{
    if (!series.has(name)) return;
    const StoredObject object = series.object(name);
    for (const std::string& key : object.names())
        if (object.has(key)) shown.emplace_back(key, object.shown(key));
}

void check(const StoredObject& object, const IterationSpread& spread, std::size_t count)
{
    for (const auto& [name, numbers] : {std::pair("min", &spread.min), {"mean", &spread.mean}, {"max", &spread.max}})
        if (numbers->size() != count) throw object.error(name, "must have a number for each iteration");
}

void check(const StoredObject& object, const Iterations& iterations)
{
    const std::size_t count = iterations.realizations.size();
    if (count == 0) throw object.error("realizations", "must have a number for each iteration");
    check(object.object("relative_radius"), iterations.relative_radius, count);
    check(object.object("energy"), iterations.energy, count);
    if (const auto& within = iterations.relative_radius_within_tiles)
        check(object.object("relative_radius_within_tiles"), *within, count);
}

void check(const StoredObject& object, const Series& series)
{
    if (!series.points_each.empty() && series.points_each.size() != static_cast<std::size_t>(series.realizations))
        throw object.error("points_each", "must have a size for each realization");
    if (!std::ranges::is_sorted(series.repeated))
        throw object.error("repeated_realizations", "must have numbers of realizations in their order");
    if (series.is_estimate && (series.deterministic || periodograms_of(series) < 2))
        throw object.object("spectrum").error("kind", "one realization has a periodogram, not an estimate");
    if (series.radial_file.empty() && !series.spectrum_file.empty())
        throw object.error("radial", "is missing, though there is a spectrum");
    if (series.iterations) check(object.object("iterations"), *series.iterations);
}

}

void members(JsonMembers& m, Stored<TileSetRecord> auto& set)
{
    m.member("tiles", set.tiles, 1);
    m.member("points_per_tile", set.points_per_tile, 1);
    m.or_none("cached", set.cached);
    m.group_if(!set.regions.empty(), "regions", [&](JsonMembers& group) { regions(group, set.regions); });
    if (m.is_there("shared_points", set.shared_points.has_value()))
        m.member("shared_points", present_value(set.shared_points));
    if (m.is_there("build_seconds", set.build.has_value())) members(m, present_value(set.build));
}

namespace {

void describe(JsonMembers& m, Stored<Series> auto& series)
{
    m.folder_name("name", series.name);
    m.member("label", series.label);
    m.member("sampler", series.sampler);
    m.json("parameters", series.parameters_json);
    m.json("defaults", series.defaults_json);
    if (m.is_there("method", series.place.has_value())) members(m, present_value(series.place));
    m.member("deterministic", series.deterministic);
    if (m.is_there("window", series.is_window)) m.member("window", series.is_window);
    m.member("points", series.points, 1);
    m.if_any("points_each", series.points_each);
    m.member("realizations", series.realizations, 1);
    m.if_any("repeated_realizations", series.repeated);
    m.object_or_null("min_distance", series.min_distance);
    m.object_or_null("relative_radius", series.relative_radius);
    m.object_or_null("covered_fraction", series.covered_fraction);
    m.object_or_none("measures", series.measures);
    m.object("blue_noise", series.blue_noise);
    m.object("border", series.border);
    m.group_if(!series.spectrum_file.empty(), "spectrum", [&](JsonMembers& spectrum) {
        spectrum.word("kind", series.is_estimate, {"periodogram", "power spectrum estimate"});
        spectrum.member("size", series.spectrum_size, 2);
        spectrum.file_name("file", series.spectrum_file);
        if (spectrum.is_there("volume_file", !series.volume_file.empty()))
            spectrum.file_name("volume_file", series.volume_file);
    });
    m.group_if(!series.radial_file.empty(), "radial", [&](JsonMembers& radial) {
        radial.file_name("file", series.radial_file);
        radial.member("background_anisotropy_db", series.background_anisotropy_db);
    });
    m.group_if(!series.pair_correlation_file.empty(), "pair_correlation",
               [&](JsonMembers& pairs) { pairs.file_name("file", series.pair_correlation_file); });
    m.group_if(!series.number_variance_file.empty(), "number_variance",
               [&](JsonMembers& variance) { variance.file_name("file", series.number_variance_file); });
    m.object("folded_density", series.folded_density);
    m.object("box", series.box);
    m.object("region", series.region);
    if (series.iterations && series.iterations->realizations.empty())
        m.json("iterations", null); // without finite means
    else
        m.object("iterations", series.iterations);
    m.object("zone_plate", series.zone_plate);
    m.file_names("point_files", series.point_files);
    m.object("tile_set", series.tile_set);
    m.if_any("device_bytes", series.device_bytes);
    m.group_if(true, "timing", [&](JsonMembers& timing) {
        timing.or_none("sample_seconds", series.sample_seconds);
        timing.or_none("build_seconds", series.build_seconds);
        timing.or_none("preparation_seconds", series.preparation_seconds);
        timing.or_none("analysis_seconds", series.analysis_seconds);
    });
}

}

void members(JsonMembers& m, const Series& series) { describe(m, series); }

void members(JsonMembers& m, Series& series)
{
    describe(m, series);
    shown_members(m.stored(), "parameters", series.parameters);
    shown_members(m.stored(), "defaults", series.defaults);
    m.check([&](const StoredObject& object) { check(object, series); });
}

}
