#include "base/regions/globe/source_system.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

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

}
