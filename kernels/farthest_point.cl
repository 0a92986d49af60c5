// Farthest point optimization: every point moves to where its neighbours leave the largest empty circle.
//
// Schloemer, Heck, Deussen, Farthest-point optimized point sets with maximized minimum distance, HPG 2011, the local
// variant; see host/sampling/optimized/farthest_point.hpp. Cells of one color of the grid are worked on side by side,
// the points of a cell one after the other, in order of their ids: no two of the cells see each other's points, so the
// result does not depend on the schedule.
//
// Points are sorted by grid cells, see point_grid.cl.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/farthest_point.h"
#include "kernels/common/polygon.clh"

#define WINDOW_SIDE (2 * NEIGHBOUR_REACH + 1)
#define WINDOW_CELLS (WINDOW_SIDE * WINDOW_SIDE)
#define MIDDLE_CELL (WINDOW_CELLS / 2)

// A neighbour is known by its cell in the window and its place in the order of points.
#define INDEX_BITS 27

/// The cells around a cell, and its borders.
typedef struct
{
    uint begin[WINDOW_CELLS], end[WINDOW_CELLS];
    double2 repetition[WINDOW_CELLS];
    double2 low, high;
    double width; // of a cell
} Window;

Window window_around(uint cell_x, uint cell_y, uint grid_size, global const uint* starts)
{
    Window window;
    for (int slot = 0; slot < WINDOW_CELLS; ++slot) {
        int turns_x, turns_y;
        const uint x = turned_cell(cell_x, slot % WINDOW_SIDE - NEIGHBOUR_REACH, (int)grid_size, &turns_x);
        const uint y = turned_cell(cell_y, slot / WINDOW_SIDE - NEIGHBOUR_REACH, (int)grid_size, &turns_y);
        window.begin[slot] = starts[y * grid_size + x];
        window.end[slot] = starts[y * grid_size + x + 1];
        window.repetition[slot] = (double2)(turns_x, turns_y);
    }
    const double width = 1.0 / grid_size;
    window.width = width;
    window.low = (double2)((int)cell_x - NEIGHBOUR_REACH, (int)cell_y - NEIGHBOUR_REACH) * width;
    window.high = (double2)(cell_x + NEIGHBOUR_REACH + 1, cell_y + NEIGHBOUR_REACH + 1) * width;
    return window;
}

/// The state of cutting a Voronoi cell by cells of the window.
typedef struct
{
    double2 place;
    uint own, left_out;
    double squared_radius; // of what is left of the Voronoi cell
} Cutting;

/// Cuts a Voronoi cell by the points of a cell of the window. False where it has too many vertices.
bool cut_by_cell(const Window* window, global const double2* positions, uint slot, Cutting* cutting, Polygon* cell)
{
    for (uint i = window->begin[slot]; i < window->end[slot]; ++i) {
        const uint neighbour = slot << INDEX_BITS | i;
        if (i == cutting->left_out || neighbour == cutting->own) continue;
        const double2 to = positions[i] + window->repetition[slot] - cutting->place;
        if (to.x * to.x + to.y * to.y >= 4 * cutting->squared_radius) continue;
        if (!cut(cell, to.x, to.y, neighbour)) return false;
        cutting->squared_radius = squared_radius_of(cell);
    }
    return true;
}

/// The place of a coordinate in a row of cells of the window.
int window_column(double offset, double width)
{
    return clamp((int)floor(offset / width), 0, WINDOW_SIDE - 1);
}

/// The Voronoi cell of a place among the points of the window, but for one that is left out. False where it has too
/// many vertices. Cells of the window come ring by ring around the place, until all others are too far away; that in the
/// middle comes first, as its points may have moved out of it.
bool cell_without(const Window* window, global const double2* positions, double2 place, uint own, uint left_out,
                  Polygon* cell)
{
    const double far = (window->high.x - window->low.x) + (window->high.y - window->low.y);
    *cell = square_around(far);
    Cutting cutting = {place, own, left_out, 2 * far * far};
    if (!cut_by_cell(window, positions, MIDDLE_CELL, &cutting, cell)) return false;
    const int column = window_column(place.x - window->low.x, window->width);
    const int row = window_column(place.y - window->low.y, window->width);
    for (int ring = 0; ring < WINDOW_SIDE; ++ring) {
        const double gap = (ring - 1) * window->width - RING_SLACK;
        if (gap > 0 && gap * gap >= 4 * cutting.squared_radius) break;
        for (int y = max(row - ring, 0); y <= min(row + ring, WINDOW_SIDE - 1); ++y) {
            const bool is_whole = y == row - ring || y == row + ring;
            for (int x = column - ring; x <= column + ring; x += is_whole || ring == 0 ? 1 : 2 * ring) {
                const int slot = y * WINDOW_SIDE + x;
                if (x < 0 || x >= WINDOW_SIDE || slot == MIDDLE_CELL) continue;
                if (!cut_by_cell(window, positions, slot, &cutting, cell)) return false;
            }
        }
    }
    return true;
}

/// The squared distance to the nearest other point of the window.
double squared_near_of(const Window* window, global const double2* positions, uint site)
{
    double near = INFINITY;
    for (uint slot = 0; slot < WINDOW_CELLS; ++slot) {
        for (uint i = window->begin[slot]; i < window->end[slot]; ++i) {
            if (i == site) continue;
            const double2 to = positions[i] + window->repetition[slot] - positions[site];
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
    if (!cell_without(window, positions, farthest, NO_NEIGHBOUR, site, &own)) return farthest;
    for (uint edge = 0; edge < own.count; ++edge) {
        const uint neighbour = own.neighbour[edge];
        if (neighbour == NO_NEIGHBOUR) continue;
        const double2 place =
            positions[neighbour & ((1u << INDEX_BITS) - 1)] + window->repetition[neighbour >> INDEX_BITS];
        Polygon cell;
        if (!cell_without(window, positions, place, neighbour, site, &cell)) continue;
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

/// The nearest multiple of 2^-32 on the torus.
double snapped(double coordinate)
{
    const double nearest = floor(coordinate * 4294967296.0 + 0.5) / 4294967296.0;
    return nearest - floor(nearest);
}

/// One work-item owns one cell of a color, and moves those of its points that have not moved in this sweep, the number of
/// which `last_sweeps` tells by id. After it, points are no longer sorted.
kernel void move_to_farthest(global double2* positions, global const uint* ids, global const uint* starts,
                             uint grid_size, uint color, uint sweep, global uint* last_sweeps)
{
    const uint id = get_global_id(0);
    const uint row = grid_size / COLORS;
    if (id >= row * row) return;
    const uint cell_x = id % row * COLORS + color % COLORS;
    const uint cell_y = id / row * COLORS + color / COLORS;
    const Window window = window_around(cell_x, cell_y, grid_size, starts);
    const uint cell = cell_y * grid_size + cell_x;
    for (uint site = starts[cell]; site < starts[cell + 1]; ++site) {
        if (last_sweeps[ids[site]] == sweep) continue;
        last_sweeps[ids[site]] = sweep;
        const double2 place = farthest_place(&window, positions, site);
        positions[site] = (double2)(snapped(place.x), snapped(place.y));
    }
}
