// Pairs of starts whose self-similar points are far from each other: see host/distribution/self_similar_search.hpp.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.7.2.2. Points are the rotations of two words of bits; up
// to 24 bits all differences are exact floats. Squares round, so that what is found here is only near the threshold or
// beyond; the host decides by integers.
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tiles/self_similar.h"

/// The distance of two numbers on the circle of `turn`.
float around(float a, float b, float turn)
{
    const float d = fabs(a - b);
    return fmin(d, turn - d);
}

/// The number that a word's bits are after so many turns to the left.
float turned(uint word, uint by, uint bits)
{
    return (float)((word << by | word >> (bits - by)) & ((1u << bits) - 1));
}

/// Two points, the square of their distance along x, and how many turns each is from the start.
struct NearPair
{
    float squared;
    uint turns, others;
};

/// Lists the pairs of points that are nearer along x than points may be, the nearest first: no other pairs can be too
/// near, and these are who tells soonest.
uint list_near_pairs(uint x, uint n, float least, struct NearPair* pairs)
{
    const float turn = (float)((1u << n) - 1);
    uint count = 0;
    for (uint k = 0; k < n; ++k)
        for (uint other = k + 1; other < n; ++other) {
            const float dx = around(turned(x, k, n), turned(x, other, n), turn);
            const float squared = dx * dx;
            if (squared >= least) continue;
            uint place = count++;
            for (; place > 0 && pairs[place - 1].squared > squared; --place) pairs[place] = pairs[place - 1];
            pairs[place].squared = squared;
            pairs[place].turns = k;
            pairs[place].others = other;
        }
    return count;
}

/// One work-item pairs a first start with SECOND_STARTS second ones.
kernel void search_starts(struct StartSearch search, global const uint* firsts, global const uint* seconds,
                          global const uint* classes, global uint* count, global uint2* found)
{
    const uint blocks = (search.seconds + SECOND_STARTS - 1) / SECOND_STARTS;
    const uint id = get_global_id(0);
    if (id >= search.firsts * blocks) return;
    const uint x = firsts[id / blocks];
    const uint begin = id % blocks * SECOND_STARTS;
    const uint end = min(begin + SECOND_STARTS, search.seconds);
    const uint n = search.bits;
    const float turn = (float)((1u << n) - 1);
    struct NearPair pairs[MAX_BITS * (MAX_BITS - 1) / 2];
    const uint near = list_near_pairs(x, n, search.least, pairs);
    for (uint s = begin; s < end; ++s) {
        const uint y = seconds[s];
        if (popcount(x & y) * 4 != n || classes[s] < x) continue;
        bool is_far = true;
        for (uint i = 0; is_far && i < near; ++i) {
            const float dy = around(turned(y, pairs[i].turns, n), turned(y, pairs[i].others, n), turn);
            is_far = pairs[i].squared + dy * dy >= search.least;
        }
        if (!is_far) continue;
        const uint place = atomic_inc(count);
        if (place < search.capacity) found[place] = (uint2)(x, y);
    }
}
