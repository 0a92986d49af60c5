#include "base/surfaces/mesh_solid.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/solid_lattice.hpp"
#include "base/surfaces/triangle_tree.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace poissonlab {
namespace {

/// The box of a solid is wider than its mesh by this part of the longest side, which is more than a cell.
constexpr double margin_of_box = 0.01;

TriangleMesh with_joined_vertices(const TriangleMesh& mesh)
{
    TriangleMesh joined;
    std::map<MeshPoint, std::uint32_t> numbers;
    for (const MeshTriangle& triangle : mesh.triangles) {
        MeshTriangle corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const MeshPoint& place = mesh.vertices[triangle[c]];
            const auto [found, is_new] = numbers.try_emplace(place, static_cast<std::uint32_t>(joined.vertices.size()));
            if (is_new) joined.vertices.push_back(place);
            corners[c] = found->second;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            joined.triangles.push_back(corners);
    }
    return joined;
}

/// Throws InputError unless each edge has two faces, which go along it in opposite directions.
void check_closed(const TriangleMesh& mesh, const std::string& name)
{
    // Faces that go along an edge to its vertex of the higher number, and to that of the lower.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<std::size_t, 2>> edges;
    for (const MeshTriangle& t : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = t[c], b = t[(c + 1) % 3];
            ++edges[std::minmax(a, b)][a < b ? 0 : 1];
        }
    const auto refuse = [&](const char* what, const auto& is_wrong) {
        const auto count = static_cast<std::size_t>(
            std::ranges::count_if(edges, [&](const auto& edge) { return is_wrong(edge.second[0], edge.second[1]); }));
        if (count > 0)
            throw InputError(fmt::format("{}: a region needs a closed surface, and {} {} {} {}", name, count,
                                         noun(count, "edge"), count == 1 ? "has" : "have", what));
    };
    refuse("a face on one side only", [](std::size_t a, std::size_t b) { return a + b == 1; });
    refuse("more than two faces", [](std::size_t a, std::size_t b) { return a + b > 2; });
    refuse("faces of opposite orientation", [](std::size_t a, std::size_t b) { return a != b; });
}

/// A place at which a line in the direction of z crosses the surface: upwards out of it, 1, or into it, -1.
struct Crossing
{
    double z = 0;
    int out = 0;
};

/// Returns how often a triangle's outline winds around a place of the plane of x and y. Both triangles at an edge
/// compute its crossing from the same two ends.
int winding_of(const std::array<MeshPoint, 3>& corners, double x, double y)
{
    int winding = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const MeshPoint &a = corners[c], &b = corners[(c + 1) % 3];
        if ((a[1] <= y) == (b[1] <= y)) continue;
        const bool is_upwards = a[1] <= y;
        const MeshPoint &low = is_upwards ? a : b, &high = is_upwards ? b : a;
        if (low[0] + (y - low[1]) / (high[1] - low[1]) * (high[0] - low[0]) > x) winding += is_upwards ? 1 : -1;
    }
    return winding;
}

double height_at(const std::array<MeshPoint, 3>& corners, double x, double y)
{
    const MeshPoint normal = cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
    const auto [low, high] = std::minmax({corners[0][2], corners[1][2], corners[2][2]});
    const double height =
        corners[0][2] - (normal[0] * (x - corners[0][0]) + normal[1] * (y - corners[0][1])) / normal[2];
    return height >= low && height <= high ? height : std::clamp(std::isnan(height) ? low : height, low, high);
}

/// Reads a closed mesh at the nodes of a lattice.
class MeshReading
{
public:
    MeshReading(const TriangleMesh& mesh, const std::string& name, const std::array<double, 3>& low, double step,
                const std::array<std::uint32_t, 3>& cells)
        : mesh_(mesh), name_(name), low_(low), step_(step), lattice_{cells}
    {}

    SolidLattice solid() const
    {
        const std::vector<signed char> inside = nodes_inside();
        const TriangleTree tree(mesh_);
        std::vector<double> values(lattice_.nodes());
        tbb::parallel_for(std::uint32_t{0}, lattice_.cells[2] + 1, [&](std::uint32_t z) {
            for (std::uint32_t y = 0; y <= lattice_.cells[1]; ++y)
                for (std::uint32_t x = 0; x <= lattice_.cells[0]; ++x) {
                    const std::size_t node = lattice_.node(x, y, z);
                    const double size = is_beside_surface(inside, x, y, z) ? distance(tree, {x, y, z}) : INFINITY;
                    values[node] = inside[node] != 0 ? std::max(size, least_distance) : -size;
                }
        });
        return solid_of_values(lattice_.cells, values);
    }

private:
    static constexpr double least_distance = 1e-300; ///< of nodes inside, whose values are above 0

    double at(std::size_t axis, std::uint32_t node) const { return low_[axis] + step_ * node; }

    double distance(const TriangleTree& tree, const std::array<std::uint32_t, 3>& node) const
    {
        const MeshPoint place{at(0, node[0]), at(1, node[1]), at(2, node[2])};
        const MeshPoint off = difference(place_of(mesh_, tree.nearest(place)), place);
        return std::hypot(off[0], off[1], off[2]);
    }

    /// The nodes along an axis from a coordinate to another one, the last one excluded.
    std::array<std::uint32_t, 2> nodes_between(std::size_t axis, double first, double last) const
    {
        const auto node = [&](double coordinate) {
            return static_cast<std::uint32_t>(
                std::clamp(std::floor((coordinate - low_[axis]) / step_), 0.0, double{1} * lattice_.cells[axis]));
        };
        return {node(first), std::min(node(last) + 2, lattice_.cells[axis] + 1)};
    }

    /// The crossings of the lines through all nodes, y after y.
    std::vector<std::vector<Crossing>> crossings() const
    {
        std::vector<std::vector<Crossing>> lines((lattice_.cells[0] + 1) * (lattice_.cells[1] + 1));
        for (const MeshTriangle& t : mesh_.triangles) {
            const std::array<MeshPoint, 3> corners{mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]};
            const auto [low_x, high_x] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
            const auto [low_y, high_y] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
            const auto columns = nodes_between(0, low_x, high_x), rows = nodes_between(1, low_y, high_y);
            for (std::uint32_t y = rows[0]; y < rows[1]; ++y)
                for (std::uint32_t x = columns[0]; x < columns[1]; ++x)
                    if (const int out = winding_of(corners, at(0, x), at(1, y)); out != 0)
                        lines[y * (lattice_.cells[0] + 1) + x].push_back({height_at(corners, at(0, x), at(1, y)), out});
        }
        return lines;
    }

    /// Throws InputError where windings are other than 0 and 1, or 0 and -1 of a surface that is turned inside out.
    std::vector<signed char> nodes_inside() const
    {
        const auto lines = crossings();
        std::vector<signed char> windings(lattice_.nodes());
        int least = 0, most = 0;
        for (std::uint32_t y = 0; y <= lattice_.cells[1]; ++y)
            for (std::uint32_t x = 0; x <= lattice_.cells[0]; ++x)
                for (std::uint32_t z = 0; z <= lattice_.cells[2]; ++z) {
                    int winding = 0;
                    for (const Crossing& crossing : lines[y * (lattice_.cells[0] + 1) + x])
                        if (crossing.z > at(2, z)) winding += crossing.out;
                    least = std::min(least, winding);
                    most = std::max(most, winding);
                    if (most - least > 1)
                        throw InputError(fmt::format("{}: the surface overlaps itself, or its parts are oriented "
                                                     "differently: see ({:.6g}, {:.6g}, {:.6g})",
                                                     name_, at(0, x), at(1, y), at(2, z)));
                    windings[lattice_.node(x, y, z)] = winding != 0 ? 1 : 0;
                }
        if (most == least)
            throw InputError(
                fmt::format("{}: the inside is thinner everywhere than a cell of the lattice by which it is "
                            "read, {:.4g}",
                            name_, step_));
        return windings;
    }

    bool is_beside_surface(const std::vector<signed char>& inside, std::uint32_t x, std::uint32_t y,
                           std::uint32_t z) const
    {
        const auto from = [](std::uint32_t at) { return at == 0 ? 0 : at - 1; };
        for (std::uint32_t k = from(z); k <= std::min(z + 1, lattice_.cells[2]); ++k)
            for (std::uint32_t j = from(y); j <= std::min(y + 1, lattice_.cells[1]); ++j)
                for (std::uint32_t i = from(x); i <= std::min(x + 1, lattice_.cells[0]); ++i)
                    if (inside[lattice_.node(i, j, k)] != inside[lattice_.node(x, y, z)]) return true;
        return false;
    }

    const TriangleMesh& mesh_;
    const std::string& name_;
    std::array<double, 3> low_;
    double step_;
    SolidLattice lattice_; ///< without values
};

}

SpaceRegion solid_of_mesh(const std::filesystem::path& file)
{
    const std::string name = file.string();
    const auto mesh = std::make_shared<const TriangleMesh>(with_joined_vertices(read_triangle_mesh(file)));
    check_closed(*mesh, name);
    SpaceRegion region{SpaceShape::solid, {}, name};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto of = [k](const MeshPoint& place) { return place[k]; };
        if (mesh->vertices.empty()) break;
        region.box.low[k] = of(std::ranges::min(mesh->vertices, {}, of));
        region.box.high[k] = of(std::ranges::max(mesh->vertices, {}, of));
    }
    const double longest = region.box.longest();
    // Products of four lengths of faces have to be doubles, those of small faces too.
    if (!(longest >= 1e-60 && longest <= 1e60))
        throw InputError(fmt::format(
            "{}: the mesh is {:.3g} long: must be from 1e-60 to 1e+60; choose another unit of length", name, longest));
    for (std::size_t k = 0; k < 3; ++k) {
        region.box.low[k] -= margin_of_box * longest;
        region.box.high[k] += margin_of_box * longest;
    }
    region.reading = [mesh, name](const std::array<double, 3>& low, double step,
                                  const std::array<std::uint32_t, 3>& cells) {
        return MeshReading(*mesh, name, low, step, cells).solid();
    };
    return region;
}

}
