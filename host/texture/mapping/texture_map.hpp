// Tile-based texture mapping: views of the endless plane that a complete set of corner or Wang tiles covers.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.4; Lagae, Dutre, An Alternative for Wang Tiles, 2006,
// section 6.3. Averages are of light, not of encoded bytes. With a ring of w texels, bilinear look-ups in the packed
// atlas are those in the endless texture at every level with 2^level <= w, with Wang tiles but within 1.5 texels of
// corners of tiles: neighbours there share no colour (Wei adds a second atlas of all corners). Exact look-ups are at
// all levels, where texels beyond a tile's own levels are means of 2 x 2 and 4 x 4 whole tiles, and then that of all
// tiles. The papers leave levels and rings open.
#pragma once

#include "base/programs/interrupt.hpp"
#include "base/word_table.hpp"
#include "host/device/device.hpp"
#include "host/device/device_memory.hpp"
#include "kernels/common/fields/texture_map.h"
#include "tiles/texture/texture_set.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

class Device;

using contract::texture_map::TextureView;

enum class TextureFilter
{
    nearest = contract::texture_map::FILTER_NEAREST,
    bilinear = contract::texture_map::FILTER_BILINEAR,
    mipmap = contract::texture_map::FILTER_MIPMAP,
    anisotropic = contract::texture_map::FILTER_ANISOTROPIC,
};
inline constexpr WordTable<TextureFilter, 4> texture_filters{{{{TextureFilter::nearest, "nearest"},
                                                               {TextureFilter::bilinear, "bilinear"},
                                                               {TextureFilter::mipmap, "mipmap"},
                                                               {TextureFilter::anisotropic, "anisotropic"}}}};

enum class TextureLookup
{
    packed = contract::texture_map::LOOKUP_PACKED,
    exact = contract::texture_map::LOOKUP_EXACT,
    clamped = contract::texture_map::LOOKUP_CLAMPED,
    repeated = contract::texture_map::LOOKUP_REPEATED,
};
inline constexpr WordTable<TextureLookup, 4> texture_lookups{{{{TextureLookup::packed, "packed"},
                                                               {TextureLookup::exact, "exact"},
                                                               {TextureLookup::clamped, "clamped"},
                                                               {TextureLookup::repeated, "repeated"}}}};

/// An atlas at all levels, as light from 0 to 65535.
struct TexturePyramid
{
    contract::texture_map::TextureLevels levels{};
    int channels = 1;
    bool is_wang = false;     ///< whether tiles are Wang tiles
    std::vector<float> light; ///< levels one after the other, rows from south to north

    /// Texels along a side of the atlas at a level.
    int width(int level) const { return levels.colors * levels.colors * (levels.size >> level); }
};

/// The pyramid of a set whose tiles a seed lays. Throws InputError for sets without places in the sense of
/// has_places(), and for tiles whose size is no power of two.
TexturePyramid texture_pyramid(const TextureSet& set, std::uint64_t seed);

/// The pyramid of a window of n^2 x n^2 tiles that are laid by scanlines from its north-west, as sets without places
/// are: TextureLookup::repeated shows it as it is, side by side. Tiles do not fit where windows meet. Throws InputError
/// as texture_window() does, and for tiles whose size is no power of two.
TexturePyramid laid_pyramid(const TextureSet& set, std::uint64_t seed, int n);

/// Sides of such windows are squares of 2 to this, in tiles, and have so many pixels: a gigabyte of colours at all
/// levels.
inline constexpr int most_laid_root = 8;
inline constexpr std::uint64_t most_laid_pixels = 8192;

/// The pyramid of a square picture as TextureLookup::repeated shows it: it counts as n^2 x n^2 tiles. Throws InputError
/// where their side is no power of two.
TexturePyramid picture_pyramid(const PngPixels& picture, int n);

/// The atlas at a level as it is stored: north first, encoded.
PngPixels level_pixels(const TexturePyramid& pyramid, int level);

/// Above a tile, looking to the north where angles are 0.
struct TextureCamera
{
    int width = 1024, height = 576; ///< pixels
    std::int64_t tile_x = 0, tile_y = 0;
    std::array<double, 2> start{0.5, 0.5}; ///< the place in that tile, to the east and north
    double forward = 0;                    ///< tiles from there, in the direction of view
    double above = 2;                      ///< tiles above the plane
    double pitch = 15;                     ///< degrees below the horizon; 90 looks straight down
    double yaw = 0;                        ///< degrees to the right
    double field = 60;                     ///< degrees, from the top to the bottom of the picture
    int samples = 1;                       ///< of a pixel, along each axis
    TextureFilter filter = TextureFilter::anisotropic;
};

/// The camera's view. Its numbers are rounded to 2^-40, far coarser than what machines disagree on.
TextureView view_of(const TextureCamera& camera);

/// The device memory that map_texture() takes.
DeviceMemory texture_map_memory(const TexturePyramid& pyramid, const TextureView& view);

/// The picture of a view: light by pixels, rows from the top, `channels` a pixel. Throws Interrupted.
std::vector<float> map_texture(Device& device, const TexturePyramid& pyramid, TextureLookup lookup,
                               const TextureView& view, std::size_t work_group_size);

/// Makes the bits of map_texture() in plain C++.
std::vector<float> reference_map_texture(const TexturePyramid& pyramid, TextureLookup lookup, const TextureView& view);

/// Light as it is shown.
PngPixels encoded_pixels(const std::vector<float>& light, int width, int height, int channels);

// Views that a device draws part by part, so that Ctrl-C need not wait for all of one.

/// Pixels of a view that are drawn at a time: with 2^20 samples.
inline std::size_t pixels_at_once(const contract::texture_map::TextureView& view)
{
    constexpr std::size_t samples_at_once = std::size_t{1} << 20;
    const std::size_t count = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
                      samples = static_cast<std::size_t>(view.samples) * static_cast<std::size_t>(view.samples);
    return std::max<std::size_t>(1, std::min(count, samples_at_once / samples));
}

/// The picture of a view: `draw(first, count, shown)` enqueues the kernel that draws `count` pixels from `first` on.
/// Throws Interrupted.
template <typename Draw>
std::vector<float> picture_in_parts(Device& device, const contract::texture_map::TextureView& view, int channels,
                                    Draw draw)
{
    const std::size_t count = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
                      values = static_cast<std::size_t>(channels), at_once = pixels_at_once(view);
    const Buffer<float> shown = device.buffer<float>(at_once * values);
    std::vector<float> pixels(count * values);
    for (std::size_t first = 0; first < count; first += at_once) {
        stop_if_interrupted();
        const std::size_t part = std::min(at_once, count - first);
        draw(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(part), shown);
        shown.read(std::span(pixels).subspan(first * values, part * values));
    }
    return pixels;
}

}
