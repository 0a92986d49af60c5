#include "host/distribution/regions/line_set.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_source.hpp"
#include "host/distribution/regions/line_points.hpp"
#include "host/distribution/regions/nearest_in_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace poissonlab {
namespace {

/// Points may be off the lines by this part of the longest side of the lines' box, because files hold rounded
/// coordinates.
constexpr double off_lines = 1e-6;

/// The edges of lines, listed by the cells of a grid near which they pass.
class EdgesByPlace
{
public:
    struct OnLine
    {
        double off = std::numeric_limits<double>::infinity();
        std::size_t line = 0;
        double along = 0; ///< from the line's first corner
    };

    EdgesByPlace(const std::vector<RegionRing>& lines, double off)
        : off_(off), cell_(std::max(length_of(lines) / most_cells, 2 * off))
    {
        for (std::size_t line = 0; line < lines.size(); ++line) {
            double along = 0;
            for (std::size_t i = 1; i < lines[line].size(); ++i) {
                edges_.push_back({lines[line][i - 1], lines[line][i], line, along});
                along += edges_.back().length();
                list(edges_.size() - 1);
            }
        }
    }

    /// The nearest place on a line; `off` is infinite where no line is near.
    OnLine nearest(const std::array<double, 2>& p) const
    {
        OnLine nearest;
        if (!(std::max(std::abs(p[0]), std::abs(p[1])) < cell_ * 0x1p62)) return nearest; // no cell has such a number
        const auto found = cells_.find(cell_of(p));
        if (found == cells_.end()) return nearest;
        for (const std::size_t i : found->second) {
            const Edge& edge = edges_[i];
            const double length = edge.length(), dx = edge.to[0] - edge.from[0], dy = edge.to[1] - edge.from[1];
            const double x = p[0] - edge.from[0], y = p[1] - edge.from[1];
            const double part = length > 0 ? std::clamp((x * dx + y * dy) / (length * length), 0.0, 1.0) : 0;
            const double off = std::hypot(x - part * dx, y - part * dy);
            // Rounding must not choose between lines that share an edge: the first one has all of its points.
            const double slack = edge.line == nearest.line ? 0 : off_;
            if (off < nearest.off - slack) nearest = {off, edge.line, edge.along + part * length};
        }
        return nearest;
    }

private:
    static constexpr double most_cells = 1 << 17; ///< along all lines together

    struct Edge
    {
        std::array<double, 2> from, to;
        std::size_t line;
        double along;

        double length() const { return std::hypot(to[0] - from[0], to[1] - from[1]); }
    };
    using Cell = std::array<std::int64_t, 2>;

    Cell cell_of(const std::array<double, 2>& p) const
    {
        return {static_cast<std::int64_t>(std::floor(p[0] / cell_)),
                static_cast<std::int64_t>(std::floor(p[1] / cell_))};
    }

    /// Lists an edge in all cells near it, by steps of at most half a cell along the edge.
    void list(std::size_t number)
    {
        const Edge& edge = edges_[number];
        const double steps = std::max(1.0, std::ceil(2 * edge.length() / cell_));
        for (double step = 0; step <= steps; ++step) {
            std::array<double, 2> p;
            for (std::size_t k = 0; k < 2; ++k) p[k] = edge.from[k] + (edge.to[k] - edge.from[k]) * (step / steps);
            const double reach = cell_ / 4 + off_;
            const Cell low = cell_of({p[0] - reach, p[1] - reach}), high = cell_of({p[0] + reach, p[1] + reach});
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t x = low[0]; x <= high[0]; ++x) {
                    std::vector<std::size_t>& listed = cells_[{x, y}];
                    if (listed.empty() || listed.back() != number) listed.push_back(number);
                }
        }
    }

    double off_, cell_;
    std::vector<Edge> edges_;
    std::map<Cell, std::vector<std::size_t>> cells_;
};

/// The gaps of points along a line, at these places from its beginning.
void append_gaps(std::vector<double> along, const RegionRing& line, std::vector<double>& gaps)
{
    std::ranges::sort(along);
    for (std::size_t i = 1; i < along.size(); ++i) gaps.push_back(along[i] - along[i - 1]);
    if (line.front() == line.back()) gaps.push_back(length_of({line}) - (along.back() - along.front()));
}

}

LineSet measure_line_set(const PlaneRegion& region, const PointSet& points)
{
    const std::vector<RegionRing>& lines = lines_of(region);
    const double off = off_lines * box_around(lines).longest();
    const EdgesByPlace edges(lines, off);
    std::map<std::size_t, std::vector<double>> along;
    std::size_t outside = 0, first = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const EdgesByPlace::OnLine on = edges.nearest({points[i][0], points[i][1]});
        if (on.off <= off)
            along[on.line].push_back(on.along);
        else if (outside++ == 0)
            first = i;
    }
    if (outside > 0) {
        const PointSet own = as_in_files(region, {2, {points[first][0], points[first][1]}});
        throw InputError(fmt::format("{} of {} points {} not on the lines: the first is point {}, ({}, {})", outside,
                                     points.size(), outside == 1 ? "is" : "are", first + 1, own[0][0], own[0][1]));
    }
    LineSet set{.lines = lines.size(), .length = length_along(lines)};
    for (const auto& [line, places] : along) append_gaps(places, lines[line], set.gaps);
    std::ranges::sort(set.gaps);
    const NearestDistances nearest = nearest_distances(points);
    set.least = nearest.least;
    set.mean_nearest = nearest.mean;
    return set;
}

}
