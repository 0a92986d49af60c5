// OFF: Geomview, http://www.geomview.org/docs/html/OFF.html, with what other programs make of it.
#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"
#include "base/files/text_lines.hpp"
#include "base/surfaces/mesh_words.hpp"
#include "base/surfaces/polygon_soup.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace poissonlab {
namespace {

// The word that files of OFF begin with.

/// [ST][C][N][4][n]OFF: what vertices have besides x, y and z, after them but for the weight.
struct OffKeyword
{
    bool has_texture = false, has_colors = false, has_normals = false, has_weights = false, has_dimension = false;
    std::string_view glued; ///< digits that follow without a blank, as in "OFF8 6 0"
};

/// Reads a keyword of OFF; returns nothing where the word is none.
std::optional<OffKeyword> off_keyword(std::string_view word)
{
    OffKeyword keyword;
    const auto skip = [&word](std::string_view text) {
        if (!word.starts_with(text)) return false;
        word.remove_prefix(text.size());
        return true;
    };
    keyword.has_texture = skip("ST");
    keyword.has_colors = skip("C");
    keyword.has_normals = skip("N");
    keyword.has_weights = skip("4");
    keyword.has_dimension = skip("n");
    if ((!skip("OFF") && !skip("off")) || word.find_first_not_of("0123456789") != word.npos) return std::nullopt;
    keyword.glued = word;
    return keyword;
}

/// Returns the columns of vertices whose colours have `colors` numbers. Texture coordinates follow these.
VertexColumns columns_of(const OffKeyword& keyword, std::size_t colors)
{
    VertexColumns columns;
    if (keyword.has_normals) columns.names = {"nx", "ny", "nz"};
    for (std::size_t k = 0; k < colors; ++k) columns.names.emplace_back(std::array{"red", "green", "blue", "alpha"}[k]);
    columns.are_bytes.assign(columns.names.size(), false);
    return columns;
}

/// Returns how many numbers vertices have after their coordinates.
std::size_t further_numbers(const OffKeyword& keyword, std::size_t colors)
{
    return columns_of(keyword, colors).names.size() + 2 * keyword.has_texture;
}

/// Adds the further numbers of a vertex to a soup, those that are asked for. False where texture coordinates are not
/// finite.
bool add_numbers(PolygonSoup& soup, const std::vector<double>& numbers, bool has_texture, MeshParts parts)
{
    const std::size_t columns = numbers.size() - 2 * has_texture;
    if (parts == MeshParts::all)
        soup.columns.values.insert(soup.columns.values.end(), numbers.begin(),
                                   numbers.begin() + static_cast<std::ptrdiff_t>(columns));
    if (!has_texture || parts == MeshParts::faces) return true;
    soup.texture_points.push_back({numbers[columns], numbers[columns + 1]});
    return std::isfinite(numbers[columns]) && std::isfinite(numbers[columns + 1]);
}

/// Divides homogeneous coordinates by their weight. False where no finite numbers come out.
bool is_divided(MeshPoint& point, double weight)
{
    bool is_finite = true;
    for (double& c : point) {
        c /= weight;
        is_finite = is_finite && std::isfinite(c);
    }
    return is_finite;
}

// Binary files of OFF: numbers are int32 and float32, big-endian.

class BinaryOffReader
{
public:
    /// The keyword is that of the first line; numbers follow it.
    BinaryOffReader(const MeshBytes& file, const OffKeyword& keyword) : file_(file), keyword_(keyword)
    {
        LineReader lines(file.bytes);
        if (lines.next()) left_ = lines.rest();
    }

    PolygonSoup read()
    {
        if (keyword_.has_dimension && integer("the dimension") != 3)
            fail("vertices of nOFF must have three coordinates");
        vertices_ = count("the number of vertices");
        const std::size_t faces = count("the number of faces");
        count("the number of edges");
        for (std::size_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (std::size_t i = 0; i < faces; ++i) read_face(i);
        if (!left_.empty())
            fail(fmt::format("has {} {} after the last of {} {} and {} {}, which its head announces", left_.size(),
                             noun(left_.size(), "byte"), vertices_, noun(vertices_, "vertex", "vertices"), faces,
                             noun(faces, "face")));
        if (!soup_.texture_points.empty()) soup_.texture_corners = soup_.corners;
        return std::move(soup_);
    }

private:
    void read_vertex(std::size_t i)
    {
        MeshPoint point{};
        for (double& c : point) c = number(i);
        const double weight = keyword_.has_weights ? number(i) : 1;
        if (!is_divided(point, weight)) fail(fmt::format("vertex {} has a coordinate that is not a finite number", i));
        if (file_.parts == MeshParts::all && i == 0) soup_.columns = columns_of(keyword_, 4 * keyword_.has_colors);
        std::vector<double> numbers(further_numbers(keyword_, 4 * keyword_.has_colors));
        for (double& n : numbers) n = number(i);
        if (!add_numbers(soup_, numbers, keyword_.has_texture, file_.parts))
            fail(fmt::format("vertex {} has a texture coordinate that is not a finite number", i));
        soup_.points.push_back(point);
    }

    void read_face(std::size_t i)
    {
        const std::size_t size = count("the number of corners");
        for (std::size_t k = 0; k < size; ++k) {
            const std::int32_t corner = integer("a corner of a face");
            if (corner < 0 || static_cast<std::size_t>(corner) >= vertices_)
                fail(fmt::format("face {} has vertex {}, which is not there: they are 0 to {}", i, corner,
                                 static_cast<std::int64_t>(vertices_) - 1));
            soup_.corners.push_back(static_cast<std::uint32_t>(corner));
        }
        soup_.sizes.push_back(static_cast<std::uint32_t>(size));
        const std::size_t colors = count("the number of colours of a face");
        for (std::size_t k = 0; k < colors; ++k) number(i);
    }

    std::size_t count(std::string_view name)
    {
        const std::int32_t value = integer(name);
        if (value < 0) fail(fmt::format("{} is {}: must be at least 0", name, value));
        return static_cast<std::size_t>(value);
    }

    std::int32_t integer(std::string_view name)
    {
        if (left_.size() < 4) fail(fmt::format("ends before {}", name));
        const auto value = load<std::int32_t>(left_, std::endian::big);
        left_.remove_prefix(4);
        return value;
    }

    double number(std::size_t row)
    {
        if (left_.size() < 4) fail(fmt::format("ends within vertex or face {}", row));
        const auto value = load<float>(left_, std::endian::big);
        left_.remove_prefix(4);
        return static_cast<double>(value);
    }

    [[noreturn]] void fail(const std::string& problem) const { throw InputError::at({file_.name}, problem); }

    const MeshBytes& file_;
    std::string_view left_;
    OffKeyword keyword_;
    std::size_t vertices_ = 0;
    PolygonSoup soup_;
};

/// The keyword of a binary file, of which the second word of the first line is BINARY; nothing where it is text.
std::optional<OffKeyword> binary_off_keyword(std::string_view bytes)
{
    WordReader words(bytes.substr(0, bytes.find('\n')));
    const auto keyword = words.next() ? off_keyword(words.word()) : std::nullopt;
    if (!keyword || !words.next() || (words.word() != "BINARY" && words.word() != "BINARY\r")) return std::nullopt;
    return keyword;
}

class OffTextReader
{
public:
    explicit OffTextReader(const MeshBytes& file)
        : words_(file.name, file.bytes, MeshWords::Lines::commented), parts_(file.parts)
    {}

    PolygonSoup read()
    {
        read_head();
        for (std::size_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (std::size_t i = 0; i < faces_; ++i) read_face(i);
        if (words_.next_filled_line() && words_.next())
            words_.fail(fmt::format("\"{}\": stands after the last of {} {} and {} {}, which the head announces",
                                    shortened(words_.word()), vertices_, noun(vertices_, "vertex", "vertices"), faces_,
                                    noun(faces_, "face")));
        if (!soup_.texture_points.empty()) soup_.texture_corners = soup_.corners;
        return std::move(soup_);
    }

private:
    void read_head()
    {
        need_word("the word OFF");
        const auto keyword = off_keyword(words_.word());
        std::string_view first = words_.word(); // where the word OFF is left out
        if (keyword) {
            keyword_ = *keyword;
            if (keyword_.has_dimension) check_dimension();
            first = keyword_.glued;
            if (first.empty()) {
                need_word("the number of vertices");
                first = words_.word();
            }
        } else if (first.find_first_not_of("0123456789") != first.npos) {
            words_.fail(fmt::format("\"{}\": a file of OFF begins with the word OFF", shortened(first)));
        }
        vertices_ = count(first, "the number of vertices");
        need_word("the number of faces");
        faces_ = count(words_.word(), "the number of faces");
        skip_edges();
    }

    void check_dimension()
    {
        need_word("the dimension");
        if (words_.word() != "3")
            words_.fail(fmt::format("{}: vertices of nOFF must have three coordinates", shortened(words_.word())));
    }

    /// The third count, of edges, is not needed, and absent in some files. It may be on a line of its own.
    void skip_edges()
    {
        if (words_.next()) return;
        if (MeshWords ahead({}, words_.line_ahead(), MeshWords::Lines::plain);
            ahead.next_line() && ahead.next() && !ahead.next())
            words_.next_filled_line();
    }

    std::size_t count(std::string_view word, std::string_view name) const
    {
        const std::int64_t number = words_.whole_number(word, name);
        if (number < 0 || static_cast<std::size_t>(number) > most_in_mesh)
            words_.fail(fmt::format("{}: {} must be from 0 to {}", number, name, most_in_mesh));
        return static_cast<std::size_t>(number);
    }

    /// The rest of a vertex's line is its normal, colour and texture coordinates.
    void read_vertex(std::size_t i)
    {
        if (!words_.next_filled_line()) fail_at_end(i, vertices_, noun(vertices_, "vertex", "vertices"));
        MeshPoint& point = soup_.points.emplace_back();
        for (double& coordinate : point) {
            need_word(fmt::format("three coordinates of vertex {}", i));
            coordinate = words_.number("a coordinate");
        }
        if (keyword_.has_weights) {
            need_word("the fourth coordinate");
            if (!is_divided(point, words_.number("a coordinate")))
                words_.fail("the first three coordinates over the fourth are no finite numbers");
        }
        if (parts_ == MeshParts::all || (parts_ != MeshParts::faces && keyword_.has_texture)) read_numbers(i);
    }

    /// Colours have three or four numbers, as many as those of the first vertex.
    void read_numbers(std::size_t i)
    {
        std::vector<double> numbers;
        while (words_.next()) numbers.push_back(words_.number("a number of a vertex"));
        const std::size_t others = further_numbers(keyword_, 0);
        if (i == 0 && keyword_.has_colors)
            colors_ = std::clamp<std::size_t>(std::max(numbers.size(), others) - others, 3, 4);
        if (i == 0 && parts_ == MeshParts::all) soup_.columns = columns_of(keyword_, colors_);
        const std::size_t needed = others + colors_;
        if (numbers.size() < needed || (keyword_.has_colors && numbers.size() > needed))
            words_.fail(fmt::format("vertex {} has {} numbers after its coordinates, and must have {}", i,
                                    numbers.size(), needed));
        numbers.resize(needed);
        add_numbers(soup_, numbers, keyword_.has_texture, parts_);
    }

    /// The rest of a face's line is its colour.
    void read_face(std::size_t i)
    {
        if (!words_.next_filled_line()) fail_at_end(i, faces_, noun(faces_, "face"));
        need_word("a face");
        const std::size_t size = count(words_.word(), "the number of corners");
        for (std::size_t k = 0; k < size; ++k) {
            need_word(fmt::format("corner {} of {} of a face", k + 1, size));
            const std::int64_t corner = words_.whole_number(words_.word(), "a corner of a face");
            if (corner < 0 || static_cast<std::size_t>(corner) >= vertices_)
                words_.fail(fmt::format("\"{}\": there is no such vertex: they are 0 to {}", corner,
                                        static_cast<std::int64_t>(vertices_) - 1));
            soup_.corners.push_back(static_cast<std::uint32_t>(corner));
        }
        soup_.sizes.push_back(static_cast<std::uint32_t>(size));
        if (soup_.corners.size() > most_in_mesh) words_.fail(fmt::format("is more than {} corners", most_in_mesh));
    }

    void need_word(const std::string& what)
    {
        if (!words_.next_anywhere()) words_.fail("the file ends before " + what);
    }

    [[noreturn]] void fail_at_end(std::size_t found, std::size_t announced, std::string_view of) const
    {
        words_.fail(fmt::format("the file ends after {} of {} {}, which its head announces", found, announced, of));
    }

    MeshWords words_;
    const MeshParts parts_;
    OffKeyword keyword_;
    std::size_t vertices_ = 0, faces_ = 0, colors_ = 0;
    PolygonSoup soup_;
};

}

PolygonSoup read_off(const MeshBytes& file)
{
    if (const auto keyword = binary_off_keyword(file.bytes)) return BinaryOffReader(file, *keyword).read();
    return OffTextReader(file).read();
}

}
