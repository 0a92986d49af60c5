// Harmonic functions in regions of tiles: by successive over-relaxation in red-black order, a work-group a channel of a
// tile. The plain twin is in host/texture/gradient_domain.cpp: sums have the same order, and so the same bits.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/fields/gradient_domain.h"

kernel void relax_gradient_domain(struct GradientDomainSizes sizes, global const uchar* inside, global double* values)
{
    const int pixels = sizes.size * sizes.size;
    inside += get_group_id(0) / sizes.channels * pixels;
    values += get_group_id(0) * pixels;
    for (int sweep = 0; sweep < 2 * sizes.sweeps; ++sweep) {
        for (int pixel = get_local_id(0); pixel < pixels; pixel += get_local_size(0)) {
            if (inside[pixel] == 0 || (pixel % sizes.size + pixel / sizes.size + sweep) % 2 != 0) continue;
            const double mean = ((values[pixel - 1] + values[pixel + 1]) +
                                 (values[pixel - sizes.size] + values[pixel + sizes.size])) * 0.25;
            values[pixel] += sizes.relaxation * (mean - values[pixel]);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
