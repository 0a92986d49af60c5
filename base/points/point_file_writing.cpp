// Writes point sets as text, CSV, PLY, USD, GeoJSON or DXF; NumPy and HDF5 are those of placed_file.
#include "base/errors/errors.hpp"
#include "base/files/npy_header.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/placed_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_endings.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

namespace poissonlab {

namespace {

/// The lines of `comment`, each with `prefix` in front. Empty lines are left out: in text, `#` alone
/// separates.
void append_comment(fmt::memory_buffer& out, std::string_view prefix, std::string_view comment)
{
    for (LineReader lines(comment); lines.next();) {
        if (trimmed(lines.line()).empty()) continue;
        fmt::format_to(std::back_inserter(out), "{} {}\n", prefix, lines.line());
    }
}

/// The marks between numbers and after each point.
struct LineMarks
{
    std::string_view between = " ";
    std::string_view end = "\n";
};

/// One point a line. 17 significant digits tell every double from its neighbours.
void append_points(fmt::memory_buffer& out, std::span<const double> coordinates, std::size_t dimension,
                   const LineMarks& marks)
{
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        std::array<char, 32> text{};
        const char* const end =
            std::to_chars(text.data(), text.data() + text.size(), coordinates[i], std::chars_format::general, 17).ptr;
        out.append(text.data(), end);
        out.append((i + 1) % dimension == 0 ? marks.end : marks.between);
    }
}

/// Points as lines, in pieces: text takes more room than numbers.
void write_lines(const FileSink& file, std::span<const double> coordinates, int dimension, const LineMarks& marks)
{
    const std::size_t axes = static_cast<std::size_t>(dimension);
    for_pieces_of_text(coordinates, axes, [&](std::span<const double> piece) {
        fmt::memory_buffer out;
        append_points(out, piece, axes, marks);
        file({out.data(), out.size()});
    });
}

/// Other names would make text of what was to be something else.
void check_point_ending(const std::filesystem::path& path)
{
    const std::string ending = path.extension();
    const std::vector<std::string>& known = point_file_endings();
    if (!ending.empty() && std::ranges::find(known, ending) == known.end())
        throw InputError(
            fmt::format("{}: a point file must end in {}", printable(path.string()), fmt::join(known, ", ")));
}

/// Appends the header of a PLY file. 2D points have a z, which is 0, because programs that show PLY files expect one.
void append_ply_header(fmt::memory_buffer& out, std::size_t points, std::string_view comment)
{
    out.append(std::string_view("ply\nformat ascii 1.0\n"));
    append_comment(out, "comment", comment);
    fmt::format_to(std::back_inserter(out),
                   "element vertex {}\nproperty double x\nproperty double y\nproperty double z\nend_header\n", points);
}

}

std::string npy_header(std::uint64_t points, int dimension)
{
    return npy_header_of(fmt::format("'{}f8'", npy_byte_order()), fmt::format("({}, {})", points, dimension));
}

const std::vector<std::string>& point_file_endings()
{
    static const std::vector<std::string> endings{".txt",  ".dat",  ".csv",    ".npy",     ".ply", ".h5",
                                                  ".hdf5", ".usda", ".h5part", ".geojson", ".dxf"};
    return endings;
}

void write_points(const std::filesystem::path& path, const PointSet& points, const std::string& comment)
{
    const auto write = [&](const PointSink& sink) { sink(points.coordinates); };
    const bool is_of_torus = std::ranges::all_of(points.coordinates, [](double c) { return c >= 0 && c < 1; });
    if (!is_of_torus && has_known_places(path))
        return write_placed_points(path,
                                   {.dimension = points.dimension,
                                    .points = points.size(),
                                    .side = 0,
                                    .unit = "units of the coordinates",
                                    .comment = comment},
                                   write);
    write_points_in_pieces(path, points.dimension, points.size(), comment, write);
}

void write_csv_points(const std::filesystem::path& path, int dimension, std::string_view names,
                      const std::function<void(const PointSink& sink)>& write)
{
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file(fmt::format("{}\n", names));
        write([&](std::span<const double> coordinates) { write_lines(file, coordinates, dimension, {","}); });
    });
}

void write_points_in_pieces(const std::filesystem::path& path, int dimension, std::size_t points,
                            const std::string& comment, const std::function<void(const PointSink& sink)>& write)
{
    check_point_ending(path);
    if (has_known_places(path))
        return write_placed_points(path, {.dimension = dimension, .points = points, .comment = comment}, write);
    const auto extension = path.extension();
    if (extension == ".geojson") return write_geojson_points(path, dimension, crs_of_lengths, comment, write);
    if (extension == ".dxf") return write_dxf_points(path, dimension, comment, write);
    if (extension == ".csv")
        return write_csv_points(path, dimension, dimension == 2 ? csv_header_2d : csv_header_3d, write);
    if (extension == ".usda") return write_usd_points(path, dimension, points, comment, write);
    const bool is_ply = extension == ".ply";
    fmt::memory_buffer header;
    if (is_ply) append_ply_header(header, points, comment);
    if (!is_ply) append_comment(header, "#", comment);

    const LineMarks marks{" ", is_ply && dimension == 2 ? " 0\n" : "\n"};
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file({header.data(), header.size()});
        write([&](std::span<const double> coordinates) { write_lines(file, coordinates, dimension, marks); });
    });
}

}
