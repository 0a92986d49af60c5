// Writes point sets as GeoJSON (RFC 7946), one MultiPoint or a feature for each point, in whatever units the points are
// in.
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace poissonlab {
namespace {

/// 17 significant digits tell every double from its neighbours.
void append_positions(fmt::memory_buffer& out, std::span<const double> coordinates, std::size_t axes, bool is_first)
{
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const bool begins = i % axes == 0;
        if (begins && !(is_first && i == 0)) out.append(std::string_view(",\n"));
        fmt::format_to(std::back_inserter(out), "{}{:.17g}", begins ? "[" : ",", coordinates[i]);
        if ((i + 1) % axes == 0) out.push_back(']');
    }
}

}

std::string geojson_begin(const std::string& type, const std::string& crs, const std::string& comment)
{
    nlohmann::ordered_json head{{"type", type}};
    if (!crs.empty()) head["crs"] = nlohmann::ordered_json::parse(crs);
    if (!comment.empty()) head["comment"] = comment;
    std::string text = head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.pop_back(); // its bracket: the points follow
    return text;
}

void write_geojson_features(const std::filesystem::path& path, const PointSet& points, const std::string& crs,
                            const std::string& comment, const std::string& property,
                            const std::vector<std::string>& values)
{
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file(geojson_begin("FeatureCollection", crs, comment) + ",\"features\":[\n");
        const auto axes = static_cast<std::size_t>(points.dimension);
        for (std::size_t i = 0; i < points.size(); ++i) {
            fmt::memory_buffer out;
            fmt::format_to(std::back_inserter(out),
                           "{}{{\"type\":\"Feature\",\"properties\":{{\"{}\":{}}},\"geometry\":{{\"type\":\"Point\","
                           "\"coordinates\":",
                           i > 0 ? ",\n" : "", property, values[i]);
            append_positions(out, std::span(points.coordinates).subspan(i * axes, axes), axes, true);
            out.append(std::string_view("}}"));
            file({out.data(), out.size()});
        }
        file("]}\n");
    });
}

void write_geojson_points(const std::filesystem::path& path, int dimension, const std::string& crs,
                          const std::string& comment, const std::function<void(const PointSink& sink)>& write)
{
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file(geojson_begin("MultiPoint", crs, comment) + ",\"coordinates\":[\n");
        const auto axes = static_cast<std::size_t>(dimension);
        bool is_first = true;
        write([&](std::span<const double> coordinates) {
            for_pieces_of_text(coordinates, axes, [&](std::span<const double> piece) {
                fmt::memory_buffer out;
                append_positions(out, piece, axes, is_first);
                is_first = false;
                file({out.data(), out.size()});
            });
        });
        file("]}\n");
    });
}

}
