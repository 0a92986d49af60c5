// A small construction.json, with every number known.
#pragma once

#include <nlohmann/json.hpp>

namespace poissonlab::test {

/// Two panels of a tile: an octagon with red and an edge with red and yellow ends; in the first, a point of
/// each class.
inline nlohmann::json plane_scene()
{
    return nlohmann::json::parse(R"({"format": "poissonlab-construction", "format_version": 1, "dimension": 2,
        "tile_units": 65536, "width": 6000, "radius": 5999.5, "solid": false, "columns": 2, "panels": [
        {"caption": "First.", "modified": true, "window": {"low": [-20000, -20000], "size": [100000, 80000]},
         "part": {"low": [-20000, -20000], "size": [100000, 80000]},
         "pieces": [{"axes": 0, "at": [0, 0], "colors": [0], "made": false},
                    {"axes": 1, "at": [0, 0], "colors": [0, 1], "made": true}],
         "tiles": [], "points": {"held": [1000, 2000], "inner": [40000, 500], "outer": [30000, 40000],
                                 "surroundings": [70000, 50000]}},
        {"caption": "Second.", "modified": true, "window": {"low": [-20000, -20000], "size": [100000, 80000]},
         "part": {"low": [0, 0], "size": [65536, 50000]},
         "pieces": [{"axes": 0, "at": [0, 0], "colors": [], "made": false}], "tiles": [0, 0], "points": {}}]})");
}

/// Two cubes of regions: a corner tile in the middle, and an edge tile.
inline nlohmann::json space_scene(bool is_solid)
{
    nlohmann::json json = nlohmann::json::parse(R"({"format": "poissonlab-construction", "format_version": 1,
        "dimension": 3, "tile_units": 65536, "width": 5000, "radius": 5000, "solid": true, "columns": 1, "panels": [
        {"caption": "", "modified": true, "window": {"low": [-25000, -25000, -25000], "size": [50000, 50000, 50000]},
         "part": {"low": [-25000, -25000, -25000], "size": [50000, 50000, 50000]},
         "pieces": [{"axes": 0, "at": [0, 0, 0], "colors": [2], "made": true}],
         "tiles": [], "points": {"inner": [0, 0, 0]}}]})");
    json["solid"] = is_solid;
    return json;
}

}
