// kind = "darts" and "points": points in a region of the plane, by dart throwing and by other methods, and how far
// apart they are.
//
// Dissertation, sections 4.2.4.1, 4.2.4.2, 4.2.5, without the torus. Spectra and relative radii of the torus say
// nothing about a region: distances are what is measured.
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/region_text.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/region_points.hpp"
#include "host/distribution/runs/region_curve_files.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

/// The longest side of the picture: its numbers have two decimals.
constexpr double picture_side = 4096;

void dart_keys(Keys& keys, DartSettings& s)
{
    keys.region(s.region);
    keys.flag("planar", s.is_planar, "whether coordinates that look like longitude and latitude are lengths");
    keys.integer("points", s.points, 1, max_points, "the number of points").otherwise("as many as there is room for");
    keys.number("min_distance", s.min_distance, {1e-12, 1e12}, "the least distance of two points")
        .unit("units of the region")
        .otherwise("that of relative_radius");
    keys.number("relative_radius", s.relative_radius, {0.001, 1},
                "of so many points: their distance over that of the densest packing of as many in the region's area")
        .excludes("min_distance");
    keys.word("boundary", s.boundary, region_boundary_names,
              "what is inside: points, whole disks of half the minimum distance around them, or points that lie on "
              "the boundary first");
    keys.region("obstacles", s.obstacles,
                "what points keep away from: a file of GeoJSON or WKT with points, lines and polygons")
        .otherwise("none");
    keys.number("obstacle_distance", s.obstacle_distance, {0, 1e12}, "the least distance of points from obstacles")
        .unit("units of the region")
        .otherwise("min_distance from points, 0 from lines and polygons");
    if (!keys.is_read()) return;
    if (keys.is_given("obstacle_distance") && s.obstacles.empty())
        throw keys.invalid("obstacle_distance", "goes with " + keys.name_of("obstacles"));
    if (!s.obstacles.empty()) keys.check("region", [&] { read_region(s.region, s.is_planar); });
    keys.check(s.obstacles.empty() ? "region" : "obstacles", [&] { s.land = region_land(s); });
    if (!s.points && !s.min_distance)
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("points"), keys.name_of("min_distance")));
    if (keys.is_given("relative_radius") && !s.points)
        throw keys.invalid("relative_radius", "goes with " + keys.name_of("points"));
    keys.check(s.min_distance ? "min_distance" : "points", [&] { region_dart_request(s, 0, s.land); });
    if (s.boundary == RegionBoundary::on && s.obstacle_distance && !s.land->obstacles.points.empty())
        throw keys.invalid("boundary",
                           fmt::format("goes with {} where no obstacle is a point", keys.name_of("obstacle_distance")));
}

void region_point_keys(Keys& keys, RegionPointSettings& s)
{
    keys.word("method", s.method, region_methods, "how points are made: see docs/regions.md");
    dart_keys(keys, s.place);
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
    keys.integer("iterations", s.iterations, 0, 1'000'000, "steps to centroids")
        .only_if(is_one_of(lloyd), "method = lloyd");
    if (!keys.is_read() || is_one_of(darts)) return;
    if (keys.is_given("relative_radius"))
        throw keys.invalid("relative_radius", "goes with " + keys.shown("method", "darts"));
    if (s.place.boundary == RegionBoundary::on)
        throw keys.invalid("boundary", "goes with " + keys.shown("method", "darts"));
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

/// The region's outlines and holes as lines, obstacles beside them, and points as disks of a third of their distance.
MarkPicture picture_of(const RegionDarts& darts)
{
    const RegionBox& box = darts.request.region->box();
    const double margin = picture_side / 100, scale = (picture_side - 2 * margin) / box.longest();
    MarkPicture picture{box.width() * scale + 2 * margin, box.height() * scale + 2 * margin};
    const auto placed = [&](double x, double y) {
        return std::array{margin + (x - box.low[0]) * scale, margin + (y - box.low[1]) * scale};
    };
    const auto add_line = [&](MarkGroup& group, const std::array<double, 2>& from, const std::array<double, 2>& to) {
        const auto [x0, y0] = placed(from[0], from[1]);
        const auto [x1, y1] = placed(to[0], to[1]);
        group.strokes.push_back({x0, y0, x1, y1, picture_side / 500});
    };
    const auto add_ring = [&](MarkGroup& group, const RegionRing& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) add_line(group, ring[i], ring[(i + 1) % ring.size()]);
    };
    MarkGroup lines{"#8a8f98"}, dots{"#000000"}, obstacles{"#c2410c"};
    for (const RegionPolygon& polygon : darts.request.land->rest.polygons) {
        add_ring(lines, polygon.outline);
        for (const RegionRing& hole : polygon.holes) add_ring(lines, hole);
    }
    for (const auto& [x0, y0, x1, y1] : lines_within(darts.request.land->obstacles, box))
        add_line(obstacles, {x0, y0}, {x1, y1});
    const double distance = darts.sure_distance > 0 ? darts.sure_distance : darts.request.min_distance;
    const double radius = std::min(distance * scale / 6, picture_side / 100);
    for (const auto& [x, y] : points_within(darts.request.land->obstacles, box)) {
        const auto [left, top] = placed(x, y);
        obstacles.disks.push_back({left, top, radius});
    }
    for (std::size_t i = 0; i < darts.points.size(); ++i) {
        const auto [x, y] = placed(darts.points[i][0], darts.points[i][1]);
        dots.disks.push_back({x, y, radius});
    }
    picture.groups = {std::move(lines), std::move(dots)};
    if (darts.request.land->obstacles.count() > 0) picture.groups.push_back(std::move(obstacles));
    return picture;
}

DistributionResult result_of(const RegionDarts& darts, const DartSettings& settings, const std::string& how,
                             DistributionFiles& files)
{
    const PlaneRegion& plane = darts.request.land->rest;
    DistributionResult result;
    result.facts = {fmt::format("{} points", darts.points.size()), how,
                    fmt::format("{} polygons, {} corners", plane.polygons.size(), corner_count(plane))};
    if (const std::size_t obstacles = darts.request.land->obstacles.count(); obstacles > 0)
        result.facts.push_back(fmt::format("{} obstacles", obstacles));
    if (settings.boundary == RegionBoundary::disks) result.facts.push_back("disks are inside whole");
    files.add_marks("points.json", picture_of(darts), "The points in their region.", result);
    write_points(files.add("points.npy"), darts.points);
    result.files.push_back("points.npy");
    result.numbers = dart_numbers(darts);
    add_region_curves(plane, darts.points, files, result);
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

DistributionNumbers dart_numbers(const RegionDarts& darts)
{
    const double area = darts.request.region->area();
    const auto count = static_cast<double>(darts.points.size());
    DistributionNumbers numbers;
    numbers.push_back({"points", "Points", count, "in the region"});
    numbers.push_back({"area", "Area", area, "of the region, in squares of its units"});
    if (darts.sure_distance > 0)
        numbers.push_back({"min_distance", "Minimum distance", darts.sure_distance,
                           "that points are sure to have, in units of the region"});
    if (darts.points.size() < 2) return numbers;
    const NearestDistances nearest = nearest_distances(darts.points);
    numbers.push_back({"least_distance", "Least distance", nearest.least, "of two points, in its units"});
    numbers.push_back({"mean_nearest", "Mean nearest distance", nearest.mean,
                       "of points from their nearest ones, also beside the boundary, in its units"});
    numbers.push_back({"relative_radius", "Relative radius",
                       nearest.least / (max_min_distance(darts.points.size(), 2) * std::sqrt(area)),
                       "least distance over that of the densest packing of as many points in the region's area; "
                       "points may lie on the boundary, so that few have more than on a torus"});
    return numbers;
}

Kind dart_kind()
{
    return make_kind<DartSettings>({"distribution", "darts", "distribute darts", "Darts in a region",
                                    "Throw darts into polygons with holes, to a number of points or until none fits"},
                                   dart_keys, dart_label, make_darts);
}

Kind region_point_kind()
{
    return make_kind<RegionPointSettings>({"distribution", "points", "distribute points", "Points in a region",
                                           "Make points in polygons with holes by one of several methods"},
                                          region_point_keys, region_point_label, make_points);
}

}
