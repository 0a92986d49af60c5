// Sample elimination in rounds, with the result of the sequential algorithm: the heaviest point is removed, again and
// again.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, Computer Graphics Forum 34(2), 2015. Weights only
// fall, so a point that is heavier than all within its reach is removed before any of them, and at the weight that it
// has: all such points are removed at once. The order of removal is that of weights at removal. The plain twin, with a
// heap, is host/sampling/optimized/reference/sample_elimination.cpp.
//   weigh_points   the weights before the first removal
//   find_heaviest  (in rounds, with the next) marks the points that are heavier than all within their reach
//   remove_points  removes them, and takes their part off the weights of others
//
// Points are sorted by grid cells, see point_grid.cl. Of equal weights, that of the lower id counts as the heavier.
// Needs DIMENSION (2 or 3).

#pragma OPENCL FP_CONTRACT OFF

#define LARGE_DISKS 0

#include "kernels/common/sample_elimination.h"
#include "kernels/common/torus.clh"

typedef struct Elimination Elimination;

ALWAYS_INLINE Position position_at(global const uint* coordinates, uint stride, uint item)
{
    Position position;
    FOR_EACH_AXIS(k) position.c[k] = coordinates[k * stride + item];
    return position;
}

/// (1 - d / d_max)^8 in units.
ALWAYS_INLINE ulong weight_of(const Elimination* e, ulong squared)
{
    const double distance = sqrt((double)squared);
    const double rest = 1 - (distance < e->least ? e->least : distance) / e->reach;
    const double squared_rest = rest * rest;
    const double fourth = squared_rest * squared_rest;
    return (ulong)(fourth * fourth * WEIGHT_UNITS + 0.5);
}

/// BODY sees `other` and `squared` of each other point within reach: calls are textual, as OpenCL C has no function
/// pointers.
#define FOR_EACH_WITHIN_REACH(e, item, coordinates, starts, BODY)                                                      \
    const Position position_ = position_at(coordinates, (e).stride, item);                                             \
    const int n_ = (int)(e).grid_size;                                                                                 \
    int first_[3] = {0, 0, 0}, cells_[3] = {1, 1, 1};                                                                  \
    FOR_EACH_AXIS(k) {                                                                                                 \
        const int cell_ = (int)(((ulong)position_.c[k] * (e).grid_size) >> 32);                                        \
        first_[k] = n_ < 3 ? 0 : cell_ + n_ - 1;                                                                       \
        cells_[k] = min(n_, 3);                                                                                        \
    }                                                                                                                  \
    for (int z_ = 0; z_ < cells_[2]; ++z_) {                                                                           \
        for (int y_ = 0; y_ < cells_[1]; ++y_) {                                                                       \
            const uint row_ = (uint)(((first_[2] + z_) % n_ * n_ + (first_[1] + y_) % n_) * n_);                       \
            for (int x_ = 0; x_ < cells_[0]; ++x_) {                                                                   \
                const uint c_ = row_ + (uint)((first_[0] + x_) % n_);                                                  \
                for (uint other = starts[c_]; other < starts[c_ + 1]; ++other) {                                       \
                    const Position there_ = position_at(coordinates, (e).stride, other);                               \
                    const ulong squared = squared_distance(&position_, &there_);                                       \
                    if (squared >= (e).squared_reach || other == item) continue;                                       \
                    BODY                                                                                               \
                }                                                                                                      \
            }                                                                                                          \
        }                                                                                                              \
    }

/// One work-item owns one point. Also makes it alive.
kernel void weigh_points(Elimination e, global const uint* coordinates, global const uint* starts,
                         global ulong* weights, global uchar* is_removed, global uchar* is_heaviest)
{
    const uint item = get_global_id(0);
    if (item >= e.points) return;
    ulong sum = 0;
    FOR_EACH_WITHIN_REACH(e, item, coordinates, starts, { sum += weight_of(&e, squared); })
    weights[item] = sum;
    is_removed[item] = is_heaviest[item] = 0;
}

/// One work-item owns one point.
kernel void find_heaviest(Elimination e, global const uint* coordinates, global const uint* starts,
                          global const uint* ids, global const ulong* weights, global const uchar* is_removed,
                          global uchar* is_heaviest)
{
    const uint item = get_global_id(0);
    if (item >= e.points) return;
    is_heaviest[item] = 0;
    if (is_removed[item]) return;
    const ulong weight = weights[item];
    const uint id = ids[item];
    bool is_lighter = false;
    FOR_EACH_WITHIN_REACH(e, item, coordinates, starts, {
        if (is_removed[other] || weights[other] < weight) continue;
        is_lighter = is_lighter || weights[other] > weight || ids[other] < id;
    })
    is_heaviest[item] = !is_lighter;
}

/// One work-item owns one point. `is_left` becomes 1 where points remain.
kernel void remove_points(Elimination e, global const uint* coordinates, global const uint* starts,
                          global ulong* weights, global uchar* is_removed, global const uchar* is_heaviest,
                          global uint* is_left)
{
    const uint item = get_global_id(0);
    if (item >= e.points || is_removed[item]) return;
    if (is_heaviest[item]) {
        is_removed[item] = 1;
        return;
    }
    ulong less = 0;
    FOR_EACH_WITHIN_REACH(e, item, coordinates, starts, {
        if (is_heaviest[other]) less += weight_of(&e, squared);
    })
    weights[item] -= less;
    *is_left = 1;
}
