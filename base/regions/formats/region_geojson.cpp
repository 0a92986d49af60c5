// GeoJSON: RFC 7946, and the member `crs` of the older description, which names the system of coordinates.
#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/regions/formats/region_shapes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace poissonlab {
namespace {

using GeoJson = nlohmann::json;

/// Properties of a feature are copied to points up to this number of bytes: each point has all of them.
constexpr std::size_t most_copied = 1'000;

/// Returns the id of a feature as JSON, followed by its properties as further members, which points in it have as well.
/// Properties whose names are taken, by points or by one another, are called feature_NAME.
std::string members_of_feature(const GeoJson& feature, std::size_t number)
{
    const auto id = feature.find("id"), properties = feature.find("properties");
    const bool has_id = id != feature.end() && (id->is_string() || id->is_number());
    std::string members = has_id ? id->dump() : std::to_string(number);
    if (properties == feature.end() || !properties->is_object()) return members;
    std::set<std::string> taken{"id", "feature", "class"};
    for (const auto& [key, value] : properties->items()) taken.insert(key);
    std::size_t copied = 0;
    for (const auto& [key, value] : properties->items()) {
        std::string name = key;
        if (key == "id" || key == "feature" || key == "class")
            while (!taken.insert(name).second) name = "feature_" + name;
        const std::string member = fmt::format(",{}:{}", GeoJson(name).dump(), value.dump());
        copied += member.size();
        if (copied > most_copied) break;
        members += member;
    }
    return members;
}

class GeoJsonReader
{
public:
    explicit GeoJsonReader(const std::string& name) : name_(name) {}

    /// Adds the points, lines and polygons of an object, which messages call `member`.
    void add(const GeoJson& object, const std::string& member)
    {
        const std::string type = type_of(object, member);
        if (type == "FeatureCollection") return add_all(object, "features", member);
        if (type == "GeometryCollection") return add_all(object, "geometries", member);
        if (type == "Feature") return add_feature(object, member);
        const bool is_multiple = type.starts_with("Multi");
        const std::string part = is_multiple ? type.substr(5) : type;
        if (part != "Polygon" && part != "Point" && part != "LineString")
            throw problem(member + "type",
                          fmt::format("{}: must be Point, LineString, Polygon or several of them, Multi...",
                                      shortened(printable(type))));
        const std::string place = member + "coordinates";
        if (!object.contains("coordinates")) throw problem(place, "is missing");
        if (!is_multiple) return add_part(part, object["coordinates"], place);
        for (std::size_t i = 0; i < list(object["coordinates"], place).size(); ++i)
            add_part(part, object["coordinates"][i], fmt::format("{}[{}]", place, i));
    }

    RegionShapes found;

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

    /// A feature without a geometry is located nowhere, as RFC 7946 has it.
    void add_feature(const GeoJson& feature, const std::string& member)
    {
        found.ids.push_back(members_of_feature(feature, found.ids.size()));
        const auto properties = feature.find("properties");
        const bool has_some = properties != feature.end() && properties->is_object();
        found.properties.push_back(has_some ? properties->dump() : "{}");
        if (feature.contains("geometry") && !feature["geometry"].is_null())
            add(feature["geometry"], member + "geometry.");
    }

    void add_part(const std::string& type, const GeoJson& coordinates, const std::string& place)
    {
        if (type == "Polygon") return add_polygon(coordinates, place);
        if (type == "Point") return found.shapes.points.push_back(position_of(coordinates, place));
        RegionRing line = positions_of(coordinates, place);
        if (line.size() < 2) throw problem(place, "must have two positions or more");
        found.shapes.lines.push_back(std::move(line));
        if (!found.ids.empty()) found.feature_of_line.push_back(found.ids.size() - 1);
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
        found.shapes.polygons.push_back(std::move(polygon));
        if (!found.ids.empty()) found.feature_of.push_back(found.ids.size() - 1);
    }

    std::array<double, 2> position_of(const GeoJson& position, const std::string& place)
    {
        if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
            throw problem(place, "must be a position: two numbers");
        found.has_further_numbers |= position.size() > 2;
        return {position[0].get<double>(), position[1].get<double>()};
    }

    RegionRing positions_of(const GeoJson& positions, const std::string& place)
    {
        RegionRing ring;
        for (std::size_t i = 0; i < list(positions, place).size(); ++i)
            ring.push_back(position_of(positions[i], fmt::format("{}[{}]", place, i)));
        return ring;
    }

    RegionRing ring_of(const GeoJson& positions, const std::string& place)
    {
        RegionRing ring = positions_of(positions, place);
        if (ring.size() < 4) throw problem(place, "must have four positions or more, of which the last is the first");
        if (ring.front() != ring.back()) throw problem(place, "is not closed: its last position is not its first");
        ring.pop_back();
        return ring;
    }

    const std::string& name_;
};

/// The name that the older member `crs` has; empty where it has none.
std::string system_of(const GeoJson& object)
{
    const GeoJson::json_pointer name("/crs/properties/name");
    return object.contains(name) && object[name].is_string() ? object[name].get<std::string>() : "";
}

}

RegionShapes shapes_of_geojson(std::string_view text, const std::string& name)
{
    const GeoJson json = parsed_geojson(text, name);
    GeoJsonReader reader(name);
    reader.add(json, "");
    reader.found.system = system_of(json);
    reader.found.has_no_system = json.contains("crs") && json["crs"].is_null();
    if (!reader.found.system.empty()) reader.found.crs_member = json["crs"].dump();
    return std::move(reader.found);
}

}
