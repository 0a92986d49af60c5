#include "app/commands/distributions/region_outputs.hpp"

#include "app/commands/picture_output.hpp"
#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/runs/dart_pictures.hpp"
#include "host/distribution/runs/varied_results.hpp"
#include "reports/drawings/mark_image.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

OutputFormats distance_formats() { return {{".npy"}}; }

/// Points in the system of coordinates that the region's file names.
void write_geojson(const std::filesystem::path& file, const RegionDarts& darts, const std::string& comment)
{
    const std::string crs = darts.request.land ? darts.request.land->whole.crs : "";
    write_geojson_points(file, darts.points.dimension, crs, comment,
                         [&](const PointSink& sink) { sink(darts.points.coordinates); });
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
    if (!varies) throw InputError("--distances: goes with a --min-distance that varies");
    checked_output(command, "--distances", distances, distance_formats());
}

void RegionOutputs::write(const RegionDarts& darts, const std::string& comment) const
{
    for (const std::filesystem::path& out : files.files()) {
        const auto& pictures = files.formats.endings;
        if (std::ranges::find(pictures, out.extension().string()) != pictures.end())
            write_picture_file(out, draw_marks(dart_picture(darts), {}));
        else if (out.extension() == ".geojson")
            write_geojson(out, darts, comment);
        else
            write_points(out, darts.points, comment);
    }
    if (!distances.empty()) write_distances(output_name(distances, distance_formats()), *darts.varied);
}

std::string words_of(const RegionDarts& darts)
{
    std::string what = fmt::format("{} {}", darts.points.size(), noun(darts.points.size(), "point"));
    if (darts.sure_distance > 0 && !darts.varied) what += fmt::format(" at least {} apart", darts.sure_distance);
    if (darts.is_saturated) what += ", between which no further one fits";
    return darts.varied ? what + "; " + words_of_varied(*darts.varied) : what;
}

}
