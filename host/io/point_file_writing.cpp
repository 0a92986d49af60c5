// Writes point sets as text, PLY or NumPy.
#include "io/point_file.hpp"
#include "io/point_file_formats.hpp"
#include "io/text_lines.hpp"
#include "io/whole_file.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <bit>
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

/// One point a line, `line_end` after each. 17 significant digits tell every double from its neighbours.
void append_points(fmt::memory_buffer& out, const PointSet& points, std::string_view line_end)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::string_view separator = "";
        for (const double x : points[i]) {
            fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}{:.17g}"), separator, x);
            separator = " ";
        }
        out.append(line_end);
    }
}

fmt::memory_buffer text_file(const PointSet& points, std::string_view comment)
{
    fmt::memory_buffer out;
    append_comment(out, "#", comment);
    append_points(out, points, "\n");
    return out;
}

/// In 2D with a z that is 0, because programs that show PLY files expect one.
fmt::memory_buffer ply_file(const PointSet& points, std::string_view comment)
{
    fmt::memory_buffer out;
    out.append(std::string_view("ply\nformat ascii 1.0\n"));
    append_comment(out, "comment", comment);
    fmt::format_to(std::back_inserter(out),
                   "element vertex {}\nproperty double x\nproperty double y\nproperty double z\nend_header\n",
                   points.size());
    append_points(out, points, points.dimension == 2 ? " 0\n" : "\n");
    return out;
}

fmt::memory_buffer npy_file(const PointSet& points)
{
    // The numbers start at a multiple of 64 bytes; blanks and an end of line fill the header up to there.
    constexpr std::size_t alignment = 64;
    constexpr std::size_t before_header = npy_magic.size() + 2 + 2;
    std::string header =
        fmt::format("{{'descr': '{}f8', 'fortran_order': False, 'shape': ({}, {}), }}",
                    std::endian::native == std::endian::little ? '<' : '>', points.size(), points.dimension);
    const std::size_t unpadded = before_header + header.size() + 1;
    header.append((alignment - unpadded % alignment) % alignment, ' ');
    header += '\n';

    fmt::memory_buffer out;
    out.append(npy_magic);
    const auto version = std::string_view("\x01\x00", 2);
    out.append(version);
    out.push_back(static_cast<char>(header.size() % 256));
    out.push_back(static_cast<char>(header.size() / 256));
    out.append(header);
    const char* const data = reinterpret_cast<const char*>(points.coordinates.data());
    out.append(data, data + points.coordinates.size() * sizeof(double));
    return out;
}

}

void write_points(const std::filesystem::path& path, const PointSet& points, const std::string& comment)
{
    const std::string extension = path.extension().string();
    const fmt::memory_buffer content = extension == ".ply"   ? ply_file(points, comment)
                                       : extension == ".npy" ? npy_file(points)
                                                             : text_file(points, comment);
    write_whole_file(path, std::string_view(content.data(), content.size()));
}

}
