// Writes point sets as a point instancer of USD, as text:
// https://openusd.org/release/api/class_usd_geom_point_instancer.html.
//
// A program that reads the file shows a sphere at each point, and lets users put something else in its place. The
// plane of 2D sets is that of x and y; z goes up. Positions are floats there, so that points keep 24 bits.
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {
namespace {

constexpr std::size_t usd_points_per_piece = 4096;

/// Text within quotes, on one line.
std::string quoted_words(std::string_view comment)
{
    std::string words;
    for (LineReader lines(comment); lines.next();) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty()) continue;
        if (!words.empty()) words += "; ";
        for (const char c : line) {
            if (c == '"' || c == '\\') words += '\\';
            words += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return words;
}

std::string usd_header(const std::string& comment)
{
    return fmt::format("#usda 1.0\n(\n    defaultPrim = \"Points\"\n    doc = \"{}\"\n    upAxis = \"Z\"\n)\n\n"
                       "def PointInstancer \"Points\"\n{{\n    rel prototypes = </Points/Prototypes/Sphere>\n",
                       quoted_words(comment));
}

/// All points are instances of the first prototype.
void write_indices(const FileSink& file, std::size_t points)
{
    file("    int[] protoIndices = [");
    for (std::size_t done = 0; done < points;) {
        const std::size_t count = std::min(points - done, usd_points_per_piece);
        std::string piece;
        for (std::size_t i = 0; i < count; ++i) piece += done + i == 0 ? "0" : ", 0";
        file(piece);
        done += count;
    }
    file("]\n");
}

void append_places(fmt::memory_buffer& out, std::span<const double> coordinates, std::size_t axes, bool is_first)
{
    for (std::size_t i = 0; i < coordinates.size(); i += axes)
        fmt::format_to(std::back_inserter(out), "{}({}, {}, {})", is_first && i == 0 ? "" : ",\n        ",
                       static_cast<float>(coordinates[i]), static_cast<float>(coordinates[i + 1]),
                       axes == 3 ? static_cast<float>(coordinates[i + 2]) : 0.0F);
}

/// Spheres with a quarter of the mean spacing of points over a square, or in a cube, of their extent.
std::string usd_end(std::size_t points, double extent, int dimension)
{
    const double spacing = extent / std::pow(static_cast<double>(std::max<std::size_t>(points, 1)), 1.0 / dimension);
    return fmt::format("]\n\n    def Scope \"Prototypes\"\n    {{\n        def Sphere \"Sphere\"\n        {{\n"
                       "            double radius = {:.4g}\n        }}\n    }}\n}}\n",
                       spacing > 0 ? spacing / 4 : 1);
}

}

void write_usd_points(const std::filesystem::path& path, int dimension, std::size_t points, const std::string& comment,
                      const std::function<void(const PointSink& sink)>& write)
{
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file(usd_header(comment));
        write_indices(file, points);
        file("    point3f[] positions = [");
        const auto axes = static_cast<std::size_t>(dimension);
        bool is_first = true;
        double low = HUGE_VAL, high = -HUGE_VAL;
        write([&](std::span<const double> coordinates) {
            for_pieces_of_text(coordinates, axes, [&](std::span<const double> piece) {
                const auto [least, most] = std::ranges::minmax(piece);
                low = std::min(low, least);
                high = std::max(high, most);
                fmt::memory_buffer out;
                append_places(out, piece, axes, is_first);
                is_first = false;
                file({out.data(), out.size()});
            });
        });
        file(usd_end(points, high - low, dimension));
    });
}

}
