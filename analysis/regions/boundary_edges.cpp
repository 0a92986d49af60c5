#include "analysis/regions/boundary_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr std::size_t most_cells = 1024;

/// More than rounding moves an edge, in sides of the square.
constexpr double edge_slack = 1e-12;

double squared_distance(const RegionEdge& e, const std::array<double, 2>& p)
{
    const double dx = e.to[0] - e.from[0], dy = e.to[1] - e.from[1];
    const double x = p[0] - e.from[0], y = p[1] - e.from[1];
    const double length = dx * dx + dy * dy;
    const double t = length > 0 ? std::clamp((x * dx + y * dy) / length, 0.0, 1.0) : 0;
    return (x - t * dx) * (x - t * dx) + (y - t * dy) * (y - t * dy);
}

void add_ring_edges(const RegionRing& ring, std::vector<RegionEdge>& edges)
{
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

}

BoundaryEdges::BoundaryEdges(const PlaneRegion& polygons)
{
    for (const RegionPolygon& polygon : polygons.polygons) {
        add_ring_edges(polygon.outline, edges_);
        for (const RegionRing& hole : polygon.holes) add_ring_edges(hole, edges_);
    }
    const auto wanted = static_cast<std::size_t>(2 * std::sqrt(static_cast<double>(edges_.size())));
    cells_ = std::clamp<std::size_t>(wanted, 1, most_cells);
    lists_.resize(cells_ * cells_);
    for (std::uint32_t number = 0; number < edges_.size(); ++number) list(number);
}

std::size_t BoundaryEdges::cell_along(double coordinate) const
{
    const double cell = std::floor(coordinate * static_cast<double>(cells_));
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells_ - 1)));
}

/// Row by row: the part of the edge in a row, and the cells that it spans.
void BoundaryEdges::list(std::uint32_t number)
{
    auto [low, high] = edges_[number];
    if (high[1] < low[1]) std::swap(low, high);
    const double slope = high[1] > low[1] ? (high[0] - low[0]) / (high[1] - low[1]) : 0;
    const std::size_t last = cell_along(high[1] + edge_slack);
    for (std::size_t row = cell_along(low[1] - edge_slack); row <= last; ++row) {
        const double bottom = std::clamp(static_cast<double>(row) / static_cast<double>(cells_), low[1], high[1]);
        const double top = std::clamp(static_cast<double>(row + 1) / static_cast<double>(cells_), low[1], high[1]);
        auto [left, right] = std::minmax({low[0] + slope * (bottom - low[1]), low[0] + slope * (top - low[1])});
        if (high[1] == low[1]) left = std::min(low[0], high[0]), right = std::max(low[0], high[0]);
        for (std::size_t c = cell_along(left - edge_slack); c <= cell_along(right + edge_slack); ++c)
            lists_[row * cells_ + c].push_back(number);
    }
}

/// Rings of cells around the place's own, until all that is farther out is farther away than what was found.
double BoundaryEdges::distance(const std::array<double, 2>& place, double most) const
{
    const auto column = static_cast<std::ptrdiff_t>(cell_along(place[0]));
    const auto row = static_cast<std::ptrdiff_t>(cell_along(place[1]));
    const auto cells = static_cast<std::ptrdiff_t>(cells_);
    double squared = most * most;
    const auto visit = [&](std::ptrdiff_t x, std::ptrdiff_t y) {
        if (x < 0 || y < 0 || x >= cells || y >= cells) return;
        for (const std::uint32_t number : lists_[static_cast<std::size_t>(y * cells + x)])
            squared = std::min(squared, squared_distance(edges_[number], place));
    };
    for (std::ptrdiff_t ring = 0; ring <= cells; ++ring) {
        const double beyond = static_cast<double>(ring - 1) / static_cast<double>(cells_);
        if (ring > 0 && beyond > 0 && beyond * beyond > squared) break;
        for (std::ptrdiff_t x = column - ring; x <= column + ring; ++x) {
            visit(x, row - ring);
            if (ring > 0) visit(x, row + ring);
        }
        for (std::ptrdiff_t y = row - ring + 1; y <= row + ring - 1; ++y) {
            visit(column - ring, y);
            visit(column + ring, y);
        }
    }
    return std::sqrt(squared);
}

std::vector<RegionEdge> BoundaryEdges::edges_near(const std::array<double, 2>& place, double reach) const
{
    std::vector<std::uint32_t> numbers;
    for (std::size_t row = cell_along(place[1] - reach); row <= cell_along(place[1] + reach); ++row)
        for (std::size_t c = cell_along(place[0] - reach); c <= cell_along(place[0] + reach); ++c)
            for (const std::uint32_t number : lists_[row * cells_ + c])
                if (squared_distance(edges_[number], place) <= reach * reach) numbers.push_back(number);
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    std::vector<RegionEdge> found;
    for (const std::uint32_t number : numbers) found.push_back(edges_[number]);
    return found;
}

/// An edge that goes out of the circle has the region on that side of it where angles grow, one that comes in on the
/// other: angles of the former begin arcs within the region, those of the latter end them.
double share_of_circle(const std::array<double, 2>& place, double radius, std::span<const RegionEdge> edges)
{
    constexpr double turn = 2 * std::numbers::pi;
    double angles = 0;
    bool is_crossed = false;
    for (const RegionEdge& e : edges) {
        const double x = e.from[0] - place[0], y = e.from[1] - place[1];
        const double dx = e.to[0] - e.from[0], dy = e.to[1] - e.from[1];
        const double x_to = e.to[0] - place[0], y_to = e.to[1] - place[1];
        const bool begins_inside = x * x + y * y < radius * radius;
        const bool ends_inside = x_to * x_to + y_to * y_to < radius * radius;
        if (begins_inside && ends_inside) continue;
        const double length = dx * dx + dy * dy;
        if (length == 0) continue;
        const double middle = -(x * dx + y * dy) / length;
        const double across = (x * dy - y * dx) * (x * dy - y * dx) / length;
        if (begins_inside == ends_inside && !(middle > 0 && middle < 1 && across < radius * radius)) continue;
        const double half = std::sqrt(std::max(0.0, (radius * radius - across) / length));
        const auto angle_at = [&](double t) { return std::atan2(y + t * dy, x + t * dx); };
        if (!begins_inside) angles += angle_at(middle - half);
        if (!ends_inside) angles -= angle_at(middle + half);
        is_crossed = true;
    }
    if (!is_crossed) return 1;
    angles -= turn * std::floor(angles / turn);
    return angles / turn;
}

}
