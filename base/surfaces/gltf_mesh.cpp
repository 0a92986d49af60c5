// Triangles of glTF: those of all nodes of a scene, with the places and texture coordinates of their corners.
#include "base/files/stored_object.hpp"
#include "base/surfaces/gltf_numbers.hpp"
#include "base/surfaces/triangle_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

// A node of glTF moves the meshes below it by its matrix, or by its scale, rotation and translation.

/// Rows of a movement of space, which may stretch and mirror it: the last column moves.
using Movement = std::array<std::array<double, 4>, 3>;

std::vector<double> numbers_of_node(const StoredObject& node, const std::string& member,
                                    const std::vector<double>& otherwise)
{
    if (!node.has(member)) return otherwise;
    std::vector<double> numbers = node.numbers(member);
    if (numbers.size() != otherwise.size())
        throw node.error(member, fmt::format("must have {} numbers", otherwise.size()));
    return numbers;
}

/// The movement of a node by its `matrix`, or by `scale`, `rotation` and `translation`. Throws InputError.
Movement movement_of_node(const StoredObject& node)
{
    Movement movement{};
    if (node.has("matrix")) {
        const std::vector<double> m = numbers_of_node(node, "matrix", std::vector<double>(16));
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column) movement[row][column] = m[4 * column + row];
        return movement;
    }
    const auto scale = numbers_of_node(node, "scale", {1, 1, 1}),
               moved = numbers_of_node(node, "translation", {0, 0, 0});
    const auto turn = numbers_of_node(node, "rotation", {0, 0, 0, 1}); // a quaternion of length 1
    const double x = turn[0], y = turn[1], z = turn[2], w = turn[3];
    const std::array<std::array<double, 3>, 3> turned{
        {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
         {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
         {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) movement[row][column] = turned[row][column] * scale[column];
        movement[row][3] = moved[row];
    }
    return movement;
}

/// Returns the transform of `inside` and then `outside`.
Movement movement_of_both(const Movement& outside, const Movement& inside)
{
    Movement result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t k = 0; k < 3; ++k) result[row][column] += outside[row][k] * inside[k][column];
        result[row][3] += outside[row][3];
    }
    return result;
}

MeshPoint moved_by(const Movement& movement, const MeshPoint& point)
{
    MeshPoint moved{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& row = movement[k];
        moved[k] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
    }
    return moved;
}

/// The turning and stretching of a movement, times a power of 2, so that its largest number is from 1 to 2: products of
/// three numbers neither vanish nor overflow, and signs and directions stay.
Movement scaled_to_one(Movement movement)
{
    double largest = 0;
    for (const auto& row : movement)
        for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(row[k]));
    if (!(largest > 0) || !std::isfinite(largest)) return movement;
    for (auto& row : movement)
        for (std::size_t k = 0; k < 3; ++k) row[k] = std::scalbn(row[k], -std::ilogb(largest));
    return movement;
}

bool is_mirroring(const Movement& movement)
{
    const Movement m = scaled_to_one(movement);
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
           0;
}

/// Moves a normal with its surface by the matrix of cofactors, whose result points inwards if the movement mirrors. The
/// result has length 1 again, so that normals between vertices are weighted by their shares alone; 0 stays 0.
MeshPoint turned_by(const Movement& movement, const MeshPoint& normal)
{
    const Movement m = scaled_to_one(movement);
    const double side = is_mirroring(m) ? -1 : 1;
    MeshPoint turned{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = m[(i + 1) % 3], &b = m[(i + 2) % 3];
        turned[i] = side * dot(cross({a[0], a[1], a[2]}, {b[0], b[1], b[2]}), normal);
    }
    const double length = std::hypot(turned[0], turned[1], turned[2]);
    if (length > 0)
        for (double& c : turned) c /= length;
    return turned;
}

enum class GltfMode
{
    points,
    lines,
    line_loop,
    line_strip,
    triangles,
    strip,
    fan
};

class GltfReader
{
public:
    explicit GltfReader(const MeshBytes& file)
        : file_(file), content_(file), numbers_(content_), nodes_(content_.list("nodes")),
          meshes_(content_.list("meshes")), is_used_(nodes_.size())
    {}

    PolygonSoup read()
    {
        constexpr Movement unmoved{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
        soup_.notes = content_.notes();
        for (const std::size_t node : roots()) add_node(node, unmoved, 0);
        if (soup_.texture_points.empty()) soup_.texture_corners.clear();
        if (soup_.normals.empty()) soup_.normal_corners.clear();
        return std::move(soup_);
    }

private:
    /// The nodes of the scene that the file names, or of its first one; of a file without scenes, all that are below no
    /// other.
    std::vector<std::size_t> roots()
    {
        const std::vector<StoredObject> scenes = content_.list("scenes");
        if (scenes.empty()) return uppermost_nodes();
        const StoredObject& scene =
            content_.root().has("scene") ? named_in(scenes, content_.root(), "scene") : scenes.front();
        if (scenes.size() > 1)
            soup_.notes.push_back(fmt::format(
                "scene {} of {} was read, which {}", &scene - scenes.data() + 1, scenes.size(),
                content_.root().has("scene") ? "is the one that the file shows" : "is the first: the file names none"));
        return scene.has("nodes") ? scene.counts("nodes") : std::vector<std::size_t>{};
    }

    std::vector<std::size_t> uppermost_nodes() const
    {
        std::vector<bool> is_below(nodes_.size());
        for (const StoredObject& node : nodes_)
            if (node.has("children"))
                for (const std::size_t child : node.counts("children"))
                    if (child < is_below.size()) is_below[child] = true;
        std::vector<std::size_t> roots;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!is_below[i]) roots.push_back(i);
        return roots;
    }

    void add_node(std::size_t index, const Movement& outside, int depth)
    {
        constexpr int deepest = 1000;
        if (index >= nodes_.size()) fail(fmt::format("nodes[{}] is named and not there", index));
        if (is_used_[index]) fail(fmt::format("nodes[{}] comes twice: a node is below one other, or none", index));
        if (depth > deepest) fail(fmt::format("has nodes within nodes, more than {} deep", deepest));
        is_used_[index] = true;
        const StoredObject& node = nodes_[index];
        const Movement movement = movement_of_both(outside, movement_of_node(node));
        if (node.has("mesh"))
            for (const StoredObject& part : named_in(meshes_, node, "mesh").objects("primitives"))
                add_part(part, movement);
        if (node.has("children"))
            for (const std::size_t child : node.counts("children")) add_node(child, movement, depth + 1);
    }

    void add_part(const StoredObject& part, const Movement& movement)
    {
        const auto mode = static_cast<GltfMode>(part.has("mode") ? part.integer("mode", 0, 6)
                                                                 : static_cast<std::int64_t>(GltfMode::triangles));
        const StoredObject attributes = part.object("attributes");
        if (!attributes.has("POSITION")) return; // has nothing that is shown, by the specification
        if (mode < GltfMode::triangles) {
            ++soup_.lines;
            return;
        }
        const std::size_t first = soup_.points.size(), first_texture = soup_.texture_points.size(),
                          first_normal = soup_.normals.size();
        add_points(attributes, movement);
        const std::size_t count = soup_.points.size() - first;
        const bool has_texture = add_texture(attributes, count), has_normals = add_normals(attributes, count, movement);
        add_colors(attributes, first, count);
        const std::vector<std::size_t> corners = corners_of(part, count);
        if (mode == GltfMode::triangles && corners.size() % 3 != 0)
            throw part.error("indices", fmt::format("are {} corners: triangles have three each", corners.size()));
        const bool is_mirrored = is_mirroring(movement);
        for (std::size_t i = 0; i + 2 < corners.size(); i += mode == GltfMode::triangles ? 3 : 1) {
            std::array<std::size_t, 3> triangle{corners[mode == GltfMode::fan ? 0 : i], corners[i + 1], corners[i + 2]};
            const bool is_turned = mode == GltfMode::strip && i % 2 == 1;
            if (is_mirrored != is_turned) std::swap(triangle[0], triangle[2]);
            for (const std::size_t corner : triangle) {
                soup_.corners.push_back(static_cast<std::uint32_t>(first + corner));
                soup_.texture_corners.push_back(has_texture ? static_cast<std::uint32_t>(first_texture + corner)
                                                            : no_texture_point);
                soup_.normal_corners.push_back(has_normals ? static_cast<std::uint32_t>(first_normal + corner)
                                                           : no_texture_point);
            }
            soup_.sizes.push_back(3);
        }
    }

    void add_points(const StoredObject& attributes, const Movement& movement)
    {
        const std::vector<double> numbers = numbers_.read(attributes, "POSITION", "VEC3", 3);
        if (soup_.points.size() + numbers.size() / 3 > most_in_mesh)
            fail(fmt::format("has more than {} vertices", most_in_mesh));
        for (std::size_t i = 0; i < numbers.size(); i += 3) {
            soup_.points.push_back(moved_by(movement, {numbers[i], numbers[i + 1], numbers[i + 2]}));
            for (const double c : soup_.points.back())
                if (!std::isfinite(c))
                    throw attributes.error(
                        "POSITION", fmt::format("row {} has a coordinate that is not a finite number", i / 3 + 1));
        }
    }

    /// Returns the numbers of an attribute, which must have as many rows as there are vertices.
    std::vector<double> rows_of(const StoredObject& attributes, const char* name, std::size_t width, std::size_t count)
    {
        std::vector<double> numbers = numbers_.read(attributes, name, fmt::format("VEC{}", width), width);
        if (numbers.size() != width * count)
            throw attributes.error(name, fmt::format("has {} rows, and POSITION {}", numbers.size() / width, count));
        return numbers;
    }

    /// Returns false if there are none.
    bool add_normals(const StoredObject& attributes, std::size_t count, const Movement& movement)
    {
        if (file_.parts != MeshParts::all || !attributes.has("NORMAL")) return false;
        const std::vector<double> numbers = rows_of(attributes, "NORMAL", 3, count);
        for (std::size_t i = 0; i < numbers.size(); i += 3)
            soup_.normals.push_back(turned_by(movement, {numbers[i], numbers[i + 1], numbers[i + 2]}));
        return true;
    }

    /// Colours have three or four numbers from 0 to 1; vertices of other parts may have none.
    void add_colors(const StoredObject& attributes, std::size_t first, std::size_t count)
    {
        if (file_.parts != MeshParts::all) return;
        VertexColumns& columns = soup_.columns;
        const bool has_colors = attributes.has("COLOR_0");
        if (has_colors && columns.names.empty()) {
            columns = {{"red", "green", "blue", "alpha"}, {false, false, false, false}, {}};
            columns.values.assign(4 * first, NAN);
        }
        if (columns.names.empty()) return;
        const std::size_t width = has_colors ? numbers_.width(attributes, "COLOR_0") : 0;
        if (has_colors && width != 3 && width != 4) throw attributes.error("COLOR_0", "must be of type VEC3 or VEC4");
        const auto numbers = has_colors ? rows_of(attributes, "COLOR_0", width, count) : std::vector<double>{};
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                columns.values.push_back(k < width ? numbers[width * i + k] : has_colors ? 1 : NAN);
    }

    /// Texture coordinates are counted from above in glTF. False where there are none.
    bool add_texture(const StoredObject& attributes, std::size_t count)
    {
        if (file_.parts == MeshParts::faces || !attributes.has("TEXCOORD_0")) return false;
        const std::vector<double> numbers = rows_of(attributes, "TEXCOORD_0", 2, count);
        for (std::size_t i = 0; i < numbers.size(); i += 2) {
            soup_.texture_points.push_back({numbers[i], 1 - numbers[i + 1]});
            if (!std::isfinite(numbers[i]) || !std::isfinite(numbers[i + 1]))
                throw attributes.error("TEXCOORD_0",
                                       fmt::format("row {} has a coordinate that is not a finite number", i / 2 + 1));
        }
        return true;
    }

    /// The vertices of the corners of a part, all of which are there.
    std::vector<std::size_t> corners_of(const StoredObject& part, std::size_t count)
    {
        std::vector<std::size_t> corners;
        if (!part.has("indices")) {
            for (std::size_t i = 0; i < count; ++i) corners.push_back(i);
        } else {
            for (const double index : numbers_.read(part, "indices", "SCALAR", 1)) {
                if (!(index >= 0) || index >= static_cast<double>(count))
                    throw part.error("indices", fmt::format("corner {} has vertex {}, which is not there: they are 0 "
                                                            "to {}",
                                                            corners.size(), index, count - 1));
                corners.push_back(static_cast<std::size_t>(index));
            }
        }
        if (soup_.corners.size() + 3 * corners.size() > most_in_mesh)
            fail(fmt::format("has more than {} corners", most_in_mesh));
        return corners;
    }

    [[noreturn]] void fail(const std::string& problem) const { throw InputError::at({file_.name}, problem); }

    const MeshBytes& file_;
    GltfFile content_;
    GltfNumbers numbers_;
    std::vector<StoredObject> nodes_, meshes_;
    std::vector<bool> is_used_;
    PolygonSoup soup_;
};

}

PolygonSoup read_gltf(const MeshBytes& file) { return GltfReader(file).read(); }

}
