// This says where a picture is too small for tiles whose windows all lie alike in its courses.
#pragma once

#include "host/texture/regular/regular_waves.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// A line for a picture of which so few windows of T x T pixels lie alike in its waves that `needed` corners have no
/// different ones, with the largest tiles of which it has enough, if there are any, and the pictures that have enough
/// for T.
std::string phase_note(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size, std::size_t needed);

}
