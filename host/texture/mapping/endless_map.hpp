// Views of endless textures that are no tiles, to the horizon: pieces of an exemplar, looked up at levels and blended.
//
// This is what graphics cards do: mip levels of the exemplar, of light, are looked up for a pixel's footprint and what
// they show is blended, as bytes are in endless_texture.hpp, instead of levels of the blended texture. The papers of
// endless_request.hpp take it so; Heitz and Neyret as well as Deliot and Heitz (section 1.5) have tables back for each
// level of a Gaussian exemplar, whose coordinates vary less there: the mean over what a level averages away. That is a
// mean of encoded numbers, which is darker than one of light; here tables have the variance as well, and half the
// second derivative of light times the variance is added, which the papers leave out. Footprints of an anisotropic
// look-up find pieces and weights for each probe, where programs for cards find them once: pieces end at borders of
// exemplars that are not tileable.
#pragma once

#include "host/device/device_memory.hpp"
#include "host/texture/endless/endless_texture.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "kernels/common/fields/endless_map.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

// Levels of an exemplar of any size, and what endless textures need of each: means of colours, and tables back.

struct LevelValues
{
    contract::endless_map::ExemplarLevels levels{};
    int channels = 1;
    std::vector<float> values; ///< channels of texels, levels one after the other

    std::size_t begin(int level) const { return levels.offsets[level]; }
    std::size_t end(int level) const { return level == levels.top ? values.size() : levels.offsets[level + 1]; }
    /// The first value of a texel.
    std::size_t texel(int level, int x, int y) const;
};

/// All levels up to the mean of all, of the values of level 0. A level has half as many texels along an axis as the one
/// below, rounded up, which divide the exemplar evenly: all have the same area, whatever its size.
LevelValues level_values(int width, int height, int channels, std::vector<float> values);

/// Numbers from 0 to 255 by the root of light: a table of the contract.
std::vector<float> encoded_numbers();

/// The light of numbers from 0 to 255, and then half the second derivatives of light there.
std::vector<float> light_of_numbers();

/// Three means of encoded light at each level, 0 of channels that there are not.
std::vector<float> encoded_means(const LevelValues& light);

/// The tables back at each level of a Gaussian exemplar, for each coordinate means over what the level averages away,
/// and then their variances.
std::vector<float> level_tables(const LevelValues& numbers, const std::vector<float>& inverse);

class Device;

/// An endless texture as its views are looked up.
struct MappedEndless
{
    EndlessTexture texture; ///< without texels
    contract::endless_map::ExemplarLevels levels{};
    std::vector<float> exemplar; ///< light from 0 to 65535; of Gaussian exemplars numbers from the mean on
    std::vector<float> encoded;  ///< numbers from 0 to 255 by the root of light
    std::vector<float> light;    ///< of these numbers, then half the second derivatives of it
    std::vector<float> means;    ///< three a level: of channels, encoded, where the method needs them
    std::vector<float> inverse;  ///< of Gaussian exemplars: tables back at each level

    /// The pixel of the texture at the lower left corner of a tile of 64 x 64 pixels; tiles within 2^45 of 0.
    contract::endless_texture::EndlessWindow origin(std::int64_t tile_x, std::int64_t tile_y) const;
};

/// The views of a request, which is not quilted. Throws InputError as endless_texture() does.
MappedEndless mapped_endless(const EndlessRequest& request, const PngPixels& exemplar);

/// The device memory that map_endless() takes.
DeviceMemory endless_map_memory(const MappedEndless& mapped, const TextureView& view);

/// The picture of a view from an origin, as map_texture() has it.
std::vector<float> map_endless(Device& device, const MappedEndless& mapped,
                               const contract::endless_texture::EndlessWindow& origin, const TextureView& view,
                               std::size_t work_group_size);

/// Makes the bits of map_endless() in plain C++.
std::vector<float> reference_map_endless(const MappedEndless& mapped,
                                         const contract::endless_texture::EndlessWindow& origin,
                                         const TextureView& view);

}
