// Views of endless textures to the horizon, all by one camera, so that pages can show them beside each other.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/texture/mapping/endless_map.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "tiles/texture/texture_set.hpp"

#include <string>

namespace poissonlab {

/// The endless plane of a set whose tiles' side is a power of two; of sets that are laid in scanlines a window of
/// 25 x 25 tiles, of omega tiles and tiles of 512 pixels 16 x 16, that is repeated. The camera is 128 pixels of the
/// texture above the plane, whatever a tile's side is.
PngPixels plane_picture(const TextureSet& set, std::uint64_t seed, const DistributionPlace& place);

/// Says what that picture shows.
std::string plane_caption(const TextureSet& set);

/// The endless plane of a texture without tiles.
PngPixels plane_picture(const MappedEndless& mapped, const DistributionPlace& place);

/// A square part of a picture, as large as a power of two from 64 on, that is repeated.
PngPixels plane_picture(const PngPixels& picture, const DistributionPlace& place);

}
