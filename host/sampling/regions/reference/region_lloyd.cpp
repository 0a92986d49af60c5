// Cells of sites in a region, plain and sequential: what the kernel must reproduce, and cells of any number of lines.
#include "host/sampling/regions/region_lloyd.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab::reference {
namespace {

using contract::region_lloyd::CellMoments;

struct CellVector
{
    double x = 0, y = 0;

    friend CellVector operator+(const CellVector& a, const CellVector& b) { return {a.x + b.x, a.y + b.y}; }
    friend CellVector operator-(const CellVector& a, const CellVector& b) { return {a.x - b.x, a.y - b.y}; }
    friend CellVector operator*(double t, const CellVector& a) { return {t * a.x, t * a.y}; }
};

double crossed(const CellVector& a, const CellVector& b) { return a.x * b.y - a.y * b.x; }
double dotted(const CellVector& a, const CellVector& b) { return a.x * b.x + a.y * b.y; }

/// Positions x with normal . x <= bound; its own ones from `low` to `high`.
struct CellLine
{
    CellVector normal, middle;
    double bound = 0, low = 0, high = 0;

    CellVector along() const { return {-normal.y, normal.x}; }
    CellVector at(double t) const { return middle + t * along(); }
    CellVector first() const { return at(low); }
    CellVector last() const { return at(high); }
};

/// Keeps what part of low <= t <= high has slope * t <= rest; of parallel lines in one place, nothing.
void cut(double rest, double slope, double& low, double& high)
{
    if (slope > 0)
        high = std::min(high, rest / slope);
    else if (slope < 0)
        low = std::max(low, rest / slope);
    else if (rest <= 0)
        high = low;
}

void cut_by(CellLine& line, const CellLine& by)
{
    cut(by.bound - dotted(by.normal, line.middle), dotted(by.normal, line.along()), line.low, line.high);
}

class RegionCell
{
public:
    explicit RegionCell(double half)
    {
        for (const CellVector& normal : {CellVector{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
            lines_.push_back({normal, half * normal, half, -half, half});
        measure_farthest();
    }

    const std::vector<CellLine>& lines() const { return lines_; }
    double squared_farthest() const { return squared_farthest_; }

    void cut_off(const CellVector& there)
    {
        const double squared = dotted(there, there);
        if (squared == 0 || squared >= 4 * squared_farthest_) return;
        constexpr double most = std::numeric_limits<double>::max();
        cut_with({there, 0.5 * there, 0.5 * squared, -most, most});
    }

    void cut_with(CellLine line)
    {
        for (const CellLine& other : lines_) cut_by(line, other);
        if (!(line.low < line.high)) return;
        for (CellLine& other : lines_) cut_by(other, line);
        std::erase_if(lines_, [](const CellLine& other) { return !(other.low < other.high); });
        lines_.push_back(line);
        measure_farthest();
    }

private:
    void measure_farthest()
    {
        squared_farthest_ = 0;
        for (const CellLine& line : lines_)
            squared_farthest_ = std::max(
                squared_farthest_, std::max(dotted(line.first(), line.first()), dotted(line.last(), line.last())));
    }

    std::vector<CellLine> lines_;
    double squared_farthest_ = 0;
};

CellVector relative(const TorusPoint<2>& position, const TorusPoint<2>& site)
{
    return {static_cast<double>(std::int64_t{position[0]} - std::int64_t{site[0]}),
            static_cast<double>(std::int64_t{position[1]} - std::int64_t{site[1]})};
}

/// Cuts the cell a little beyond an edge that ends the region.
void cut_beyond(RegionCell& cell, const contract::region_lloyd::SiteGrid& grid, const FixedEdge& edge,
                const TorusPoint<2>& site)
{
    constexpr double most = std::numeric_limits<double>::max();
    const CellVector begin = relative({edge[0], edge[1]}, site),
                     along = relative({edge[2], edge[3]}, {edge[0], edge[1]});
    const CellVector normal{along.y, -along.x};
    const double squared = dotted(normal, normal);
    const double bound =
        dotted(normal, begin) + contract::region_lloyd::CLIP_PART * (1u << grid.shift) * std::sqrt(squared);
    cell.cut_with({normal, (bound / squared) * normal, bound, -most, most});
}

/// Cuts by the sites of ring after ring of the grid's cells, until no farther one matters.
RegionCell cell_of(const SiteGrid& sites, const TorusPoint<2>& site)
{
    const contract::region_lloyd::SiteGrid& grid = sites.grid();
    RegionCell cell(grid.half_box);
    const TorusPoint<2> from{site[0] - grid.low_x, site[1] - grid.low_y};
    for (const std::uint32_t edge : sites.clips_around(from)) cut_beyond(cell, grid, sites.edges()[edge], from);
    const std::uint32_t width = 1u << grid.shift;
    const TorusPoint<2> inner{from[0] & (width - 1), from[1] & (width - 1)};
    const double gap = std::min(std::min(inner[0], inner[1]), std::min(width - inner[0], width - inner[1]));
    const std::int64_t column = from[0] >> grid.shift, row = from[1] >> grid.shift;
    const auto cut_by_row = [&](std::int64_t y, std::int64_t first, std::int64_t last) {
        if (y < 0 || y >= grid.rows) return;
        first = std::max<std::int64_t>(first, 0);
        last = std::min<std::int64_t>(last, grid.columns - 1);
        if (first > last) return;
        const auto in_row = static_cast<std::uint32_t>(y);
        const std::size_t begin = sites.number_of_cell(in_row, static_cast<std::uint32_t>(first));
        const std::size_t end = sites.number_of_cell(in_row, static_cast<std::uint32_t>(last + 1));
        for (std::uint32_t i = sites.starts()[begin]; i < sites.starts()[end]; ++i)
            cell.cut_off(relative(sites.sites()[i], site));
    };
    for (std::int64_t ring = 0; ring < std::max(grid.columns, grid.rows); ++ring) {
        const double nearest = gap + static_cast<double>(ring - 1) * width;
        if (ring > 0 && nearest * nearest >= 4 * cell.squared_farthest()) break;
        for (std::int64_t y = row - ring; y <= row + ring; ++y) {
            if (y == row - ring || y == row + ring) {
                cut_by_row(y, column - ring, column + ring);
            } else {
                cut_by_row(y, column - ring, column - ring);
                cut_by_row(y, column + ring, column + ring);
            }
        }
    }
    return cell;
}

void add_triangle(CellMoments& sum, const CellVector& a, const CellVector& b, double factor)
{
    const double twice = factor * crossed(a, b);
    sum.twice_area += twice;
    sum.x += twice * (a.x + b.x);
    sum.y += twice * (a.y + b.y);
}

/// Cells of the grid, from the first to the last column and row.
struct GridBlock
{
    std::uint32_t first_column, last_column, first_row, last_row;
};

std::uint32_t bounded_cell(double position, std::uint32_t shift, std::uint32_t count)
{
    const double cell = std::floor(position / (1u << shift));
    return static_cast<std::uint32_t>(std::min(std::max(cell, 0.0), double{1} * (count - 1)));
}

GridBlock block_of(const RegionCell& cell, const contract::region_lloyd::SiteGrid& grid, const TorusPoint<2>& site)
{
    constexpr double most = std::numeric_limits<double>::max();
    CellVector low{most, most}, high{-most, -most};
    for (const CellLine& line : cell.lines()) {
        const CellVector a = line.first(), b = line.last();
        low = {std::min(low.x, std::min(a.x, b.x)), std::min(low.y, std::min(a.y, b.y))};
        high = {std::max(high.x, std::max(a.x, b.x)), std::max(high.y, std::max(a.y, b.y))};
    }
    const double x = site[0] - grid.low_x, y = site[1] - grid.low_y;
    return {bounded_cell(x + low.x - 1, grid.shift, grid.columns),
            bounded_cell(x + high.x + 1, grid.shift, grid.columns), bounded_cell(y + low.y - 1, grid.shift, grid.rows),
            bounded_cell(y + high.y + 1, grid.shift, grid.rows)};
}

/// Is this the first of the block's cells that list the edge?
bool is_first_listed(const contract::region_lloyd::SiteGrid& grid, const FixedEdge& edge, const GridBlock& block,
                     std::uint32_t column, std::uint32_t row)
{
    for (std::uint32_t y = std::max(block.first_row, std::min(edge[1], edge[3]) >> grid.shift); y <= row; ++y) {
        const auto [first, last] = columns_of(grid, edge, y);
        if (last < block.first_column || first > block.last_column) continue;
        return y == row && std::max(first, block.first_column) == column;
    }
    return false;
}

/// Does the edge have the site on its left? On its line, it is moved by (e^2, e).
bool is_on_left(const FixedEdge& edge, const TorusPoint<2>& site)
{
    const std::int64_t dx = std::int64_t{edge[2]} - edge[0], dy = std::int64_t{edge[3]} - edge[1];
    const std::int64_t side = dx * (std::int64_t{site[1]} - edge[1]) - dy * (std::int64_t{site[0]} - edge[0]);
    if (side != 0) return side > 0;
    return dx != 0 ? dx > 0 : dy < 0;
}

/// The direction in which a place is seen: from a site that lies there, moved as it is, downwards.
CellVector sight(const CellVector& place) { return place.x == 0 && place.y == 0 ? CellVector{0, -1} : place; }

/// Adds what lies behind an edge, or takes it away where the site is on the edge's left.
void look_behind(CellMoments& sum, const RegionCell& cell, const FixedEdge& edge, const TorusPoint<2>& site)
{
    const CellVector begin = relative({edge[0], edge[1]}, site), end = relative({edge[2], edge[3]}, site);
    double low = 0, high = 1;
    for (const CellLine& line : cell.lines())
        cut(line.bound - dotted(line.normal, begin), dotted(line.normal, end - begin), low, high);
    if (!(low < high)) return;
    const CellVector first = begin + low * (end - begin), last = begin + high * (end - begin);
    const bool is_left = is_on_left(edge, site);
    const double factor = is_left ? -1 : 1;
    const CellVector a = is_left ? first : last, b = is_left ? last : first; // counterclockwise
    add_triangle(sum, a, b, -factor);
    const CellVector from = sight(a), to = sight(b);
    for (CellLine line : cell.lines()) {
        cut(crossed(from, line.middle), -crossed(from, line.along()), line.low, line.high);
        cut(crossed(line.middle, to), -crossed(line.along(), to), line.low, line.high);
        if (line.low < line.high) add_triangle(sum, line.first(), line.last(), factor);
    }
}

}

CellMoments integrate_cell(const SiteGrid& sites, std::size_t number)
{
    const contract::region_lloyd::SiteGrid& grid = sites.grid();
    const TorusPoint<2> site = sites.sites()[number];
    const RegionCell cell = cell_of(sites, site);
    CellMoments sum{.twice_area = 0, .x = 0, .y = 0, .is_known = 1, .unused = 0};
    if (sites.is_inside()[number] != 0)
        for (const CellLine& line : cell.lines()) add_triangle(sum, line.first(), line.last(), 1);
    const GridBlock block = block_of(cell, grid, site);
    for (std::uint32_t row = block.first_row; row <= block.last_row; ++row) {
        const std::size_t end = sites.number_of_cell(row, block.last_column + 1);
        for (std::size_t place = sites.number_of_cell(row, block.first_column); place < end; ++place) {
            const std::uint32_t column = sites.column_of(place, row);
            for (std::uint32_t i = sites.edge_starts()[place]; i < sites.edge_starts()[place + 1]; ++i) {
                const FixedEdge& edge = sites.edges()[sites.edge_numbers()[i]];
                if (is_first_listed(grid, edge, block, column, row))
                    look_behind(sum, cell, edge, {site[0] - grid.low_x, site[1] - grid.low_y});
            }
        }
    }
    return sum;
}

std::vector<CellMoments> integrate_cells(const SiteGrid& grid)
{
    std::vector<CellMoments> moments;
    for (std::size_t i = 0; i < grid.sites().size(); ++i) moments.push_back(integrate_cell(grid, i));
    return moments;
}

}
