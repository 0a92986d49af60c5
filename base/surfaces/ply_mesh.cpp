// PLY: Turk 1994, "The PLY polygon file format", whose names of properties are those that programs write.
#include "base/surfaces/ply_rows.hpp"
#include "base/surfaces/polygon_soup.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

constexpr std::size_t no_column = SIZE_MAX;

std::size_t column_of(const PlyElement& element, std::string_view name)
{
    const auto found = std::ranges::find_if(
        element.columns, [&](const PlyColumn& column) { return column.name == name && !column.count; });
    return found == element.columns.end() ? no_column : static_cast<std::size_t>(found - element.columns.begin());
}

/// The places of texture coordinates among the columns of vertices.
std::array<std::size_t, 2> texture_columns(const PlyElement& vertices)
{
    for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}})
        if (const std::array found{column_of(vertices, u), column_of(vertices, v)};
            found[0] != no_column && found[1] != no_column)
            return found;
    return {no_column, no_column};
}

/// Returns the place of a list among the columns, or no_column.
std::size_t list_of(const PlyElement& element, std::string_view name, std::string_view other_name)
{
    const auto found = std::ranges::find_if(element.columns, [&](const PlyColumn& column) {
        return column.count && (column.name == name || column.name == other_name);
    });
    return found == element.columns.end() ? no_column : static_cast<std::size_t>(found - element.columns.begin());
}

std::size_t corner_list(const PlyElement& element) { return list_of(element, "vertex_indices", "vertex_index"); }

/// Returns the list of texture coordinates of a face, u and v of each corner, as MeshLab writes it, or no_column.
std::size_t texture_list(const PlyElement& element)
{
    return element.name == "face" ? list_of(element, "texcoord", "texcoord") : no_column;
}

class PlyReader
{
public:
    explicit PlyReader(const MeshBytes& file)
        : file_(file), header_(read_ply_header({file.name, file.bytes, any_coordinates})), rows_(file.name, header_)
    {}

    PolygonSoup read()
    {
        check_elements();
        for (const PlyElement& element : header_.elements) {
            if (element.name == "edge") soup_.lines = element.count;
            if (!element.columns.empty()) read_element(element);
        }
        rows_.end_file();
        if (farthest_ >= static_cast<double>(soup_.points.size()))
            fail(fmt::format("row {} of the element `{}` has vertex {}, which is not there: they are 0 to {}",
                             farthest_row_, farthest_element_, farthest_,
                             static_cast<std::int64_t>(soup_.points.size()) - 1));
        if (!has_texture_lists_ && !soup_.texture_points.empty()) soup_.texture_corners = soup_.corners;
        return std::move(soup_);
    }

private:
    /// Finds the columns of coordinates, and that there are faces.
    void check_elements()
    {
        const auto vertices = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
        if (vertices == header_.elements.end()) fail("has no element `vertex`");
        if (std::ranges::count(header_.elements, "vertex", &PlyElement::name) > 1)
            fail("has more than one element `vertex`");
        columns_ = {column_of(*vertices, "x"), column_of(*vertices, "y"), column_of(*vertices, "z")};
        if (std::ranges::find(columns_, no_column) != columns_.end())
            fail("the element `vertex` must have the properties x, y and z");
        const bool reads_texture = file_.parts != MeshParts::faces;
        has_texture_lists_ = reads_texture && std::ranges::any_of(header_.elements, [](const PlyElement& element) {
                                 return texture_list(element) != no_column;
                             });
        if (reads_texture && !has_texture_lists_) texture_columns_ = texture_columns(*vertices);
        if (file_.parts == MeshParts::all) find_others(*vertices);
        bool has_faces = false;
        for (const PlyElement& element : header_.elements) {
            if (element.name != "face" && element.name != "tristrips") continue;
            has_faces = true;
            if (corner_list(element) == no_column)
                fail(fmt::format("the element `{}` must have a list `vertex_indices` or `vertex_index`", element.name));
        }
        if (!has_faces) fail("has no faces: it has neither an element `face` nor `tristrips`");
    }

    /// Finds the columns of vertices that are neither places nor texture coordinates.
    void find_others(const PlyElement& vertices)
    {
        for (std::size_t c = 0; c < vertices.columns.size(); ++c) {
            const PlyColumn& column = vertices.columns[c];
            if (column.count || std::ranges::find(columns_, c) != columns_.end() ||
                std::ranges::find(texture_columns_, c) != texture_columns_.end())
                continue;
            others_.push_back(c);
            soup_.columns.names.push_back(column.name);
            soup_.columns.are_bytes.push_back(column.type == PlyType::uint8);
        }
    }

    void read_element(const PlyElement& element)
    {
        const bool is_vertex = element.name == "vertex", is_strips = element.name == "tristrips";
        const std::size_t list = is_strips || element.name == "face" ? corner_list(element) : no_column;
        const std::size_t texture = has_texture_lists_ ? texture_list(element) : no_column;
        for (std::size_t row = 0; row < element.count; ++row) {
            read_row(element, row, list, texture);
            if (is_vertex) add_vertex();
            if (list == no_column) continue;
            for (const double corner : list_) check_corner(corner, is_strips, element, row);
            if (is_strips)
                add_strips();
            else
                add_face(list_);
            if (soup_.corners.size() > most_in_mesh) fail(fmt::format("has more than {} corners", most_in_mesh));
        }
    }

    /// Takes the numbers of a row, and the entries of two lists of it.
    void read_row(const PlyElement& element, std::size_t row, std::size_t list, std::size_t texture)
    {
        rows_.next_row(element, row);
        list_.clear();
        texture_list_.clear();
        values_.assign(element.columns.size(), 0);
        for (std::size_t c = 0; c < element.columns.size(); ++c) {
            const PlyColumn& column = element.columns[c];
            if (!column.count) {
                values_[c] = rows_.value(column.type);
                continue;
            }
            for (std::size_t n = rows_.count(*column.count, column.type); n > 0; --n) {
                const double value = rows_.value(column.type);
                if (c == list) list_.push_back(value);
                if (c == texture) texture_list_.push_back(finite(value, "a texture coordinate"));
            }
        }
        rows_.end_row();
    }

    void add_vertex()
    {
        MeshPoint& point = soup_.points.emplace_back();
        if (soup_.points.size() > most_in_mesh) fail(fmt::format("has more than {} vertices", most_in_mesh));
        for (std::size_t k = 0; k < 3; ++k) point[k] = finite(values_[columns_[k]], "a coordinate");
        for (std::size_t i = 0; i < others_.size(); ++i) add_number(i, values_[others_[i]]);
        if (texture_columns_[0] == no_column) return;
        TexturePoint& texture = soup_.texture_points.emplace_back();
        for (std::size_t k = 0; k < 2; ++k) texture[k] = finite(values_[texture_columns_[k]], "a texture coordinate");
    }

    /// Text can have numbers that the type of their column has not.
    void add_number(std::size_t column, double value)
    {
        if (soup_.columns.are_bytes[column] && !(value >= 0 && value <= 255 && value == std::floor(value)))
            rows_.fail(fmt::format("{}: a number of the property `{}` must be a whole number from 0 to 255, since its "
                                   "type is uchar",
                                   value, soup_.columns.names[column]));
        soup_.columns.values.push_back(value);
    }

    double finite(double value, std::string_view name) const
    {
        if (!std::isfinite(value)) rows_.fail(fmt::format("{}: {} must be a finite number", value, name));
        return value;
    }

    /// Vertices may come after the faces.
    void check_corner(double corner, bool is_strips, const PlyElement& element, std::size_t row)
    {
        if (is_strips && corner == -1) return; // begins the next strip
        if (!(corner >= 0) || corner != std::floor(corner) || corner > static_cast<double>(most_in_mesh))
            rows_.fail(fmt::format("{}: there is no such vertex", corner));
        if (corner <= farthest_) return;
        farthest_ = corner;
        farthest_row_ = row + 1;
        farthest_element_ = element.name;
    }

    void add_face(const std::vector<double>& corners)
    {
        for (const double corner : corners) soup_.corners.push_back(static_cast<std::uint32_t>(corner));
        soup_.sizes.push_back(static_cast<std::uint32_t>(corners.size()));
        if (!has_texture_lists_) return;
        if (!texture_list_.empty() && texture_list_.size() != 2 * corners.size())
            rows_.fail(fmt::format("texcoord: has {} numbers, and must have two for each of {} corners",
                                   texture_list_.size(), corners.size()));
        for (std::size_t i = 0; i < corners.size(); ++i)
            soup_.texture_corners.push_back(
                texture_list_.empty() ? no_texture_point
                                      : texture_point(corners[i], {texture_list_[2 * i], texture_list_[2 * i + 1]}));
    }

    /// Corners that have a vertex and its texture coordinates in common share a texture point: no seam is there.
    std::uint32_t texture_point(double corner, const TexturePoint& at)
    {
        const auto [found, is_new] = texture_numbers_.try_emplace(
            {corner, at[0], at[1]}, static_cast<std::uint32_t>(soup_.texture_points.size()));
        if (is_new) soup_.texture_points.push_back(at);
        return found->second;
    }

    /// Each corner of a strip makes a triangle with the two before it; every other one is turned around.
    void add_strips()
    {
        std::size_t first = 0;
        for (std::size_t i = 0; i < list_.size(); ++i) {
            if (list_[i] == -1)
                first = i + 1;
            else if (i >= first + 2)
                add_face((i - first) % 2 == 0 ? std::vector{list_[i - 2], list_[i - 1], list_[i]}
                                              : std::vector{list_[i - 1], list_[i - 2], list_[i]});
        }
    }

    [[noreturn]] void fail(const std::string& problem) const { throw InputError::at({file_.name}, problem); }

    const MeshBytes& file_;
    const PlyHeader header_;
    PlyRows rows_;
    PolygonSoup soup_;
    std::array<std::size_t, 3> columns_{};
    std::array<std::size_t, 2> texture_columns_{no_column, no_column};
    std::vector<std::size_t> others_;                  ///< other columns of vertices
    std::vector<double> values_, list_, texture_list_; ///< of a row
    bool has_texture_lists_ = false;                   ///< then vertices' own texture coordinates are left alone
    std::map<std::array<double, 3>, std::uint32_t> texture_numbers_; ///< by vertex, u and v
    double farthest_ = -1; ///< the largest number of a vertex, and where it is
    std::size_t farthest_row_ = 0;
    std::string farthest_element_;
};

/// The bytes with a header whose lines end in CR alone as one whose lines end in LF; empty where it has none.
std::string with_mended_header(std::string_view bytes)
{
    const std::size_t first = bytes.find_first_of("\r\n");
    if (first == bytes.npos || bytes[first] == '\n' || bytes.substr(first + 1).starts_with('\n')) return {};
    std::string mended(bytes);
    const std::size_t last = std::min(bytes.find("end_header"), bytes.size()),
                      end = std::min(bytes.find('\r', last), bytes.size() - 1) + 1;
    std::replace(mended.begin(), mended.begin() + static_cast<std::ptrdiff_t>(end), '\r', '\n');
    return mended;
}

}

PolygonSoup read_ply(const MeshBytes& file)
{
    std::string_view bytes = file.bytes;
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    if (trimmed(bytes.substr(0, bytes.find_first_of("\r\n"))) != "ply")
        throw InputError::at({file.name}, "is no PLY: its first line must be the word ply");
    const std::string mended = with_mended_header(bytes);
    return PlyReader({file.name, mended.empty() ? bytes : std::string_view(mended), file.parts}).read();
}

}
