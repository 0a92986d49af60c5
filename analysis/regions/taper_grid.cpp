#include "analysis/regions/taper_grid.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// A boundary on a line of the grid crosses no cell, where rounding moves it by less than this part of one.
constexpr double rounded_part = 1e-6;

/// Cells of a row, from the first one to before the end.
struct CellRun
{
    std::uint32_t begin = 0, end = 0;
};
using Runs = std::vector<CellRun>;

/// Adds the cells that an edge crosses to the runs of their rows; the edge is in units of cells. An edge along the line
/// between two cells adds an empty run, because the cells on its two sides may differ.
void mark_edge(std::array<double, 2> from, std::array<double, 2> to, const std::array<std::size_t, 2>& cells,
               std::vector<Runs>& crossed)
{
    if (from[1] > to[1]) std::swap(from, to);
    const double slope = to[1] > from[1] ? (to[0] - from[0]) / (to[1] - from[1]) : 0;
    const bool is_level = to[1] == from[1];
    const auto last_column = static_cast<double>(cells[0]);
    const auto first = static_cast<std::size_t>(std::clamp(from[1], 0.0, static_cast<double>(cells[1] - 1)));
    for (std::size_t row = first; row < cells[1] && static_cast<double>(row) + rounded_part < to[1]; ++row) {
        const double low = std::max(from[1], static_cast<double>(row) + rounded_part);
        const double high = std::min(to[1], static_cast<double>(row + 1) - rounded_part);
        if (low > high) continue;
        const double a = is_level ? from[0] : from[0] + slope * (low - from[1]);
        const double b = is_level ? to[0] : from[0] + slope * (high - from[1]);
        const double begin = std::floor(std::clamp(std::min(a, b) + rounded_part, 0.0, last_column));
        const double end = std::ceil(std::clamp(std::max(a, b) - rounded_part, 0.0, last_column));
        crossed[row].push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::max(begin, end))});
    }
}

/// The runs of cells of a row that are inside. The cells between two crossed runs are all inside or all outside.
template <typename Inside>
Runs runs_inside(Runs crossed, std::uint32_t columns, const Inside& is_inside)
{
    std::ranges::sort(crossed, {}, &CellRun::begin);
    crossed.push_back({columns, columns});
    Runs inside;
    std::uint32_t begin = 0;
    for (const CellRun& run : crossed) {
        if (run.begin > begin && is_inside(begin)) inside.push_back({begin, run.begin});
        begin = std::max(begin, run.end);
    }
    return inside;
}

/// Visits the columns of nodes between two rows, whose cells to the left and to the right are inside in both.
template <typename Visit>
void for_common_nodes(const Runs& below, const Runs& above, const Visit& visit)
{
    for (std::size_t i = 0, k = 0; i < below.size() && k < above.size();) {
        const std::uint32_t begin = std::max(below[i].begin, above[k].begin),
                            end = std::min(below[i].end, above[k].end);
        for (std::uint32_t column = begin + 1; column < end; ++column) visit(column);
        (below[i].end < above[k].end ? i : k) += 1;
    }
}

}

TaperGrid::TaperGrid(const FramedRegion& region, const std::array<std::size_t, 2>& cells) : cells_(cells)
{
    const RegionBox box = box_of(region.polygons());
    for (std::size_t k = 0; k < 2; ++k) step_[k] = (box.high[k] - box.low[k]) / static_cast<double>(cells_[k]);
    std::vector<Runs> crossed(cells_[1]);
    const auto in_cells = [&](const std::array<double, 2>& p) { return std::array{p[0] / step_[0], p[1] / step_[1]}; };
    for (const RegionEdge& e : region.boundary().edges()) mark_edge(in_cells(e.from), in_cells(e.to), cells_, crossed);
    Runs below;
    for (std::size_t row = 0; row < cells_[1]; ++row) {
        const double y = (static_cast<double>(row) + 0.5) * step_[1];
        Runs above =
            runs_inside(std::move(crossed[row]), static_cast<std::uint32_t>(cells_[0]), [&](std::uint32_t column) {
                return region.contains({(column + 0.5) * step_[0], y});
            });
        row_begins_.push_back(columns_.size());
        for_common_nodes(below, above, [&](std::uint32_t column) { columns_.push_back(column); });
        below = std::move(above);
    }
    row_begins_.resize(cells_[1] + 2, columns_.size());
}

std::size_t TaperGrid::number(std::size_t column, std::size_t row) const
{
    const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(row_begins_[row]);
    const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(row_begins_[row + 1]);
    const auto found = std::lower_bound(begin, end, column);
    return found != end && *found == column ? static_cast<std::size_t>(found - columns_.begin()) : no_node;
}

}
