// Image quilting in one piece: blocks of the exemplar that fit to those before them, cut along the best path.
//
// Efros and Freeman, Image Quilting for Texture Synthesis and Transfer, SIGGRAPH 2001: blocks row by row; an overlap of
// a sixth of a block; one at random of those whose difference in it is at most a tenth above the smallest; cuts by
// paths. Their paper leaves open that the window which goes on where a neighbour's ends fits without any difference, so
// that nothing but copies of the exemplar would follow, and that the best windows fit to themselves, so that one is
// taken again and again. Here windows near such a continuation are not taken, nor those near what blocks up to three
// columns and rows away show, as long as there are others: nearer than a quarter of a block, or less in small
// exemplars, of which this forbids a quarter at most.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/endless/endless_request.hpp"
#include "tiles/texture/texture_set.hpp"

#include <algorithm>
#include <functional>
#include <vector>

namespace poissonlab {

struct QuiltedPicture
{
    PngPixels pixels;
    std::vector<SourcePixel> sources; ///< in the exemplar, row by row
};

/// Pixels from a block to the next one.
inline int quilting_step(const EndlessRequest& request) { return request.block - std::max(2, request.block / 6); }

/// A quilted picture of this size. Its bytes do not depend on the number of threads. Throws InputError as check() does,
/// and Interrupted from `tell`, which is called with rows of blocks that are done and all of them.
QuiltedPicture quilted_picture(const EndlessRequest& request, const PngPixels& exemplar, int width, int height,
                               const std::function<void(int done, int total)>& tell);

}
