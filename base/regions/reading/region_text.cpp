#include "base/regions/region_text.hpp"

#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/formats/typed_region.hpp"
#include "base/regions/globe/globe_strip.hpp"
#include "base/regions/globe/mapped_shapes.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/polygon_sets.hpp"
#include "base/regions/region_source.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace poissonlab {
namespace {

/// Regions whose plane has lengths that are off by more than this part are refused.
constexpr double most_distortion = 0.1;

/// Planes that stretch lengths by more than this part are told of.
constexpr double told_distortion = 0.01;

double turn_of(const MapSystem& system) { return 2 * std::numbers::pi / system.angle; }

/// Makes a region of what a text holds, step by step, and notes what becomes of it.
class RegionMaker
{
public:
    RegionMaker(const TypedRegion& typed, const RegionReading& reading)
        : name_(typed.name), typed_(typed), reading_(reading), shapes_(typed.shapes.shapes),
          feature_of_polygon_(typed.shapes.feature_of), feature_of_line_(typed.shapes.feature_of_line)
    {}

    PlaneRegion region()
    {
        note_left_out();
        if (reading_.is_along) take_outlines();
        const auto system = source_system(typed_, reading_);
        if (system && system->has_angles) shapes_ = laid_in_strip(std::move(shapes_), turn_of(*system), name_);
        remember_features();
        if (reading_.is_along)
            check_lines();
        else
            unite();
        if (system && system->has_angles) {
            map_to_plane(*system);
        } else if (system) {
            note_stretched_plane(*system);
        }
        if (reading_.buffer > 0) grow();
        PlaneRegion made{shapes_.polygons};
        if (reading_.is_along) source_.lines = shapes_.lines;
        if (!reading_.is_along && (reading_.buffer > 0 || source_.map)) check_region(made, name_);
        if (system) {
            made.crs = crs_member(typed_, *system);
            source_.system = system->text;
        }
        made.source = std::make_shared<const RegionSource>(std::move(source_));
        return made;
    }

private:
    void note(const std::string& sentence) { source_.notes.push_back(fmt::format("{}: {}", name_, sentence)); }

    void note_left_out()
    {
        if (typed_.shapes.has_further_numbers) note("heights and measures of its positions are left out");
        const bool has_some = !shapes_.polygons.empty() || (reading_.is_along && !shapes_.lines.empty());
        if (reading_.buffer > 0 || !has_some) return;
        const std::size_t points = shapes_.points.size(), lines = reading_.is_along ? 0 : shapes_.lines.size();
        if (points + lines == 0) return;
        const std::string point_words = fmt::format("{} {}", points, noun(points, "point"));
        const std::string line_words = fmt::format("{} {}", lines, noun(lines, "line"));
        note(fmt::format("left out, as it has no {}: {}", reading_.is_along ? "length" : "inside",
                         points == 0  ? line_words
                         : lines == 0 ? point_words
                                      : point_words + " and " + line_words));
        shapes_.points.clear();
        if (!reading_.is_along) shapes_.lines.clear();
    }

    /// Polygons become their outlines and holes, after the lines.
    void take_outlines()
    {
        for (std::size_t i = 0; i < shapes_.polygons.size(); ++i) {
            const auto add = [&](RegionRing ring) {
                ring.push_back(ring.front());
                shapes_.lines.push_back(std::move(ring));
                if (!feature_of_polygon_.empty()) feature_of_line_.push_back(feature_of_polygon_[i]);
            };
            add(shapes_.polygons[i].outline);
            std::ranges::for_each(shapes_.polygons[i].holes, add);
        }
        shapes_.polygons.clear();
    }

    void check_lines() const
    {
        for (const RegionRing& line : shapes_.lines)
            for (const auto& place : line)
                if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
                    throw InputError(name_ + ": has a coordinate that is not a number");
        if (!(length_of(shapes_.lines) > 0))
            throw InputError(name_ + ": has no line with a length that points could lie on");
    }

    /// Features are kept as they are typed, before polygons become their union.
    void remember_features()
    {
        if ((reading_.is_along ? feature_of_line_ : feature_of_polygon_).empty()) return;
        for (std::size_t i = 0; i < typed_.shapes.ids.size(); ++i)
            source_.features.push_back({typed_.shapes.ids[i], typed_.shapes.properties[i]});
        for (std::size_t i = 0; i < shapes_.polygons.size() && i < feature_of_polygon_.size(); ++i)
            source_.features[feature_of_polygon_[i]].polygons.push_back(shapes_.polygons[i]);
        if (reading_.is_along) source_.feature_of_line = feature_of_line_;
    }

    /// Checks polygons. Those that are valid each by itself, but not together, become their union; not those of
    /// drawings, where a white shape over another one is a hole to the eye.
    void unite()
    {
        std::vector<RegionPolygon>& polygons = shapes_.polygons;
        if (polygons.empty() && reading_.buffer > 0 && shapes_.count() > 0) return;
        if (polygons.empty() && shapes_.count() > 0)
            throw InputError(fmt::format("{}: has points or lines and no polygon: the region is empty, unless a buffer "
                                         "makes it what lies around them",
                                         name_));
        if (polygons.size() < 2 || reading_.overlap == PolygonOverlap::refuse || typed_.kind == TypedKind::shape)
            return check_region({polygons}, name_);
        try {
            check_region({polygons}, name_);
        } catch (const InputError&) {
            for (std::size_t i = 0; i < polygons.size(); ++i)
                check_region({{polygons[i]}}, fmt::format("{}: polygon {}", name_, i + 1));
            const std::size_t before = polygons.size();
            polygons = united(polygons);
            check_region({polygons}, name_);
            note(fmt::format("{} polygons overlap or share edges: the region is their union, of {} {}", before,
                             polygons.size(), noun(polygons.size(), "polygon")));
        }
    }

    void map_to_plane(const MapSystem& system)
    {
        const auto plane = plane_around(shapes_, system);
        source_.distortion = largest_distortion(shapes_, *plane);
        if (!(source_.distortion <= most_distortion))
            throw InputError(fmt::format("{}: is too large for a plane: lengths would be off by up to {}, of which {} "
                                         "are the most",
                                         name_, percent(source_.distortion), percent(most_distortion)));
        const PlaceMap map = [plane](std::span<double> places) { plane->to_plane(places); };
        const RegionBox box = mapped_box(shapes_, map);
        shapes_ = mapped_shapes(shapes_, map, box);
        for (RegionFeature& feature : source_.features)
            feature.polygons = mapped_shapes({{}, {}, feature.polygons}, map, box).polygons;
        source_.map = plane;
        const auto [longitude, latitude] = plane->middle();
        note(fmt::format("longitude and latitude ({}) are mapped to Lambert's azimuthal equal-area plane around ({:g}, "
                         "{:g}): lengths are metres there, off by {} at most",
                         system.title, longitude, latitude, percent(source_.distortion)));
    }

    static std::string percent(double part)
    {
        return std::isfinite(part) ? fmt::format("{:.2g} %", std::max(100 * part, 1e-4)) : "any amount";
    }

    void note_stretched_plane(const MapSystem& system)
    {
        const RegionBox box = box_of_all(shapes_);
        const double scale = ground_scale(system, {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2});
        if (std::abs(scale - 1) > told_distortion)
            note(fmt::format("a metre on the ground is {:.4g} of {} in its middle: distances are those of that plane",
                             scale, system.title));
    }

    void grow()
    {
        shapes_ = {{}, {}, grown(shapes_, reading_.buffer)};
        note(fmt::format("the region is what lies within {:g} of its shapes", reading_.buffer));
    }

    const std::string& name_;
    const TypedRegion& typed_;
    const RegionReading& reading_;
    Obstacles shapes_;
    std::vector<std::size_t> feature_of_polygon_, feature_of_line_;
    RegionSource source_;
};

/// The points of a file in one of the formats of points.
std::vector<std::array<double, 2>> points_of_file(const std::string& file)
{
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<std::array<double, 2>> points;
    try {
        for (const PointSet& set : read_points(file, CoordinateRange{-far, far})) {
            if (set.dimension != 2) throw InputError("the points are in space");
            for (std::size_t i = 0; i < set.size(); ++i) points.push_back({set[i][0], set[i][1]});
        }
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}, nor a file of points: {}", printable(file), no_region, error.what()));
    }
    return points;
}

void check_obstacles(const Obstacles& obstacles, const std::string& name)
{
    if (obstacles.count() == 0) throw InputError(name + ": has no point, line or polygon to keep away from");
    const auto check_place = [&](const std::array<double, 2>& place) {
        if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
            throw InputError(name + ": has a coordinate that is not a number");
    };
    std::ranges::for_each(obstacles.points, check_place);
    for (const RegionRing& line : obstacles.lines) std::ranges::for_each(line, check_place);
    for (std::size_t i = 0; i < obstacles.polygons.size(); ++i)
        check_region({{obstacles.polygons[i]}},
                     obstacles.polygons.size() == 1 ? name : fmt::format("{}: polygon {}", name, i + 1));
}

/// The map from a system, or from the region's own coordinates where there is none, to the region's plane; nothing
/// where these are the same.
std::optional<PlaceMap> map_to(const PlaneRegion& region, const std::optional<MapSystem>& from)
{
    const std::string own = region.source ? region.source->system : "";
    const auto plane = region.source ? region.source->map : nullptr;
    const bool changes = from && !own.empty() && from->text != own;
    if (!plane && !changes) return {};
    const PlaceMap change = changes ? system_change(*from, map_system(own)) : PlaceMap([](std::span<double>) {});
    return [plane, change](std::span<double> places) {
        change(places);
        if (plane) plane->to_plane(places);
    };
}

Obstacles in_plane_of(const PlaneRegion& region, const Obstacles& obstacles, const std::optional<MapSystem>& from,
                      const std::string& name)
{
    const auto map = map_to(region, from);
    if (!map) return obstacles;
    const std::vector<std::string> notes = obstacles.notes;
    const bool has_angles = from ? from->has_angles : is_mapped(region);
    const double turn = turn_of(from && has_angles ? *from : map_system(region.source->system));
    const std::vector<RegionRing>& lines = lines_of(region);
    Obstacles mapped = mapped_shapes(has_angles ? laid_in_strip(obstacles, turn, name) : obstacles, *map,
                                     lines.empty() ? box_of(region) : box_around(lines));
    const RegionBox box = box_of_all(mapped);
    if (!std::isfinite(box.longest()))
        throw InputError(name + ": has a place that the region's plane has not: they must be in the same part of the "
                                "world");
    mapped.notes = notes;
    return mapped;
}

}

PlaneRegion read_region(const std::string& text, const RegionReading& reading)
{
    const TypedRegion typed(text, reading.is_along);
    if (typed.kind == TypedKind::unknown) throw InputError(fmt::format("{}: {}", typed.name, no_region));
    return RegionMaker(typed, reading).region();
}

void check_map_system(const std::string& name) { map_system(name); }

Obstacles read_obstacles(const std::string& text, const RegionReading& reading, const PlaneRegion& region)
{
    const TypedRegion typed(text);
    Obstacles obstacles = typed.kind == TypedKind::unknown ? Obstacles{points_of_file(text)} : typed.shapes.shapes;
    if (typed.shapes.has_further_numbers)
        obstacles.notes.push_back(typed.name + ": heights and measures of its positions are left out");
    check_obstacles(obstacles, typed.name);
    const auto system = obstacle_system(typed, reading);
    const bool is_known = region.source && !region.source->system.empty();
    if (system && system->has_angles && !is_known)
        refuse_degrees(box_of_all(obstacles), typed.name, "the region's system of coordinates is not said");
    return in_plane_of(region, obstacles, system, typed.name);
}

}
