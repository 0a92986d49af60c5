// Pairs of starts whose self-similar points are far from each other: see host/distribution/self_similar_search.hpp.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.7.2.2. Points are the rotations of two words of bits; up
// to 24 bits all differences are exact floats. Squares round, so that what is found here is only near the threshold or
// beyond; the host decides by integers.
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/self_similar.h"

/// The distance of two numbers on the circle of `turn`.
float around(float a, float b, float turn)
{
    const float d = fabs(a - b);
    return fmin(d, turn - d);
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
    const uint all = (1u << n) - 1;
    const float turn = (float)all;
    float px[MAX_BITS], py[MAX_BITS];
    uint word = x;
    for (uint k = 0; k < n; ++k) {
        px[k] = (float)word;
        word = (word << 1 | word >> (n - 1)) & all;
    }
    for (uint s = begin; s < end; ++s) {
        const uint y = seconds[s];
        if (popcount(x & y) * 4 != n || classes[s] < x) continue;
        word = y;
        for (uint k = 0; k < n; ++k) {
            py[k] = (float)word;
            word = (word << 1 | word >> (n - 1)) & all;
        }
        bool is_far = true;
        for (uint d = 1; is_far && d <= n / 2; ++d)
            for (uint k = 0; is_far && k < n; ++k) {
                const uint other = k + d < n ? k + d : k + d - n;
                const float dx = around(px[k], px[other], turn), dy = around(py[k], py[other], turn);
                is_far = dx * dx + dy * dy >= search.least;
            }
        if (!is_far) continue;
        const uint place = atomic_inc(count);
        if (place < search.capacity) found[place] = (uint2)(x, y);
    }
}
