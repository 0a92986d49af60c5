#include "base/regions/globe/mapped_shapes.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Coordinates that are ten times as far from 0 as they are from each other are places on the globe, where they could
/// be.
constexpr double far_away = 10;

/// Could the coordinates be longitudes and latitudes? What crosses the antimeridian may go on beyond 180 degrees.
bool fits_globe(const RegionBox& box)
{
    if (!(box.low[1] >= -90 && box.high[1] <= 90 && box.low[0] >= -360 && box.high[0] <= 360)) return false;
    const bool crosses_antimeridian =
        box.width() <= 180 && ((box.low[0] <= 180 && box.high[0] > 180) || (box.low[0] < -180 && box.high[0] >= -180));
    return (box.low[0] >= -180 && box.high[0] <= 180) || crosses_antimeridian;
}

bool is_far_away(const RegionBox& box)
{
    if (box.longest() <= 0) return false; // a point, or nothing, is small anywhere
    double nearest = 0;
    for (std::size_t k = 0; k < 2; ++k)
        if (box.low[k] > 0 || box.high[k] < 0)
            nearest = std::max(nearest, std::min(std::abs(box.low[k]), std::abs(box.high[k])));
    return nearest > far_away * box.longest();
}

MapSystem named_system(const TypedRegion& typed)
{
    try {
        return map_system(typed.shapes.system);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", typed.name, error.what()));
    }
}

/// The system that is said in some way.
std::optional<MapSystem> said_system(const TypedRegion& typed, const RegionReading& reading)
{
    if (reading.is_planar) return {};
    if (!reading.crs.empty()) return map_system(reading.crs);
    if (!typed.shapes.system.empty()) return named_system(typed);
    if (typed.is_json() && !typed.shapes.has_no_system && fits_globe(box_of_all(typed.shapes.shapes)))
        return map_system(geojson_system);
    return {};
}

using MappedPlace = std::array<double, 2>;

/// Edges are halved so often at most: an edge that bends on is none.
constexpr int most_halvings = 20;

/// The part of the distance from the region by which edges may be off.
constexpr double tolerance_away = 0.125;

/// The middle is rounded to so many parts of a unit of angle.
constexpr double parts_of_degree = 1e4;

MappedPlace mapped(const PlaceMap& map, MappedPlace place)
{
    map(place);
    return place;
}

MappedPlace between(const MappedPlace& a, const MappedPlace& b, double part)
{
    return {a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part};
}

double distance(const MappedPlace& a, const MappedPlace& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// The distance between the boxes of a few places and of a region.
double distance_from(const RegionBox& box, const RegionBox& region)
{
    double squared = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const double apart = std::max({box.low[k] - region.high[k], region.low[k] - box.high[k], 0.0});
        squared += apart * apart;
    }
    return std::sqrt(squared);
}

class EdgeMapper
{
public:
    /// Edges may bend out of the box of the corners, and obstacles matter up to its longest side away.
    EdgeMapper(const PlaceMap& map, const RegionBox& near)
        : map_(map), tolerance_(bent_edge_tolerance * near.longest()), near_(near)
    {
        for (std::size_t k = 0; k < 2; ++k) {
            near_.low[k] -= near.longest();
            near_.high[k] += near.longest();
        }
    }

    RegionRing line(const RegionRing& corners, bool is_closed) const
    {
        RegionRing line;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const MappedPlace corner = mapped(map_, corners[i]);
            add(line, corner, is_closed);
            if (i + 1 == corners.size() && !is_closed) break;
            const MappedPlace& next = corners[(i + 1) % corners.size()];
            add_edge(line, {corners[i], corner}, {next, mapped(map_, next)}, is_closed, 0);
        }
        return is_closed ? without_spike_at_ends(line) : line;
    }

private:
    struct Corner
    {
        MappedPlace typed, mapped;
    };

    static RegionRing without_spike_at_ends(const RegionRing& ring)
    {
        auto begin = ring.begin(), end = ring.end();
        while (end - begin > 2) {
            if (*begin == end[-1] || *begin == end[-2])
                --end;
            else if (begin[1] == end[-1])
                ++begin;
            else
                break;
        }
        return {begin, end};
    }

    /// Leaves out what goes to a place and back in rings: the seam of a map around a pole is drawn so.
    static void add(RegionRing& line, const MappedPlace& place, bool is_closed)
    {
        if (!line.empty() && line.back() == place) return;
        if (is_closed && line.size() > 1 && line[line.size() - 2] == place)
            line.pop_back();
        else
            line.push_back(place);
    }

    /// Adds the corners between two others. From either end they are the same to the last bit.
    void add_edge(RegionRing& line, const Corner& a, const Corner& b, bool is_closed, int halvings) const
    {
        const MappedPlace middle = between(a.typed, b.typed, 0.5);
        const Corner half{middle, mapped(map_, middle)};
        if (halvings == most_halvings || is_straight(a, half, b)) return;
        add_edge(line, a, half, is_closed, halvings + 1);
        add(line, half.mapped, is_closed);
        add_edge(line, half, b, is_closed, halvings + 1);
    }

    bool is_straight(const Corner& a, const Corner& half, const Corner& b) const
    {
        const std::array quarters{mapped(map_, between(a.typed, half.typed, 0.5)),
                                  mapped(map_, between(half.typed, b.typed, 0.5))};
        const double off = std::max({distance(half.mapped, between(a.mapped, b.mapped, 0.5)),
                                     distance(quarters[0], between(a.mapped, b.mapped, 0.25)),
                                     distance(quarters[1], between(a.mapped, b.mapped, 0.75))});
        const RegionBox box = box_of({{{{a.mapped, quarters[0], half.mapped, quarters[1], b.mapped}}}});
        return !(off > tolerance_ + tolerance_away * distance_from(box, near_));
    }

    const PlaceMap& map_;
    double tolerance_;
    RegionBox near_;
};

/// Calls `take` with each corner.
template <class Take>
void for_each_corner(const Obstacles& shapes, const Take& take)
{
    std::ranges::for_each(shapes.points, take);
    for (const RegionRing& line : shapes.lines) std::ranges::for_each(line, take);
    for (const RegionPolygon& polygon : shapes.polygons) {
        std::ranges::for_each(polygon.outline, take);
        for (const RegionRing& hole : polygon.holes) std::ranges::for_each(hole, take);
    }
}

MappedPlace middle_of(const RegionBox& box) { return {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2}; }

/// The first middle of shapes is that of their box; shapes that go around a pole have the pole there.
MappedPlace first_middle(const Obstacles& shapes, double turn)
{
    const RegionBox box = mapped_box(shapes, [](std::span<double>) {});
    MappedPlace middle = middle_of(box);
    if (box.width() >= turn) middle[1] = middle[1] < 0 ? -turn / 4 : turn / 4;
    return middle;
}

MappedPlace rounded(MappedPlace place)
{
    for (double& c : place) c = std::round(c * parts_of_degree) / parts_of_degree;
    return place;
}

}

std::optional<MapSystem> source_system(const TypedRegion& typed, const RegionReading& reading)
{
    const auto said = said_system(typed, reading);
    if (said || reading.is_planar || (!typed.is_wkt() && !typed.is_json())) return said;
    const RegionBox box = box_of_all(typed.shapes.shapes);
    const RegionBox turned{{box.low[1], box.low[0]}, {box.high[1], box.high[0]}};
    if (!fits_globe(box) && fits_globe(turned) && is_far_away(box))
        throw InputError(
            fmt::format("{}: coordinates from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) look like latitude and "
                        "longitude: longitude must come first; if they are lengths, give --planar (planar = true)",
                        typed.name, box.low[0], box.low[1], box.high[0], box.high[1]));
    if (fits_globe(box) && is_far_away(box)) refuse_degrees(box, typed.name, "it is small and far from 0");
    return {};
}

std::optional<MapSystem> obstacle_system(const TypedRegion& typed, const RegionReading& reading)
{
    RegionReading own = reading;
    own.crs.clear(); // it is the region's
    return said_system(typed, own);
}

std::string crs_member(const TypedRegion& typed, const MapSystem& system)
{
    if (system.text == typed.shapes.system && !typed.shapes.crs_member.empty()) return typed.shapes.crs_member;
    if (system.text == geojson_system || system.text == "EPSG:4326" || !system.text.starts_with("EPSG:")) return "";
    return nlohmann::json{{"type", "name"}, {"properties", {{"name", system.text}}}}.dump();
}

void refuse_degrees(const RegionBox& box, const std::string& name, const std::string& why)
{
    throw InputError(fmt::format(
        "{}: {}: coordinates from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) look like longitude and latitude, whose degrees "
        "are no lengths: say which they are (crs EPSG:4326), or that they are lengths (planar)",
        name, why, box.low[0], box.low[1], box.high[0], box.high[1]));
}

Obstacles mapped_shapes(const Obstacles& shapes, const PlaceMap& map, const RegionBox& near)
{
    const EdgeMapper mapper(map, near);
    Obstacles there;
    for (const auto& point : shapes.points) there.points.push_back(mapped(map, point));
    for (const RegionRing& line : shapes.lines) there.lines.push_back(mapper.line(line, false));
    for (const RegionPolygon& polygon : shapes.polygons) {
        RegionPolygon& added = there.polygons.emplace_back();
        added.outline = mapper.line(polygon.outline, true);
        for (const RegionRing& hole : polygon.holes) added.holes.push_back(mapper.line(hole, true));
    }
    return there;
}

RegionBox mapped_box(const Obstacles& shapes, const PlaceMap& map)
{
    RegionRing corners;
    for_each_corner(shapes, [&](const MappedPlace& corner) { corners.push_back(mapped(map, corner)); });
    return box_of({{{corners}}});
}

std::shared_ptr<const LocalPlane> plane_around(const Obstacles& shapes, const MapSystem& system)
{
    constexpr int steps = 2; // the middle of the box around what is mapped hardly moves after the first
    MappedPlace middle = first_middle(shapes, 2 * std::numbers::pi / system.angle);
    for (int step = 0; step < steps; ++step) {
        const auto plane = local_plane(system, middle);
        const RegionBox box = mapped_box(shapes, [&](std::span<double> places) { plane->to_plane(places); });
        MappedPlace next = middle_of(box);
        plane->to_file(next);
        if (!std::isfinite(next[0]) || !std::isfinite(next[1])) break; // opposite to the middle: far too large
        middle = next;
    }
    return local_plane(system, rounded(middle));
}

double largest_distortion(const Obstacles& shapes, const LocalPlane& plane)
{
    double largest = 0;
    for_each_corner(shapes,
                    [&](const MappedPlace& corner) { largest = std::max(largest, plane.distortion_at(corner)); });
    return largest;
}

}
