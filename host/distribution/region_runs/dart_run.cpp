// kind = "darts" and "points": points in a region of the plane or of space, by dart throwing and by other methods, and
// how far apart they are.
//
// Dissertation, sections 4.2.4.1, 4.2.4.2, 4.2.5, without the torus. Spectra and relative radii of the torus say
// nothing about a region: distances are what is measured.
#include "base/files/file_kind.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/region_units.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/region_runs/dart_pictures.hpp"
#include "host/distribution/region_runs/region_results.hpp"
#include "host/distribution/regions/line_points.hpp"
#include "host/distribution/regions/nearest_in_plane.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "host/distribution/regions/space_points.hpp"
#include "host/distribution/regions/varied_points.hpp"
#include "host/kinds/kinds.hpp"
#include "host/sampling/regions/region_gaussian.hpp"
#include "host/settings/keys/region_keys.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {
namespace {

void distance_keys(Keys& keys, DartSettings& s)
{
    VaryingDistance& v = s.varying;
    keys.number_over_region(
            "min_distance", s.min_distance, v.text, v.from, {1e-12, 1e12},
            "the least distance of two points; where it varies, a formula in the region's x and y, or a "
            "picture over its box, and only a shape where points are given")
        .unit(region_units)
        .otherwise("that of relative_radius");
    keys.numbers("distance_range", v.range, {{1e-12, 1e12}}, {"black", "white"},
                 "the distances where the picture of min_distance is 0 and 1")
        .unit(region_units)
        .otherwise("needed with a picture");
    keys.word("between", v.between, kept_distances_names,
              "which distance two points keep where it varies: the smaller of theirs, or the mean of both")
        .only_if(!keys.is_read() || s.varies(), "a min_distance that varies");
    if (!keys.is_read()) return;
    const bool is_picture = s.varies() && is_file_name(v.text);
    if (is_picture && !keys.is_given("distance_range"))
        throw keys.invalid("min_distance", "needs " + keys.name_of("distance_range") + ", as it is a picture");
    if (!is_picture && keys.is_given("distance_range"))
        throw keys.invalid("distance_range", "needs a picture as " + keys.name_of("min_distance"));
}

/// Reads the region, and refuses what regions of space do not take.
void read_land(Keys& keys, DartSettings& s)
{
    if (!s.is_in_space()) {
        if (!s.obstacles.empty()) keys.check("region", [&] { read_region(s.region, s.reading); });
        keys.check(s.obstacles.empty() ? "region" : "obstacles", [&] { s.land = region_land(s); });
        return;
    }
    const std::string plane_only = "needs a region of the plane, and this one is of space";
    if (s.varies()) throw keys.invalid("min_distance", "a distance that varies " + plane_only);
    for (const char* key : {"obstacles", "obstacle_distance"})
        if (keys.is_given(key)) throw keys.invalid(key, plane_only);
    for (const char* key : region_reading_names)
        if (keys.is_given(key)) throw keys.invalid(key, plane_only);
    if (s.boundary == RegionBoundary::on) throw keys.invalid("boundary", plane_only);
    keys.check("region", [&] { s.space = whole_space(s); });
    if (!is_mesh_name(s.region)) return;
    for (const auto& file : files_beside_mesh(s.region)) keys.reads_too(file);
}

/// Refuses keys that only regions with an inside have.
void check_along(const Keys& keys, const DartSettings& s)
{
    for (const char* key : {"overlap", "buffer"})
        if (keys.is_given(key)) throw keys.invalid(key, "cannot be combined with " + keys.name_of("along"));
    if (s.is_in_space()) throw keys.invalid("along", "needs a region of the plane, and this one is of space");
}

void dart_keys(Keys& keys, DartSettings& s)
{
    keys.region(s.region);
    region_reading_keys(keys, s.reading);
    keys.flag("along", s.reading.is_along,
              "whether points lie on the region's lines and outlines, at distances through the plane");
    if (s.reading.is_along) check_along(keys, s);
    keys.integer("points", s.points, 1, max_points, "the number of points").otherwise("as many as there is room for");
    distance_keys(keys, s);
    keys.number("relative_radius", s.relative_radius, {0.001, 1},
                "of so many points: their distance over that of the densest packing of as many in the region's area");
    if (keys.is_given("relative_radius") && s.min_distance)
        throw keys.invalid("relative_radius", "cannot be combined with " + keys.name_of("min_distance"));
    keys.word("boundary", s.boundary, region_boundary_names,
              "what is inside: points, whole disks of half the minimum distance around them, or points that lie on "
              "the boundary first");
    obstacle_keys(keys, s.obstacles, s.obstacle_distance, "min_distance from points, 0 from lines and polygons");
    if (!keys.is_read()) return;
    read_land(keys, s);
    if (!s.points && !s.min_distance && !s.varies())
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("points"), keys.name_of("min_distance")));
    if (keys.is_given("relative_radius") && !s.points)
        throw keys.invalid("relative_radius", "needs " + keys.name_of("points"));
    if (s.is_in_space()) {
        keys.check(s.min_distance ? "min_distance" : "points", [&] { space_distance_request(s, 0); });
        return;
    }
    if (s.reading.is_along) {
        if (s.varies())
            throw keys.invalid("min_distance",
                               "a distance that varies cannot be combined with " + keys.name_of("along"));
        if (s.boundary != RegionBoundary::inside)
            throw keys.invalid("boundary", "cannot be combined with " + keys.name_of("along"));
        keys.check(s.min_distance ? "min_distance" : "points", [&] { distance_along(s, lines_of(s.land->whole)); });
        return;
    }
    if (s.varies() && s.boundary != RegionBoundary::inside)
        throw keys.invalid("boundary", fmt::format("needs a number as {}", keys.name_of("min_distance")));
    if (s.varies() && !s.obstacle_distance && !s.land->obstacles.points.empty())
        throw keys.invalid("obstacles", fmt::format("has points, which need {} where {} varies",
                                                    keys.name_of("obstacle_distance"), keys.name_of("min_distance")));
    if (s.varies()) return;
    keys.check(s.min_distance ? "min_distance" : "points", [&] { region_dart_request(s, 0, s.land); });
    if (s.boundary == RegionBoundary::on && s.obstacle_distance && !s.land->obstacles.points.empty())
        throw keys.invalid("boundary",
                           fmt::format("needs {} where no obstacle is a point", keys.name_of("obstacle_distance")));
}

void check_varied(Keys& keys, const RegionPointSettings& s, VaryingDistance& varying)
{
    if (!keys.is_read() || !s.place.varies()) return;
    keys.check("min_distance",
               [&] { varying.request = std::make_shared<const VariedRequest>(varied_request(s, s.place.land)); });
}

void dart_kind_keys(Keys& keys, DartSettings& s)
{
    dart_keys(keys, s);
    RegionPointSettings points; // by darts
    points.place = s;
    check_varied(keys, points, s.varying);
}

/// Methods that take distances which vary need a number of points, but for darts.
/// All partners of all candidates are in memory, some hundred bytes of each.
constexpr std::size_t most_varied_candidates = std::size_t{1} << 24;

void check_method_of_varied(const Keys& keys, const RegionPointSettings& s)
{
    const RegionMethod method = s.method;
    if (method == RegionMethod::lloyd || method == RegionMethod::gaussian || method == RegionMethod::bridson)
        throw keys.invalid("min_distance", fmt::format("varies, which {} does not take: darts, relaxation and "
                                                       "elimination do",
                                                       region_methods[method]));
    if (method != RegionMethod::darts && !s.place.points)
        throw keys.problem(fmt::format("{} needs {}", region_methods[method], keys.name_of("points")));
    if (method == RegionMethod::elimination && *s.place.points > most_varied_candidates / s.candidates)
        throw keys.invalid("points", fmt::format("must be at most {} with {} candidates each where distances vary",
                                                 most_varied_candidates / s.candidates, s.candidates));
}

void region_point_keys(Keys& keys, RegionPointSettings& s)
{
    keys.word("method", s.method, region_methods, "how points are made: see docs/regions.md");
    dart_keys(keys, s.place);
    if (keys.is_read() && s.place.reading.is_along && s.method != RegionMethod::darts)
        throw keys.invalid("along", "needs " + keys.shown("method", "darts"));
    if (keys.is_read() && s.place.is_in_space() &&
        (s.method == RegionMethod::lloyd || s.method == RegionMethod::gaussian))
        throw keys.invalid("method", "needs a region of the plane, and this one is of space: darts, relaxation, "
                                     "elimination and bridson do");
    const auto is_one_of = [&](auto... methods) { return ((s.method == methods) || ...); };
    using enum RegionMethod;
    keys.integer("attempts", s.attempts, 1, 1'000'000'000,
                 "darts that fail in a row before the radius is reduced, or around a point before it is given up")
        .otherwise("1000 of relaxation, 30 of bridson")
        .only_if(is_one_of(relaxation, bridson), "method = relaxation or bridson");
    keys.number("factor", s.factor, {0.01, 0.999999}, "what the radius is multiplied by")
        .only_if(is_one_of(relaxation), "method = relaxation");
    keys.integer("candidates", s.candidates, 1, 30, "random points to begin with, for each point that is kept")
        .only_if(is_one_of(elimination), "method = elimination");
    keys.integer("iterations", s.iterations, 0, 1'000'000, "steps to centroids, or along the forces of Gaussians")
        .otherwise("50 of lloyd, 100 of gaussian")
        .only_if(is_one_of(lloyd, gaussian), "method = lloyd or gaussian");
    if (keys.is_read() && s.place.varies()) check_method_of_varied(keys, s);
    check_varied(keys, s, s.place.varying);
    if (!keys.is_read() || is_one_of(darts)) return;
    if (keys.is_given("relative_radius"))
        throw keys.invalid("relative_radius", "needs " + keys.shown("method", "darts"));
    if (s.place.boundary == RegionBoundary::on)
        throw keys.invalid("boundary", "needs " + keys.shown("method", "darts"));
    if (s.place.varies()) return;
    if (is_one_of(gaussian) && s.place.points.value_or(SIZE_MAX) < least_points_of_region_gaussian())
        throw keys.invalid("points",
                           fmt::format("must be at least {} for gaussian, so that Gaussians do not meet around "
                                       "the region",
                                       least_points_of_region_gaussian()));
    const bool takes_distance = is_one_of(bridson);
    const std::string other = takes_distance ? "points" : "min_distance",
                      needed = takes_distance ? "min_distance" : "points";
    if (keys.is_given(other))
        throw keys.invalid(other, fmt::format("{} takes {} alone", region_methods[s.method], keys.name_of(needed)));
}

std::string dart_label(const DartSettings& s) { return "Darts in " + name_of_input(s.region); }

std::string region_point_label(const RegionPointSettings& s)
{
    return fmt::format("Points in {}, {}", name_of_input(s.place.region), region_methods[s.method]);
}

/// Adds the pictures and files that sets of one distance do not have.
void add_varied_results(const VariedSet& set, DistributionFiles& files, DistributionResult& result)
{
    result.facts.push_back(words_of_varied(set));
    write_distances(files.add("distances.npy"), set);
    result.files.push_back("distances.npy");
    files.add_curves("nearest", nearest_chart(set),
                     "Nearest distances of points, over the distance that both points keep: none is below 1.", result);
}

std::string words_of_region(const RegionDarts& darts)
{
    if (darts.length > 0) {
        const std::vector<RegionRing>& lines = lines_of(darts.request.land->whole);
        return fmt::format("{} {}, {:.6g} long", lines.size(), noun(lines.size(), "line"), darts.length);
    }
    if (!darts.space) {
        const PlaneRegion& plane = darts.request.land->rest;
        const std::size_t polygons = plane.polygons.size();
        return fmt::format("{} {}, {} corners", polygons, noun(polygons, "polygon"), corner_count(plane));
    }
    if (darts.space->shape() == SpaceShape::solid)
        return fmt::format("a solid by a lattice of {} cells", fmt::join(darts.space->cells(), " x "));
    return darts.space->shape() == SpaceShape::ball ? "a ball" : "a box";
}

DistributionResult result_of(const RegionDarts& darts, const DartSettings& settings, const std::string& how,
                             DistributionFiles& files)
{
    DistributionResult result;
    result.facts = {fmt::format("{} points", darts.points.size()), how, words_of_region(darts)};
    if (const std::size_t obstacles = darts.obstacle_count(); obstacles > 0)
        result.facts.push_back(fmt::format("{} obstacles", obstacles));
    std::ranges::copy(darts.notes(), std::back_inserter(result.facts));
    if (settings.boundary == RegionBoundary::disks)
        result.facts.push_back(fmt::format("{} are inside whole", darts.space ? "balls" : "disks"));
    files.add_marks("points.json", dart_picture(darts),
                    darts.space ? "The points in their region, seen from in front and above: those behind are lighter."
                    : darts.length > 0 ? "The points on their lines."
                    : darts.varied     ? "The points in their region, with disks of half their distances."
                                       : "The points in their region.",
                    result);
    write_points(files.add("points.npy"), darts.file_points());
    result.files.push_back("points.npy");
    if (darts.varied) add_varied_results(*darts.varied, files, result);
    result.numbers = dart_numbers(darts);
    if (!darts.varied && !darts.space && darts.length == 0)
        add_region_curves(darts.request.land->rest, darts.points, files, result);
    return result;
}

DistributionResult make_darts(const DartSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              DistributionFiles& files)
{
    const RegionDarts darts = throw_region_darts(settings, seed, place);
    return result_of(darts, settings,
                     darts.is_saturated ? "saturated: no further point fits" : "stopped at that number", files);
}

DistributionResult make_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               DistributionFiles& files)
{
    return result_of(make_region_points(settings, seed, place), settings.place, region_methods[settings.method], files);
}

}

namespace {

/// Adds the plane that longitude and latitude were mapped to.
void append_map_numbers(const RegionDarts& darts, DistributionNumbers& numbers)
{
    if (!darts.request.land || !is_mapped(darts.request.land->whole)) return;
    const RegionSource& source = *darts.request.land->whole.source;
    const auto [longitude, latitude] = source.map->middle();
    numbers.push_back({"center_longitude", "Longitude of the plane's middle", longitude,
                       "of Lambert's azimuthal equal-area plane, whose units are metres"});
    numbers.push_back({"center_latitude", "Latitude of the plane's middle", latitude, "of this plane"});
    numbers.push_back(
        {"distortion", "Distortion", source.distortion, "the part by which lengths in this plane are off at most"});
}

/// The unit of lengths that numbers name.
std::string units_of_lengths(const RegionDarts& darts)
{
    return darts.request.land ? length_units(darts.request.land->whole) : "units of the region";
}

/// Points lie in something of this length, area or volume.
struct RegionSize
{
    double size = 0;
    int dimension = 2;
    const char* key = "area";
    const char* title = "Area";
    std::string meaning = "of the region, in squares of its units";
};

RegionSize size_of(const RegionDarts& darts)
{
    if (darts.length > 0) return {darts.length, 1, "length", "Length", "of the lines, in " + units_of_lengths(darts)};
    if (darts.space) return {darts.space->volume(), 3, "volume", "Volume", "of the region, in cubes of its units"};
    RegionSize size{darts.request.region->area()};
    if (darts.request.land && is_mapped(darts.request.land->whole)) size.meaning = "of the region, in m²";
    return size;
}

/// Returns the least distance over that of the densest packing or, on lines, over the length that each point has.
DistributionNumber relative_radius_number(const RegionDarts& darts, const RegionSize& size, double least)
{
    const std::size_t count = darts.points.size();
    if (size.dimension == 1)
        return {"relative_radius", "Relative radius", least * static_cast<double>(count) / size.size,
                "least distance over the length of the lines for each point"};
    return {"relative_radius", "Relative radius",
            least / (max_min_distance(count, size.dimension) * std::pow(size.size, 1.0 / size.dimension)),
            fmt::format("least distance over that of the densest packing of as many points in the region's "
                        "{}; points may lie on the boundary, so that few have more than on a torus",
                        size.key)};
}

}

DistributionNumbers dart_numbers(const RegionDarts& darts)
{
    const RegionSize size = size_of(darts);
    const auto count = static_cast<double>(darts.points.size());
    DistributionNumbers numbers;
    numbers.push_back({"points", "Points", count, "in the region"});
    numbers.push_back({size.key, size.title, size.size, size.meaning});
    append_map_numbers(darts, numbers);
    if (darts.sure_distance > 0)
        numbers.push_back({"min_distance", "Minimum distance", darts.sure_distance,
                           "that points are sure to have, in " + units_of_lengths(darts)});
    if (darts.points.size() < 2) return numbers;
    const NearestDistances nearest =
        darts.space ? nearest_in_space(*darts.space, darts.points) : nearest_distances(darts.points);
    numbers.push_back(
        {"least_distance", "Least distance", nearest.least, "of two points, in " + units_of_lengths(darts)});
    numbers.push_back({"mean_nearest", "Mean nearest distance", nearest.mean,
                       "of points from their nearest ones, also beside the boundary, in " + units_of_lengths(darts)});
    if (darts.varied) {
        append_varied_numbers(*darts.varied, numbers);
        return numbers;
    }
    numbers.push_back(relative_radius_number(darts, size, nearest.least));
    return numbers;
}

Kind dart_kind()
{
    return make_kind<DartSettings>({"distribution", "darts", "distribute darts", "Darts in a region",
                                    "Throw darts into polygons with holes, to a number of points or until none fits"},
                                   dart_kind_keys, dart_label, make_darts);
}

Kind region_point_kind()
{
    return make_kind<RegionPointSettings>({"distribution", "points", "distribute points", "Points in a region",
                                           "Make points in polygons with holes by one of several methods"},
                                          region_point_keys, region_point_label, make_points);
}

}
