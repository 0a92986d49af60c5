// Writes point sets as DXF of AutoCAD's release 12, which every program for drawings, cutters and plotters reads: pairs
// of lines, a group's code and its value.
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>

#include <iterator>

namespace poissonlab {
namespace {

void append_entities(fmt::memory_buffer& out, std::span<const double> coordinates, std::size_t axes)
{
    for (std::size_t i = 0; i < coordinates.size(); i += axes)
        fmt::format_to(std::back_inserter(out), "0\nPOINT\n8\n0\n10\n{:.17g}\n20\n{:.17g}\n30\n{:.17g}\n",
                       coordinates[i], coordinates[i + 1], axes == 3 ? coordinates[i + 2] : 0.0);
}

}

std::string dxf_begin(const std::string& comment)
{
    constexpr std::size_t longest = 250; // release 12 reads strings of at most 255 characters
    std::string text;
    for (LineReader lines(comment); lines.next();)
        for (std::string_view rest = lines.line(); !trimmed(rest).empty();) {
            constexpr std::size_t dots = 3; // that shortened() adds to whole characters
            const std::string_view piece =
                rest.size() > longest ? rest.substr(0, shortened(rest, longest).size() - dots) : rest;
            text += fmt::format("999\n{}\n", piece);
            rest.remove_prefix(piece.size());
        }
    return text + "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
}

void write_dxf_points(const std::filesystem::path& path, int dimension, const std::string& comment,
                      const std::function<void(const PointSink& sink)>& write)
{
    write_whole_file_in_pieces(path, [&](const FileSink& file) {
        file(dxf_begin(comment));
        const auto axes = static_cast<std::size_t>(dimension);
        write([&](std::span<const double> coordinates) {
            for_pieces_of_text(coordinates, axes, [&](std::span<const double> piece) {
                fmt::memory_buffer out;
                append_entities(out, piece, axes);
                file({out.data(), out.size()});
            });
        });
        file(dxf_end);
    });
}

}
