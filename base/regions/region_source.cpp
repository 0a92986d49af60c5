#include "base/regions/region_source.hpp"

namespace poissonlab {

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
