// Writes point sets as GeoJSON (RFC 7946), a feature for each point, in whatever units the points are in.
// Reads the points of GeoJSON (RFC 7946): Point, MultiPoint, and those in features and collections, in their order.
#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/points/unit_coordinates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace poissonlab {

std::string geojson_begin(const std::string& type, const std::string& crs, const std::string& comment)
{
    nlohmann::ordered_json head{{"type", type}};
    if (!crs.empty()) head["crs"] = nlohmann::ordered_json::parse(crs);
    if (!comment.empty()) head["comment"] = comment;
    std::string text = head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.pop_back(); // its bracket: the points follow
    return text;
}

std::string geojson_feature(std::uint64_t id, const std::string& more_properties, std::span<const double> position)
{
    return fmt::format("{}{{\"type\":\"Feature\",\"properties\":{{\"id\":{}{}}},\"geometry\":{{\"type\":\"Point\","
                       "\"coordinates\":[{:.17g}]}}}}",
                       id > 0 ? ",\n" : "", id, more_properties, fmt::join(position, ","));
}

void write_geojson_points(const std::filesystem::path& path, int dimension, const std::string& crs,
                          const std::string& comment, const std::function<void(const PointSink& sink)>& write,
                          const std::vector<std::string>& features)
{
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file(geojson_begin("FeatureCollection", crs, comment) + ",\"features\":[\n");
        const auto axes = static_cast<std::size_t>(dimension);
        std::uint64_t id = 0;
        write([&](std::span<const double> coordinates) {
            for_pieces_of_text(coordinates, axes, [&](std::span<const double> piece) {
                std::string text;
                for (std::size_t i = 0; i < piece.size(); i += axes, ++id)
                    text += geojson_feature(id, features.empty() ? "" : ",\"feature\":" + features[id],
                                            piece.subspan(i, axes));
                file(text);
            });
        });
        file("]}\n");
    });
}

namespace {

/// Coordinates of GeoJSON are degrees, unless its member `crs` names another system than the standard's, or is null.
bool are_degrees(const nlohmann::json& json)
{
    if (!json.contains("crs")) return true;
    const std::string system = json["crs"].dump();
    return system.find("CRS84\"") != system.npos || system.find(":4326\"") != system.npos;
}

class GeoJsonPoints
{
public:
    explicit GeoJsonPoints(const PointFileContent& file) : file_(file), unit_(file) {}

    PointSet read()
    {
        const nlohmann::json json = parsed_geojson(file_.bytes, file_.name);
        add(json);
        if (set_.dimension == 0) fail_in_point_file(file_, 0, "GeoJSON", "must have a Point or a MultiPoint");
        if (are_degrees(json))
            unit_.check_degrees({0, "coordinates"}, 180, "\"crs\": null in the file says that they are lengths");
        unit_.finish();
        if (left_out_ > 0)
            file_.tell(fmt::format("only its points are read; {} {} left out", left_out_,
                                   left_out_ == 1 ? "line or polygon is" : "lines and polygons are"));
        return std::move(set_);
    }

private:
    void add(const nlohmann::json& object)
    {
        if (!object.is_object()) return refuse(object, "must be an object with a type");
        const auto type = object.find("type");
        if (type == object.end() || !type->is_string()) return refuse(object, "must have a type: this is no GeoJSON");
        if (*type == "FeatureCollection") return for_each(object, "features", [&](const auto& each) { add(each); });
        if (*type == "GeometryCollection") return for_each(object, "geometries", [&](const auto& each) { add(each); });
        if (*type == "Feature") {
            const auto geometry = object.find("geometry");
            if (file_.has_classes()) find_class(object);
            if (geometry != object.end() && !geometry->is_null()) add(*geometry);
        } else if (*type == "MultiPoint") {
            for_each(object, "coordinates", [&](const auto& each) { add_position(each); });
        } else if (*type == "Point") {
            if (!object.contains("coordinates")) refuse(object, "must have coordinates");
            add_position(object["coordinates"]);
        } else {
            ++left_out_;
        }
    }

    /// Returns the class of all points of a feature.
    void find_class(const nlohmann::json& feature)
    {
        const auto properties = feature.find("properties");
        class_.reset();
        if (properties == feature.end() || !properties->is_object()) return;
        const auto found = properties->find(file_.classes.column);
        if (found == properties->end() || found->is_null()) return;
        if (found->is_structured())
            refuse(*found, fmt::format("the property {} must be a text or a number", file_.classes.column));
        class_ = found->is_string() ? found->get<std::string>() : found->dump();
    }

    template <class Take>
    void for_each(const nlohmann::json& object, const char* member, const Take& take)
    {
        const auto list = object.find(member);
        if (list == object.end() || !list->is_array())
            return refuse(object, fmt::format("must have a list {}", member));
        for (const nlohmann::json& each : *list) take(each);
    }

    void add_position(const nlohmann::json& position)
    {
        const std::size_t axes = position.is_array() ? position.size() : 0;
        if (axes != 2 && axes != 3) refuse(position, "must be a position: two numbers, or three in space");
        if (set_.dimension == 0) set_.dimension = static_cast<int>(axes);
        if (axes != static_cast<std::size_t>(set_.dimension))
            refuse(position, fmt::format("must have {} numbers as the first point has", set_.dimension));
        if (file_.has_classes()) {
            if (!class_)
                refuse(position, fmt::format("must belong to a feature with the property {}, which is its class",
                                             file_.classes.column));
            file_.classes.take(*class_);
        }
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const nlohmann::json& number = position[axis];
            if (!number.is_number()) refuse(position, "must be a position: two numbers, or three in space");
            set_.coordinates.push_back(unit_(number.get<double>(), axis, half_ulp_of_double, [&] {
                return CoordinatePlace{0, number.dump()};
            }));
        }
    }

    void refuse(const nlohmann::json& value, const std::string& allowed) const
    {
        fail_in_point_file(file_, 0, shortened(value.dump(), 40), allowed);
    }

    const PointFileContent& file_;
    UnitCoordinates unit_;
    PointSet set_{0, {}};
    std::size_t left_out_ = 0;
    std::optional<std::string> class_; ///< the class of the feature that is read
};

}

std::vector<PointSet> read_geojson_points(const PointFileContent& file) { return {GeoJsonPoints(file).read()}; }

}
