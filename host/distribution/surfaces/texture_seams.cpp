#include "host/distribution/surfaces/texture_seams.hpp"

#include "host/distribution/surfaces/surface_neighbours.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace poissonlab {
namespace {

/// A corner by its place in space and in the plane.
using ChartCorner = std::tuple<std::array<std::int32_t, 3>, TexturePoint>;

/// An edge by the numbers of its corners, with a triangle of the plane.
using ChartEdge = std::array<std::uint32_t, 3>;

std::vector<ChartEdge> chart_edges(const TriangleMesh& mesh, const FixedSurface& surface, const TexturePlane& plane)
{
    std::map<ChartCorner, std::uint32_t> numbers;
    std::vector<ChartEdge> edges;
    edges.reserve(3 * plane.triangles.size());
    for (std::uint32_t t = 0; t < plane.triangles.size(); ++t) {
        const std::uint32_t of = plane.triangles[t].triangle;
        const std::int32_t* const corners = surface.triangles[of].corners;
        const auto texture = *texture_of(mesh, surface.faces[of]);
        std::array<std::uint32_t, 3> named{};
        for (std::size_t k = 0; k < 3; ++k)
            named[k] = numbers
                           .try_emplace({{corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]}, texture[k]},
                                        static_cast<std::uint32_t>(numbers.size()))
                           .first->second;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(named[k], named[(k + 1) % 3]);
            edges.push_back({low, high, t});
        }
    }
    return edges;
}

/// Sets that are joined, each known by the least of its members.
class JoinedSets
{
public:
    explicit JoinedSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t first_of(std::uint32_t member)
    {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }

    void join(std::uint32_t a, std::uint32_t b)
    {
        const std::uint32_t first_a = first_of(a), first_b = first_of(b);
        parent_[std::max(first_a, first_b)] = std::min(first_a, first_b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

constexpr std::uint64_t no_distance_to_seam = std::numeric_limits<std::uint64_t>::max();

struct NearestBySeam
{
    std::uint64_t within = no_distance_to_seam, beyond = no_distance_to_seam; ///< squared, in units of the grid
};

/// The chart of a triangle of the surface, and its least singular value.
struct ChartPlace
{
    std::uint32_t chart = 0;
    double least_stretch = 0;
};

class SeamSearch
{
public:
    SeamSearch(const FixedSurface& surface, const TexturePlane& plane, const std::vector<Stretch>& stretch,
               const Charts& charts)
        : surface_(surface), covered_area_(surface.area - plane.bare_area), places_(surface.triangles.size())
    {
        for (std::size_t t = 0; t < plane.triangles.size(); ++t)
            places_[plane.triangles[t].triangle] = {charts.chart[t], stretch[t].least};
    }

    std::vector<NearestBySeam> nearest(const std::vector<SurfacePoint>& points,
                                       const std::vector<TexturePoint>& texture, std::int32_t least_cosine) const
    {
        const double spacing = std::sqrt(covered_area_ / static_cast<double>(points.size()));
        const auto reach = static_cast<std::uint64_t>(2 * surface_.units_of(spacing)) + 1;
        const SurfaceNeighbours near(surface_, points, reach);
        std::vector<NearestBySeam> all(points.size());
        tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
            near.for_each_around(place_of(points[i]), [&](std::size_t j) {
                if (j == i || !sees(points[i], points[j], least_cosine)) return;
                const std::uint64_t squared = squared_distance(place_of(points[i]), place_of(points[j]));
                if (squared > reach * reach) return;
                const bool is_beyond = is_seam_between(points[i], points[j], texture[i], texture[j], squared);
                std::uint64_t& least = is_beyond ? all[i].beyond : all[i].within;
                least = std::min(least, squared);
            });
        });
        return all;
    }

private:
    bool sees(const SurfacePoint& a, const SurfacePoint& b, std::int32_t least_cosine) const
    {
        return cosine_between(surface_.triangles[a.triangle], surface_.triangles[b.triangle]) >= least_cosine;
    }

    bool is_seam_between(const SurfacePoint& a, const SurfacePoint& b, const TexturePoint& texture_a,
                         const TexturePoint& texture_b, std::uint64_t squared) const
    {
        const ChartPlace &of_a = places_[a.triangle], &of_b = places_[b.triangle];
        if (of_a.chart != of_b.chart) return true;
        const double distance = std::sqrt(static_cast<double>(squared)) * surface_.unit;
        const double apart = std::hypot(texture_a[0] - texture_b[0], texture_a[1] - texture_b[1]);
        return apart * std::min(of_a.least_stretch, of_b.least_stretch) > 2 * distance;
    }

    const FixedSurface& surface_;
    double covered_area_;            ///< of what has texture coordinates
    std::vector<ChartPlace> places_; ///< of all triangles of the surface
};

}

Charts charts_of(const TriangleMesh& mesh, const FixedSurface& surface, const TexturePlane& plane)
{
    std::vector<ChartEdge> edges = chart_edges(mesh, surface, plane);
    std::ranges::sort(edges);
    JoinedSets sets(plane.triangles.size());
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i][0] == edges[i - 1][0] && edges[i][1] == edges[i - 1][1]) sets.join(edges[i][2], edges[i - 1][2]);
    Charts charts;
    for (std::uint32_t t = 0; t < plane.triangles.size(); ++t) {
        const std::uint32_t first = sets.first_of(t);
        charts.chart.push_back(first == t ? static_cast<std::uint32_t>(charts.count++) : charts.chart[first]);
    }
    return charts;
}

SeamDistances seam_distances(const FixedSurface& surface, const TexturePlane& plane,
                             const std::vector<Stretch>& stretch, const Charts& charts,
                             const std::vector<SurfacePoint>& points, const std::vector<TexturePoint>& texture,
                             std::int32_t least_cosine)
{
    const auto nearest = SeamSearch(surface, plane, stretch, charts).nearest(points, texture, least_cosine);
    const std::uint64_t least = std::ranges::min(nearest, {}, &NearestBySeam::within).within;
    if (least == no_distance_to_seam) return {};
    SeamDistances found{.least = std::sqrt(static_cast<double>(least)) * surface.unit};
    for (const NearestBySeam& of : nearest) found.broken += of.beyond < least ? 1 : 0;
    return found;
}

}
