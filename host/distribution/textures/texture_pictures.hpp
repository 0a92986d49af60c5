// Pictures of texture tiles for pages: seams, pieces by where they come from, windows in the exemplar, the levels of
// the atlas, steps by their place in the tile.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "host/texture/texture_build.hpp"
#include "host/texture/window_choice.hpp"
#include "tiles/texture/texture_set.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

// Pictures that show how a corner tile is made.

/// A corner tile with colours as different as can be, from patches to the finished tile: four patches side by side,
/// the quarters that are cut out, the tile, and the tile with new pieces in grey; enlarged.
PngPixels step_picture(const BuiltTexture& built);

// Pictures of sets with marked corners.

/// Shows the first tile of the set with all marks that its corners have there, and dots at marked corners.
PngPixels marks_picture(const TextureSet& set);

/// The picture of a window with dots at marked corners.
PngPixels marked_window_picture(const TextureSet& set, const TextureWindow& window);

/// The values of a set's tiles tinted by the window of the exemplar that they come from, three channels a pixel: one
/// colour a patch, which its quarters in all tiles have in common.
std::vector<std::uint8_t> piece_values(const TextureSet& set);

/// The atlas, twice as large, with red lines where sources are no neighbours.
PngPixels seam_picture(const TextureSet& set);

/// The exemplar with the frames of all windows: the first `patches` in their own colours, the others in grey.
PngPixels window_picture(const PngPixels& exemplar, const std::vector<ExemplarWindow>& windows, std::size_t patches);

/// All levels of an atlas side by side.
PngPixels level_picture(const TexturePyramid& pyramid);

/// A step map as grey: the exemplar's mean in the middle, white twice as much.
PngPixels step_map_picture(const StepMap& map);

}
