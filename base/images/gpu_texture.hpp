// Textures as graphics cards take them: levels, layers and formats, in DDS and KTX2 files without compression.
//
// DDS: Microsoft, Programming Guide for DDS, with the extended header DX10. KTX2: Khronos, KTX File Format
// Specification 2.0, with the basic block of Khronos Data Format 1.3. OpenImageIO writes neither.
#pragma once

#include "base/word_table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// The numbers of a texel: channels, bits, and whether bytes of colours are sRGB.
enum class GpuFormat
{
    r8,
    rgba8,
    rgba8_srgb,
    r16,
    rgba16,
    r32f,
    rgba32f,
};

/// The names of the formats in DirectX, without DXGI_FORMAT_.
inline constexpr WordTable<GpuFormat, 7> gpu_formats{{{{GpuFormat::r8, "R8_UNORM"},
                                                       {GpuFormat::rgba8, "R8G8B8A8_UNORM"},
                                                       {GpuFormat::rgba8_srgb, "R8G8B8A8_UNORM_SRGB"},
                                                       {GpuFormat::r16, "R16_UNORM"},
                                                       {GpuFormat::rgba16, "R16G16B16A16_UNORM"},
                                                       {GpuFormat::r32f, "R32_FLOAT"},
                                                       {GpuFormat::rgba32f, "R32G32B32A32_FLOAT"}}}};

struct GpuTexture
{
    GpuFormat format = GpuFormat::rgba8;
    int width = 0; ///< of level 0; a level has half of the one before, rounded down, and at least 1
    int height = 0;
    int layers = 1;
    bool is_array = false;           ///< one of a single layer is no array otherwise
    std::vector<std::string> levels; ///< texels row by row from the top, layer after layer, little-endian
};

/// The bytes of a texel.
std::size_t texel_bytes(GpuFormat format);

/// The contents of files. Textures have at least one level; all have the sizes that the numbers above say.
std::string dds_file(const GpuTexture& texture);
std::string ktx2_file(const GpuTexture& texture);

}
