// Points on a surface by cells of space, and the nearest ones of each: what sets are measured by.
//
// Cells are sorted here, where dart throwing hashes them, so that a mistake of one is seen by the other.
#pragma once

#include "host/sampling/surfaces/fixed_surface.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

class SurfaceNeighbours
{
public:
    /// Cells have sides of `reach` units of the grid. The arguments must outlive it.
    SurfaceNeighbours(const FixedSurface& surface, const std::vector<SurfacePoint>& points, std::uint64_t reach);

    /// The least squared distance from point `own` to another one whose normal is near enough, in squares of units.
    /// UINT64_MAX where there is none within reach.
    std::uint64_t squared_nearest(std::size_t own, std::int32_t least_cosine) const;

    /// Is a point nearer to a place of a triangle than the root of `squared`, which is no more than the reach?
    bool is_near(const SurfacePoint& place, std::uint64_t squared, std::int32_t least_cosine) const;

    /// Calls visit(number of a point) for all points in the 27 cells around a place: all that are in reach, and others.
    template <typename Visit>
    void for_each_around(const MeshPlace& place, const Visit& visit) const;

    /// The numbers of the points by their cells: neighbours come one after the other.
    const std::vector<std::uint32_t>& order() const { return order_; }

private:
    std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z) const;

    const FixedSurface& surface_;
    const std::vector<SurfacePoint>& points_;
    std::int64_t reach_;
    std::vector<std::uint64_t> keys_;  ///< of cells, ascending: of each point
    std::vector<std::uint32_t> order_; ///< numbers of points
};

template <typename Visit>
void SurfaceNeighbours::for_each_around(const MeshPlace& place, const Visit& visit) const
{
    const std::int64_t x = place[0] / reach_;
    for (std::int64_t z = place[2] / reach_ - 1; z <= place[2] / reach_ + 1; ++z)
        for (std::int64_t y = place[1] / reach_ - 1; y <= place[1] / reach_ + 1; ++y) {
            const std::uint64_t last = key_of(x + 1, y, z);
            auto i = static_cast<std::size_t>(std::ranges::lower_bound(keys_, key_of(x - 1, y, z)) - keys_.begin());
            for (; i < keys_.size() && keys_[i] <= last; ++i) visit(order_[i]);
        }
}

/// Returns which points stay where they come in this order, and each stays unless it is nearer than a distance to one
/// before it that stays and that it sees. In the mesh's units.
std::vector<bool> kept_in_order(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                const std::vector<std::uint32_t>& order, double distance, std::int32_t least_cosine);

/// Are all points that see each other at least so far from each other, in the mesh's units, but for what doubles round?
/// Pairs of points before number `first` are not looked at.
bool keep_distance(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double distance,
                   std::int32_t least_cosine, std::size_t first = 0);

/// In the mesh's units. There are two points or more; infinite where normals are too far apart for any two. Of more
/// than 10,000 points, those that see none within some sixteen mean distances count as seeing none. `area`: of the part
/// of the surface that has points.
struct SurfaceDistances
{
    double least = 0; ///< of points that see each other
    double least_of_any = 0;
    double mean_nearest = 0; ///< of points that see another one
};
SurfaceDistances surface_distances(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                   std::int32_t least_cosine, double area);

}
