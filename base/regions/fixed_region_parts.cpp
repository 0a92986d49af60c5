// Cells of a region's grid with many edges, divided into parts.
// A region's grid decides whether a box lies inside the region, outside of it, or is crossed by edges, and by which.
#include "base/regions/fixed_edges.hpp"
#include "base/regions/fixed_region.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

namespace poissonlab {

using namespace fixed_edges;

namespace {

/// Cells with more edges are divided, into parts with some four of them on a line: there are so many parts at most.
constexpr std::uint32_t many_edges = 16;
constexpr std::uint32_t edges_a_part = 4;
constexpr int most_fine_bits = 5;
constexpr std::size_t most_parts = std::size_t{1} << 23;

}

void FixedRegion::divide_cells()
{
    std::vector<std::size_t> divided;
    std::uint32_t most = 0;
    for (std::size_t cell = 0; cell < cell_count(); ++cell) {
        const auto edges = static_cast<std::uint32_t>(edges_of(cell).size());
        if (edges > many_edges) divided.push_back(cell);
        most = std::max(most, edges);
    }
    if (divided.empty()) return;
    int bits = std::min({most_fine_bits, static_cast<int>(std::bit_width(most / edges_a_part)), shift()});
    while (bits > 0 && (divided.size() << 2 * bits > most_parts || std::ranges::max(margins_) >> (shift() - bits) != 0))
        --bits;
    if (bits == 0) return;
    const std::size_t parts = (std::size_t{1} << 2 * bits) + 1, first = 2 * cell_count() + 1;
    std::vector<std::uint32_t> beginnings(cell_count());
    for (std::size_t i = 0; i < divided.size(); ++i)
        beginnings[divided[i]] = static_cast<std::uint32_t>(first + i * parts);
    cells_.reserve(first + divided.size() * parts);
    // Until fine_bits_ is set, positions are looked for in whole cells.
    cells_.insert(cells_.end(), beginnings.begin(), beginnings.end());
    for (const std::size_t cell : divided) divide(cell, bits);
    fine_bits_ = bits;
}

/// Along a row of corners of parts, edges that go through its height turn outside into inside from some column on.
std::vector<bool> FixedRegion::corners_inside(std::span<const FixedEdge> of_cell, const TorusPoint<2>& first,
                                              int part_shift, int bits) const
{
    std::vector<bool> turns(std::size_t{1} << bits);
    turns[0] = contains_moved(first);
    for (const FixedEdge& e : of_cell) {
        if (!is_of_boundary(e) || !spans_height(e, first[1])) continue;
        const auto is_crossed_at = [&](std::uint32_t column) {
            return is_left(e, line_side(e, whole(first[0]) + (whole(column) << part_shift), whole(first[1])));
        };
        if (is_crossed_at(0)) continue;
        const auto columns = std::views::iota(1u, 1u << bits);
        const auto crossed = std::ranges::partition_point(columns, [&](std::uint32_t c) { return !is_crossed_at(c); });
        if (crossed != columns.end()) turns[*crossed] = !turns[*crossed];
    }
    for (std::size_t column = 1; column < turns.size(); ++column) turns[column] = turns[column] != turns[column - 1];
    return turns;
}

/// Appends the parts of a cell.
void FixedRegion::divide(std::size_t cell, int bits)
{
    const int part_shift = shift() - bits;
    const TorusPoint<2> low{static_cast<std::uint32_t>(cell & (size() - 1)) << shift(),
                            static_cast<std::uint32_t>(cell >> bits_) << shift()};
    const std::uint32_t last = (1u << shift()) - 1, mask = (1u << bits) - 1;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found; // part, edge
    for (std::uint32_t i = cells_[cell] / 2; i < cells_[cell + 1] / 2; ++i)
        find_cells(listed_numbers_[i], {low, {low[0] + last, low[1] + last}}, part_shift,
                   [&](std::uint32_t column, std::uint32_t row) {
                       found.emplace_back((row & mask) << bits | (column & mask), listed_numbers_[i]);
                   });
    std::ranges::sort(found);
    const std::span<const FixedEdge> edges = std::span(listed_).subspan(cells_[cell] / 2, edges_of(cell).size());
    const std::vector<FixedEdge> of_cell(edges.begin(), edges.end());
    std::vector<bool> are_inside;
    auto next = found.begin();
    for (std::uint32_t part = 0; part < 1u << 2 * bits; ++part) {
        if ((part & mask) == 0)
            are_inside = corners_inside(of_cell, {low[0], low[1] + ((part >> bits) << part_shift)}, part_shift, bits);
        cells_.push_back(static_cast<std::uint32_t>(2 * listed_.size() + are_inside[part & mask]));
        for (; next != found.end() && next->first == part; ++next) listed_.push_back(edges_[next->second]);
    }
    cells_.push_back(static_cast<std::uint32_t>(2 * listed_.size()));
}

FixedRegion::FoundCell FixedRegion::cell_with(const TorusPoint<2>& p) const
{
    const std::size_t cell = cell_at(p[0] >> shift(), p[1] >> shift());
    const std::uint32_t divided = fine_bits_ == 0 ? 0 : cells_[cell_count() + 1 + cell];
    if (divided == 0) return {cell, shift()};
    const int part_shift = shift() - fine_bits_;
    const std::uint32_t mask = (1u << fine_bits_) - 1;
    return {divided + ((p[1] >> part_shift & mask) << fine_bits_ | (p[0] >> part_shift & mask)), part_shift};
}

using namespace fixed_edges;

namespace {

bool has_position(const FixedBox& box, std::uint32_t x, std::uint32_t y)
{
    return x >= box.low[0] && x <= box.high[0] && y >= box.low[1] && y <= box.high[1];
}

/// Returns the side of a box in a cell of a region without margins. `is_corner_inside` says whether the cell's lowest
/// corner, moved by (e^2, e), is inside. Returns nothing if an edge ends in the cell or is a line to keep away from;
/// all other edges cross the whole cell, so that only their lines matter.
std::optional<RegionSide> side_in_cell(const FixedBox& box, const FixedBox& cell, std::span<const FixedEdge> edges,
                                       bool is_corner_inside)
{
    bool is_inside = is_corner_inside;
    for (const FixedEdge& e : edges) {
        if (!is_of_boundary(e) || has_position(cell, e[0], e[1]) || has_position(cell, e[2], e[3])) return {};
        if (touches(e, box)) return RegionSide::crossed;
        const std::int64_t of_corner = line_side(e, whole(cell.low[0]), whole(cell.low[1]));
        is_inside ^= (line_side(e, whole(box.low[0]), whole(box.low[1])) > 0) !=
                     (of_corner > 0 || (of_corner == 0 && e[2] > e[0]));
    }
    return is_inside ? RegionSide::inside : RegionSide::outside;
}

}

/// Calls what(edge) for the edges of the cells that a box is in, as long as it returns true; one may come several
/// times. Small boxes are held against those parts of divided cells alone that they lie in.
template <typename What>
void FixedRegion::for_each_edge_of_cells(const FixedBox& box, const What& what) const
{
    const int fine_shift = shift() - fine_bits_;
    const bool is_fine = box.high[0] >> fine_shift <= (box.low[0] >> fine_shift) + 1 &&
                         box.high[1] >> fine_shift <= (box.low[1] >> fine_shift) + 1;
    const int looked_at = is_fine ? fine_shift : shift();
    for (std::uint32_t row = box.low[1] >> looked_at; row <= box.high[1] >> looked_at; ++row)
        for (std::uint32_t column = box.low[0] >> looked_at; column <= box.high[0] >> looked_at; ++column) {
            const std::size_t cell =
                is_fine ? cell_with({column << looked_at, row << looked_at}).number : cell_at(column, row);
            for (const FixedEdge& e : edges_of(cell))
                if (!what(e)) return;
        }
}

RegionSide FixedRegion::side_of(const FixedBox& box) const
{
    if ((box.low[0] | box.low[1]) >> coordinate_bits != 0) return RegionSide::outside;
    const FixedBox cut{box.low, {std::min(box.high[0], most_coordinate), std::min(box.high[1], most_coordinate)}};
    const std::uint32_t left = cut.low[0] >> shift(), right = cut.high[0] >> shift();
    const std::uint32_t bottom = cut.low[1] >> shift(), top = cut.high[1] >> shift();
    const std::size_t stride = size() + 1;
    const std::uint32_t filled = filled_[stride * (top + 1) + right + 1] - filled_[stride * (top + 1) + left] -
                                 filled_[stride * bottom + right + 1] + filled_[stride * bottom + left];
    if (filled == 0) return RegionSide::outside;
    if (right > left + 1 || top > bottom + 1) return RegionSide::crossed;
    const auto [number, width] = cell_with(cut.low);
    const std::uint32_t within = (1u << width) - 1;
    const FixedBox cell{{cut.low[0] & ~within, cut.low[1] & ~within}, {cut.low[0] | within, cut.low[1] | within}};
    if (std::ranges::max(squared_margins_) == 0 && has_position(cell, cut.high[0], cut.high[1]))
        if (const auto side = side_in_cell(cut, cell, edges_of(number), cells_[number] % 2 == 1))
            return *side == RegionSide::inside && cut.high != box.high ? RegionSide::crossed : *side;
    bool is_crossed = false, is_near_edge = false, is_all_margin = false;
    for_each_edge_of_cells(cut, [&](const FixedEdge& e) {
        const FixedEdge ends = ends_of(e);
        const std::uint64_t squared = squared_margin_of(e);
        is_all_margin |= squared != 0 && is_all_near(ends, cut, squared);
        is_crossed |= is_of_boundary(e) && touches(ends, cut);
        is_near_edge |= touches(ends, enlarged(cut, margin_of(e)));
        return !is_all_margin;
    });
    if (is_all_margin) return RegionSide::outside;
    if (is_crossed) return RegionSide::crossed;
    if (!contains(box.low, false)) return RegionSide::outside;
    return cut.high == box.high && !is_near_edge ? RegionSide::inside : RegionSide::crossed;
}

bool FixedRegion::find_crossing(const FixedBox& box, std::vector<FixedEdge>& edges) const
{
    edges.clear();
    bool is_simple = std::ranges::max(margins_) == 0 && !has_coinciding_edges_;
    if (is_simple)
        for_each_edge_of_cells(box, [&](const FixedEdge& e) {
            if (!touches(e, box) || std::ranges::find(edges, e) != edges.end()) return true;
            is_simple =
                edges.size() < most_crossing && !has_position(box, e[0], e[1]) && !has_position(box, e[2], e[3]);
            edges.push_back(e);
            return is_simple;
        });
    return is_simple;
}

}
