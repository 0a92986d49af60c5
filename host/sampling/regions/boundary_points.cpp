#include "host/sampling/regions/boundary_points.hpp"

#include "base/geometry/torus.hpp"
#include "host/sampling/classics/torus_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace poissonlab {
namespace {

class BoundaryWalk
{
public:
    BoundaryWalk(const FixedRegion& region, double min_distance)
        : region_(region), distance_(min_distance * 0x1p32), squared_(squared_threshold(min_distance)),
          grid_(static_cast<std::size_t>(length_of(region) / min_distance * 0x1p-32), 2,
                static_cast<std::uint64_t>(std::ceil(min_distance * 0x1p32)))
    {
        const auto& margins = region.squared_margins();
        has_margins_ = std::ranges::any_of(margins, [](std::uint64_t margin) { return margin != 0; });
    }

    std::vector<TorusPoint<2>> run()
    {
        const std::vector<FixedEdge> edges = region_.directed_boundary();
        for (const FixedEdge& edge : edges)
            for (const TorusPoint<2>& corner : {TorusPoint<2>{edge[0], edge[1]}, TorusPoint<2>{edge[2], edge[3]}})
                add_if_free(corner);
        for (const FixedEdge& edge : edges) divide(edge);
        for (const FixedEdge& edge : edges) fill(edge);
        return std::move(points_);
    }

private:
    bool is_free(const TorusPoint<2>& place) const
    {
        return grid_.squared_nearest_below({place[0], place[1], 0}, squared_) >= squared_;
    }

    bool add_if_free(const TorusPoint<2>& place)
    {
        if (!is_free(place) || (has_margins_ && !region_.contains(place))) return false;
        grid_.add({place[0], place[1], 0});
        points_.push_back(place);
        return true;
    }

    static double length_of(const FixedRegion& region)
    {
        double length = 0;
        for (const FixedEdge& edge : region.directed_boundary()) length += length_of(edge);
        return length;
    }

    static double length_of(const FixedEdge& e) { return std::hypot(double{1} * e[2] - e[0], double{1} * e[3] - e[1]); }

    static TorusPoint<2> place_on(const FixedEdge& e, double part)
    {
        const auto between = [part](std::uint32_t from, std::uint32_t to) {
            return static_cast<std::uint32_t>(std::lround(from + part * (double{1} * to - from)));
        };
        return {between(e[0], e[2]), between(e[1], e[3])};
    }

    void divide(const FixedEdge& edge)
    {
        const double parts = std::floor(length_of(edge) / (distance_ + 2)); // rounding takes less than two positions
        for (double i = 1; i < parts; ++i) add_if_free(place_on(edge, i / parts));
    }

    /// Goes from the begin to the end, past the disks of points that are in the way.
    void fill(const FixedEdge& edge)
    {
        const double length = length_of(edge);
        double at = 0;
        while (at <= length) {
            const TorusPoint<2> place = place_on(edge, length == 0 ? 0 : at / length);
            const double beyond = end_of_disks(edge, length, place);
            if (beyond > at) {
                at = beyond;
            } else if (!add_if_free(place)) {
                at += 1 + distance_ * step;
            }
        }
    }

    /// The length along the edge at which the farthest disk ends in which the place is; 0: it is in none.
    double end_of_disks(const FixedEdge& edge, double length, const TorusPoint<2>& place) const
    {
        double farthest = 0;
        if (length == 0 || is_free(place)) return farthest;
        const double x = (double{1} * edge[2] - edge[0]) / length, y = (double{1} * edge[3] - edge[1]) / length;
        for (const std::size_t i : grid_.within({place[0], place[1], 0}, std::min(distance_, 0x1p31 - 1))) {
            const double dx = double{1} * grid_[i][0] - edge[0], dy = double{1} * grid_[i][1] - edge[1];
            const double along = dx * x + dy * y, across = dx * y - dy * x;
            const double half = std::sqrt(std::max(0.0, distance_ * distance_ - across * across));
            farthest = std::max(farthest, along + half + 1);
        }
        return farthest;
    }

    /// Places that margins forbid are passed in such parts of the distance.
    static constexpr double step = 1.0 / 256;

    const FixedRegion& region_;
    double distance_;       ///< in positions
    std::uint64_t squared_; ///< in squares of them
    bool has_margins_ = false;
    TorusGrid grid_;
    std::vector<TorusPoint<2>> points_;
};

}

std::vector<TorusPoint<2>> boundary_points(const FixedRegion& region, double min_distance)
{
    return BoundaryWalk(region, min_distance).run();
}

}
