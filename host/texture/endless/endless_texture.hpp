// Colours of endless textures at pixels of the plane: those of endless_request.hpp, and tiles that have places in an
// atlas, by the same kernel, kernels/textures/endless_texture.cl.
//
// Pixels of the plane have whole coordinates, x to the east and y to the south, and show texels of the exemplar as they
// are: what renderers do between them, and with levels, is left out. In hexagonal grids row j of lattice points is at
// y = j row, and its points at x = i cell + j cell / 2. Pieces lie inside of the exemplar unless it is tileable: the
// papers take all exemplars for that, and neither they nor photographs fit to themselves. Hexagons may turn, by one of
// 256 angles each; turned texels are looked up bilinearly. Quilez mirrors squares, which light from one side forbids.
#pragma once

#include "host/device/device_memory.hpp"
#include "host/texture/endless/endless_request.hpp"
#include "kernels/common/fields/endless_texture.h"
#include "tiles/texture/texture_set.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

class Device;

/// A rectangle of pixels of the plane by its upper left one.
struct PixelWindow
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    int width = 0;
    int height = 0;
};

/// A texture as its pixels are looked up.
struct EndlessTexture
{
    int method = contract::endless_texture::METHOD_REPEATED; ///< of the contract
    int channels = 1;
    int exponent = 1;
    int gain = 1;
    bool is_restored = false;
    bool is_turned = false;
    std::uint32_t colors = 1; ///< of tiles
    contract::endless_texture::EndlessPlane plane{};
    std::vector<std::uint32_t> texels; ///< channels in bytes from the lowest; of Gaussian exemplars 16 bits each
    /// Gaussian exemplars have their tables back here; turned hexagons have cosines, then sines of angles, in whole
    /// 32768ths.
    std::vector<float> inverse{0};
};

/// The texture of a request, which is not quilted. Throws InputError as check() does.
EndlessTexture endless_texture(const EndlessRequest& request, const PngPixels& exemplar);

/// The texture of a complete set of tiles, has_places(), laid by a seed.
EndlessTexture endless_tiles(const TextureSet& set, std::uint64_t seed);

/// Bytes that a program keeps for it.
std::size_t bytes_of(const EndlessTexture& texture);

/// The window as the kernel takes it.
contract::endless_texture::EndlessWindow contract_window(const EndlessTexture& texture, const PixelWindow& window);

/// The device memory that endless_window() takes.
DeviceMemory endless_memory(const EndlessTexture& texture, const PixelWindow& window);

/// The pixels of a window by the kernel. Throws Interrupted.
PngPixels endless_window(Device& device, const EndlessTexture& texture, const PixelWindow& window,
                         std::size_t work_group_size);

/// Makes the bytes of endless_window() in plain C++.
PngPixels reference_endless_window(const EndlessTexture& texture, const PixelWindow& window);

/// Seconds that the device takes for the pixels of a window, without handing them over: the median of several.
double endless_seconds(Device& device, const EndlessTexture& texture, const PixelWindow& window);

/// The largest sides of a window.
inline constexpr int most_endless_pixels = 16'384;

}
