// Gaussian blue noise: how far each point is pushed by the Gaussians of all others.
//
// Ahmed, Ren, Wonka, Gaussian blue noise, ACM Transactions on Graphics 41(6), 2022; see
// host/sampling/optimized/gaussian_blue_noise.hpp. Single precision, eight neighbours at a time. The exponential is a
// polynomial of our own, and sums are taken in an order that only the points decide, so that bytes are the same on every
// device: each row of cells around a point, up to where the torus begins again, is dealt out to the lanes from the
// first one on.
//
// Points are sorted by grid cells, see point_grid.cl. Needs DIMENSION (2 or 3) and ADAPTIVE (0 or 1): whether there is a
// density, which points follow, see host/sampling/optimized/gaussian_field.hpp.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/gaussian_blue_noise.h"

#define FIRST_LANES ((int8)(0, 1, 2, 3, 4, 5, 6, 7))

/// 2^t for t <= 0: its power of two, and a Taylor polynomial of relative error below 2e-7 for the rest. What it is below
/// -126 does not matter.
float8 power_of_two(float8 t)
{
    const float8 whole = floor(t + 0.5f);
    const float8 x = (t - whole) * 0.693147182f;
    float8 sum = 0.00138888892f;
    sum = sum * x + 0.00833333377f;
    sum = sum * x + 0.0416666679f;
    sum = sum * x + 0.166666672f;
    sum = sum * x + 0.5f;
    sum = sum * x + 1.0f;
    sum = sum * x + 1.0f;
    return as_float8(as_int8(sum) + convert_int8(whole) * 8388608);
}

float sum_of_lanes(float8 v)
{
    return ((v.s0 + v.s1) + (v.s2 + v.s3)) + ((v.s4 + v.s5) + (v.s6 + v.s7));
}

float smallest_lane(float8 v)
{
    const float4 a = v.lo < v.hi ? v.lo : v.hi;
    const float2 b = a.lo < a.hi ? a.lo : a.hi;
    return b.x < b.y ? b.x : b.y;
}

/// The sum over the neighbours of a point.
typedef struct
{
    float8 force[DIMENSION];
    float8 energy;
    float8 squared_near;
} Sums;

/// Adds the points `begin` to `end` without the point itself.
void add_points(const struct Gaussians* g, global const int* coordinates, uint item, uint begin, uint end, Sums* sums)
{
    for (uint i = begin; i < end; i += SUM_LANES) {
        float8 difference[DIMENSION];
        float8 squared = 0;
        for (int k = 0; k < DIMENSION; ++k) {
            const int8 there = vload8(0, coordinates + k * g->stride + i);
            difference[k] = convert_float8(there - coordinates[k * g->stride + item]) * g->scale;
            squared += difference[k] * difference[k];
        }
        const int8 number = FIRST_LANES + (int)i;
        const int8 is_other = (number < (int)end) & (number != (int)item);
        const float8 gaussian = select((float8)0, power_of_two(squared * g->exponent),
                                       is_other & (squared < g->squared_cut));
        for (int k = 0; k < DIMENSION; ++k) sums->force[k] -= difference[k] * gaussian;
        sums->energy += gaussian;
        const float8 distance = select((float8)INFINITY, squared, is_other);
        sums->squared_near = distance < sums->squared_near ? distance : sums->squared_near;
    }
}

#if ADAPTIVE

/// The cells of a density on the torus, `size` along each axis.
typedef struct
{
    global const struct DensityCell* cells;
    int size;
} DensityField;

/// The cell of a place.
struct DensityCell cell_at(DensityField field, double x, double y)
{
    const int column = min((int)(x * field.size), field.size - 1);
    const int row = min((int)(y * field.size), field.size - 1);
    return field.cells[row * field.size + column];
}

/// A coordinate after a movement, on the torus.
double moved_on_torus(double place, double movement)
{
    const double moved = place + movement;
    return moved - floor(moved);
}

double between(double a, double b, double part)
{
    return a * (1 - part) + b * part;
}

/// Displacement and excess energy at a place, linear between the middles of cells.
double3 density_at(DensityField field, double x, double y)
{
    const int n = field.size;
    const double left = floor(x * n - 0.5);
    const double low = floor(y * n - 0.5);
    const double part_x = x * n - 0.5 - left;
    const double part_y = y * n - 0.5 - low;
    const int columns[2] = {((int)left + n) % n, ((int)left + 1) % n};
    const int rows[2] = {((int)low + n) % n, ((int)low + 1) % n};
    double3 values[2];
    for (int i = 0; i < 2; ++i) {
        const struct DensityCell a = field.cells[rows[i] * n + columns[0]];
        const struct DensityCell b = field.cells[rows[i] * n + columns[1]];
        values[i].x = between(a.x, b.x, part_x);
        values[i].y = between(a.y, b.y, part_x);
        values[i].z = between(a.excess, b.excess, part_x);
    }
    return (double3)(between(values[0].x, values[1].x, part_y), between(values[0].y, values[1].y, part_y),
                     between(values[0].z, values[1].z, part_y));
}

#endif

/// One work-item owns one point: its displacement, the Gaussians of all others there, and the squared distance of the
/// nearest of them in units of the torus' side; too large where it is beyond the cells around. With a density, the
/// point's own width of Gaussians counts for all of its pairs.
kernel void sum_gaussians(struct Gaussians g, global const double* positions, global const int* coordinates,
                          global const uint* starts, global double* displacements, global double* energies,
                          global double* squared_near
#if ADAPTIVE
                          ,
                          global const struct DensityCell* density_cells, uint density_size
#endif
)
{
    const uint item = get_global_id(0);
    if (item >= g.points) return;
    Sums sums;
    sums.energy = 0;
    sums.squared_near = INFINITY;
    for (int k = 0; k < DIMENSION; ++k) sums.force[k] = 0;

    const int n = (int)g.grid_size;
#if ADAPTIVE
    const DensityField field = {density_cells, (int)density_size};
    const double x = positions[item * DIMENSION];
    const double y = positions[item * DIMENSION + 1];
    const struct DensityCell own = cell_at(field, x, y);
    g.exponent = own.exponent;
    g.squared_cut = own.squared_cut;
    const int reach = own.reach < 0 ? ~own.reach : own.reach;
#else
    const int reach = n == 1 ? 0 : WINDOW_REACH;
#endif
    int cell[3] = {0, 0, 0};
    for (int k = 0; k < DIMENSION; ++k) cell[k] = min((int)(positions[item * DIMENSION + k] * n), n - 1);
    const int after = min(reach, n - 1 - reach); // no cell twice
    const int reach_z = DIMENSION == 3 ? reach : 0;
    for (int z = cell[2] - reach_z; z <= cell[2] + reach_z; ++z) {
        for (int y = cell[1] - reach; y <= cell[1] + after; ++y) {
            const int row = DIMENSION == 3 ? ((z + n) % n * n + (y + n) % n) * n : (y + n) % n * n;
            const int low = cell[0] - reach;
            const int high = cell[0] + after + 1;
            if (low < 0) add_points(&g, coordinates, item, starts[row + n + low], starts[row + n], &sums);
            add_points(&g, coordinates, item, starts[row + max(low, 0)], starts[row + min(high, n)], &sums);
            if (high > n) add_points(&g, coordinates, item, starts[row], starts[row + high - n], &sums);
        }
    }
    for (int k = 0; k < DIMENSION; ++k)
        displacements[item * DIMENSION + k] = (double)sum_of_lanes(sums.force[k]) * g.step;
    energies[item] = sum_of_lanes(sums.energy);
#if ADAPTIVE
    const double3 density = density_at(field, x, y);
    const double movement_x = displacements[item * DIMENSION] + density.x;
    const double movement_y = displacements[item * DIMENSION + 1] + density.y;
    const bool enters_nothing =
        cell_at(field, moved_on_torus(x, movement_x), moved_on_torus(y, movement_y)).reach < 0;
    displacements[item * DIMENSION] = enters_nothing ? 0 : movement_x;
    displacements[item * DIMENSION + 1] = enters_nothing ? 0 : movement_y;
    energies[item] -= density.z;
#endif
    const double unit = 0x1p-32 / (double)g.scale; // of lengths; of the torus' side
    squared_near[item] = (double)smallest_lane(sums.squared_near) * (unit * unit);
}
