#include "base/regions/region_source.hpp"

#include "base/points/point_file_formats.hpp"

#include <cmath>

namespace poissonlab {

const std::vector<RegionRing>& lines_of(const PlaneRegion& region)
{
    static const std::vector<RegionRing> none;
    return region.source ? region.source->lines : none;
}

double length_of(const std::vector<RegionRing>& lines)
{
    double length = 0;
    for (const RegionRing& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    return length;
}

RegionBox box_around(const std::vector<RegionRing>& lines)
{
    PlaneRegion all;
    for (const RegionRing& line : lines) all.polygons.push_back({line});
    return box_of(all);
}

bool is_mapped(const PlaneRegion& region) { return region.source && region.source->map; }

PointSet as_in_files(const PlaneRegion& region, PointSet points)
{
    if (is_mapped(region)) region.source->map->to_file(points.coordinates);
    return points;
}

PointSet as_in_plane(const PlaneRegion& region, PointSet points)
{
    if (is_mapped(region)) region.source->map->to_plane(points.coordinates);
    return points;
}

std::string crs_in_files(const PlaneRegion& region)
{
    return region.crs.empty() && !is_mapped(region) ? crs_of_lengths : region.crs;
}

std::string degrees_sentence(const PlaneRegion& region)
{
    return is_mapped(region) ? ""
                             : "its longitude and latitude are taken for lengths, as the region's "
                               "coordinates are; where these are degrees, crs EPSG:4326 maps both to metres";
}

std::string file_units(const PlaneRegion& region)
{
    return is_mapped(region) ? "longitude and latitude, distances in metres" : "units of the region";
}

const std::vector<std::string>& notes_of(const PlaneRegion& region)
{
    static const std::vector<std::string> none;
    return region.source ? region.source->notes : none;
}

}
