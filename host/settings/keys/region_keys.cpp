#include "host/settings/keys/region_keys.hpp"

#include "base/regions/region_text.hpp"
#include "base/regions/region_units.hpp"

namespace poissonlab {

void region_coordinates_keys(Keys& keys, RegionReading& reading)
{
    keys.flag("planar", reading.is_planar, "whether coordinates that look like longitude and latitude are lengths");
    keys.text(
            "crs", reading.crs,
            "the system of the region's coordinates as PROJ knows it, such as EPSG:4326; longitudes and latitudes are "
            "mapped to a plane of metres")
        .otherwise("what the file says");
    if (!keys.is_read() || !keys.is_given("crs")) return;
    if (reading.is_planar) throw keys.invalid("crs", "cannot be combined with " + keys.name_of("planar"));
    keys.check("crs", [&] { check_map_system(reading.crs); });
}

void region_reading_keys(Keys& keys, RegionReading& reading)
{
    region_coordinates_keys(keys, reading);
    keys.word("overlap", reading.overlap, polygon_overlap_names,
              "what becomes of polygons that overlap or share edges: their union, or an error");
    keys.number("buffer", reading.buffer, {0, 1e12},
                "the region is what lies within this distance of its lines, points and polygons")
        .unit(region_units);
}

void obstacle_keys(Keys& keys, std::string& obstacles, std::optional<double>& distance, const std::string& usually)
{
    keys.region("obstacles", obstacles,
                "what points keep away from: a file of GeoJSON or WKT with points, lines and polygons")
        .otherwise("none");
    keys.number("obstacle_distance", distance, {0, 1e12}, "the least distance of points from obstacles")
        .unit(region_units)
        .otherwise(usually);
    if (keys.is_read() && keys.is_given("obstacle_distance") && obstacles.empty())
        throw keys.invalid("obstacle_distance", "needs " + keys.name_of("obstacles"));
}

}
