// Pictures of sets with marked corners.
#pragma once

#include "base/images/png_file.hpp"
#include "tiles/texture/texture_set.hpp"
#include "tiles/texture/texture_tiling.hpp"

namespace poissonlab {

/// Shows the first tile of the set with all marks that its corners have there, and dots at marked corners.
PngPixels marks_picture(const TextureSet& set);

/// The picture of a window with dots at marked corners.
PngPixels marked_window_picture(const TextureSet& set, const TextureWindow& window);

}
