#include "tiles/quads/quad_mesh.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace poissonlab {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

std::uint64_t way_of(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

std::string named_edge(std::uint32_t a, std::uint32_t b)
{
    return fmt::format("the edge between vertices {} and {}", a + 1, b + 1);
}

MeshPoint mixed_places(const MeshPoint& a, double share_a, const MeshPoint& b, double share_b)
{
    MeshPoint sum{};
    for (std::size_t k = 0; k < 3; ++k) sum[k] = a[k] * share_a + b[k] * share_b;
    return sum;
}

}

QuadTopology::QuadTopology(const QuadMesh& mesh)
    : across_(4 * mesh.quads.size()), edges_(across_.size(), none), wedges_(across_.size()),
      around_(mesh.vertices.size())
{
    if (mesh.quads.empty()) throw InputError("there are no quads");
    join_sides(mesh);
    order_corners(mesh);
}

void QuadTopology::join_sides(const QuadMesh& mesh)
{
    std::unordered_map<std::uint64_t, std::uint32_t> sides;
    sides.reserve(across_.size());
    for (std::uint32_t side = 0; side < across_.size(); ++side) {
        const Quad& quad = mesh.quads[side / 4];
        const std::uint32_t from = quad[side % 4], to = quad[(side + 1) % 4];
        if (from == to || from == quad[(side + 2) % 4])
            throw InputError(fmt::format("quad {} has vertex {} twice", side / 4 + 1, from + 1));
        if (!sides.emplace(way_of(from, to), side).second)
            throw InputError(fmt::format("{} has two quads on one side: it is no manifold, or quads are turned "
                                         "differently",
                                         named_edge(from, to)));
    }
    for (std::uint32_t side = 0; side < across_.size(); ++side) {
        const Quad& quad = mesh.quads[side / 4];
        const std::uint32_t from = quad[side % 4], to = quad[(side + 1) % 4];
        const auto other = sides.find(way_of(to, from));
        if (other == sides.end())
            throw InputError(
                fmt::format("{} has a quad on one side only: the surface must be closed", named_edge(from, to)));
        across_[side] = {other->second / 4, other->second % 4};
        edges_[side] = side < other->second ? static_cast<std::uint32_t>(edge_count_++) : edges_[other->second];
    }
}

void QuadTopology::order_corners(const QuadMesh& mesh)
{
    std::vector<std::uint32_t> count(mesh.vertices.size(), 0);
    for (const Quad& quad : mesh.quads)
        for (const std::uint32_t vertex : quad) ++count[vertex];
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q)
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t vertex = mesh.quads[q][k];
            auto& corners = around_[vertex];
            if (!corners.empty()) continue;
            QuadCorner at{q, k};
            do {
                wedges_[number_of(at)] = static_cast<std::uint32_t>(corners.size());
                corners.push_back(at);
                // The next quad lies beyond the side that ends in the vertex, and its own side there begins in it.
                at = across({at.quad, (at.corner + 3) % 4});
            } while (at != QuadCorner{q, k});
            if (corners.size() != count[vertex])
                throw InputError(
                    fmt::format("parts of the surface touch at vertex {} alone: it is no manifold", vertex + 1));
            ++vertex_count_;
        }
}

std::size_t QuadTopology::irregular() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(around_, [](const auto& corners) { return !corners.empty() && corners.size() != 4; }));
}

std::int64_t QuadTopology::euler() const
{
    return static_cast<std::int64_t>(vertex_count_ + across_.size() / 4) - static_cast<std::int64_t>(edge_count_);
}

QuadMesh refined(const QuadMesh& mesh, const QuadTopology& topology, std::uint32_t parts)
{
    QuadMesh fine{mesh.vertices, {}};
    const auto first_on_edges = static_cast<std::uint32_t>(fine.vertices.size());
    fine.vertices.resize(fine.vertices.size() + topology.edges() * (parts - 1));
    // This returns vertex number `step` of a side, counted from its start.
    const auto on_side = [&](std::uint32_t q, std::uint32_t side, std::uint32_t step) {
        if (step == 0 || step == parts) return mesh.quads[q][(side + step / parts) % 4];
        const std::uint32_t along = topology.is_forward({q, side}) ? step : parts - step;
        return first_on_edges + topology.edge_of({q, side}) * (parts - 1) + along - 1;
    };
    const auto part = [&](std::uint32_t step) { return static_cast<double>(step) / parts; };
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q) {
        const Quad& quad = mesh.quads[q];
        const auto first_inside = static_cast<std::uint32_t>(fine.vertices.size());
        const auto number = [&](std::uint32_t i, std::uint32_t j) {
            if (j == 0) return on_side(q, 0, i);
            if (i == parts) return on_side(q, 1, j);
            if (j == parts) return on_side(q, 2, parts - i);
            if (i == 0) return on_side(q, 3, parts - j);
            return first_inside + (j - 1) * (parts - 1) + i - 1;
        };
        for (std::uint32_t side = 0; side < 4; ++side)
            for (std::uint32_t step = 1; step < parts && topology.is_forward({q, side}); ++step)
                fine.vertices[on_side(q, side, step)] = mixed_places(mesh.vertices[quad[side]], 1 - part(step),
                                                                     mesh.vertices[quad[(side + 1) % 4]], part(step));
        for (std::uint32_t j = 1; j < parts; ++j)
            for (std::uint32_t i = 1; i < parts; ++i) {
                const auto row = [&](std::uint32_t left, std::uint32_t right) {
                    return mixed_places(mesh.vertices[left], 1 - part(i), mesh.vertices[right], part(i));
                };
                fine.vertices.push_back(
                    mixed_places(row(quad[0], quad[1]), 1 - part(j), row(quad[3], quad[2]), part(j)));
            }
        for (std::uint32_t j = 0; j < parts; ++j)
            for (std::uint32_t i = 0; i < parts; ++i)
                fine.quads.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    }
    return fine;
}

QuadMesh smoothed(const QuadMesh& mesh, const QuadTopology& topology)
{
    QuadMesh fine = refined(mesh, topology, 2);
    // Vertices of the mesh come first, then middles of edges, then those of quads.
    const auto edge_vertex = [&](QuadCorner side) {
        return static_cast<std::uint32_t>(mesh.vertices.size()) + topology.edge_of(side);
    };
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q)
        for (std::uint32_t side = 0; side < 4; ++side) {
            if (!topology.is_forward({q, side})) continue;
            const MeshPoint middles =
                mixed_places(middle_of(mesh, q), 0.25, middle_of(mesh, topology.across({q, side}).quad), 0.25);
            MeshPoint& place = fine.vertices[edge_vertex({q, side})];
            place = mixed_places(place, 0.5, middles, 1); // it was the middle of the edge
        }
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const double n = topology.valence(v);
        if (n == 0) continue;
        MeshPoint place = mixed_places(mesh.vertices[v], (n - 3) / n, {}, 0);
        for (const QuadCorner& at : topology.around(v)) {
            const MeshPoint other = mesh.vertices[mesh.quads[at.quad][(at.corner + 1) % 4]];
            const MeshPoint edge = mixed_places(mesh.vertices[v], 0.5, other, 0.5);
            const MeshPoint both = mixed_places(middle_of(mesh, at.quad), 1 / n, edge, 2 / n);
            place = mixed_places(place, 1, both, 1 / n);
        }
        fine.vertices[v] = place;
    }
    return fine;
}

MeshPoint middle_of(const QuadMesh& mesh, std::uint32_t quad)
{
    const auto at = [&](std::size_t k) { return mesh.vertices[mesh.quads[quad][k]]; };
    return mixed_places(mixed_places(at(0), 0.5, at(2), 0.5), 0.5, mixed_places(at(1), 0.5, at(3), 0.5), 0.5);
}

FanPlace fan_place(double u, double v)
{
    // The nearest side has the place; places on a diagonal belong to the lower number.
    const std::array<double, 4> depth{v, 1 - u, 1 - v, u}, along{u, v, 1 - u, 1 - v};
    const auto side = static_cast<std::uint32_t>(std::ranges::min_element(depth) - depth.begin());
    const double middle = 2 * depth[side];
    return {side, along[side] - middle / 2, middle};
}

MeshPoint place_on(const QuadMesh& mesh, std::uint32_t quad, double u, double v)
{
    const FanPlace at = fan_place(u, v);
    const Quad& q = mesh.quads[quad];
    const MeshPoint on_side =
        mixed_places(mesh.vertices[q[at.side]], 1 - at.end - at.middle, mesh.vertices[q[(at.side + 1) % 4]], at.end);
    return mixed_places(on_side, 1, middle_of(mesh, quad), at.middle);
}

TriangleMesh fans_of(const QuadMesh& mesh)
{
    TriangleMesh fans;
    fans.vertices = mesh.vertices;
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q) {
        const auto middle = static_cast<std::uint32_t>(fans.vertices.size());
        fans.vertices.push_back(middle_of(mesh, q));
        for (std::size_t side = 0; side < 4; ++side)
            fans.triangles.push_back({mesh.quads[q][side], mesh.quads[q][(side + 1) % 4], middle});
    }
    return fans;
}

std::array<double, 2> turned_place(double u, double v, std::uint32_t quarters)
{
    switch (quarters % 4) {
    case 1:
        return {1 - v, u};
    case 2:
        return {1 - u, 1 - v};
    case 3:
        return {v, 1 - u};
    default:
        return {u, v};
    }
}

}
