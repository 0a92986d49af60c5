// Sample elimination on a surface, side by side, with the result of the sequential algorithm: the heaviest point is
// removed, again and again.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, Computer Graphics Forum 34(2), 2015, section 4.2,
// with distances through space. Weights only fall, so a point that is heavier than all within its reach is removed before
// any of them, and at the weight that it has: all such points are removed at once, in rounds of three kernels. The order
// of removal is that of weights at removal.
//
//   weigh_candidates  the weights before the first removal
//   mark_heaviest     which points are heavier than all within reach
//   touch_around      which points have such a one within reach
//   remove_marked     removes the former, and takes their weights off the latter
//
// Points are sorted by buckets: those of bucket b are starts[b] to starts[b + 1]. Of equal weights, that of the lower id
// counts as the heavier. The twin, with a heap, is host/sampling/surfaces/reference/surface_elimination.cpp.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/surfaces/surface.clh"
#include "kernels/common/surfaces/surface_elimination.h"

typedef struct Elimination Elimination;
typedef struct Candidate Candidate;

/// (1 - d / d_max)^8 in units.
long weight_of(const Elimination* e, ulong squared)
{
    const double distance = sqrt((double)squared);
    const double rest = 1 - (distance < e->least ? e->least : distance) / e->reach;
    const double squared_rest = rest * rest;
    const double fourth = squared_rest * squared_rest;
    return (long)(fourth * fourth * WEIGHT_UNITS + 0.5);
}

/// BODY sees `other` and `squared` of each other point within reach for which WHERE, which sees `other`, is true.
#define FOR_EACH_WITHIN_REACH(e, item, candidates, triangles, starts, WHERE, BODY)                                     \
    Place place_;                                                                                                      \
    for (int k = 0; k < 3; ++k) place_.c[k] = candidates[item].place[k];                                               \
    uint buckets_[NEAREST_CELLS];                                                                                      \
    const uint count_ = find_buckets(&place_, (e)->cell, (e)->bucket_mask, buckets_);                                  \
    for (uint i_ = 0; i_ < count_; ++i_)                                                                               \
        for (uint other = starts[buckets_[i_]]; other < starts[buckets_[i_] + 1]; ++other) {                           \
            if (other == item || !(WHERE)) continue;                                                                   \
            const ulong squared = squared_length(&place_, candidates[other].place);                                  \
            if (squared >= (e)->squared_reach ||                                                                       \
                !have_near_normals(&triangles[candidates[item].triangle], &triangles[candidates[other].triangle],      \
                                   (e)->least_cosine))                                                                 \
                continue;                                                                                              \
            BODY                                                                                                       \
        }

/// Removed points keep one's complement of the weight that they had.
bool is_heavier(global const long* weights, global const uint* ids, uint item, uint other)
{
    return weights[item] > weights[other] || (weights[item] == weights[other] && ids[item] < ids[other]);
}

/// No heavier points are known yet, which `heavier` says by the point itself.
kernel void weigh_candidates(Elimination e, global const Candidate* candidates,
                             global const struct Triangle* triangles, global const uint* starts,
                             global long* weights, global uint* heavier, global uint* marks, global uint* touched)
{
    const uint item = get_global_id(0);
    if (item >= e.points) return;
    long sum = 0;
    FOR_EACH_WITHIN_REACH(&e, item, candidates, triangles, starts, true, { sum += weight_of(&e, squared); })
    weights[item] = sum;
    heavier[item] = item;
    marks[item] = 0;
    touched[item] = 0;
}

/// No point that is lighter than `least` is marked. `heavier` has a point that was heavier, for each: another one is
/// looked for only where it is no longer.
kernel void mark_heaviest(Elimination e, long least, global const Candidate* candidates,
                          global const struct Triangle* triangles, global const uint* starts, global const uint* ids,
                          global const long* weights, global uint* heavier, global uint* marks, global uint* removed)
{
    const uint item = get_global_id(0);
    if (item >= e.points) return;
    marks[item] = 0;
    if (weights[item] < least || is_heavier(weights, ids, heavier[item], item)) return;
    uint found = item;
    FOR_EACH_WITHIN_REACH(&e, item, candidates, triangles, starts, is_heavier(weights, ids, other, found),
                          { found = other; })
    heavier[item] = found;
    if (found != item) return;
    marks[item] = 1;
    atomic_inc(removed);
}

kernel void touch_around(Elimination e, global const Candidate* candidates, global const struct Triangle* triangles,
                         global const uint* starts, global const long* weights, global const uint* marks,
                         global uint* touched)
{
    const uint item = get_global_id(0);
    if (item >= e.points || !marks[item]) return;
    FOR_EACH_WITHIN_REACH(&e, item, candidates, triangles, starts, weights[other] >= 0,
                          { atomic_xchg(&touched[other], 1u); })
}

kernel void remove_marked(Elimination e, global const Candidate* candidates, global const struct Triangle* triangles,
                          global const uint* starts, global long* weights, global const uint* marks,
                          global uint* touched)
{
    const uint item = get_global_id(0);
    if (item >= e.points) return;
    if (marks[item]) {
        weights[item] = ~weights[item];
    } else if (touched[item]) {
        long sum = 0;
        FOR_EACH_WITHIN_REACH(&e, item, candidates, triangles, starts, marks[other] != 0,
                              { sum += weight_of(&e, squared); })
        weights[item] -= sum;
        touched[item] = 0;
    }
}
