// The areas and first moments of Voronoi cells as far as they lie in a region: Lloyd's method in polygons with holes.
//
// Du, Faber, Gunzburger, Centroidal Voronoi tessellations, SIAM Review 41(4), 1999. The plain twin is
// host/sampling/regions/reference/region_lloyd.cpp, with the same operations in the same order.
//   integrate_cells  the moments of each site's cell in the region
//
// A cell is a list of lines, each with the interval of it that bounds the cell: a further line cuts the intervals, and
// its own is what the others leave of it. No corners are listed, and no order of lines is needed: area and moments are
// sums over triangles between the site and intervals.
//
// Edges of the region are seen from the site: what lies behind one, within the cell, is on the other side of it. Crossing
// an edge from its left, where the region is, ends the region, and from its right begins it. So the part in the region
// is the cell, if the site is inside, less what lies behind each edge that has the site on its left, and with what lies
// behind the others. A site on an edge counts as moved by (e^2, e), with an e smaller than any number.

#pragma OPENCL FP_CONTRACT OFF

#define ALWAYS_INLINE __attribute__((always_inline))

#include "kernels/common/listed_cells.clh"
#include "kernels/common/regions/region_lloyd.h"

/// The grid, and which of its cells are listed: a row's columns ascend from `row_starts` on.
typedef struct
{
    double half_box;
    uint low_x, low_y;
    uint columns, rows;
    uint shift;
    bool is_listed;
    global const uint* row_starts;
    global const uint* listed_columns;
} SiteCells;

typedef struct CellMoments CellMoments;

/// Positions x with normal . x <= bound; the line's own are middle + t * (-normal.y, normal.x), low <= t <= high.
typedef struct
{
    double2 normal, middle;
    double bound, low, high;
} Line;

typedef struct
{
    Line lines[MAX_LINES];
    uint count;
    double squared_farthest; ///< of its corners from the site
} Cell;

ALWAYS_INLINE double2 along(const Line* line) { return (double2)(-line->normal.y, line->normal.x); }
ALWAYS_INLINE double2 place_on(const Line* line, double t) { return line->middle + t * along(line); }
ALWAYS_INLINE double crossed(double2 a, double2 b) { return a.x * b.y - a.y * b.x; }
ALWAYS_INLINE double dotted(double2 a, double2 b) { return a.x * b.x + a.y * b.y; }

/// Keeps what part of low <= t <= high has slope * t <= rest; of parallel lines in one place, nothing.
ALWAYS_INLINE void cut(double rest, double slope, double* low, double* high)
{
    if (slope > 0)
        *high = min(*high, rest / slope);
    else if (slope < 0)
        *low = max(*low, rest / slope);
    else if (rest <= 0)
        *high = *low;
}

ALWAYS_INLINE void cut_by(Line* line, const Line* by)
{
    double low = line->low, high = line->high;
    cut(by->bound - dotted(by->normal, line->middle), dotted(by->normal, along(line)), &low, &high);
    line->low = low;
    line->high = high;
}

void measure_farthest(Cell* cell)
{
    cell->squared_farthest = 0;
    for (uint i = 0; i < cell->count; ++i) {
        const double2 first = place_on(&cell->lines[i], cell->lines[i].low);
        const double2 last = place_on(&cell->lines[i], cell->lines[i].high);
        cell->squared_farthest = max(cell->squared_farthest, max(dotted(first, first), dotted(last, last)));
    }
}

void begin_box(Cell* cell, double half_side)
{
    for (uint i = 0; i < 4; ++i) {
        const double2 normal = (double2)(i == 0 ? 1 : i == 2 ? -1 : 0, i == 1 ? 1 : i == 3 ? -1 : 0);
        const Line line = {normal, half_side * normal, half_side, -half_side, half_side};
        cell->lines[i] = line;
    }
    cell->count = 4;
    measure_farthest(cell);
}

/// Cuts the cell by a line whose interval is not known yet. False: there is no room for it.
bool cut_with(Cell* cell, Line line)
{
    for (uint i = 0; i < cell->count; ++i) cut_by(&line, &cell->lines[i]);
    if (!(line.low < line.high)) return true;
    uint kept = 0;
    for (uint i = 0; i < cell->count; ++i) {
        Line old = cell->lines[i];
        cut_by(&old, &line);
        if (old.low < old.high) cell->lines[kept++] = old;
    }
    cell->count = kept;
    if (kept == MAX_LINES) return false;
    cell->lines[cell->count++] = line;
    measure_farthest(cell);
    return true;
}

/// Cuts the cell by the bisector of its site and another one, which lies there. False: there is no room for it.
bool cut_off(Cell* cell, double2 there)
{
    const double squared = dotted(there, there);
    if (squared == 0 || squared >= 4 * cell->squared_farthest) return true;
    const Line line = {there, 0.5 * there, 0.5 * squared, -DBL_MAX, DBL_MAX};
    return cut_with(cell, line);
}

ALWAYS_INLINE double2 relative(uint2 position, uint2 site)
{
    return (double2)((double)((long)position.x - (long)site.x), (double)((long)position.y - (long)site.y));
}

/// The number of the first cell of a row that is not before a column, up to the end of the row.
ALWAYS_INLINE uint number_of_cell(const SiteCells* grid, uint row, uint column)
{
    if (!grid->is_listed) return row * grid->columns + column;
    return number_of_listed(grid->row_starts, grid->listed_columns, row, column);
}

/// Cuts the cell by the sites of the grid's cells in a row, from one column to another.
bool cut_by_row(Cell* cell, const SiteCells* grid, global const uint* sites, global const uint* starts, uint2 site,
                long row, long first, long last)
{
    if (row < 0 || row >= grid->rows) return true;
    first = max(first, 0l);
    last = min(last, (long)grid->columns - 1);
    if (first > last) return true;
    const uint end = starts[number_of_cell(grid, (uint)row, (uint)last + 1)];
    for (uint i = starts[number_of_cell(grid, (uint)row, (uint)first)]; i < end; ++i)
        if (!cut_off(cell, relative(vload2(i, sites), site))) return false;
    return true;
}

/// Cuts the cell a little beyond an edge that ends the region. There is room for the line.
void cut_beyond(Cell* cell, const SiteCells* grid, uint4 edge, uint2 site)
{
    const double2 begin = relative(edge.xy, site), along_edge = relative(edge.zw, edge.xy);
    const double2 normal = (double2)(along_edge.y, -along_edge.x);
    const double squared = dotted(normal, normal);
    const double bound = dotted(normal, begin) + CLIP_PART * (double)(1u << grid->shift) * sqrt(squared);
    const Line line = {normal, (bound / squared) * normal, bound, -DBL_MAX, DBL_MAX};
    cut_with(cell, line);
}

/// The cell within its box: sites are looked at in rings of the grid's cells, until no farther one matters.
bool find_cell(Cell* cell, const SiteCells* grid, global const uint* sites, global const uint* starts, uint2 site,
               global const uint* edges, global const uint* clips)
{
    begin_box(cell, grid->half_box);
    const uint2 from = site - (uint2)(grid->low_x, grid->low_y);
    if (grid->is_listed) {
        const uint number = number_of_cell(grid, from.y >> grid->shift, from.x >> grid->shift);
        for (uint i = number * MAX_CLIPS; i < (number + 1) * MAX_CLIPS && clips[i] != NO_CLIP; ++i)
            cut_beyond(cell, grid, vload4(clips[i], edges), from);
    }
    const uint width = 1u << grid->shift;
    const uint2 inner = from & (width - 1);
    const uint2 outer = width - inner;
    const double gap = (double)min(min(inner.x, inner.y), min(outer.x, outer.y));
    const long column = from.x >> grid->shift, row = from.y >> grid->shift;
    const long rings = max(grid->columns, grid->rows);
    for (long ring = 0; ring < rings; ++ring) {
        const double nearest = gap + (double)(ring - 1) * (double)width;
        if (ring > 0 && nearest * nearest >= 4 * cell->squared_farthest) break;
        for (long y = row - ring; y <= row + ring; ++y) {
            if (y == row - ring || y == row + ring) {
                if (!cut_by_row(cell, grid, sites, starts, site, y, column - ring, column + ring)) return false;
            } else {
                if (!cut_by_row(cell, grid, sites, starts, site, y, column - ring, column - ring)) return false;
                if (!cut_by_row(cell, grid, sites, starts, site, y, column + ring, column + ring)) return false;
            }
        }
    }
    return true;
}

/// Adds the triangle between the site and two places, times a factor.
ALWAYS_INLINE void add_triangle(CellMoments* sum, double2 a, double2 b, double factor)
{
    const double twice = factor * crossed(a, b);
    sum->twice_area += twice;
    sum->x += twice * (a.x + b.x);
    sum->y += twice * (a.y + b.y);
}

/// The grid's columns that an edge is in, and a little more, within a row. Positions count from the grid's lowest one.
ALWAYS_INLINE void find_columns(const SiteCells* grid, uint4 edge, uint row, uint* first, uint* last)
{
    const bool goes_up = edge.y <= edge.w;
    const double x0 = goes_up ? edge.x : edge.z, y0 = goes_up ? edge.y : edge.w;
    const double x1 = goes_up ? edge.z : edge.x, y1 = goes_up ? edge.w : edge.y;
    const double width = 1u << grid->shift;
    double low = min(x0, x1), high = max(x0, x1);
    if (y0 != y1) {
        const double slope = (x1 - x0) / (y1 - y0);
        const double below = min(max((double)row * width - 1, y0), y1) - y0;
        const double above = min(max((double)row * width + width + 1, y0), y1) - y0;
        const double a = x0 + slope * below, b = x0 + slope * above;
        low = max(low, min(a, b) - 2);
        high = min(high, max(a, b) + 2);
    }
    *first = (uint)low >> grid->shift;
    *last = (uint)high >> grid->shift;
}

/// A part of the grid, its last column and row included.
typedef struct
{
    uint first_column, last_column, first_row, last_row;
} Block;

ALWAYS_INLINE uint bounded_cell(double position, uint shift, uint count)
{
    const double cell = floor(position / (double)(1u << shift));
    return (uint)min(max(cell, 0.0), (double)(count - 1));
}

/// The grid's cells that a cell touches.
void find_block(const Cell* cell, const SiteCells* grid, uint2 site, Block* block)
{
    double2 low = DBL_MAX, high = -DBL_MAX;
    for (uint i = 0; i < cell->count; ++i) {
        const double2 first = place_on(&cell->lines[i], cell->lines[i].low);
        const double2 last = place_on(&cell->lines[i], cell->lines[i].high);
        low = (double2)(min(low.x, min(first.x, last.x)), min(low.y, min(first.y, last.y)));
        high = (double2)(max(high.x, max(first.x, last.x)), max(high.y, max(first.y, last.y)));
    }
    const double x = (double)(site.x - grid->low_x), y = (double)(site.y - grid->low_y);
    block->first_column = bounded_cell(x + low.x - 1, grid->shift, grid->columns);
    block->last_column = bounded_cell(x + high.x + 1, grid->shift, grid->columns);
    block->first_row = bounded_cell(y + low.y - 1, grid->shift, grid->rows);
    block->last_row = bounded_cell(y + high.y + 1, grid->shift, grid->rows);
}

/// Is this the first of the block's cells that list the edge? Each edge is looked at there alone.
bool is_first_listed(const SiteCells* grid, uint4 edge, const Block* block, uint column, uint row)
{
    for (uint y = max(block->first_row, min(edge.y, edge.w) >> grid->shift); y <= row; ++y) {
        uint first, last;
        find_columns(grid, edge, y, &first, &last);
        if (last < block->first_column || first > block->last_column) continue;
        return y == row && max(first, block->first_column) == column;
    }
    return false;
}

/// Does the edge have the site on its left? On its line, it is moved.
ALWAYS_INLINE bool is_on_left(uint4 edge, uint2 site)
{
    const long dx = (long)edge.z - (long)edge.x, dy = (long)edge.w - (long)edge.y;
    const long side = dx * ((long)site.y - (long)edge.y) - dy * ((long)site.x - (long)edge.x);
    if (side != 0) return side > 0;
    return dx != 0 ? dx > 0 : dy < 0;
}

/// The direction in which a place is seen: from a site that lies there, moved as it is, downwards.
ALWAYS_INLINE double2 sight(double2 place)
{
    return place.x == 0 && place.y == 0 ? (double2)(0, -1) : place;
}

/// Adds what lies behind an edge, or takes it away where the site is on the edge's left.
void look_behind(CellMoments* sum, const Cell* cell, uint4 edge, uint2 site)
{
    double2 a = relative(edge.xy, site), b = relative(edge.zw, site);
    double low = 0, high = 1;
    for (uint i = 0; i < cell->count; ++i)
        cut(cell->lines[i].bound - dotted(cell->lines[i].normal, a), dotted(cell->lines[i].normal, b - a), &low, &high);
    if (!(low < high)) return;
    const double2 first = a + low * (b - a), last = a + high * (b - a);
    const bool is_left = is_on_left(edge, site);
    const double factor = is_left ? -1 : 1;
    a = is_left ? first : last; // counterclockwise
    b = is_left ? last : first;
    add_triangle(sum, a, b, -factor);
    const double2 from = sight(a), to = sight(b);
    for (uint i = 0; i < cell->count; ++i) {
        const Line* line = &cell->lines[i];
        low = line->low;
        high = line->high;
        cut(crossed(from, line->middle), -crossed(from, along(line)), &low, &high);
        cut(crossed(line->middle, to), -crossed(along(line), to), &low, &high);
        if (low < high) add_triangle(sum, place_on(line, low), place_on(line, high), factor);
    }
}

/// One work-item owns one site. `sites` are sorted by the grid's cells, which begin at `starts`; `is_inside` tells of
/// each site, moved as above; `edges` count from the grid's lowest position, and the cells' lists of their numbers begin
/// at `edge_starts`; `row_starts` and `listed_columns` are those of listed cells, and `clips` their edges that end the
/// region.
kernel void integrate_cells(struct SiteGrid sites_grid, global const uint* sites, global const uint* starts,
                            global const uchar* is_inside, global const uint* edges, global const uint* edge_starts,
                            global const uint* edge_numbers, global const uint* row_starts,
                            global const uint* listed_columns, global const uint* clips,
                            global CellMoments* moments)
{
    const uint id = get_global_id(0);
    if (id >= sites_grid.sites) return;
    const SiteCells grid = {sites_grid.half_box, sites_grid.low_x, sites_grid.low_y, sites_grid.columns,
                            sites_grid.rows, sites_grid.shift, sites_grid.is_listed != 0, row_starts, listed_columns};
    const uint2 site = vload2(id, sites);
    const uint2 lowest = (uint2)(grid.low_x, grid.low_y);
    Cell cell;
    CellMoments sum = {0, 0, 0, 0, 0};
    sum.is_known = find_cell(&cell, &grid, sites, starts, site, edges, clips);
    if (sum.is_known) {
        if (is_inside[id])
            for (uint i = 0; i < cell.count; ++i)
                add_triangle(&sum, place_on(&cell.lines[i], cell.lines[i].low),
                             place_on(&cell.lines[i], cell.lines[i].high), 1);
        Block block;
        find_block(&cell, &grid, site, &block);
        for (uint row = block.first_row; row <= block.last_row; ++row) {
            const uint end = number_of_cell(&grid, row, block.last_column + 1);
            for (uint number = number_of_cell(&grid, row, block.first_column); number < end; ++number) {
                const uint column = grid.is_listed ? listed_columns[number] : number - row * grid.columns;
                for (uint i = edge_starts[number]; i < edge_starts[number + 1]; ++i) {
                    const uint4 edge = vload4(edge_numbers[i], edges);
                    if (is_first_listed(&grid, edge, &block, column, row))
                        look_behind(&sum, &cell, edge, site - lowest);
                }
            }
        }
    }
    moments[id] = sum;
}
