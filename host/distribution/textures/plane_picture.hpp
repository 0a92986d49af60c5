// Views of endless textures to the horizon, all by one camera, so that pages can show them beside each other.
//
// The speed of views of endless textures on a device.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/texture/endless/endless_texture.hpp"
#include "host/texture/mapping/endless_map.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "results/pictures/distribution_result.hpp"
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

inline constexpr int frame_width = 1024, frame_height = 576; ///< pixels

/// Frames of the endless plane that the device draws and hands over in a second, the median of several: between mipmap
/// levels, from the packed atlas or from the exemplar of a texture without tiles, as graphics cards do. It differs from
/// run to run. Throws InputError where the device has too little memory, and Interrupted.
double frames_a_second(Device& device, const TexturePyramid& pyramid);
double frames_a_second(Device& device, const MappedEndless& mapped);

/// The picture by which pixels are timed.
inline constexpr int timed_width = 1920, timed_height = 1080;

/// A time of this machine, by its key in texture_measures().
DistributionNumber time_number(const std::string& key, double value);

/// Nanoseconds a pixel of an endless texture, seen from straight above, on a device, and frames a second that it makes.
std::vector<DistributionNumber> time_numbers(Device& device, const EndlessTexture& texture);

}
