#include "host/sampling/regions/site_grid.hpp"

#include "base/regions/region_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// Sites in a cell of the grid inside the region, on average, between half of this and twice as many.
constexpr double sites_per_cell = 2;

/// Cells for each site, at most: thin regions fill little of their box.
constexpr double cells_per_site = 16;

/// Squares by which listed cells are found at most.
constexpr std::size_t most_listed_squares = std::size_t{1} << 22;

/// The distance, in steps, up to which a site is looked for around each of them.
constexpr std::int64_t most_steps_to_site = 64;

}

SiteGrid::SiteGrid(const FixedRegion& region, std::size_t sites, bool is_listed) : region_(region)
{
    const FixedBox& box = region.extent();
    const double width = double{1} * box.high[0] - box.low[0] + 1, height = double{1} * box.high[1] - box.low[1] + 1;
    const double area = region.area() / (region.unit() * region.unit());
    const auto count = static_cast<double>(sites);
    const double of_area = std::sqrt(area * sites_per_cell / count);
    const double of_box = is_listed ? 0 : std::sqrt(width * height / (cells_per_site * count + 1024));
    grid_.shift = static_cast<std::uint32_t>(std::clamp(std::lround(std::log2(std::max(of_area, of_box))), 1l, 31l));
    grid_.low_x = box.low[0];
    grid_.low_y = box.low[1];
    grid_.columns = ((box.high[0] - box.low[0]) >> grid_.shift) + 1;
    grid_.rows = ((box.high[1] - box.low[1]) >> grid_.shift) + 1;
    grid_.sites = static_cast<std::uint32_t>(sites);
    grid_.is_listed = is_listed;
    edges_ = region_.directed_boundary();
    for (FixedEdge& e : edges_) e = {e[0] - grid_.low_x, e[1] - grid_.low_y, e[2] - grid_.low_x, e[3] - grid_.low_y};
    if (is_listed) list_cells();
    list_edges();
    find_filled();
}

void SiteGrid::sort(std::span<const TorusPoint<2>> sites)
{
    const auto cell_of = [&](const TorusPoint<2>& site) {
        return number_of_cell((site[1] - grid_.low_y) >> grid_.shift, (site[0] - grid_.low_x) >> grid_.shift);
    };
    starts_.assign(cells() + 1, 0);
    for (const TorusPoint<2>& site : sites) ++starts_[cell_of(site) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    numbers_.resize(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i) numbers_[next[cell_of(sites[i])]++] = i;
    sites_.clear();
    is_inside_.clear();
    for (const std::uint32_t number : numbers_) {
        sites_.push_back(sites[number]);
        is_inside_.push_back(region_.contains_moved(sites[number]));
    }
    grid_.half_box = grid_.is_listed != 0 ? half_box_of_listed() : half_box();
    if (grid_.is_listed != 0 && (grid_.half_box > clip_reach_ || grid_.half_box < clip_reach_ / 2)) find_clips();
}

std::size_t SiteGrid::number_of_cell(std::uint32_t row, std::uint32_t column) const
{
    return grid_.is_listed == 0 ? first_of_row(row) + column : list_.number_of(row, column);
}

/// Calls body(row, column, number of the edge).
template <typename Body>
void SiteGrid::for_each_cell_of_edges(const Body& body) const
{
    for (std::uint32_t number = 0; number < edges_.size(); ++number) {
        const FixedEdge& e = edges_[number];
        const std::uint32_t last_row = std::max(e[1], e[3]) >> grid_.shift;
        for (std::uint32_t row = std::min(e[1], e[3]) >> grid_.shift; row <= last_row; ++row) {
            const auto [first, last] = columns_of(grid_, e, row);
            for (std::uint32_t column = first; column <= last; ++column) body(row, column, number);
        }
    }
}

/// The cells of squares that are not outside, and those of edges.
void SiteGrid::list_cells()
{
    std::vector<std::uint64_t> found; // rows in the upper half
    const auto add = [&](std::uint64_t row, std::uint64_t column) { found.push_back(row << 32 | column); };
    for_each_cell_of_edges([&](std::uint32_t row, std::uint32_t column, std::uint32_t) { add(row, column); });
    const RegionSquares<FixedRegion> squares = squares_of(region_, most_listed_squares);
    const auto cell_along = [&](std::uint64_t position, std::uint32_t low, std::uint32_t count) -> std::uint64_t {
        const std::uint64_t along = position < low ? 0 : (position - low) >> grid_.shift;
        return std::min<std::uint64_t>(along, count - 1);
    };
    for (const TorusPoint<2>& corner : squares.corners) {
        const std::uint64_t side = (std::uint64_t{1} << squares.shift) - 1;
        const std::uint64_t first = cell_along(corner[0], grid_.low_x, grid_.columns);
        const std::uint64_t last = cell_along(corner[0] + side, grid_.low_x, grid_.columns);
        const std::uint64_t top = cell_along(corner[1] + side, grid_.low_y, grid_.rows);
        for (std::uint64_t row = cell_along(corner[1], grid_.low_y, grid_.rows); row <= top; ++row)
            for (std::uint64_t column = first; column <= last; ++column) add(row, column);
    }
    list_ = cell_rows(std::move(found), grid_.rows);
}

void SiteGrid::list_edges()
{
    const auto visit = [&](const auto& body) {
        for_each_cell_of_edges([&](std::uint32_t row, std::uint32_t column, std::uint32_t number) {
            body(number_of_cell(row, column), number);
        });
    };
    edge_starts_.assign(cells() + 1, 0);
    visit([&](std::size_t cell, std::uint32_t) { ++edge_starts_[cell + 1]; });
    for (std::size_t i = 1; i < edge_starts_.size(); ++i) edge_starts_[i] += edge_starts_[i - 1];
    std::vector<std::uint32_t> next(edge_starts_.begin(), edge_starts_.end() - 1);
    edge_numbers_.resize(edge_starts_.back());
    visit([&](std::size_t cell, std::uint32_t number) { edge_numbers_[next[cell]++] = number; });
}

void SiteGrid::find_filled()
{
    const std::uint32_t last = (1u << grid_.shift) - 1;
    is_filled_.resize(cells());
    for (std::uint32_t row = 0; row < grid_.rows; ++row)
        for (std::size_t cell = number_of_cell(row, 0); cell < number_of_cell(row, grid_.columns); ++cell) {
            const std::uint32_t column = column_of(cell, row);
            const TorusPoint<2> low{grid_.low_x + (column << grid_.shift), grid_.low_y + (row << grid_.shift)};
            const RegionSide side = region_.side_of({low, {low[0] + last, low[1] + last}});
            // With margins the region goes on where no point may be.
            is_filled_[cell] = side != RegionSide::outside || edge_starts_[cell + 1] > edge_starts_[cell] ||
                               region_.contains_moved(low);
        }
}

/// The most steps from a cell that is not outside to one with a site, along rows, columns and diagonals, by passing
/// twice over the grid. Whatever lies in the region has a site within one cell more than these.
double SiteGrid::half_box() const
{
    constexpr std::uint32_t far = std::numeric_limits<std::uint32_t>::max() / 2;
    const std::int64_t columns = grid_.columns, rows = grid_.rows;
    std::vector<std::uint32_t> steps(cells(), far);
    for (std::size_t cell = 0; cell < steps.size(); ++cell)
        if (starts_[cell + 1] > starts_[cell]) steps[cell] = 0;
    const auto look = [&](std::int64_t row, std::int64_t column, std::int64_t down, std::int64_t right) {
        const std::int64_t y = row + down, x = column + right;
        if (y < 0 || y >= rows || x < 0 || x >= columns) return;
        auto& here = steps[static_cast<std::size_t>(row * columns + column)];
        here = std::min(here, steps[static_cast<std::size_t>(y * columns + x)] + 1);
    };
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
            for (const auto& [down, right] : {std::array{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}})
                look(row, column, down, right);
    for (std::int64_t row = rows; row-- > 0;)
        for (std::int64_t column = columns; column-- > 0;)
            for (const auto& [down, right] : {std::array{1, 1}, {1, 0}, {1, -1}, {0, 1}})
                look(row, column, down, right);
    std::uint32_t most = 0;
    for (std::size_t cell = 0; cell < steps.size(); ++cell)
        if (is_filled_[cell] != 0) most = std::max(most, steps[cell]);
    return 1.5 * (most + 1) * static_cast<double>(std::uint64_t{1} << grid_.shift); // 1.5 > sqrt(2)
}

/// As half_box(), by looking around each cell; where one has no site so near, all of the box.
double SiteGrid::half_box_of_listed() const
{
    const std::int64_t columns = grid_.columns, rows = grid_.rows;
    const auto has_site = [&](std::int64_t row, std::int64_t first, std::int64_t last) {
        if (row < 0 || row >= rows || last < 0 || first >= columns) return false;
        const auto y = static_cast<std::uint32_t>(row);
        const std::size_t begin = number_of_cell(y, static_cast<std::uint32_t>(std::max<std::int64_t>(first, 0)));
        const std::size_t end = number_of_cell(y, static_cast<std::uint32_t>(std::min(last + 1, columns)));
        return starts_[end] > starts_[begin];
    };
    std::int64_t most = 0;
    for (std::int64_t row = 0; row < rows; ++row) {
        const auto y = static_cast<std::uint32_t>(row);
        for (std::size_t cell = number_of_cell(y, 0); cell < number_of_cell(y, grid_.columns); ++cell) {
            if (is_filled_[cell] == 0 || starts_[cell + 1] > starts_[cell]) continue;
            const std::int64_t column = column_of(cell, y);
            // Cells nearer than what is known already need not be looked at one by one.
            std::int64_t steps = most;
            const auto is_near = [&] {
                for (std::int64_t away = 0; away <= steps; ++away)
                    for (const std::int64_t other : {row - away, row + away})
                        if (has_site(other, column - steps, column + steps)) return true;
                return false;
            };
            while (!is_near()) {
                if (++steps <= most_steps_to_site) continue;
                return 1.5 * (std::max(grid_.columns, grid_.rows) + 1.0) * std::exp2(grid_.shift);
            }
            most = steps;
        }
    }
    return 1.5 * static_cast<double>(most + 1) * std::exp2(grid_.shift); // 1.5 > sqrt(2)
}

std::array<std::uint32_t, 2> columns_of(const contract::region_lloyd::SiteGrid& grid, const FixedEdge& edge,
                                        std::uint32_t row)
{
    const bool goes_up = edge[1] <= edge[3];
    const double x0 = goes_up ? edge[0] : edge[2], y0 = goes_up ? edge[1] : edge[3];
    const double x1 = goes_up ? edge[2] : edge[0], y1 = goes_up ? edge[3] : edge[1];
    const double width = 1u << grid.shift;
    double low = std::min(x0, x1), high = std::max(x0, x1);
    if (y0 != y1) {
        const double slope = (x1 - x0) / (y1 - y0);
        const double below = std::min(std::max(row * width - 1, y0), y1) - y0;
        const double above = std::min(std::max(row * width + width + 1, y0), y1) - y0;
        const double a = x0 + slope * below, b = x0 + slope * above;
        low = std::max(low, std::min(a, b) - 2);
        high = std::min(high, std::max(a, b) + 2);
    }
    return {static_cast<std::uint32_t>(low) >> grid.shift, static_cast<std::uint32_t>(high) >> grid.shift};
}

}
