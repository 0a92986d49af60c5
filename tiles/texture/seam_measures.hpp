// Measures of how much of a texture set's seams can be seen, from its sources and its exemplar.
//
// Two neighbouring pixels p and q are a seam where their sources are no neighbours: p shows a window A of the exemplar,
// q a window B. All differences are sums over channels, in parts of the mean difference of neighbours in the exemplar
// in the same direction: 1 is what is natural. Smoothed sets are measured as they were before.
#pragma once

#include "tiles/texture/texture_set.hpp"

namespace poissonlab {

struct SeamMeasures
{
    double pairs_a_tile = 0; ///< seam pairs inside of a tile
    double mismatch = 0;     ///< mean of (|A(p) - B(p)| + |A(q) - B(q)|) / 2, over pairs whose windows go on
    double excess = 0;       ///< mean of max(0, |A(p) - B(q)| - max(|A(p) - A(q)|, |B(p) - B(q)|))
    double conspicuous = 0;  ///< share of steps |A(p) - B(q)| above the 95 % quantile of the exemplar's own
    double natural = 0;      ///< share of the exemplar's own steps above it: at most 0.05, less where many are equal
    int longest_run = 0;     ///< of conspicuous steps side by side along a straight line, in pixels
    double mean_line = 0;    ///< share of the pairs over a line between two columns, or rows, of a tile that are seams
    double largest_line = 0; ///< of the line with the largest share
    int longest_line = 0;    ///< of seam pairs side by side along a straight line, in pixels
    double coverage = 0;     ///< part of the exemplar's pixels that some tile shows
};

SeamMeasures seam_measures(const TextureSet& set);

}
