// Tables [[texture]], of tiles and of methods without tiles.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/settings/distributions/texture_config.hpp"
#include "host/texture/endless/endless_texture.hpp"
#include "results/pictures/distribution_files.hpp"

namespace poissonlab {

DistributionResult make_texture(const TextureSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files);

DistributionResult make_endless(const TextureSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files);

/// The picture that `texture endless` is asked for. Throws InputError for an exemplar that does not suit the method.
PngPixels endless_picture(const EndlessSettings& settings, std::uint64_t seed, const DistributionPlace& place);

/// The pixels of a window on the place's engine. Throws InputError where the device has too little memory.
PngPixels endless_pixels(const EndlessTexture& texture, const PixelWindow& window, const DistributionPlace& place);

}
