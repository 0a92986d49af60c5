// Cells of a region's grid with many edges, divided into parts.
#include "base/regions/fixed_edges.hpp"
#include "base/regions/fixed_region.hpp"

#include <algorithm>
#include <bit>
#include <ranges>
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

}
