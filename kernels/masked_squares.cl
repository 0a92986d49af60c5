// Sums of squared differences between a piece and every window of an exemplar, over a mask: all products, one by one.
//
// host/texture/masked_squares.cpp has the same by Fourier transforms, and plain C++: integers, equal in all three.
#include "kernels/common/fields/masked_squares.h"

/// A work-item a window.
kernel void sum_masked_squares(global const uchar* exemplar, global const uchar* mask, global const uchar* piece,
                               struct MaskedSquaresSizes sizes, global ulong* sums)
{
    const uint window = get_global_id(0);
    if (window >= (uint)(sizes.columns * sizes.rows)) return;
    const int left = (int)window % sizes.columns, top = (int)window / sizes.columns;
    ulong sum = 0;
    for (int y = 0; y < sizes.height; ++y) {
        global const uchar* line = exemplar + ((ulong)(top + y) * sizes.exemplar_width + left) * sizes.channels;
        for (int x = 0; x < sizes.width; ++x) {
            const int pixel = y * sizes.width + x;
            if (mask[pixel] == 0) continue;
            for (int c = 0; c < sizes.channels; ++c) {
                const int difference = piece[pixel * sizes.channels + c] - line[x * sizes.channels + c];
                sum += (uint)(difference * difference);
            }
        }
    }
    sums[window] = sum;
}
