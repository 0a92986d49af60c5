// A region's grid decides whether a box lies inside the region, outside of it, or is crossed by edges, and by which.
#include "base/regions/fixed_edges.hpp"
#include "base/regions/fixed_region.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace poissonlab {

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
