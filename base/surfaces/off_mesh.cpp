// OFF: Geomview, http://www.geomview.org/docs/html/OFF.html, with what other programs make of it.
#include "base/surfaces/off_binary.hpp"
#include "base/surfaces/off_keyword.hpp"

#include "base/errors/errors.hpp"
#include "base/surfaces/mesh_words.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

class OffTextReader
{
public:
    explicit OffTextReader(const MeshBytes& file) : words_(file.name, file.bytes, MeshWords::Lines::commented) {}

    PolygonSoup read()
    {
        read_head();
        for (std::size_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (std::size_t i = 0; i < faces_; ++i) read_face(i);
        if (words_.next_filled_line() && words_.next())
            words_.fail(fmt::format("\"{}\": stands after the last of {} {} and {} {}, which the head announces",
                                    shortened(words_.word()), vertices_, noun(vertices_, "vertex", "vertices"), faces_,
                                    noun(faces_, "face")));
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
        if (!keyword_.has_weights) return;
        need_word("the fourth coordinate");
        if (!is_divided(point, words_.number("a coordinate")))
            words_.fail("the first three coordinates over the fourth are no finite numbers");
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
    OffKeyword keyword_;
    std::size_t vertices_ = 0, faces_ = 0;
    PolygonSoup soup_;
};

}

bool is_divided(MeshPoint& point, double weight)
{
    bool is_finite = true;
    for (double& c : point) {
        c /= weight;
        is_finite = is_finite && std::isfinite(c);
    }
    return is_finite;
}

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

PolygonSoup read_off(const MeshBytes& file)
{
    return is_binary_off(file.bytes) ? read_binary_off(file) : OffTextReader(file).read();
}

}
