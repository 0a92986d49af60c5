// STL: 3D Systems, StereoLithography Interface Specification. Corners at one place are one vertex.
#include "base/surfaces/mesh_words.hpp"
#include "base/surfaces/polygon_soup.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <unordered_map>

namespace poissonlab {
namespace {

struct HashOfPlace
{
    std::size_t operator()(const MeshPoint& place) const
    {
        std::size_t hash = 0;
        for (const double c : place) hash = (hash ^ std::hash<double>()(c)) * 0x9e3779b97f4a7c15U;
        return hash;
    }
};

/// Gives corners the numbers of vertices, in the order in which these come first.
class StlSoup
{
public:
    void add_corner(const MeshPoint& place)
    {
        const auto next = static_cast<std::uint32_t>(soup.points.size());
        const auto [found, is_new] = numbers_.try_emplace(place, next);
        if (is_new) soup.points.push_back(place);
        soup.corners.push_back(found->second);
    }

    PolygonSoup soup;

private:
    std::unordered_map<MeshPoint, std::uint32_t, HashOfPlace> numbers_;
};

bool is_word(std::string_view word, std::string_view lower)
{
    return std::ranges::equal(word, lower, [](unsigned char a, char b) { return std::tolower(a) == b; });
}

class StlTextReader
{
public:
    explicit StlTextReader(const MeshBytes& file) : words_(file.name, file.bytes, MeshWords::Lines::plain) {}

    PolygonSoup read()
    {
        while (words_.next_anywhere()) read_solid();
        return std::move(stl_.soup);
    }

private:
    /// `solid`, whose name is the rest of its line, facets, and `endsolid`.
    void read_solid()
    {
        if (!is_word(words_.word(), "solid")) fail_at_word("must be `solid`");
        skip_line();
        while (need_word("`endsolid`"), !is_word(words_.word(), "endsolid")) {
            if (is_word(words_.word(), "facet"))
                read_facet();
            else if (is_word(words_.word(), "color")) // of some programs
                skip_line();
            else
                fail_at_word("must be `facet` or `endsolid`");
        }
        skip_line();
    }

    void read_facet()
    {
        need("normal");
        for (int k = 0; k < 3; ++k) need_word("the normal"); // which is not used, and often no number
        need("outer");
        need("loop");
        std::uint32_t size = 0;
        for (; need_word("`endloop`"), is_word(words_.word(), "vertex"); ++size) {
            MeshPoint place{};
            for (double& c : place) {
                need_word("a coordinate");
                c = words_.number("a coordinate");
            }
            stl_.add_corner(place);
        }
        if (!is_word(words_.word(), "endloop")) fail_at_word("must be `vertex` or `endloop`");
        need("endfacet");
        stl_.soup.sizes.push_back(size);
        if (stl_.soup.corners.size() > most_in_mesh) words_.fail(fmt::format("is more than {} corners", most_in_mesh));
    }

    void skip_line()
    {
        while (words_.next()) {
        }
    }

    void need(std::string_view word)
    {
        need_word(fmt::format("`{}`", word));
        if (!is_word(words_.word(), word)) fail_at_word(fmt::format("must be `{}`", word));
    }

    void need_word(const std::string& what)
    {
        if (!words_.next_anywhere()) words_.fail("the file ends before " + what + ": a part of it is missing");
    }

    [[noreturn]] void fail_at_word(const std::string& problem) const
    {
        words_.fail(fmt::format("\"{}\": {}", shortened(words_.word()), problem));
    }

    MeshWords words_;
    StlSoup stl_;
};

constexpr std::size_t bytes_of_head = 84, bytes_of_triangle = 50;

std::size_t triangles_announced(std::string_view bytes)
{
    return load<std::uint32_t>(bytes.substr(bytes_of_head - 4), std::endian::little);
}

PolygonSoup read_binary_stl(const MeshBytes& file)
{
    const auto fail = [&file](const std::string& problem) { throw InputError::at({file.name}, problem); };
    const std::size_t triangles = triangles_announced(file.bytes);
    if (triangles > most_in_mesh / 3) fail(fmt::format("has more than {} triangles", most_in_mesh / 3));
    StlSoup stl;
    for (std::size_t t = 0; t < triangles; ++t) {
        std::string_view corners = file.bytes.substr(bytes_of_head + t * bytes_of_triangle + 12); // after the normal
        for (int k = 0; k < 3; ++k) {
            MeshPoint place{};
            for (double& c : place) {
                c = static_cast<double>(load<float>(corners, std::endian::little));
                corners.remove_prefix(4);
                if (!std::isfinite(c))
                    fail(fmt::format("triangle {} has a coordinate that is not a finite number", t + 1));
            }
            stl.add_corner(place);
        }
        stl.soup.sizes.push_back(3);
    }
    return std::move(stl.soup);
}

bool is_binary_stl(std::string_view bytes)
{
    return bytes.size() >= bytes_of_head &&
           bytes.size() == bytes_of_head + triangles_announced(bytes) * bytes_of_triangle;
}

/// The size of a binary file says how many triangles it has, also where it begins with "solid". Files of text have no
/// byte 0.
bool is_stl_text(std::string_view bytes)
{
    std::string_view text = bytes.substr(0, 1000);
    if (text.find('\0') != text.npos) return false;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != text.npos && is_word(text.substr(begin, 5), "solid");
}

}

PolygonSoup read_stl(const MeshBytes& file)
{
    if (is_binary_stl(file.bytes)) return read_binary_stl(file);
    if (is_stl_text(file.bytes)) return StlTextReader(file).read();
    if (file.bytes.size() < bytes_of_head)
        throw InputError::at({file.name}, fmt::format("is no STL: it does not begin with `solid`, and has {} bytes, of "
                                                      "which a binary file has {} at least",
                                                      file.bytes.size(), bytes_of_head));
    const std::size_t triangles = triangles_announced(file.bytes);
    throw InputError::at({file.name},
                         fmt::format("is no STL: it is no text that begins with `solid`, and a binary file of {} "
                                     "triangles, as its head has it, has {} bytes, this one {}",
                                     triangles, bytes_of_head + triangles * bytes_of_triangle, file.bytes.size()));
}

}
