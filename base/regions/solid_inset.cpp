// Distances from a solid's surface by CGAL's tree of bounding boxes, at nodes that may be near the one asked for.
#include "base/errors/errors.hpp"
#include "base/regions/solid_lattice.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// Distances matter where a node is nearer than this to the one asked for, in cells: beyond, others of its tetrahedra
/// have the same sign.
constexpr double near_by = 2;

/// The time grows with the triangles: a ball that fills the lattice has about half a million.
constexpr std::size_t most_triangles = 4'000'000;

/// Units of values in a cell.
constexpr double units_a_cell = 0x1p26;

/// For each node, the number of steps to the nearest one outside, along axes and diagonals: no more than its distance
/// from that one, and no less than a part of 1 / sqrt(3) of it. Up to `most`, for farther ones most + 1.
std::vector<std::uint32_t> steps_to_outside(const SolidLattice& solid, std::uint32_t most)
{
    std::vector<std::uint32_t> steps(solid.nodes(), most + 1);
    std::vector<std::array<std::uint32_t, 3>> front, next;
    for (std::uint32_t z = 0; z <= solid.cells[2]; ++z)
        for (std::uint32_t y = 0; y <= solid.cells[1]; ++y)
            for (std::uint32_t x = 0; x <= solid.cells[0]; ++x)
                if (solid.values[solid.node(x, y, z)] <= 0) {
                    steps[solid.node(x, y, z)] = 0;
                    front.push_back({x, y, z});
                }
    for (std::uint32_t step = 1; step <= most && !front.empty(); ++step) {
        next.clear();
        for (const auto& [x, y, z] : front)
            for (std::uint32_t c = z - (z > 0); c <= std::min(z + 1, solid.cells[2]); ++c)
                for (std::uint32_t b = y - (y > 0); b <= std::min(y + 1, solid.cells[1]); ++b)
                    for (std::uint32_t a = x - (x > 0); a <= std::min(x + 1, solid.cells[0]); ++a) {
                        std::uint32_t& at = steps[solid.node(a, b, c)];
                        if (at <= step) continue;
                        at = step;
                        next.push_back({a, b, c});
                    }
        std::swap(front, next);
    }
    return steps;
}

Triangles surface_of(const SolidLattice& solid, const std::string& name)
{
    Triangles triangles;
    for_each_surface_triangle(solid, [&](const SurfaceTriangle& t) {
        if (triangles.size() == most_triangles)
            throw InputError(fmt::format("{}: the solid's surface has more than {} triangles on its lattice, too many "
                                         "to keep whole balls inside: type a smaller box, in which it turns less often",
                                         name, most_triangles));
        const auto point = [&](std::size_t i) { return Kernel::Point_3(t[i][0], t[i][1], t[i][2]); };
        triangles.emplace_back(point(0), point(1), point(2));
    });
    return triangles;
}

/// A distance less the one asked for.
std::int32_t value_of(double excess)
{
    return static_cast<std::int32_t>(std::floor(std::clamp(excess, -near_by, near_by) * units_a_cell));
}

}

SolidLattice inset_solid(const SolidLattice& solid, double distance, const std::string& name)
{
    const Triangles triangles = surface_of(solid, name);
    const double wanted = distance + spare_distance(distance);
    SolidLattice inset{solid.cells, std::vector<std::int32_t>(solid.nodes(), value_of(-near_by))};
    // A surface is sqrt(3) cells nearer than the node behind it, at most.
    const auto most = static_cast<std::uint32_t>(wanted + near_by + 2);
    const std::vector<std::uint32_t> steps = steps_to_outside(solid, most);
    if (triangles.empty()) {
        for (std::size_t node = 0; node < steps.size(); ++node)
            if (solid.values[node] > 0) inset.values[node] = value_of(near_by);
        return inset;
    }
    Tree tree(triangles.begin(), triangles.end());
    tree.accelerate_distance_queries();
    tbb::parallel_for(std::uint32_t{0}, solid.cells[2] + 1, [&](std::uint32_t z) {
        for (std::uint32_t y = 0; y <= solid.cells[1]; ++y)
            for (std::uint32_t x = 0; x <= solid.cells[0]; ++x) {
                const std::size_t node = solid.node(x, y, z);
                if (steps[node] * std::sqrt(3.0) < wanted - near_by) continue;
                const double found =
                    steps[node] > most ? HUGE_VAL : std::sqrt(tree.squared_distance(Kernel::Point_3(x, y, z)));
                if (steps[node] > 0) inset.values[node] = value_of(found - wanted);
            }
    });
    return inset;
}

}
