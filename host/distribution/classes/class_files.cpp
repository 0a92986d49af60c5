#include "host/distribution/classes/class_files.hpp"

#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/regions/region_source.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr std::size_t points_a_piece = 4096;

/// Coordinates, the class, and an end of line. 17 significant digits tell every double from its neighbours.
void append_row(std::string& to, std::span<const double> at, std::uint32_t of, char between, bool has_plane_z)
{
    for (const double c : at) to += fmt::format("{:.17g}{}", c, between);
    if (has_plane_z && at.size() == 2) to += fmt::format("0{}", between);
    to += fmt::format("{}\n", of);
}

void append_record(std::string& to, std::span<const double> at, std::uint32_t of)
{
    to.append(reinterpret_cast<const char*>(at.data()), at.size_bytes());
    to.append(reinterpret_cast<const char*>(&of), sizeof of);
}

void append_point(std::string& to, const std::string& format, std::span<const double> at, std::uint32_t of)
{
    if (format == ".csv") return append_row(to, at, of, ',', false);
    if (format == ".ply") return append_row(to, at, of, ' ', true);
    append_record(to, at, of);
}

std::string header_of(const std::string& format, int dimension, std::size_t points, const std::string& comment,
                      const PlaneRegion* region)
{
    if (format == ".geojson")
        return geojson_begin("FeatureCollection", region ? crs_in_files(*region) : crs_of_lengths, comment) +
               ",\"features\":[\n";
    const bool is_solid = dimension == 3;
    if (format == ".csv" && region && is_mapped(*region)) return fmt::format("{},class\n", csv_header_globe);
    if (format == ".csv") return is_solid ? "x,y,z,class\n" : "x,y,class\n";
    if (format == ".ply")
        return fmt::format("ply\nformat ascii 1.0\n{}element vertex {}\nproperty double x\nproperty double "
                           "y\nproperty double z\nproperty uint class\nend_header\n",
                           comment.empty() ? "" : fmt::format("comment {}\n", comment), points);
    const std::string_view order = npy_byte_order();
    const std::string z = is_solid ? fmt::format("('z', '{}f8'), ", order) : "";
    return npy_header_of(fmt::format("[('x', '{0}f8'), ('y', '{0}f8'), {1}('class', '{0}u4')]", order, z),
                         fmt::format("({},)", points));
}

}

const std::vector<std::string>& class_file_ends()
{
    static const std::vector<std::string> ends{".csv", ".ply", ".npy", ".geojson"};
    return ends;
}

void write_class_pieces(const std::filesystem::path& file, int dimension, std::size_t points,
                        const std::string& comment, const std::function<void(const ClassedPointSink&)>& source,
                        const PlaneRegion* region, const std::vector<std::string>& features)
{
    const std::string format = file.extension().string();
    const auto axes = static_cast<std::size_t>(dimension);
    const bool is_geojson = format == ".geojson";
    write_whole_file_in_pieces(file, [&](const FileSink& sink) {
        sink(header_of(format, dimension, points, comment, region));
        std::uint64_t id = 0;
        source([&](std::span<const double> coordinates, std::span<const std::uint32_t> classes) {
            std::string piece;
            for (std::size_t i = 0; i < classes.size(); ++i) {
                const auto at = coordinates.subspan(i * axes, axes);
                if (!is_geojson) {
                    append_point(piece, format, at, classes[i]);
                    continue;
                }
                const std::string of_feature = features.empty() ? "" : ",\"feature\":" + features[id];
                piece += geojson_feature(id++, fmt::format(",\"class\":{}{}", classes[i], of_feature), at);
            }
            sink(piece);
        });
        if (is_geojson) sink("]}\n");
    });
}

void write_class_file(const std::filesystem::path& file, const ClassedPoints& points, const std::string& comment,
                      const PlaneRegion* region, const std::vector<std::string>& features)
{
    const std::size_t count = points.classes.size();
    const auto axes = static_cast<std::size_t>(points.points.dimension);
    const auto in_pieces = [&](const ClassedPointSink& sink) {
        for (std::size_t begin = 0; begin < count; begin += points_a_piece) {
            const std::size_t some = std::min(points_a_piece, count - begin);
            sink(std::span(points.points.coordinates).subspan(begin * axes, some * axes),
                 std::span(points.classes).subspan(begin, some));
        }
    };
    write_class_pieces(file, points.points.dimension, count, comment, in_pieces, region, features);
}

void write_class_numbers(const std::filesystem::path& file, const std::vector<std::uint32_t>& classes)
{
    write_whole_file(
        file, npy_header_of(fmt::format("'{}u4'", npy_byte_order()), fmt::format("({},)", classes.size())) +
                  std::string(reinterpret_cast<const char*>(classes.data()), classes.size() * sizeof(std::uint32_t)));
}

}
