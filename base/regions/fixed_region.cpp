#include "base/regions/fixed_region.hpp"

#include "base/regions/fixed_edges.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {

using namespace fixed_edges;

namespace {

/// Cells of the grid for each edge, nearly, and the limits of its bits: small grids are of no use where regions have
/// few edges but boxes are small.
constexpr std::size_t cells_an_edge = 16;
constexpr int least_grid_bits = 5;
constexpr int most_grid_bits = 11;

}

FixedRegion::FixedRegion(const PlaneRegion& region, double margin)
    : FixedRegion(region, margin, KeptAway{{}, {}, 0, 0, box_of(region)})
{}

FixedRegion::FixedRegion(const PlaneRegion& region, double margin, const KeptAway& kept_away)
    : box_(kept_away.box), unit_(torus_side(box_) * 0x1p-32), area_(area_of(region))
{
    const std::array margins{margin, kept_away.from_lines, kept_away.from_points};
    for (std::size_t i = 0; i < margins.size(); ++i) {
        margins_[i] = static_cast<std::uint32_t>(std::ceil(margins[i] * 0x1p32));
        squared_margins_[i] = squared_threshold(margins[i]);
    }
    for (const RegionPolygon& polygon : region.polygons) {
        add_ring(polygon.outline, false);
        for (const RegionRing& hole : polygon.holes) add_ring(hole, true);
    }
    for (const auto& [x0, y0, x1, y1] : kept_away.lines) add_edge({x0, y0}, {x1, y1}, FixedEdgeKind::line);
    for (const auto& point : kept_away.points) add_edge(point, point, FixedEdgeKind::point);
    const RegionBox around = box_of(region);
    extent_ = {rounded(around.low), rounded(around.high)};
    const auto wanted = static_cast<int>(std::bit_width(cells_an_edge * edges_.size() - 1));
    bits_ = std::clamp((wanted + 1) / 2, least_grid_bits, most_grid_bits);
    // Cells no narrower than the margins, so that they are near few others.
    while (bits_ > 0 && std::ranges::max(margins_) >> shift() != 0) --bits_;
    list_edges();
    find_corners();
    count_filled();
    divide_cells();
}

TorusPoint<2> FixedRegion::rounded(const std::array<double, 2>& corner) const
{
    TorusPoint<2> position;
    for (std::size_t k = 0; k < 2; ++k) {
        const double exact = std::round((corner[k] - box_.low[k]) / unit_);
        position[k] = static_cast<std::uint32_t>(std::clamp(exact, 0.0, 0x1p31 - 1));
    }
    return position;
}

void FixedRegion::add_edge(const std::array<double, 2>& from, const std::array<double, 2>& to, FixedEdgeKind kind,
                           bool lies_right)
{
    TorusPoint<2> a = rounded(from), b = rounded(to);
    if (a == b && kind == FixedEdgeKind::boundary) return;
    if (std::pair(b[1], b[0]) < std::pair(a[1], a[0])) {
        std::swap(a, b);
        lies_right = !lies_right;
    }
    const std::uint32_t line = kind == FixedEdgeKind::line, point = kind == FixedEdgeKind::point;
    edges_.push_back({a[0] | line << coordinate_bits, a[1], b[0] | point << coordinate_bits, b[1]});
    lies_right_.push_back(lies_right);
}

std::vector<FixedEdge> FixedRegion::directed_boundary() const
{
    std::vector<FixedEdge> directed;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const FixedEdge& e = edges_[i];
        if (is_of_boundary(e)) directed.push_back(lies_right_[i] ? FixedEdge{e[2], e[3], e[0], e[1]} : e);
    }
    return directed;
}

void FixedRegion::add_ring(const RegionRing& ring, bool is_hole)
{
    const bool lies_right = (signed_area_of(ring) < 0) != is_hole;
    for (std::size_t i = 0; i < ring.size(); ++i)
        add_edge(ring[i], ring[(i + 1) % ring.size()], FixedEdgeKind::boundary, lies_right);
}

std::uint32_t FixedRegion::margin_of(const FixedEdge& edge) const
{
    return margins_[static_cast<std::size_t>(kind_of(edge))];
}

std::uint64_t FixedRegion::squared_margin_of(const FixedEdge& edge) const
{
    return squared_margins_[static_cast<std::size_t>(kind_of(edge))];
}

bool FixedRegion::is_too_near(const FixedEdge& edge, const TorusPoint<2>& position) const
{
    const std::uint64_t squared = squared_margin_of(edge);
    return squared != 0 && is_near(ends_of(edge), position, squared);
}

/// Cells that an edge is near are found row by row, nearly, and then exactly.
void FixedRegion::find_cells(std::size_t edge, const FixedBox& block, int shift,
                             const std::function<void(std::uint32_t, std::uint32_t)>& found) const
{
    const std::uint32_t width = 1u << shift;
    const FixedEdge e = ends_of(edges_[edge]);
    const std::uint32_t margin = margin_of(edges_[edge]);
    const FixedBox box = enlarged({{std::min(e[0], e[2]), e[1]}, {std::max(e[0], e[2]), e[3]}}, margin);
    const double slope = e[3] == e[1] ? 0 : (double{1} * e[2] - e[0]) / (double{1} * e[3] - e[1]);
    const std::uint32_t last_row = std::min(box.high[1], block.high[1]) >> shift;
    for (std::uint32_t row = std::max(box.low[1], block.low[1]) >> shift; row <= last_row; ++row) {
        const std::uint32_t bottom = row << shift, top = bottom + width - 1;
        double first = std::max(box.low[0], block.low[0]), last = std::min(box.high[0], block.high[0]);
        if (e[1] != e[3]) {
            // Heights of the edge that are near the row, from its lower end.
            const double below = std::clamp(double{1} * bottom - margin, double{1} * e[1], double{1} * e[3]) - e[1];
            const double above = std::clamp(double{1} * top + margin, double{1} * e[1], double{1} * e[3]) - e[1];
            const auto [least, most] = std::minmax({e[0] + slope * below, e[0] + slope * above});
            first = std::max(first, least - margin - 2);
            last = std::min(last, most + margin + 2);
        }
        if (last < first) continue;
        const auto last_column = static_cast<std::uint32_t>(last) >> shift;
        for (std::uint32_t c = static_cast<std::uint32_t>(first) >> shift; c <= last_column; ++c) {
            const std::uint32_t left = c << shift;
            if (touches(e, enlarged({{left, bottom}, {left + width - 1, top}}, margin))) found(c, row);
        }
    }
}

void FixedRegion::list_edges()
{
    std::vector<FixedEdge> sorted = edges_;
    std::ranges::sort(sorted);
    has_coinciding_edges_ = std::ranges::adjacent_find(sorted) != sorted.end();
    const FixedBox all{{0, 0}, {most_coordinate, most_coordinate}};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found; // cell, edge
    for (std::uint32_t number = 0; number < edges_.size(); ++number)
        find_cells(number, all, shift(), [&](std::uint32_t column, std::uint32_t row) {
            found.emplace_back(static_cast<std::uint32_t>(cell_at(column, row)), number);
        });
    std::ranges::sort(found);
    cells_.assign(cell_count() + 1, 0);
    for (const auto& [cell, edge] : found) {
        listed_.push_back(edges_[edge]);
        listed_numbers_.push_back(edge);
        cells_[cell + 1] += 2;
    }
    for (std::size_t i = 1; i < cells_.size(); ++i) cells_[i] += cells_[i - 1];
}

/// Along each row of corners, edges that go through its height turn outside into inside from some column on.
void FixedRegion::find_corners()
{
    std::vector<bool> turns(std::size_t{1} << 2 * bits_);
    for (const FixedEdge& e : edges_) {
        if (e[1] == e[3] || !is_of_boundary(e)) continue;
        const std::uint32_t width = 1u << shift();
        for (std::uint32_t row = (e[1] + width - 1) >> shift(); row < size() && row << shift() < e[3]; ++row) {
            const std::int64_t y = whole(row) << shift();
            const double across = double{1} * static_cast<double>(y - whole(e[1])) / (double{1} * e[3] - e[1]);
            const double x = e[0] + across * (double{1} * e[2] - e[0]);
            const auto is_crossed_at = [&](std::uint32_t column) {
                return is_left(e, line_side(e, whole(column) << shift(), y));
            };
            std::uint32_t column = std::min(static_cast<std::uint32_t>(std::max(0.0, x)) >> shift(), size());
            while (column > 0 && is_crossed_at(column - 1)) --column;
            while (column < size() && !is_crossed_at(column)) ++column;
            if (column < size()) turns[cell_at(column, row)] = !turns[cell_at(column, row)];
        }
    }
    for (std::uint32_t row = 0; row < size(); ++row) {
        bool is_inside = false;
        for (std::uint32_t column = 0; column < size(); ++column) {
            is_inside ^= turns[cell_at(column, row)];
            cells_[cell_at(column, row)] += is_inside;
        }
    }
}

void FixedRegion::count_filled()
{
    const std::size_t stride = size() + 1;
    filled_.assign(stride * stride, 0);
    for (std::uint32_t row = 0; row < size(); ++row)
        for (std::uint32_t column = 0; column < size(); ++column) {
            const std::size_t cell = cell_at(column, row), at = stride * row + column;
            const bool is_filled = cells_[cell] % 2 == 1 || cells_[cell + 1] / 2 != cells_[cell] / 2;
            filled_[at + stride + 1] = filled_[at + stride] + filled_[at + 1] - filled_[at] + is_filled;
        }
}

FixedRegion::Inside FixedRegion::look_at(const TorusPoint<2>& p, bool has_margins) const
{
    Inside inside;
    if ((p[0] | p[1]) >> coordinate_bits != 0) return inside;
    const auto [cell, shift] = cell_with(p);
    const TorusPoint<2> corner{p[0] >> shift << shift, p[1] >> shift << shift};
    inside.moved = cells_[cell] % 2 == 1;
    for (const FixedEdge& e : edges_of(cell)) {
        if (has_margins && is_too_near(e, p)) {
            inside.is_too_near = true;
            return inside;
        }
        if (!is_of_boundary(e)) continue;
        const std::int64_t side = line_side(e, whole(p[0]), whole(p[1]));
        inside.is_on_edge |= side == 0 && is_between(e, p);
        const std::int64_t above_corner = line_side(e, whole(corner[0]), whole(p[1]));
        if (spans_height(e, p[1])) inside.moved ^= is_left(e, side) != is_left(e, above_corner);
        if (spans_width(e, corner[0]))
            inside.moved ^= is_below(e, above_corner) != is_below(e, line_side(e, whole(corner[0]), whole(corner[1])));
    }
    return inside;
}

bool FixedRegion::contains(const TorusPoint<2>& position, bool has_margins) const
{
    const Inside inside = look_at(position, has_margins);
    return !inside.is_too_near && (inside.moved || inside.is_on_edge);
}

bool FixedRegion::contains_moved(const TorusPoint<2>& position) const { return look_at(position, false).moved; }

bool FixedRegion::contains_place(const std::array<double, 2>& place) const
{
    TorusPoint<2> position;
    for (std::size_t k = 0; k < 2; ++k) {
        const double nearest = std::round((place[k] - box_.low[k]) / unit_);
        if (!(nearest >= 0 && nearest < 0x1p31)) return false;
        position[k] = static_cast<std::uint32_t>(nearest);
    }
    return contains(position);
}

bool FixedRegion::contains_plainly(const TorusPoint<2>& p) const
{
    if ((p[0] | p[1]) >> coordinate_bits != 0) return false;
    if (std::ranges::any_of(edges_, [&](const FixedEdge& e) { return is_too_near(e, p); })) return false;
    bool is_inside = false;
    for (const FixedEdge& e : edges_) {
        if (!is_of_boundary(e)) continue;
        const std::int64_t side = line_side(e, whole(p[0]), whole(p[1]));
        if (side == 0 && is_between(e, p)) return true;
        if (spans_height(e, p[1])) is_inside ^= is_left(e, side);
    }
    return is_inside;
}

std::array<double, 2> FixedRegion::own(const TorusPoint<2>& position) const
{
    return {box_.low[0] + unit_ * position[0], box_.low[1] + unit_ * position[1]};
}

}
