// The settings of [[distribution]] kind = "mri-mask" and "dither-mask".
#pragma once

#include "base/word_table.hpp"
#include "host/settings/keys/choices.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace poissonlab {

/// kind = "mri-mask": see host/distribution/masks/sampling_mask.hpp. Either an acceleration or a number of samples.
struct SamplingMaskSettings
{
    std::array<std::uint32_t, 2> shape{256, 256}; ///< rows and columns
    std::optional<double> acceleration;           ///< pixels over samples
    std::optional<std::size_t> samples;
    std::array<std::uint32_t, 2> calibration{}; ///< rows and columns in the middle, of which all pixels are samples
    bool has_corners = false;                   ///< beyond the ellipse of the grid
    double power = 1;                           ///< the density falls as the distance from the middle to minus this
    DensityChoice density;                      ///< instead; empty: by power
};

/// The ways to thresholds.
enum class DitherMethod
{
    tiles,           ///< corner tiles whose pixels are ranked: endless
    void_and_cluster ///< of the mask as a whole
};

inline constexpr WordTable<DitherMethod, 2> dither_methods{
    {{{DitherMethod::tiles, "tiles"}, {DitherMethod::void_and_cluster, "void-and-cluster"}}}};

/// kind = "dither-mask": see host/distribution/masks/dither_mask.hpp.
struct DitherMaskSettings
{
    std::uint32_t size = 1024; ///< pixels along each axis, after which the mask repeats
    DitherMethod method = DitherMethod::void_and_cluster;
    std::uint32_t colors = 3;       ///< of corner tiles
    std::uint32_t tile_pixels = 16; ///< of a tile, along each axis
};

}
