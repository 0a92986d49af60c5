// The points, lines and polygons that texts of GeoJSON and WKT hold, before anything is made of them.
#pragma once

#include "base/regions/obstacles.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

struct RegionShapes
{
    Obstacles shapes;
    std::string system{};           ///< the system of coordinates that the text names, as PROJ knows it; empty: none
    std::string crs_member{};       ///< the member `crs` of GeoJSON that names it
    bool has_no_system = false;     ///< says GeoJSON whose `crs` is null: it is not that of the standard
    std::vector<std::string> ids{}; ///< ids of features as JSON, with the properties as further members
    std::vector<std::string> properties{};      ///< of each feature, a JSON object
    std::vector<std::size_t> feature_of{};      ///< of each polygon; empty: there are no features
    std::vector<std::size_t> feature_of_line{}; ///< of each line; empty as well
    bool has_further_numbers = false;           ///< heights or measures, which are left out
};

/// Reads points, lines and polygons; `name` is what messages call the text. Throws InputError; what it returns is not
/// checked beyond its form.
RegionShapes shapes_of_geojson(std::string_view text, const std::string& name);

/// Reads them from WKT as OGC, ISO and PostGIS write it: with Z and M, collections, empty members, and SRID=...;
/// before.
RegionShapes shapes_of_wkt(std::string_view text, const std::string& name);

}
