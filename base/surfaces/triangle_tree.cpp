#include "base/surfaces/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::uint32_t most_in_leaf = 4;

double squared_to_box(const MeshPoint& place, const MeshPoint& low, const MeshPoint& high)
{
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double off = std::max({low[k] - place[k], place[k] - high[k], 0.0});
        squared += off * off;
    }
    return squared;
}

/// Returns the shares of a segment's two ends in its point that is nearest to `place`.
std::array<double, 2> shares_of_segment(const MeshPoint& place, const MeshPoint& a, const MeshPoint& b)
{
    const MeshPoint edge = difference(b, a);
    const double along = std::clamp(dot(difference(place, a), edge) / dot(edge, edge), 0.0, 1.0);
    return {1 - along, along};
}

double squared_off(const TriangleMesh& mesh, const MeshPosition& position, const MeshPoint& place)
{
    const MeshPoint off = difference(place_of(mesh, position), place);
    return dot(off, off);
}

/// Returns the nearest position on one triangle: the foot of the perpendicular if it lies in the triangle, else a point
/// of the nearest edge.
MeshPosition nearest_on(const TriangleMesh& mesh, std::uint32_t triangle, const MeshPoint& place)
{
    const auto& t = mesh.triangles[triangle];
    const auto& [a, b, c] = std::array{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    const MeshPoint u = difference(b, a), v = difference(c, a), w = difference(place, a);
    const MeshPoint normal = cross(u, v);
    const double squared = dot(normal, normal);
    const double second = dot(cross(w, v), normal) / squared, third = dot(cross(u, w), normal) / squared;
    if (second >= 0 && third >= 0 && second + third <= 1) return {triangle, {1 - second - third, second, third}};
    MeshPosition best;
    double least = INFINITY;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const auto shares = shares_of_segment(place, mesh.vertices[t[k]], mesh.vertices[t[next]]);
        MeshPosition on{triangle, {}};
        on.shares[k] = shares[0];
        on.shares[next] = shares[1];
        if (const double off = squared_off(mesh, on, place); off < least) least = off, best = on;
    }
    return best;
}

}

MeshPoint place_of(const TriangleMesh& mesh, const MeshPosition& position)
{
    MeshPoint place{};
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t k = 0; k < 3; ++k)
            place[k] += position.shares[corner] * mesh.vertices[mesh.triangles[position.triangle][corner]][k];
    return place;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size())
{
    std::iota(order_.begin(), order_.end(), 0u);
    add_node(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t TriangleTree::add_node(std::uint32_t begin, std::uint32_t end)
{
    Node node{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, begin, end, 0};
    for (std::uint32_t i = begin; i < end; ++i)
        for (const std::uint32_t corner : mesh_.triangles[order_[i]])
            for (std::size_t k = 0; k < 3; ++k) {
                node.low[k] = std::min(node.low[k], mesh_.vertices[corner][k]);
                node.high[k] = std::max(node.high[k], mesh_.vertices[corner][k]);
            }
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
    if (end - begin <= most_in_leaf) return number;
    const MeshPoint sides = difference(node.high, node.low);
    const auto axis = static_cast<std::size_t>(std::ranges::max_element(sides) - sides.begin());
    const auto sum_along = [&](std::uint32_t triangle) {
        double sum = 0;
        for (const std::uint32_t corner : mesh_.triangles[triangle]) sum += mesh_.vertices[corner][axis];
        return sum;
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double at_a = sum_along(a), at_b = sum_along(b);
                         return at_a != at_b ? at_a < at_b : a < b;
                     });
    add_node(begin, middle);
    const std::uint32_t right = add_node(middle, end);
    nodes_[number].right = right;
    return number;
}

MeshPosition TriangleTree::nearest(const MeshPoint& place,
                                   const std::function<bool(std::uint32_t triangle)>& counts) const
{
    MeshPosition best;
    double least = INFINITY;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const std::uint32_t number = open.back();
        const Node& node = nodes_[number];
        open.pop_back();
        if (squared_to_box(place, node.low, node.high) >= least) continue;
        if (node.right == 0) {
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                if (!counts(order_[i])) continue;
                const MeshPosition on = nearest_on(mesh_, order_[i], place);
                if (const double off = squared_off(mesh_, on, place); off < least) least = off, best = on;
            }
            continue;
        }
        const Node &left = nodes_[number + 1], &right = nodes_[node.right];
        const bool is_left_nearer =
            squared_to_box(place, left.low, left.high) <= squared_to_box(place, right.low, right.high);
        open.push_back(is_left_nearer ? node.right : number + 1);
        open.push_back(is_left_nearer ? number + 1 : node.right);
    }
    return best;
}

}
