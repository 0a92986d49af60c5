// The cells of a power diagram on the torus: of each point, the places that have the smallest squared distance less the
// point's weight.
//
// De Goes, Breeden, Ostromoukhov, Desbrun, Blue noise through optimal transport, ACM Transactions on Graphics 31(6),
// 2012. Each cell is cut by the points around it, ring after ring of the grid, until no point farther away can matter:
// weights change little from point to point where they change much across the torus, so that the largest ones around are
// known for ever larger blocks of the grid. The plain twin, host/sampling/optimized/reference/power_cells.cpp, takes the
// largest of all.
//
// Points are sorted by grid cells, see point_grid.cl.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/polygon.clh"
#include "kernels/common/optimized/power_cells.h"

/// The number of a neighbour with the turns of its image.
uint label_of(uint index, int turns_x, int turns_y)
{
    return (uint)((turns_y + MAX_TURNS) * (2 * MAX_TURNS + 1) + turns_x + MAX_TURNS) << INDEX_BITS | index;
}

double2 turns_of(uint label)
{
    const int image = (int)(label >> INDEX_BITS);
    return (double2)(image % (2 * MAX_TURNS + 1) - MAX_TURNS, image / (2 * MAX_TURNS + 1) - MAX_TURNS);
}

/// True where no point that is more than `ring` cells away cuts a cell of a radius: one at a distance d cuts no farther
/// from the site than (d^2 - excess) / (2 d), where its weight exceeds the site's. `largest` has for blocks of 2, 4, 8...
/// cells the largest weight in them and the blocks around, until these are all.
bool is_beyond_all(global const double* largest, uint grid_size, uint cell_x, uint cell_y, double weight, int ring,
                   double radius)
{
    for (int level = 1;; ++level) {
        const uint blocks = max(grid_size >> level, 1u);
        const bool are_all = blocks < 3;
        if (1 << level > ring || are_all) {
            const double excess =
                largest[min(cell_y >> level, blocks - 1) * blocks + min(cell_x >> level, blocks - 1)] - weight;
            const double distance = max(ring, 1 << (level - 1)) * ((1 - 0x1p-40) / (int)grid_size);
            if (distance * distance - excess < 2 * distance * radius) return false;
        }
        if (are_all) return true;
        largest += blocks * blocks;
    }
}

/// The cell of a point; without vertices where others take all of it. False where it has too many.
bool find_power_cell(global const double2* positions, global const uint* ids, global const double* weights,
                     global const uint* starts, uint grid_size, global const double* largest, uint site,
                     Polygon* cell)
{
    const double2 place = positions[site];
    const double weight = weights[ids[site]];
    const int n = (int)grid_size;
    const uint cell_x = (uint)min((int)(place.x * n), n - 1);
    const uint cell_y = (uint)min((int)(place.y * n), n - 1);
    *cell = square_around(1);
    double squared_radius = 2;
    for (int ring = 0; ring <= (MAX_TURNS + 1) * n; ++ring) {
        for (int j = -ring; j <= ring; ++j) {
            const int step = j == -ring || j == ring || ring == 0 ? 1 : 2 * ring;
            for (int i = -ring; i <= ring; i += step) {
                int turns_x, turns_y;
                const uint x = turned_cell(cell_x, i, n, &turns_x);
                const uint y = turned_cell(cell_y, j, n, &turns_y);
                if (max(abs(turns_x), abs(turns_y)) > MAX_TURNS) continue;
                for (uint index = starts[y * grid_size + x]; index < starts[y * grid_size + x + 1]; ++index) {
                    if (index == site && turns_x == 0 && turns_y == 0) continue;
                    const double2 to = positions[index] + (double2)(turns_x, turns_y) - place;
                    const double offset = (to.x * to.x + to.y * to.y + weight - weights[ids[index]]) / 2;
                    if (offset > 0 && offset * offset >= squared_radius * (to.x * to.x + to.y * to.y)) continue;
                    if (!cut_at(cell, to.x, to.y, offset, label_of(index, turns_x, turns_y))) return false;
                    squared_radius = squared_radius_of(cell);
                    if (cell->count == 0) return true;
                }
            }
        }
        if (ring > 0 && is_beyond_all(largest, grid_size, cell_x, cell_y, weight, ring, sqrt(squared_radius))) break;
    }
    return true;
}

/// One work-item owns one point: the area of its cell, the way to its centroid, the integral of the squared distance to
/// it, and the neighbours by their ids (MAX_NEIGHBORS each, then NO_NEIGHBOUR) with how much area a neighbour gives for
/// a unit of weight. `largest`: weights, see is_beyond_all(). Cells of too many vertices have an area of 0.
kernel void measure_power_cells(global const double2* positions, global const uint* ids, global const double* weights,
                                global const uint* starts, uint grid_size, uint point_count,
                                global const double* largest, global double* areas, global double2* displacements, global double* energies,
                                global uint* neighbours, global double* exchanges)
{
    const uint site = get_global_id(0);
    if (site >= point_count) return;
    Polygon cell;
    if (!find_power_cell(positions, ids, weights, starts, grid_size, largest, site, &cell)) cell.count = 0;
    double area = 0, energy = 0;
    double2 moment = 0;
    uint count = 0;
    const uint id = ids[site];
    for (uint k = 0; k < cell.count; ++k) {
        const uint next = k + 1 < cell.count ? k + 1 : 0;
        const double ax = cell.x[k], ay = cell.y[k], bx = cell.x[next], by = cell.y[next];
        const double doubled = ax * by - ay * bx;
        area += doubled / 2;
        moment += doubled / 6 * (double2)(ax + bx, ay + by);
        energy += doubled / 12 * ((ax * ax + ay * ay) + (bx * bx + by * by) + (ax * bx + ay * by));
        const uint label = cell.neighbour[k];
        const uint index = label & ((1u << INDEX_BITS) - 1);
        if (label == NO_NEIGHBOUR || index == site || count == MAX_NEIGHBORS) continue;
        const double2 to = positions[index] + turns_of(label) - positions[site];
        const double squared_length = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
        neighbours[id * MAX_NEIGHBORS + count] = ids[index];
        exchanges[id * MAX_NEIGHBORS + count] = sqrt(squared_length / (to.x * to.x + to.y * to.y)) / 2;
        ++count;
    }
    if (count < MAX_NEIGHBORS) neighbours[id * MAX_NEIGHBORS + count] = NO_NEIGHBOUR;
    areas[id] = area;
    displacements[id] = area > 0 ? moment / area : (double2)0;
    energies[id] = energy;
}
