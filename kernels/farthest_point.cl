// Farthest point optimization: every point moves to where its neighbours leave the largest empty circle.
//
// Schloemer, Heck, Deussen, Farthest-point optimized point sets with maximized minimum distance, HPG 2011, the local
// variant; see host/sampling/optimized/farthest_point.hpp. Cells of one color of the grid are worked on side by side,
// the points of a cell one after the other, in order of their ids: no two of the cells see or reach the same places, so
// the result does not depend on the schedule, and is that of one point after the other.
//
// Points are sorted by grid cells, see point_grid.cl.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/optimized/farthest_point.h"
#include "kernels/common/polygon.clh"

#define WINDOW_SIDE (2 * NEIGHBOUR_REACH + 1)

// Rows of a window go around the torus twice where the grid has three cells.
#define MAX_SEGMENTS (3 * WINDOW_SIDE)

// A neighbour is known by its segment of the window and its place in the order of points.
#define INDEX_BITS 27

// The reach of the first batch of neighbours, of some 14 points in even sets: squared, in widths of cells.
#define FIRST_REACH 1.7

// Points of a row of cells are as far away as the row is, less what rounding does.
#define ROW_SLACK 1e-9

/// The cells around a cell, row by row, and their borders. The points of neighbouring cells of a row follow each other,
/// up to the torus' border: a segment.
typedef struct
{
    uint begin[MAX_SEGMENTS], end[MAX_SEGMENTS];
    double2 repetition[MAX_SEGMENTS];
    uint first[WINDOW_SIDE + 1]; // segments of rows
    double2 low, high;
    double width; // of a cell
} Window;

Window window_around(uint cell_x, uint cell_y, uint grid_size, global const uint* starts)
{
    Window window;
    uint segment = 0;
    for (int row = 0; row < WINDOW_SIDE; ++row) {
        window.first[row] = segment;
        int turns_y;
        const uint y = turned_cell(cell_y, row - NEIGHBOUR_REACH, (int)grid_size, &turns_y);
        for (int column = 0; column < WINDOW_SIDE; ++column) {
            int turns_x;
            const uint x = turned_cell(cell_x, column - NEIGHBOUR_REACH, (int)grid_size, &turns_x);
            if (column == 0 || x == 0) {
                window.begin[segment] = starts[y * grid_size + x];
                window.repetition[segment++] = (double2)(turns_x, turns_y);
            }
            window.end[segment - 1] = starts[y * grid_size + x + 1];
        }
    }
    window.first[WINDOW_SIDE] = segment;
    const double width = 1.0 / grid_size;
    window.width = width;
    window.low = (double2)((int)cell_x - NEIGHBOUR_REACH, (int)cell_y - NEIGHBOUR_REACH) * width;
    window.high = (double2)(cell_x + NEIGHBOUR_REACH + 1, cell_y + NEIGHBOUR_REACH + 1) * width;
    return window;
}

/// Some points of the window around a place, nearest first, and where those that are not among them begin.
typedef struct
{
    double squared[BATCH]; // distances
    uint neighbour[BATCH], count;
    double until; // squared distance
} NearPoints;

double2 from_place(const Window* window, global const double2* positions, uint neighbour, double2 place)
{
    return positions[neighbour & ((1u << INDEX_BITS) - 1)] + window->repetition[neighbour >> INDEX_BITS] - place;
}

/// Is a row of the window nearer than the root of `squared`? That in the middle always is, as points of the cell in it
/// may have moved out of it.
bool is_row_near(const Window* window, int row, double y, double squared)
{
    const double low = window->low.y + row * window->width;
    const double gap = max(low - y, y - (low + window->width)) - ROW_SLACK;
    return row == NEIGHBOUR_REACH || gap <= 0 || gap * gap < squared;
}

/// The nearest of the points of the window, but for two, whose squared distances are at least `from` and less than
/// `until`.
void find_near(const Window* window, global const double2* positions, double2 place, uint own, uint left_out,
               double from, double until, NearPoints* near)
{
    uint count = 0;
    for (int row = 0; row < WINDOW_SIDE; ++row) {
        if (!is_row_near(window, row, place.y, until)) continue;
        for (uint segment = window->first[row]; segment < window->first[row + 1]; ++segment) {
            const double2 corner = window->repetition[segment] - place;
            const uint end = window->end[segment];
            for (uint i = window->begin[segment]; i < end; ++i) {
                const double2 to = positions[i] + corner;
                const double squared = to.x * to.x + to.y * to.y;
                if (!(squared >= from && squared < until)) continue;
                const uint neighbour = segment << INDEX_BITS | i;
                if (i == left_out || neighbour == own) continue;
                uint k = count;
                if (k == BATCH) {
                    until = max(squared, near->squared[--k]);
                    if (squared == until) continue;
                } else {
                    ++count;
                }
                for (; k > 0 && near->squared[k - 1] > squared; --k) {
                    near->squared[k] = near->squared[k - 1];
                    near->neighbour[k] = near->neighbour[k - 1];
                }
                near->squared[k] = squared;
                near->neighbour[k] = neighbour;
            }
        }
    }
    while (count > 0 && near->squared[count - 1] >= until) --count;
    near->count = count;
    near->until = until;
}

/// The Voronoi cell of a place among the points of the window, but for one that is left out. False where no vertex is
/// farther than the root of `least`, or there are too many of them. The nearest points cut first, some at a time.
bool cell_without(const Window* window, global const double2* positions, double2 place, uint own, uint left_out,
                  double least, Polygon* cell)
{
    const double far = (window->high.x - window->low.x) + (window->high.y - window->low.y);
    *cell = square_around(far);
    double squared_radius = 2 * far * far;
    NearPoints near;
    near.until = 0;
    for (double until = FIRST_REACH * window->width * window->width; near.until < 4 * squared_radius;
         until = 4 * squared_radius) {
        const double from = near.until;
        find_near(window, positions, place, own, left_out, from, until, &near);
        if (near.until == from) return false; // more than a batch of points at one distance
        for (uint k = 0; k < near.count && near.squared[k] < 4 * squared_radius; ++k) {
            const double2 to = from_place(window, positions, near.neighbour[k], place);
            if (!cut(cell, to.x, to.y, near.neighbour[k])) return false;
            squared_radius = squared_radius_of(cell);
            if (squared_radius <= least) return false;
        }
    }
    return true;
}

/// The squared distance to the nearest other point of the window.
double squared_near_of(const Window* window, global const double2* positions, uint site)
{
    double near = INFINITY;
    for (uint segment = 0; segment < window->first[WINDOW_SIDE]; ++segment) {
        const double2 corner = window->repetition[segment] - positions[site];
        for (uint i = window->begin[segment]; i < window->end[segment]; ++i) {
            if (i == site) continue;
            const double2 to = positions[i] + corner;
            const double squared = to.x * to.x + to.y * to.y;
            near = squared < near ? squared : near;
        }
    }
    return near;
}

/// Is a circle inside of the window, so that points outside of that are not in it?
bool is_inside(const Window* window, double2 centre, double radius)
{
    return centre.x - radius >= window->low.x && centre.x + radius <= window->high.x &&
           centre.y - radius >= window->low.y && centre.y + radius <= window->high.y;
}

/// The vertex of the cells of a point's Voronoi neighbours, without the point, that is farthest from all others, if that
/// is farther than the point is.
double2 farthest_place(const Window* window, global const double2* positions, uint site)
{
    double2 farthest = positions[site];
    double most = squared_near_of(window, positions, site);
    Polygon own;
    if (!cell_without(window, positions, farthest, NO_NEIGHBOUR, site, 0, &own)) return farthest;
    for (uint edge = 0; edge < own.count; ++edge) {
        const uint neighbour = own.neighbour[edge];
        if (neighbour == NO_NEIGHBOUR) continue;
        const double2 place = from_place(window, positions, neighbour, (double2)(0, 0));
        Polygon cell;
        if (!cell_without(window, positions, place, neighbour, site, most, &cell)) continue;
        for (uint k = 0; k < cell.count; ++k) {
            const double squared = cell.x[k] * cell.x[k] + cell.y[k] * cell.y[k];
            const double2 centre = place + (double2)(cell.x[k], cell.y[k]);
            if (!(squared > most) || !is_inside(window, centre, sqrt(squared))) continue;
            most = squared;
            farthest = centre;
        }
    }
    return farthest;
}

/// The nearest multiple of 2^-32.
double snapped(double coordinate)
{
    return floor(coordinate * 4294967296.0 + 0.5) / 4294967296.0;
}

/// One work-item owns one cell of a color, and moves those of its points that have not moved in this sweep, the number of
/// which `last_sweeps` tells by id. After it, points are no longer sorted.
kernel void move_to_farthest(global double2* positions, global const uint* ids, global const uint* starts,
                             uint grid_size, uint color, uint sweep, global uint* last_sweeps)
{
    const uint id = get_global_id(0);
    const uint colors = min((uint)COLORS, grid_size);
    const uint row = grid_size / colors;
    if (id >= row * row) return;
    const uint cell_x = id % row * colors + color % colors;
    const uint cell_y = id / row * colors + color / colors;
    const Window window = window_around(cell_x, cell_y, grid_size, starts);
    const uint cell = cell_y * grid_size + cell_x;
    for (uint site = starts[cell]; site < starts[cell + 1]; ++site) {
        if (last_sweeps[ids[site]] == sweep) continue;
        last_sweeps[ids[site]] = sweep;
        const double2 place = farthest_place(&window, positions, site);
        positions[site] = (double2)(snapped(place.x), snapped(place.y));
    }
    // Until now they were where the window is, so that the points of the cell saw each other across the torus' borders.
    for (uint site = starts[cell]; site < starts[cell + 1]; ++site) positions[site] -= floor(positions[site]);
}
