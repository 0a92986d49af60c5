// How a corner tile is made, as a picture.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/texture_build.hpp"

namespace poissonlab {

/// A corner tile with colours as different as can be, from patches to the finished tile: four patches side by side,
/// the quarters that are cut out, the tile, and the tile with new pieces in grey; enlarged.
PngPixels step_picture(const BuiltTexture& built);

}
