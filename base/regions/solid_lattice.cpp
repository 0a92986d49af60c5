#include "base/regions/solid_lattice.hpp"

#include "base/densities/plane_formula.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Triangles' corners keep away from nodes by this part of an edge, so that no triangle comes to nothing.
constexpr double least_part_of_edge = 1e-3;

using NodePlace = std::array<std::uint32_t, 3>;

template <typename Visit>
void for_each_node(const SolidLattice& solid, const Visit& visit)
{
    for (std::uint32_t z = 0; z <= solid.cells[2]; ++z)
        for (std::uint32_t y = 0; y <= solid.cells[1]; ++y)
            for (std::uint32_t x = 0; x <= solid.cells[0]; ++x) visit(NodePlace{x, y, z}, solid.node(x, y, z));
}

/// Nodes that have a tetrahedron in common differ by 0 or 1 along each axis, in the same direction.
template <typename Test>
bool has_neighbour(const SolidLattice& solid, const NodePlace& at, const Test& test)
{
    for (std::uint32_t step = 1; step < 8; ++step) {
        bool has_up = true, has_down = true;
        NodePlace up = at, down = at;
        for (std::size_t k = 0; k < 3; ++k) {
            if ((step >> k & 1) == 0) continue;
            has_up &= at[k] < solid.cells[k];
            has_down &= at[k] > 0;
            ++up[k];
            --down[k];
        }
        if (has_up && test(solid.node(up[0], up[1], up[2]))) return true;
        if (has_down && test(solid.node(down[0], down[1], down[2]))) return true;
    }
    return false;
}

/// The values in whole numbers of one sign each: those beside the surface, the largest of which is most_solid_value,
/// and no larger ones.
void take_values(SolidLattice& solid, const std::vector<double>& exact)
{
    double largest = 0;
    for_each_node(solid, [&](const NodePlace& at, std::size_t node) {
        const bool is_inside = exact[node] > 0;
        if (std::isinf(exact[node])) return;
        if (has_neighbour(solid, at, [&](std::size_t other) { return (exact[other] > 0) != is_inside; }))
            largest = std::max(largest, std::abs(exact[node]));
    });
    // One over the least numbers is infinite; parts of them are not.
    if (largest == 0) largest = most_solid_value;
    for (const double value : exact) {
        const double scaled = std::clamp(std::round(value / largest * most_solid_value), -double{most_solid_value},
                                         double{most_solid_value});
        const auto whole = static_cast<std::int32_t>(scaled);
        solid.values.push_back(value > 0 ? std::max(whole, 1) : whole);
    }
}

std::array<double, 3> crossing_of(const SolidLattice& solid, const NodePlace& inside, const NodePlace& outside)
{
    const double in = solid.values[solid.node(inside[0], inside[1], inside[2])];
    const double out = solid.values[solid.node(outside[0], outside[1], outside[2])];
    const double part = std::clamp(in / (in - out), least_part_of_edge, 1 - least_part_of_edge);
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = inside[k] + part * (double{1} * outside[k] - inside[k]);
    return place;
}

/// One triangle around a corner that differs from the others, two between pairs.
void visit_surface_in(const SolidLattice& solid, const std::array<NodePlace, 4>& corners,
                      const std::function<void(const SurfaceTriangle&)>& visit)
{
    std::vector<NodePlace> in, out;
    for (const NodePlace& c : corners) (solid.values[solid.node(c[0], c[1], c[2])] > 0 ? in : out).push_back(c);
    const auto cut = [&](std::size_t i, std::size_t o) { return crossing_of(solid, in[i], out[o]); };
    if (in.size() == 1) visit({cut(0, 0), cut(0, 1), cut(0, 2)});
    if (in.size() == 3) visit({cut(0, 0), cut(1, 0), cut(2, 0)});
    if (in.size() == 2) {
        visit({cut(0, 0), cut(0, 1), cut(1, 0)});
        visit({cut(0, 1), cut(1, 0), cut(1, 1)});
    }
}

/// The part of a tetrahedron in which what is linear between its corners' values is positive.
double part_of_tetrahedron(std::array<double, 4> v)
{
    std::ranges::sort(v, std::greater());
    const auto positive = std::ranges::count_if(v, [](double value) { return value > 0; });
    const auto alone = [](double a, double b, double c, double d) { return a * a * a / ((a - b) * (a - c) * (a - d)); };
    const auto [a, b, c, d] = v;
    if (positive == 0) return 0;
    if (positive == 1) return alone(a, b, c, d);
    if (positive == 3) return 1 - alone(-d, -a, -b, -c);
    if (positive == 4) return 1;
    return (a * a * b * b - a * b * (a + b) * (c + d) + c * d * (a * a + a * b + b * b)) /
           ((a - c) * (a - d) * (b - c) * (b - d));
}

}

SolidLattice solid_of_values(const std::array<std::uint32_t, 3>& cells, const std::vector<double>& exact)
{
    SolidLattice solid{cells};
    take_values(solid, exact);
    return solid;
}

SolidLattice solid_of_formula(const std::string& formula, const std::array<double, 3>& low, double step,
                              const std::array<std::uint32_t, 3>& cells)
{
    SpaceFormula space(formula);
    std::vector<double> exact;
    exact.reserve(SolidLattice{cells}.nodes());
    for_each_node(SolidLattice{cells}, [&](const NodePlace& at, std::size_t) {
        const double value = space.at(low[0] + step * at[0], low[1] + step * at[1], low[2] + step * at[2]);
        exact.push_back(std::isnan(value) ? -1 : value);
    });
    if (std::ranges::none_of(exact, [](double value) { return value > 0; }))
        throw InputError(fmt::format("{}: is nowhere above 0 in its box", space.name()));
    return solid_of_values(cells, exact);
}

void for_each_surface_triangle(const SolidLattice& solid, const std::function<void(const SurfaceTriangle&)>& visit)
{
    for (std::uint32_t z = 0; z < solid.cells[2]; ++z)
        for (std::uint32_t y = 0; y < solid.cells[1]; ++y)
            for (std::uint32_t x = 0; x < solid.cells[0]; ++x)
                for (const auto& order : axis_orders) {
                    std::array<NodePlace, 4> corners;
                    corners[0] = {x, y, z};
                    for (std::size_t i = 0; i < 3; ++i) {
                        corners[i + 1] = corners[i];
                        ++corners[i + 1][order[i]];
                    }
                    visit_surface_in(solid, corners, visit);
                }
}

double spare_distance(double distance)
{
    // Corners of triangles are off by least_part_of_edge of an edge, sqrt(3) cells at most.
    constexpr double moved = 2 * least_part_of_edge;
    constexpr double always = 0.867, turn = 0.433;
    const double curved = distance < turn ? always : std::max(0.375 / distance, turn + always - distance);
    return std::min(curved, always) + moved;
}

double part_inside(const std::array<std::int64_t, 8>& corners)
{
    const auto [least, most] = std::ranges::minmax(corners);
    if (most <= 0 || least > 0) return most > 0 ? 1 : 0;
    double part = 0;
    for (const auto& order : axis_orders) {
        std::array<double, 4> values{};
        std::size_t at = 0;
        values[0] = static_cast<double>(corners[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            at |= std::size_t{1} << order[i];
            values[i + 1] = static_cast<double>(corners[at]);
        }
        part += part_of_tetrahedron(values) / 6;
    }
    return part;
}

}
