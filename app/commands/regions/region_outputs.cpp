#include "app/commands/regions/region_outputs.hpp"

#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/regions/region_features.hpp"
#include "base/regions/region_source.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/region_runs/dart_pictures.hpp"
#include "host/distribution/region_runs/region_results.hpp"
#include "reports/drawings/mark_image.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

OutputFormats distance_formats() { return {{".npy"}}; }

/// Points in the system of coordinates that the region's file names, with the id of the region's feature that they
/// lie in, where it has several.
void write_geojson(const std::filesystem::path& file, const RegionDarts& darts, const std::string& comment)
{
    const PlaneRegion* const whole = darts.request.land ? &darts.request.land->whole : nullptr;
    const std::string crs = whole ? crs_in_files(*whole) : crs_of_lengths;
    const PointSet points = darts.file_points();
    std::vector<std::string> features;
    if (whole && whole->source && whole->source->features.size() > 1)
        features = darts.features.empty() ? ids_of_features(whole->source->features, darts.points) : darts.features;
    write_geojson_points(
        file, points.dimension, crs, comment, [&](const PointSink& sink) { sink(points.coordinates); }, features);
}

/// Points for a program that draws, or for one that reads tables.
void write_point_file(const std::filesystem::path& file, const RegionDarts& darts, const std::string& comment)
{
    const std::string ending = file.extension();
    const bool is_of_globe = darts.request.land && is_mapped(darts.request.land->whole);
    if (ending == ".geojson") return write_geojson(file, darts, comment);
    if (ending == ".dxf" || ending == ".usda") return write_points(file, darts.points, comment);
    const PointSet points = darts.file_points();
    if (ending == ".csv" && is_of_globe)
        return write_csv_points(file, points.dimension, csv_header_globe,
                                [&](const PointSink& sink) { sink(points.coordinates); });
    write_points(file, points, comment);
}

/// The units of the coordinates in point files.
std::string units_of(const RegionDarts& darts)
{
    return darts.request.land ? file_units(darts.request.land->whole) : "units of the region";
}

/// A line that says how many points there are, how far apart they are, and whether a further one fits.
std::string words_of(const RegionDarts& darts)
{
    std::string what = fmt::format("{} {}", darts.points.size(), noun(darts.points.size(), "point"));
    if (darts.sure_distance > 0 && !darts.varied)
        what += fmt::format(" at least {}{} apart", darts.sure_distance,
                            darts.request.land && is_mapped(darts.request.land->whole) ? " m" : "");
    if (darts.is_saturated) what += ", between which no further one fits";
    return darts.varied ? what + "; " + words_of_varied(*darts.varied) : what;
}

}

std::vector<Option> RegionOutputs::options()
{
    return {
        files.option(),
        {"--distances", &distances, "Write the distance at each point, where it varies, to this .npy file", "FILE"}};
}

void RegionOutputs::check(const std::string& command, bool varies) const
{
    files.check(command);
    if (distances.empty()) return;
    if (!varies) throw InputError("--distances: needs a --min-distance that varies");
    checked_output(command, "--distances", distances, distance_formats());
}

void RegionOutputs::write(const RegionDarts& darts, const std::string& comment) const
{
    for (const std::filesystem::path& out : files.files()) {
        const auto& pictures = files.formats.endings;
        if (std::ranges::find(pictures, out.extension().string()) != pictures.end())
            write_picture_file(out, draw_marks(dart_picture(darts), {}));
        else
            write_point_file(out, darts, comment);
    }
    if (!distances.empty()) write_distances(output_name(distances, distance_formats()), *darts.varied);
}

void RegionOptions::finish(const RegionDarts& made) const
{
    const std::string what = words_of(made);
    say_note(what);
    for (const std::string& note : made.notes()) say_note(note);
    outs.write(made, command_comment(fmt::format("{}, in {}", what, units_of(made))));
    if (prints_json()) print_numbers(dart_numbers(made));
}

}
