#include "host/tile_construction/recursive/edge_merging.hpp"

#include "base/geometry/plane_delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr double triangle_slack = 4; ///< spacings

/// A place as seen from a side: along it from 0 to 1, and inwards.
struct SidePlace
{
    double along = 0, inward = 0;
};

SidePlace seen_from(const PlanePosition& p, TileSide side)
{
    switch (side) {
    case TileSide::north:
        return {p[0], 1 - p[1]};
    case TileSide::east:
        return {p[1], 1 - p[0]};
    case TileSide::south:
        return {p[0], p[1]};
    case TileSide::west:
        break;
    }
    return {p[1], p[0]};
}

PlanePosition position_of(const RecursivePlace& place) { return {place[0] * 0x1p-32, place[1] * 0x1p-32}; }

/// The tile's points, and those of the edge's set in the tile and around it, near the side. Shared points come once.
std::vector<PlanePosition> united_positions(const std::vector<RankedPlace>& tile, const std::vector<RankedPlace>& edge,
                                            TileSide side, double spacing)
{
    const double margin = 5 * spacing;
    std::vector<PlanePosition> united;
    const auto add = [&](const PlanePosition& p) {
        const SidePlace seen = seen_from(p, side);
        const bool is_near = seen.inward > -margin && seen.inward < 0.5 + 2 * margin;
        if (is_near && seen.along > -margin && seen.along < 1 + margin) united.push_back(p);
    };
    std::set<RecursivePlace> of_edge;
    for (const RankedPlace& point : edge) {
        of_edge.insert(point.place);
        const PlanePosition p = position_of(point.place);
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) add({p[0] + x, p[1] + y});
    }
    for (const RankedPlace& point : tile)
        if (!of_edge.contains(point.place)) add(position_of(point.place));
    return united;
}

bool may_be_crossed(const PlanePosition& p, TileSide side, double spacing, double strip)
{
    const auto [along, inward] = seen_from(p, side);
    const double end = std::min(along, 1 - along);
    if (end * end + inward * inward < shared_corner * shared_corner * spacing * spacing) return true;
    return inward <= end + triangle_slack * spacing && std::min(inward, end) >= strip * spacing;
}

/// The borders of Voronoi cells between two points at a distance cost (1 - distance / largest)^100.
double crossing_cost(double part)
{
    const double base = 1 - part, square = base * base, fourth = square * square;
    const double eighth = fourth * fourth, sixteenth = eighth * eighth, power_32 = sixteenth * sixteenth;
    return power_32 * power_32 * power_32 * fourth;
}

class CutGraph
{
public:
    CutGraph(const std::vector<PlanePosition>& points, TileSide side, double spacing, double strip)
        : points_(points), triangles_(plane_triangles(points))
    {
        for (const PlaneTriangle& t : triangles_) {
            vertices_.push_back(circumcentre(points[t.points[0]], points[t.points[1]], points[t.points[2]]));
            open_.push_back(may_be_crossed(vertices_.back(), side, spacing, strip));
        }
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                if (is_passage(i, k)) largest_ = std::max(largest_, distance_across(i, k));
    }

    std::size_t vertex_nearest(const PlanePosition& p) const
    {
        std::size_t nearest = 0;
        double smallest = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const double dx = vertices_[i][0] - p[0], dy = vertices_[i][1] - p[1], squared = dx * dx + dy * dy;
            if (!open_[i] || squared >= smallest) continue;
            smallest = squared;
            nearest = i;
        }
        return nearest;
    }

    /// The vertices of the cheapest path from its end to its beginning; none where there is no path.
    std::vector<PlanePosition> path(std::size_t from, std::size_t to) const
    {
        constexpr double far = std::numeric_limits<double>::max();
        constexpr double step = 1e-9; // that of two paths that cost nothing the shorter is taken
        std::vector<double> costs(triangles_.size(), far);
        std::vector<std::size_t> before(triangles_.size(), from);
        using Entry = std::pair<double, std::size_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        costs[from] = 0;
        open.emplace(0.0, from);
        while (!open.empty()) {
            const auto [cost, i] = open.top();
            open.pop();
            if (i == to) break;
            if (cost > costs[i]) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                if (!is_passage(i, k)) continue;
                const std::size_t next = triangles_[i].across[k];
                const double longer = cost + step + crossing_cost(distance_across(i, k) / largest_);
                if (longer >= costs[next]) continue;
                costs[next] = longer;
                before[next] = i;
                open.emplace(longer, next);
            }
        }
        if (costs[to] == far) return {};
        std::vector<PlanePosition> path{vertices_[to]};
        for (std::size_t i = to; i != from; i = before[i]) path.push_back(vertices_[before[i]]);
        return path;
    }

private:
    bool is_passage(std::size_t i, std::size_t k) const
    {
        const std::uint32_t next = triangles_[i].across[k];
        return open_[i] && next != UINT32_MAX && open_[next];
    }

    double distance_across(std::size_t i, std::size_t k) const
    {
        const PlanePosition &a = points_[triangles_[i].points[(k + 1) % 3]],
                            &b = points_[triangles_[i].points[(k + 2) % 3]];
        return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
    }

    const std::vector<PlanePosition>& points_;
    std::vector<PlaneTriangle> triangles_;
    std::vector<PlanePosition> vertices_;
    std::vector<bool> open_;
    double largest_ = 0;
};

bool lies_inside(const std::vector<PlanePosition>& polygon, const PlanePosition& p)
{
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const PlanePosition &a = polygon[i], &b = polygon[j];
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0])
            inside = !inside;
    }
    return inside;
}

/// The corners at the ends of a side, and places outside of the tile beside them.
std::array<PlanePosition, 4> ends_of(TileSide side)
{
    switch (side) {
    case TileSide::north:
        return {{{0, 1}, {1, 1}, {1.5, 2}, {-0.5, 2}}};
    case TileSide::east:
        return {{{1, 0}, {1, 1}, {2, 1.5}, {2, -0.5}}};
    case TileSide::south:
        return {{{0, 0}, {1, 0}, {1.5, -1}, {-0.5, -1}}};
    case TileSide::west:
        break;
    }
    return {{{0, 0}, {0, 1}, {-1, 1.5}, {-1, -0.5}}};
}

}

std::vector<RankedPlace> with_edge(const std::vector<RankedPlace>& tile, const std::vector<RankedPlace>& edge,
                                   TileSide side, double spacing)
{
    const std::vector<PlanePosition> united = united_positions(tile, edge, side, spacing);
    const auto [from, to, beyond_to, beyond_from] = ends_of(side);
    std::vector<PlanePosition> outside;
    // A way out of the corners is there nearly always.
    for (double strip = own_strip; outside.empty(); strip /= 2) {
        const CutGraph graph(united, side, spacing, strip > 0.01 ? strip : 0);
        outside = graph.path(graph.vertex_nearest(from), graph.vertex_nearest(to));
        if (outside.empty() && strip < 0.01) throw std::logic_error("no cut between two sets of points");
    }
    outside.insert(outside.end(), {from, beyond_from, beyond_to, to});
    std::vector<RankedPlace> merged;
    for (const RankedPlace& point : edge)
        if (lies_inside(outside, position_of(point.place))) merged.push_back(point);
    for (const RankedPlace& point : tile)
        if (!lies_inside(outside, position_of(point.place))) merged.push_back(point);
    return merged;
}

}
