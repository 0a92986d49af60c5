// Repulsion: what points that are too close push each other by. See host/sampling/repulsion.hpp; points are moved by
// move_points of relaxation.cl.
//
// Points are sorted by grid cells, see point_grid.cl. Needs DIMENSION (2 or 3).

#pragma OPENCL FP_CONTRACT OFF

/// Floor of i / n, for repeated grids.
int repetition_of(int i, int n) { return i >= 0 ? i / n : -((n - 1 - i) / n); }

/// One work-item owns one point: its displacement, and the squared distance of the nearest point or image of a point
/// that lies in the cells around. `is_fixed` is by id.
kernel void push_points(global const double* positions, global const uint* ids, uint point_count,
                        global const uint* starts, uint grid_size, int reach, double distance, double limit,
                        global const uchar* is_fixed, uint has_fixed, global double* displacements,
                        global double* squared_near)
{
    const uint item = get_global_id(0);
    if (item >= point_count) return;
    const uint id = ids[item];
    const int n = (int)grid_size;
    double position[DIMENSION];
    double sum[DIMENSION];
    int cell[DIMENSION];
    for (int k = 0; k < DIMENSION; ++k) {
        position[k] = positions[item * DIMENSION + k];
        sum[k] = 0;
        cell[k] = min((int)(position[k] * grid_size), n - 1);
    }
    double near = 1; // the point's own images
    const double far = distance * distance * (1 + 0x1p-40); // no root needed beyond

    // The cells around, row by row; on small grids several times, as the images that they are there.
    const int reach_z = DIMENSION == 3 ? reach : 0;
    for (int z = -reach_z; z <= reach_z; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            double repetition[DIMENSION];
            uint row = 0;
            for (int k = DIMENSION - 1; k > 0; --k) {
                const int moved = cell[k] + (k == 1 ? y : z);
                const int repeated = moved >= 0 && moved < n ? 0 : repetition_of(moved, n);
                repetition[k] = repeated;
                row = row * grid_size + (uint)(moved - repeated * n);
            }
            row *= grid_size;

            // Cells of a row lie one after the other, up to the border of the torus.
            for (int x = cell[0] - reach; x <= cell[0] + reach;) {
                const int repeated = x >= 0 && x < n ? 0 : repetition_of(x, n);
                const int first = x - repeated * n;
                const int end = min(first + cell[0] + reach + 1 - x, n);
                repetition[0] = repeated;
                const uint others_end = starts[row + end];
                for (uint other = starts[row + first]; other < others_end; ++other) {
                    if (other == item) continue;
                    double difference[DIMENSION];
                    double squared = 0;
                    for (int k = 0; k < DIMENSION; ++k) {
                        difference[k] = positions[other * DIMENSION + k] - position[k] + repetition[k];
                        squared += difference[k] * difference[k];
                    }
                    near = fmin(near, squared);
                    if (squared > far) continue;
                    const double length = sqrt(squared);
                    if (length >= distance) continue;
                    const uint other_id = ids[other];
                    const double part = has_fixed && is_fixed[other_id] ? 1 : 0.5;
                    const double push = part * (distance - length);
                    if (length == 0) {
                        sum[0] += id < other_id ? -push : push;
                    } else {
                        for (int k = 0; k < DIMENSION; ++k) sum[k] -= difference[k] / length * push;
                    }
                }
                x += end - first;
            }
        }
    }
    squared_near[item] = near;

    double squared = 0;
    for (int k = 0; k < DIMENSION; ++k) squared += sum[k] * sum[k];
    const double length = sqrt(squared);
    const double scale = has_fixed && is_fixed[id] ? 0 : length > limit ? limit / length : 1;
    for (int k = 0; k < DIMENSION; ++k) displacements[item * DIMENSION + k] = scale * sum[k];
}

/// One work-item owns one point: keeps its position, by id.
kernel void keep_points(global const double* positions, global const uint* ids, uint point_count, global double* kept)
{
    const uint item = get_global_id(0);
    if (item >= point_count) return;
    for (int k = 0; k < DIMENSION; ++k) kept[ids[item] * DIMENSION + k] = positions[item * DIMENSION + k];
}
