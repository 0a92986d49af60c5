// OBJ: Wavefront, Advanced Visualizer, appendix B1. This reader takes vertices, texture coordinates, normals and faces,
// and colours, which many programs write after coordinates; it skips groups and materials.
#include "base/surfaces/mesh_words.hpp"
#include "base/surfaces/polygon_soup.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace poissonlab {
namespace {

/// Statements that would add to the surface: free forms and other files.
constexpr std::array<std::string_view, 6> unread_statements{"surf", "bzp", "bsp", "cdp", "call", "csh"};

class ObjReader
{
public:
    explicit ObjReader(const MeshBytes& file)
        : file_(file), has_texture_(file.parts != MeshParts::faces), has_all_(file.parts == MeshParts::all),
          words_(file.name, file.bytes, MeshWords::Lines::continued)
    {}

    PolygonSoup read()
    {
        while (words_.next_line())
            if (words_.next()) read_statement(words_.word());
        if (farthest_ > soup_.points.size())
            throw InputError::at(
                {file_.name, farthest_line_},
                fmt::format("\"{}\": there is no such vertex: the file has {}", farthest_, soup_.points.size()));
        if (soup_.texture_points.empty()) soup_.texture_corners.clear();
        if (soup_.normals.empty()) soup_.normal_corners.clear();
        return std::move(soup_);
    }

private:
    void read_statement(std::string_view name)
    {
        if (name == "v")
            read_vertex();
        else if (name == "vt" && has_texture_)
            read_texture_point();
        else if (name == "vn" && has_all_)
            read_normal();
        else if (name == "f" || name == "fo") // as older files have it
            read_face();
        else if (name == "l" || name == "p")
            ++soup_.lines;
        else if (std::ranges::find(unread_statements, name) != unread_statements.end())
            words_.fail(fmt::format("{}: only vertices and faces of OBJ are read, no free forms and no other files: "
                                    "store the surface as polygons",
                                    name));
    }

    void read_vertex()
    {
        MeshPoint& point = soup_.points.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            if (!words_.next()) words_.fail(fmt::format("a vertex has three coordinates, this one {}", k));
            point[k] = words_.number("a coordinate");
        }
        if (soup_.points.size() > most_in_mesh) words_.fail(fmt::format("is more than {} vertices", most_in_mesh));
        if (has_all_) read_color();
    }

    /// A vertex without colours has at most one number after its coordinates, its weight.
    void read_color()
    {
        std::vector<double> numbers;
        while (numbers.size() < 3 && words_.next()) numbers.push_back(words_.number("a colour"));
        VertexColumns& columns = soup_.columns;
        if (columns.names.empty() && numbers.size() == 3) {
            columns = {{"red", "green", "blue"}, {false, false, false}, {}};
            columns.values.assign(3 * (soup_.points.size() - 1), NAN);
        }
        if (columns.names.empty()) return;
        if (numbers.size() < 3) numbers.assign(3, NAN);
        columns.values.insert(columns.values.end(), numbers.begin(), numbers.end());
    }

    void read_normal()
    {
        MeshPoint& normal = soup_.normals.emplace_back();
        for (double& c : normal) {
            if (!words_.next()) words_.fail("a normal has three numbers");
            c = words_.number("a number of a normal");
        }
    }

    void read_texture_point()
    {
        TexturePoint& point = soup_.texture_points.emplace_back();
        for (std::size_t k = 0; k < 2 && words_.next(); ++k) point[k] = words_.number("a texture coordinate");
    }

    void read_face()
    {
        std::uint32_t size = 0;
        for (; words_.next(); ++size) {
            const std::string_view word = words_.word(), number = word.substr(0, word.find('/'));
            soup_.corners.push_back(vertex(number));
            const auto [texture, normal] = indices_after(word);
            if (has_texture_)
                soup_.texture_corners.push_back(
                    other_index(texture, soup_.texture_points.size(), "texture coordinate"));
            if (has_all_) soup_.normal_corners.push_back(other_index(normal, soup_.normals.size(), "normal"));
        }
        soup_.sizes.push_back(size);
        if (soup_.corners.size() > most_in_mesh) words_.fail(fmt::format("is more than {} corners", most_in_mesh));
    }

    /// The number of a vertex, which may come later; negative ones count from the last before this line.
    std::uint32_t vertex(std::string_view number)
    {
        std::int64_t index = index_of(number);
        const auto count = static_cast<std::int64_t>(soup_.points.size());
        if (index == 0) words_.fail(fmt::format("\"{}\": vertices are counted from 1", words_.word()));
        if (index < -count || index > static_cast<std::int64_t>(most_in_mesh))
            words_.fail(fmt::format("\"{}\": there is no such vertex among the {} before this line",
                                    shortened(words_.word()), count));
        if (index < 0) index += count + 1;
        if (index > count && static_cast<std::size_t>(index) > farthest_) {
            farthest_ = static_cast<std::size_t>(index);
            farthest_line_ = words_.line();
        }
        return static_cast<std::uint32_t>(index - 1);
    }

    /// Returns the texts of the texture point and of the normal of a corner: 5 and 2 for "3/5/2"; they may be empty.
    static std::array<std::string_view, 2> indices_after(std::string_view word)
    {
        std::array<std::string_view, 2> indices{};
        for (std::string_view& index : indices) {
            const std::size_t slash = word.find('/');
            if (slash == word.npos) break;
            word.remove_prefix(slash + 1);
            index = word.substr(0, word.find('/'));
        }
        return indices;
    }

    /// Returns the number of one of `size` texture points or normals; negative numbers count from the last.
    std::uint32_t other_index(std::string_view number, std::size_t size, std::string_view name) const
    {
        if (number.empty()) return no_texture_point;
        std::int64_t index = index_of(number);
        const auto count = static_cast<std::int64_t>(size);
        if (index < 0) index += count + 1;
        if (index < 1 || index > count)
            words_.fail(fmt::format("\"{}\": there is no such {} among the {} before this line",
                                    shortened(words_.word()), name, count));
        return static_cast<std::uint32_t>(index - 1);
    }

    std::int64_t index_of(std::string_view number) const
    {
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
        if (error != std::errc() || end != number.data() + number.size())
            words_.fail(fmt::format("\"{}\": a corner of a face is a whole number, or several with slashes between "
                                    "them, as in 3, 3/1 and 3/1/2",
                                    shortened(words_.word())));
        return index;
    }

    const MeshBytes& file_;
    const bool has_texture_, has_all_;
    MeshWords words_;
    PolygonSoup soup_;
    std::size_t farthest_ = 0; ///< the largest number of a vertex that was not there yet
    int farthest_line_ = 0;
};

}

PolygonSoup read_obj(const MeshBytes& file) { return ObjReader(file).read(); }

}
