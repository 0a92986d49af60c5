#include "base/surfaces/path_search.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

/// The starts of groups, for a list that is sorted by `group_of`.
std::vector<std::uint32_t> starts_of_groups(const std::vector<std::uint32_t>& counts)
{
    std::vector<std::uint32_t> starts(counts.size() + 1);
    std::partial_sum(counts.begin(), counts.end(), starts.begin() + 1);
    return starts;
}

}

SurfacePaths::SurfacePaths(const TriangleMesh& mesh, const std::vector<MeshPosition>& targets) : mesh_(mesh)
{
    for (std::uint32_t side = 0; side < 3 * mesh.triangles.size(); ++side) {
        const MeshTriangle& t = mesh.triangles[side / 3];
        const MeshPoint& start = mesh.vertices[t[side % 3]];
        const MeshPoint edge = difference(mesh.vertices[t[(side + 1) % 3]], start),
                        top = difference(mesh.vertices[t[(side + 2) % 3]], start), normal = cross(edge, top);
        const double squared = dot(edge, edge);
        tops_.push_back({dot(edge, top) / squared, std::sqrt(dot(normal, normal)) / squared});
    }
    link_sides();
    find_bends();
    aim_at(targets);
}

double SurfacePaths::along_first_side(const MeshPosition& target) const
{
    return target.shares[1] + target.shares[2] * tops_[3 * target.triangle][0];
}

void SurfacePaths::aim_at(const std::vector<MeshPosition>& targets)
{
    targets_ = targets;
    std::vector<std::uint32_t> counts(mesh_.triangles.size());
    for (const MeshPosition& target : targets) ++counts[target.triangle];
    target_starts_ = starts_of_groups(counts);
    target_order_.resize(targets.size());
    std::iota(target_order_.begin(), target_order_.end(), 0u);
    std::ranges::stable_sort(target_order_, {}, [&](std::uint32_t i) {
        return std::pair{targets[i].triangle, along_first_side(targets[i])};
    });
    target_along_.clear();
    for (const std::uint32_t i : target_order_) target_along_.push_back(along_first_side(targets[i]));
}

/// Finds the sides that lie on one edge, and those opposite to each vertex.
void SurfacePaths::link_sides()
{
    const auto count = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    const auto ends = [&](std::uint32_t side) { return std::minmax({start_of(side), start_of(next_of(side))}); };
    sides_.resize(count);
    std::iota(sides_.begin(), sides_.end(), 0u);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t side = 0; side < count; ++side) edges.emplace_back(ends(side));
    std::ranges::stable_sort(sides_, {}, [&](std::uint32_t side) { return edges[side]; });
    group_of_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == 0 || edges[sides_[i]] != edges[sides_[i - 1]]) group_starts_.push_back(i);
        group_of_[sides_[i]] = static_cast<std::uint32_t>(group_starts_.size() - 1);
    }
    group_starts_.push_back(count);
    std::vector<std::uint32_t> counts(mesh_.vertices.size());
    for (std::uint32_t side = 0; side < count; ++side) ++counts[start_of(side)];
    fan_starts_ = starts_of_groups(counts);
    fans_.resize(count);
    std::vector<std::uint32_t> next = fan_starts_;
    for (std::uint32_t side = 0; side < count; ++side) fans_[next[start_of(side)]++] = next_of(side);
}

void SurfacePaths::find_bends()
{
    std::vector<double> angles(mesh_.vertices.size());
    for (std::uint32_t side = 0; side < tops_.size(); ++side)
        angles[start_of(side)] += std::atan2(tops_[side][1], tops_[side][0]);
    std::vector<double> straight(mesh_.vertices.size(), 2 * std::numbers::pi); // the most that paths do not bend around
    for (std::size_t g = 0; g + 1 < group_starts_.size(); ++g) {
        const std::uint32_t triangles = group_starts_[g + 1] - group_starts_[g], side = sides_[group_starts_[g]];
        if (triangles == 2) continue;
        for (const std::uint32_t vertex : {start_of(side), start_of(next_of(side))})
            straight[vertex] = triangles == 1 ? std::min(straight[vertex], std::numbers::pi) : 0;
    }
    for (std::size_t i = 0; i < angles.size(); ++i)
        may_bend_.push_back(angles[i] > straight[i] + 100 * paths::rounding);
}

void SurfacePaths::from_each(const std::vector<MeshPosition>& sources, double reach,
                             const std::function<void(std::size_t, std::span<const SurfacePath>)>& visit) const
{
    tbb::enumerable_thread_specific<paths::PathSearch> searches([&] { return paths::PathSearch(*this); });
    tbb::parallel_for(std::size_t{0}, sources.size(),
                      [&](std::size_t i) { visit(i, searches.local().from(sources[i], reach)); });
}

}
