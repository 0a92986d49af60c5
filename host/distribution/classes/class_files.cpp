#include "host/distribution/classes/class_files.hpp"

#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace poissonlab {
namespace {

/// Writes a header, and then what `text` says of each point, in pieces.
void write_each(const std::filesystem::path& file, const std::string& header, std::size_t points,
                const std::function<void(std::string& to, std::size_t point)>& append)
{
    constexpr std::size_t points_a_piece = 4096;
    write_whole_file_in_pieces(file, [&](const FileSink& sink) {
        sink(header);
        for (std::size_t begin = 0; begin < points; begin += points_a_piece) {
            std::string piece;
            for (std::size_t i = begin; i < std::min(points, begin + points_a_piece); ++i) append(piece, i);
            sink(piece);
        }
    });
}

/// Coordinates, the class, and an end of line. 17 significant digits tell every double from its neighbours.
void append_row(std::string& to, const ClassedPoints& points, std::size_t point, char between, bool has_plane_z)
{
    for (const double c : points.points[point]) to += fmt::format("{:.17g}{}", c, between);
    if (has_plane_z && points.points.dimension == 2) to += fmt::format("0{}", between);
    to += fmt::format("{}\n", points.classes[point]);
}

void append_record(std::string& to, const ClassedPoints& points, std::size_t point)
{
    const auto at = points.points[point];
    to.append(reinterpret_cast<const char*>(at.data()), at.size_bytes());
    to.append(reinterpret_cast<const char*>(&points.classes[point]), sizeof(std::uint32_t));
}

}

const std::vector<std::string>& class_file_ends()
{
    static const std::vector<std::string> ends{".csv", ".ply", ".npy"};
    return ends;
}

void write_class_file(const std::filesystem::path& file, const ClassedPoints& points, const std::string& comment)
{
    const std::size_t count = points.classes.size();
    const bool is_solid = points.points.dimension == 3;
    const auto rows = [&](char between, bool has_plane_z) {
        return [&points, between, has_plane_z](std::string& to, std::size_t i) {
            append_row(to, points, i, between, has_plane_z);
        };
    };
    if (file.extension() == ".csv")
        return write_each(file, is_solid ? "x,y,z,class\n" : "x,y,class\n", count, rows(',', false));
    if (file.extension() == ".ply")
        return write_each(file,
                          fmt::format("ply\nformat ascii 1.0\n{}element vertex {}\nproperty double x\nproperty double "
                                      "y\nproperty double z\nproperty uint class\nend_header\n",
                                      comment.empty() ? "" : fmt::format("comment {}\n", comment), count),
                          count, rows(' ', true));
    const std::string_view order = npy_byte_order();
    const std::string z = is_solid ? fmt::format("('z', '{}f8'), ", order) : "";
    write_each(file,
               npy_header_of(fmt::format("[('x', '{0}f8'), ('y', '{0}f8'), {1}('class', '{0}u4')]", order, z),
                             fmt::format("({},)", count)),
               count, [&](std::string& to, std::size_t i) { append_record(to, points, i); });
}

void write_class_numbers(const std::filesystem::path& file, const ClassedPoints& points)
{
    write_whole_file(
        file, npy_header_of(fmt::format("'{}u4'", npy_byte_order()), fmt::format("({},)", points.classes.size())) +
                  std::string(reinterpret_cast<const char*>(points.classes.data()),
                              points.classes.size() * sizeof(std::uint32_t)));
}

}
