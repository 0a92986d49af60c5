// Averaged tiles: displacements of points to the centroids of their Voronoi cells, in the mean of all surroundings of
// their tile, or in one.
//
// Hiller, Deussen and Keller, Tiled blue noise samples, 2001; Cohen and others, Wang tiles for image and texture
// generation, 2003, section 3.3. The plain twin, with the same bytes, is
// host/tile_sampling/wang_tiles/averaged_tiles.cpp. A work-item owns a point. Cells are of double precision, their
// centroids are rounded to units, and sums of these are integers.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tile_sampling/averaged_tiles.h"
#include "kernels/common/polygon.clh"

/// A cell, and which points can change it.
typedef struct
{
    Polygon polygon;
    double squared_radius;
    bool is_known; ///< false: it has too many corners
} Cell;

void begin_cell(Cell* cell)
{
    const double r = CELL_REACH;
    // Compilers put a literal of constant arrays outside of the function, where SPIR-V allows no such variable.
    for (uint i = 0; i < 4; ++i) {
        cell->polygon.x[i] = i == 1 || i == 2 ? r : -r;
        cell->polygon.y[i] = i < 2 ? -r : r;
        cell->polygon.neighbour[i] = NO_NEIGHBOUR;
    }
    cell->polygon.count = 4;
    cell->squared_radius = squared_radius_of(&cell->polygon);
    cell->is_known = true;
}

/// Cuts by the points of a tile so many tiles away, without the point `but`.
void cut_by_tile(Cell* cell, global const int2* points, uint count, int2 centre, int x, int y, uint but)
{
    for (uint i = 0; i < count && cell->is_known; ++i) {
        if (i == but) continue;
        const double to_x = points[i].x + x * TILE_UNITS - centre.x;
        const double to_y = points[i].y + y * TILE_UNITS - centre.y;
        if (!(to_x * to_x + to_y * to_y < 4 * cell->squared_radius)) continue;
        cell->is_known = cut(&cell->polygon, to_x, to_y, i);
        cell->squared_radius = squared_radius_of(&cell->polygon);
    }
}

/// The centroid of a cell, rounded to units; its point where it has no area.
int2 rounded_centroid(const Polygon* polygon)
{
    double area = 0, x = 0, y = 0;
    for (uint i = 0; i < polygon->count; ++i) {
        const uint j = i + 1 < polygon->count ? i + 1 : 0;
        const double cross_product = polygon->x[i] * polygon->y[j] - polygon->y[i] * polygon->x[j];
        area += cross_product;
        x += cross_product * (polygon->x[i] + polygon->x[j]);
        y += cross_product * (polygon->y[i] + polygon->y[j]);
    }
    if (!(area > 0)) return (int2)(0);
    return (int2)((int)rint(x / area / 3), (int)rint(y / area / 3));
}

/// Tells whether no point outside of a rectangle around the centre can reach into the cell.
bool is_known_from(const Polygon* polygon, int2 centre, int2 low, int2 high)
{
    for (uint i = 0; i < polygon->count; ++i) {
        const double x = polygon->x[i], y = polygon->y[i];
        const double inside = fmin(fmin(centre.x + x - low.x, high.x - (centre.x + x)),
                                   fmin(centre.y + y - low.y, high.y - (centre.y + y)));
        if (!(inside >= sqrt(x * x + y * y))) return false;
    }
    return true;
}

/// The mean over the 4 x 4 x 2 choices for the three tiles in the quadrant of each point of all tiles. `beside`: the
/// tiles that fit at each side of each; `between`: those that fit between two sides of each quadrant.
kernel void average_over_quadrants(uint points_per_tile, global const int2* points, global const uint* beside,
                                   global const uint* between, global struct CentroidShift* displacements)
{
    const uint item = get_global_id(0);
    if (item >= TILES * points_per_tile) return;
    const uint tile = item / points_per_tile, number = item % points_per_tile;
    const int2 centre = points[item];
    const int2 is_upper = (centre >= TILE_UNITS / 2) & 1;
    const int2 sign = 2 * is_upper - 1;
    const int2 low = (is_upper - 1) * TILE_UNITS;
    const uint quadrant = (uint)(is_upper.x | is_upper.y << 1);
    long sum_x = 0, sum_y = 0;
    bool is_known = true;
    Cell own;
    begin_cell(&own);
    cut_by_tile(&own, points + tile * points_per_tile, points_per_tile, centre, 0, 0, number);
    for (uint i = 0; i < BESIDE && is_known; ++i) {
        const uint at_x = beside[(tile * SIDES + is_upper.x) * BESIDE + i];
        Cell with_x = own;
        cut_by_tile(&with_x, points + at_x * points_per_tile, points_per_tile, centre, sign.x, 0, NO_NEIGHBOUR);
        for (uint j = 0; j < BESIDE && is_known; ++j) {
            const uint at_y = beside[(tile * SIDES + 2 + is_upper.y) * BESIDE + j];
            Cell with_both = with_x;
            cut_by_tile(&with_both, points + at_y * points_per_tile, points_per_tile, centre, 0, sign.y, NO_NEIGHBOUR);
            for (uint k = 0; k < BETWEEN && is_known; ++k) {
                const uint corner = between[((quadrant * TILES + at_x) * TILES + at_y) * BETWEEN + k];
                Cell cell = with_both;
                cut_by_tile(&cell, points + corner * points_per_tile, points_per_tile, centre, sign.x, sign.y,
                            NO_NEIGHBOUR);
                is_known = cell.is_known && is_known_from(&cell.polygon, centre, low, low + 2 * TILE_UNITS);
                const int2 centroid = rounded_centroid(&cell.polygon);
                sum_x += centroid.x;
                sum_y += centroid.y;
            }
        }
    }
    const double choices = BESIDE * BESIDE * BETWEEN;
    const struct CentroidShift result = {(int)rint(sum_x / choices), (int)rint(sum_y / choices), is_known, 0};
    displacements[item] = result;
}

/// The displacements of the points of the middle one of 3 x 3 tiles.
kernel void find_in_surrounding(uint points_per_tile, global const int2* points, global const uint* surrounding,
                                global struct CentroidShift* displacements)
{
    const uint item = get_global_id(0);
    if (item >= points_per_tile) return;
    const int2 centre = points[surrounding[SURROUNDING / 2] * points_per_tile + item];
    Cell cell;
    begin_cell(&cell);
    cut_by_tile(&cell, points + surrounding[SURROUNDING / 2] * points_per_tile, points_per_tile, centre, 0, 0, item);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            if (x == 0 && y == 0) continue;
            const uint tile = surrounding[3 * (y + 1) + x + 1];
            cut_by_tile(&cell, points + tile * points_per_tile, points_per_tile, centre, x, y, NO_NEIGHBOUR);
        }
    const int2 centroid = rounded_centroid(&cell.polygon);
    const struct CentroidShift result = {centroid.x, centroid.y, cell.is_known, 0};
    displacements[item] = result;
}
