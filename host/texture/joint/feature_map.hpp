// Features are what windows of an exemplar are compared by: colours, and how they change.
//
// Beside the channels of the picture the lightness' derivatives along both axes, the lowest level of a steerable filter
// (Freeman and Adelson, The Design and Use of Steerable Filters, PAMI 13, 1991: those along any other direction are
// sums of these two), at the exemplar's own scale and at one twice as coarse. Edges that do not meet differ in them
// over more pixels than the colours do.
#pragma once

#include "base/images/png_file.hpp"

namespace poissonlab {

/// Channels of 8 bits. `slopes` multiplies derivatives, which are differences of neighbours two pixels apart; 0:
/// colours alone.
PngPixels feature_map(const PngPixels& exemplar, double slopes);

}
