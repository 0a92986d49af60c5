// Differences of a field by layered depth images and the whole scene.
#pragma once

#include "base/images/png_file.hpp"

#include <array>

namespace poissonlab {

/// Differences of pictures: the mean over channels, the root of the mean square, and their picture, darker for more.
struct PictureDifference
{
    double mean = 0, root_mean_square = 0;
    double signed_mean = 0; ///< of the first picture less the second
    PngPixels picture;
};
PictureDifference difference_of(const PngPixels& a, const PngPixels& b);

/// Takes pictures with white plants before black. Returns the part of what plants cover in the whole scene that the
/// field leaves open, and what the field covers beside it, over what they cover.
std::array<double, 2> cover_errors(const PngPixels& field, const PngPixels& whole);

}
