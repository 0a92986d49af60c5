// OBJ: Wavefront, Advanced Visualizer, appendix B1; PLY has no rule for names, these are those that programs write.
#include "base/surfaces/texture_coordinates.hpp"

#include "base/errors/errors.hpp"
#include "base/files/mapped_file.hpp"
#include "base/files/text_lines.hpp"
#include "base/points/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace poissonlab {
namespace {

/// Goes through the lines of an OBJ file that concern texture coordinates.
class ObjTexture
{
public:
    ObjTexture(const std::filesystem::path& file, std::string_view text) : file_(file), lines_(text) {}

    TextureCoordinates read(const std::vector<std::vector<std::size_t>>& faces)
    {
        std::size_t face = 0;
        while (lines_.next()) {
            WordReader words(lines_.line());
            if (!words.next()) continue;
            if (words.word() == "vt") read_point(words);
            if (words.word() != "f") continue;
            if (face == faces.size()) fail("is a face more than the mesh has");
            read_face(words, faces[face++].size());
        }
        if (face < faces.size()) fail("the file ends before its last face");
        return std::move(read_);
    }

private:
    void read_point(WordReader& words)
    {
        TexturePoint point{};
        for (std::size_t k = 0; k < 2 && words.next(); ++k)
            if (!parse_number(words.word(), point[k]) || !std::isfinite(point[k]))
                fail(fmt::format("\"{}\": a texture coordinate must be a finite number", words.word()));
        read_.points.push_back(point);
    }

    void read_face(WordReader& words, std::size_t corners)
    {
        std::size_t count = 0;
        for (; words.next() && !words.word().starts_with('#'); ++count) read_.corners.push_back(corner(words.word()));
        if (count != corners) fail(fmt::format("has a face of {} corners, of which {} were read", count, corners));
    }

    /// The number of the texture point of a corner: 5 of "3/6/2" and "3/6"; negative ones count from the last.
    std::uint32_t corner(std::string_view word) const
    {
        const std::size_t slash = word.find('/');
        if (slash == std::string_view::npos) return no_texture_point;
        const std::string_view number = word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
        if (number.empty()) return no_texture_point;
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
        const auto count = static_cast<std::int64_t>(read_.points.size());
        if (index < 0) index += count + 1;
        if (error != std::errc{} || end != number.data() + number.size() || index < 1 || index > count)
            fail(fmt::format("\"{}\": there is no such texture coordinate before this line, of {}", word, count));
        return static_cast<std::uint32_t>(index - 1);
    }

    [[noreturn]] void fail(const std::string& problem) const
    {
        throw InputError::at({file_.string(), lines_.number()}, problem);
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    TextureCoordinates read_;
};

/// The columns of texture coordinates in the element `vertex`.
std::vector<std::size_t> texture_columns(const PlyElement& table)
{
    for (const auto& [u, v] :
         {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const auto first = std::ranges::find(table.properties, u, &PlyProperty::name);
        const auto second = std::ranges::find(table.properties, v, &PlyProperty::name);
        if (first != table.properties.end() && second != table.properties.end())
            return {static_cast<std::size_t>(first - table.properties.begin()),
                    static_cast<std::size_t>(second - table.properties.begin())};
    }
    return {};
}

TextureCoordinates ply_texture(const PointFileContent& file, const std::vector<std::vector<std::size_t>>& faces)
{
    const PlyHeader header = read_ply_header(file);
    const auto table = std::ranges::find(header.elements, "vertex", &PlyElement::name);
    if (table == header.elements.end()) return {};
    const std::vector<std::size_t> columns = texture_columns(*table);
    if (columns.empty()) return {};
    if (table->has_lists)
        throw InputError::at({file.name}, "the element `vertex` has texture coordinates and must not have lists");
    const std::vector<double> values =
        read_ply_columns(file, header, static_cast<std::size_t>(table - header.elements.begin()), columns);
    TextureCoordinates read;
    for (std::size_t i = 0; i < values.size(); i += 2) read.points.push_back({values[i], values[i + 1]});
    for (const auto& face : faces)
        for (const std::size_t corner : face) {
            if (corner >= read.points.size())
                throw InputError::at({file.name}, fmt::format("vertex {} has no texture coordinates: the element "
                                                              "`vertex` has {} rows",
                                                              corner, read.points.size()));
            read.corners.push_back(static_cast<std::uint32_t>(corner));
        }
    return read;
}

}

TextureCoordinates read_texture_coordinates(const std::filesystem::path& file, std::string_view end,
                                            const std::vector<std::vector<std::size_t>>& faces)
{
    if (end != ".obj" && end != ".ply") return {};
    const MappedFile content(file);
    TextureCoordinates read = end == ".obj" ? ObjTexture(file, content.bytes()).read(faces)
                                            : ply_texture({file.string(), content.bytes(), any_coordinates}, faces);
    return read.points.empty() ? TextureCoordinates{} : read;
}

}
