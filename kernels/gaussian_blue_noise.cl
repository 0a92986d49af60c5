// Gaussian blue noise: how far each point is pushed by the Gaussians of all others.
//
// Ahmed, Ren, Wonka, Gaussian blue noise, ACM Transactions on Graphics 41(6), 2022; see
// host/sampling/optimized/gaussian_blue_noise.hpp. Single precision. A work-item owns eight points that are side by
// side in a row of cells, and adds a neighbour to the sums of all of them at once. The exponential is a polynomial of
// our own, multiplications and additions are fused where fma() says so and nowhere else, and each point's neighbours
// are added in the order of the sorted points, row of cells by row of cells, so that bytes are the same on every
// device, whichever points share a work-item.
//
// Points are sorted by grid cells, see point_grid.cl. Needs DIMENSION (2 or 3), ADAPTIVE (0 or 1): whether there is
// a density, which points follow, see host/sampling/optimized/gaussian_field.hpp, and LISTED (0 or 1): whether only
// some cells are there, as listed_cells.clh has them.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/grid_part.clh"
#include "kernels/common/listed_cells.clh"
#include "kernels/common/optimized/gaussian_blue_noise.h"

#if ADAPTIVE
#include "kernels/common/optimized/density_field.clh"
#endif

#define ALWAYS_INLINE __attribute__((always_inline))
#define FOR_EACH_AXIS(k) _Pragma("unroll") for (int k = 0; k < DIMENSION; ++k)

/// The sorted points by grid cells. The rows of a plane come after those of the plane below.
typedef struct
{
    const struct GridPart* part;
    global const uint* starts;
#if LISTED
    global const uint *row_starts, *columns;
#endif
} SortedCells;

/// The number of points before a cell of a row; before the end of the row where the column is that of no cell.
ALWAYS_INLINE uint points_before(const SortedCells* cells, uint row, uint column)
{
#if LISTED
    return cells->starts[number_of_listed(cells->row_starts, cells->columns, row, column)];
#else
    return cells->starts[place_of_cell(cells->part, row * cells->part->grid_size) + column];
#endif
}

/// Points that are side by side in a row of cells, and their sums over neighbours.
typedef struct
{
    uint first, end;                        ///< in the order of the sorted points
    double low[DIMENSION], high[DIMENSION]; ///< where the points are; cells
    int8 place[DIMENSION];                  ///< units of 2^-32 of the torus' side
    float8 exponent;
    float8 row_force[DIMENSION], row_energy; ///< of the neighbours in one row of cells
    float8 force[DIMENSION], energy, squared_near;
} Block;

/// 2^t for t <= 0: its power of two, and a polynomial for the rest, which differs by less than 9.2e-8 of it. What it is
/// below -126 does not matter.
ALWAYS_INLINE float8 power_of_two(float8 t)
{
    const float8 shifted = t + 0x1.8p23f; // the whole number is in its last bits
    const float8 x = t - (shifted - 0x1.8p23f);
    float8 sum = 0.00132647273f;
    sum = fma(sum, x, (float8)0.00967151299f);
    sum = fma(sum, x, (float8)0.0555073358f);
    sum = fma(sum, x, (float8)0.240222424f);
    sum = fma(sum, x, (float8)0.693147004f);
    sum = fma(sum, x, (float8)1.0f);
    return as_float8(as_int8(sum) + (as_int8(shifted) << 23));
}

/// Adds the neighbours `begin` to `end`. `may_be_near`: the points themselves may be among these, or one that is nearer
/// to them than Gaussians.near; a constant.
ALWAYS_INLINE void add_points(Block* b, global const int* coordinates, uint stride, uint begin, uint end,
                              bool may_be_near)
{
    const int8 number = (int8)(0, 1, 2, 3, 4, 5, 6, 7) + (int)b->first;
    for (uint i = begin; i < end; ++i) {
        float8 difference[DIMENSION];
        float8 squared;
        FOR_EACH_AXIS(k) {
            difference[k] = convert_float8(b->place[k] - coordinates[k * stride + i]);
            squared = k == 0 ? difference[k] * difference[k] : fma(difference[k], difference[k], squared);
        }
        if (may_be_near) {
            squared = number == (int)i ? (float8)INFINITY : squared;
            b->squared_near = squared < b->squared_near ? squared : b->squared_near;
        }
        const float8 t = squared * b->exponent;
        const float8 gaussian = as_float8(as_int8(power_of_two(t)) & (t > (float)CUT_EXPONENT));
        FOR_EACH_AXIS(k) b->row_force[k] = fma(difference[k], gaussian, b->row_force[k]);
        b->row_energy += gaussian;
    }
}

/// Cells or rows of cells that are in a row along an axis of the repeated grid.
typedef struct
{
    int first;  ///< may be outside of the torus
    int count;  ///< all of the torus at most
    int behind; ///< so many, the first ones, come after the others in the order of the grid: the torus begins again
} Span;

Span span_around(double low, double high, double reach, int grid_size)
{
    const int first = (int)floor(low - reach);
    const int end = (int)floor(high + reach) + 1;
    const Span all = {0, grid_size, 0};
    const Span span = {first, end - first, first < 0 ? -first : end > grid_size ? grid_size - first : 0};
    return span.count < grid_size ? span : all;
}

/// The cell of a number in the order of the grid; in the repeated grid.
int cell_of_span(Span span, int i) { return span.first + (i + span.behind) % span.count; }

int wrapped_cell(int cell, int grid_size)
{
    return cell < 0 ? cell + grid_size : cell < grid_size ? cell : cell - grid_size;
}

/// The squared distance along an axis from the block to a cell of a span; cells.
double squared_gap(const Block* b, int axis, Span span, int cell, int grid_size)
{
    if (span.count == grid_size) return 0; // other repetitions of it may be nearer
    const double gap = fmax(fmax(cell - b->high[axis], b->low[axis] - (cell + 1)), 0.0);
    return gap * gap;
}

/// Adds the points of a row of cells, up to some distance along it, in the order of the grid.
ALWAYS_INLINE void add_row(Block* b, const struct Gaussians* g, const SortedCells* sorted,
                           global const int* coordinates, uint row, double reach, bool may_be_near)
{
    const int n = (int)sorted->part->grid_size;
    const Span cells = span_around(b->low[0], b->high[0], reach, n);
    FOR_EACH_AXIS(k) b->row_force[k] = 0;
    b->row_energy = 0;
    if (cells.behind > 0)
        add_points(b, coordinates, g->stride, points_before(sorted, row, 0),
                   points_before(sorted, row, (uint)(cells.count - cells.behind)), may_be_near);
    const int first = wrapped_cell(cells.first, n);
    const int end = first + (cells.behind > 0 ? cells.behind : cells.count);
    add_points(b, coordinates, g->stride, points_before(sorted, row, (uint)first),
               points_before(sorted, row, (uint)end), may_be_near);
    FOR_EACH_AXIS(k) b->force[k] += b->row_force[k];
    b->energy += b->row_energy;
}

/// Adds the points of the plane of cells whose first row is `plane`, and which is `squared_distance` away, up to
/// `squared_reach`; in cells.
ALWAYS_INLINE void add_plane(Block* b, const struct Gaussians* g, const SortedCells* sorted,
                             global const int* coordinates, uint plane, double squared_distance, double squared_reach)
{
    const int n = (int)sorted->part->grid_size;
    const Span rows = span_around(b->low[1], b->high[1], sqrt(squared_reach - squared_distance), n);
    for (int i = 0; i < rows.count; ++i) {
        const int y = cell_of_span(rows, i);
        const double squared = squared_distance + squared_gap(b, 1, rows, y, n);
        if (squared > squared_reach) continue;
        const uint row = plane + (uint)wrapped_cell(y, n);
        const double reach = sqrt(squared_reach - squared);
        if (squared > (double)g->near * g->near)
            add_row(b, g, sorted, coordinates, row, reach, false);
        else
            add_row(b, g, sorted, coordinates, row, reach, true);
    }
}

/// Adds all neighbours of a block, up to some distance in cells.
ALWAYS_INLINE void add_neighbours(Block* b, const struct Gaussians* g, const SortedCells* sorted,
                                  global const int* coordinates, double reach)
{
#if DIMENSION == 2
    add_plane(b, g, sorted, coordinates, 0, 0, reach * reach);
#else
    const int n = (int)sorted->part->grid_size;
    const Span planes = span_around(b->low[2], b->high[2], reach, n);
    for (int i = 0; i < planes.count; ++i) {
        const int z = cell_of_span(planes, i);
        const double squared = squared_gap(b, 2, planes, z, n);
        if (squared <= reach * reach)
            add_plane(b, g, sorted, coordinates, (uint)wrapped_cell(z, n) * n, squared, reach * reach);
    }
#endif
}

/// Takes the points from `first` on that are in its row of cells, up to `end`; no sums yet.
ALWAYS_INLINE void begin_block(Block* b, uint first, uint end, const struct Gaussians* g, const SortedCells* sorted,
                               global const double* positions, global const int* coordinates)
{
    const int n = (int)sorted->part->grid_size;
    uint row = 0;
    for (int k = DIMENSION - 1; k > 0; --k) row = row * n + min((int)(positions[first * DIMENSION + k] * n), n - 1);
    b->first = first;
    b->end = min(end, points_before(sorted, row, (uint)n));
    FOR_EACH_AXIS(k) {
        b->place[k] = vload8(0, coordinates + k * g->stride + first);
        b->low[k] = n;
        b->high[k] = 0;
        for (uint i = first; i < b->end; ++i) {
            b->low[k] = fmin(b->low[k], positions[i * DIMENSION + k] * n);
            b->high[k] = fmax(b->high[k], positions[i * DIMENSION + k] * n);
        }
        b->force[k] = 0;
    }
    b->exponent = g->exponent;
    b->energy = 0;
    b->squared_near = INFINITY;
}

/// The cells to which a Gaussian reaches, and somewhat farther: coordinates are rounded.
double reach_of(float exponent, uint grid_size)
{
    return (sqrt(CUT_EXPONENT / exponent) * 1.000001 + 2) * 0x1p-32 * grid_size;
}

/// Each work-item owns BLOCK_POINTS of the requested points. It finds their displacements, the sums of the Gaussians of
/// all other points there, and the squared distance to the nearest one, in units of the torus' side. This distance is
/// too large if the nearest point is farther away than Gaussians.near. With a density, a point's own width of Gaussians
/// counts for all of its pairs.
kernel void sum_gaussians(struct Gaussians g, struct GridPart part, global const double* positions,
                          global const int* coordinates, global const uint* starts, global double* displacements,
                          global double* energies, global double* squared_near
#if ADAPTIVE
                          ,
                          global const struct DensityCell* density_cells, uint density_size
#endif
#if LISTED
                          ,
                          global const uint* row_starts, global const uint* columns
#endif
)
{
#if LISTED
    const SortedCells sorted = {&part, starts, row_starts, columns};
#else
    const SortedCells sorted = {&part, starts};
#endif
    const uint begin = g.first + (uint)get_global_id(0) * BLOCK_POINTS;
    const uint end = min(begin + BLOCK_POINTS, g.end);
    for (uint first = begin; first < end;) {
        Block b;
        begin_block(&b, first, end, &g, &sorted, positions, coordinates);
        double reach = reach_of(g.exponent, part.grid_size);
#if ADAPTIVE
#if LISTED
        const DensityField field = {density_cells, (int)density_size, row_starts, columns};
#else
        const DensityField field = {density_cells, (int)density_size};
#endif
        float exponents[BLOCK_POINTS] = {0};
        reach = 0;
        for (uint i = first; i < b.end; ++i) {
            exponents[i - first] = cell_at(field, positions[2 * i], positions[2 * i + 1]).exponent;
            reach = fmax(reach, reach_of(exponents[i - first], part.grid_size));
        }
        b.exponent = vload8(0, exponents);
#endif
        add_neighbours(&b, &g, &sorted, coordinates, reach);
        float force[DIMENSION][BLOCK_POINTS], energy[BLOCK_POINTS], near[BLOCK_POINTS];
        FOR_EACH_AXIS(k) vstore8(b.force[k], 0, force[k]);
        vstore8(b.energy, 0, energy);
        vstore8(b.squared_near, 0, near);
        for (uint i = first; i < b.end; ++i) {
            FOR_EACH_AXIS(k) displacements[i * DIMENSION + k] = force[k][i - first] * g.step;
            energies[i] = energy[i - first];
            squared_near[i] = near[i - first] * 0x1p-64;
#if ADAPTIVE
            follow_density(field, positions + 2 * i, displacements + 2 * i, energies + i);
#endif
        }
        first = b.end;
    }
}
