// GeoJSON: RFC 7946, and the member `crs` of the older description, which says that coordinates are lengths.
#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using GeoJson = nlohmann::json;

class GeoJsonReader
{
public:
    GeoJsonReader(const std::string& name, bool takes_all) : name_(name), takes_all_(takes_all) {}

    /// Adds the polygons of an object, which messages call `member`, and its points and lines if all are taken.
    void add(const GeoJson& object, const std::string& member)
    {
        const std::string type = type_of(object, member);
        if (type == "FeatureCollection") return add_all(object, "features", member);
        if (type == "GeometryCollection") return add_all(object, "geometries", member);
        if (type == "Feature") {
            if (!object.contains("geometry") || object["geometry"].is_null()) return; // RFC 7946: it is located nowhere
            return add(object["geometry"], member + "geometry.");
        }
        const bool is_multiple = type.starts_with("Multi");
        const std::string part = is_multiple ? type.substr(5) : type;
        if (part != "Polygon" && takes_all_ && part != "Point" && part != "LineString")
            throw problem(member + "type",
                          fmt::format("{}: must be Point, LineString, Polygon or several of them, Multi...",
                                      shortened(printable(type))));
        if (part != "Polygon" && !takes_all_)
            throw problem(member + "type", fmt::format("{}: must be Polygon or MultiPolygon, which have an inside",
                                                       shortened(printable(type))));
        const std::string place = member + "coordinates";
        if (!object.contains("coordinates")) throw problem(place, "is missing");
        if (!is_multiple) return add_part(part, object["coordinates"], place);
        for (std::size_t i = 0; i < list(object["coordinates"], place).size(); ++i)
            add_part(part, object["coordinates"][i], fmt::format("{}[{}]", place, i));
    }

    Obstacles found;

private:
    InputError problem(const std::string& member, const std::string& what) const
    {
        return InputError(fmt::format("{}: {}: {}", name_, member, what));
    }

    std::string type_of(const GeoJson& object, const std::string& member) const
    {
        if (!object.is_object() || !object.contains("type") || !object["type"].is_string())
            throw problem(member + "type", "is missing: this is no GeoJSON");
        return object["type"];
    }

    const GeoJson& list(const GeoJson& value, const std::string& place) const
    {
        if (!value.is_array()) throw problem(place, "must be a list");
        return value;
    }

    void add_all(const GeoJson& object, const std::string& key, const std::string& member)
    {
        if (!object.contains(key)) throw problem(member + key, "is missing");
        for (std::size_t i = 0; i < list(object[key], member + key).size(); ++i)
            add(object[key][i], fmt::format("{}{}[{}].", member, key, i));
    }

    void add_part(const std::string& type, const GeoJson& coordinates, const std::string& place)
    {
        if (type == "Polygon") return add_polygon(coordinates, place);
        if (type == "Point") return found.points.push_back(position_of(coordinates, place));
        RegionRing line = positions_of(coordinates, place);
        if (line.size() < 2) throw problem(place, "must have two positions or more");
        found.lines.push_back(std::move(line));
    }

    void add_polygon(const GeoJson& rings, const std::string& place)
    {
        if (list(rings, place).empty()) throw problem(place, "has no outline");
        RegionPolygon polygon;
        for (std::size_t i = 0; i < rings.size(); ++i) {
            RegionRing ring = ring_of(rings[i], fmt::format("{}[{}]", place, i));
            if (i == 0)
                polygon.outline = std::move(ring);
            else
                polygon.holes.push_back(std::move(ring));
        }
        found.polygons.push_back(std::move(polygon));
    }

    std::array<double, 2> position_of(const GeoJson& position, const std::string& place) const
    {
        if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
            throw problem(place, "must be a position: two numbers");
        return {position[0].get<double>(), position[1].get<double>()};
    }

    RegionRing positions_of(const GeoJson& positions, const std::string& place) const
    {
        RegionRing found;
        for (std::size_t i = 0; i < list(positions, place).size(); ++i)
            found.push_back(position_of(positions[i], fmt::format("{}[{}]", place, i)));
        return found;
    }

    RegionRing ring_of(const GeoJson& positions, const std::string& place) const
    {
        RegionRing ring = positions_of(positions, place);
        if (ring.size() < 4) throw problem(place, "must have four positions or more, of which the last is the first");
        if (ring.front() != ring.back()) throw problem(place, "is not closed: its last position is not its first");
        ring.pop_back();
        return ring;
    }

    const std::string& name_;
    bool takes_all_;
};

/// Does the older member `crs` name anything but longitude and latitude?
bool names_other_system(const GeoJson& object)
{
    if (!object.is_object() || !object.contains("crs") || !object["crs"].is_object()) return false;
    const std::string text = object["crs"].dump();
    for (const char* geographic : {"CRS84", "4326", "CRS83", "4269", "4258"})
        if (text.find(geographic) != std::string::npos) return false;
    return text.find("name") != std::string::npos;
}

Obstacles obstacles_of(const GeoJson& json, const std::string& name, bool takes_all)
{
    GeoJsonReader reader(name, takes_all);
    reader.add(json, "");
    return std::move(reader.found);
}

}

PlaneRegion region_of_geojson(std::string_view text, const std::string& name, bool& says_metres)
{
    const GeoJson json = parsed_json(text, name);
    says_metres = names_other_system(json);
    return {obstacles_of(json, name, false).polygons, says_metres ? json["crs"].dump() : ""};
}

Obstacles obstacles_of_geojson(std::string_view text, const std::string& name, bool& says_metres)
{
    const GeoJson json = parsed_json(text, name);
    says_metres = names_other_system(json);
    return obstacles_of(json, name, true);
}

}
