// Writes point sets as GeoJSON (RFC 7946), a feature for each point, in whatever units the points are in.
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

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

}
