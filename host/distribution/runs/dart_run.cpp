// kind = "darts": points in a region of the plane by dart throwing, and how far apart they are.
//
// Dissertation, section 4.2.4.1, without the torus. Spectra and relative radii of the torus say nothing about a region:
// distances are what is measured.
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/region_text.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/region_darts.hpp"
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
              "what is inside: points, or whole disks of half the minimum distance around them");
    keys.region("obstacles", s.obstacles,
                "what points keep away from: a file of GeoJSON or WKT with points, lines and polygons")
        .otherwise("none");
    keys.number("obstacle_distance", s.obstacle_distance, {0, 1e12}, "the least distance of points from obstacles")
        .unit("units of the region")
        .otherwise("min_distance from points, 0 from lines and polygons");
    if (!keys.is_read()) return;
    if (keys.is_given("obstacle_distance") && s.obstacles.empty())
        throw keys.invalid("obstacle_distance", "goes with " + keys.name_of("obstacles"));
    RegionLand land;
    if (!s.obstacles.empty()) keys.check("region", [&] { read_region(s.region, s.is_planar); });
    keys.check(s.obstacles.empty() ? "region" : "obstacles", [&] { land = region_land(s); });
    if (!s.points && !s.min_distance)
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("points"), keys.name_of("min_distance")));
    if (keys.is_given("relative_radius") && !s.points)
        throw keys.invalid("relative_radius", "goes with " + keys.name_of("points"));
    keys.check(s.min_distance ? "min_distance" : "points", [&] { region_dart_request(s, 0, std::move(land)); });
}

std::string dart_label(const DartSettings& s) { return "Darts in " + name_of_input(s.region); }

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
    for (const RegionPolygon& polygon : darts.request.land.rest.polygons) {
        add_ring(lines, polygon.outline);
        for (const RegionRing& hole : polygon.holes) add_ring(lines, hole);
    }
    for (const auto& [x0, y0, x1, y1] : lines_within(darts.request.land.obstacles, box))
        add_line(obstacles, {x0, y0}, {x1, y1});
    const double radius = std::min(darts.request.min_distance * scale / 6, picture_side / 100);
    for (const auto& [x, y] : points_within(darts.request.land.obstacles, box)) {
        const auto [left, top] = placed(x, y);
        obstacles.disks.push_back({left, top, radius});
    }
    for (std::size_t i = 0; i < darts.points.size(); ++i) {
        const auto [x, y] = placed(darts.points[i][0], darts.points[i][1]);
        dots.disks.push_back({x, y, radius});
    }
    picture.groups = {std::move(lines), std::move(dots)};
    if (darts.request.land.obstacles.count() > 0) picture.groups.push_back(std::move(obstacles));
    return picture;
}

DistributionResult make_darts(const DartSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              DistributionFiles& files)
{
    const RegionDarts darts = throw_region_darts(settings, seed, place);
    const PlaneRegion& plane = darts.request.land.rest;
    DistributionResult result;
    result.facts = {fmt::format("{} points", darts.points.size()),
                    darts.is_saturated ? "saturated: no further point fits" : "stopped at that number",
                    fmt::format("{} polygons, {} corners", plane.polygons.size(), corner_count(plane))};
    if (const std::size_t obstacles = darts.request.land.obstacles.count(); obstacles > 0)
        result.facts.push_back(fmt::format("{} obstacles", obstacles));
    if (settings.boundary == RegionBoundary::disks) result.facts.push_back("disks are inside whole");
    files.add_marks("points.json", picture_of(darts), "The points in their region.", result);
    write_points(files.add("points.npy"), darts.points);
    result.files.push_back("points.npy");
    result.numbers = dart_numbers(darts);
    return result;
}

}

DistributionNumbers dart_numbers(const RegionDarts& darts)
{
    const double area = darts.request.region->area();
    const auto count = static_cast<double>(darts.points.size());
    DistributionNumbers numbers;
    numbers.push_back({"points", "Points", count, "in the region"});
    numbers.push_back({"area", "Area", area, "of the region, in squares of its units"});
    numbers.push_back(
        {"min_distance", "Minimum distance", darts.request.min_distance, "that was asked for, in units of the region"});
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

}
