// Masks of thresholds for dithering: the pixels below any threshold are even.
//
// By tiles: corner tiles of pixels, which are ranked as points of tile sets are (tile_ranking.hpp), the lower half from
// below and the upper one from above, so that each has as many pixels below any threshold, and any tiling of them is a
// mask, endless too: such tiles are a tile set, whose points are the middles of pixels. By void-and-cluster: a mask of
// its own, see void_and_cluster.hpp.
#pragma once

#include "host/settings/distributions/mask_config.hpp"
#include "results/pictures/curve_chart.hpp"
#include "results/pictures/distribution_result.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace poissonlab {

/// Ranks of the pixels of a torus, row after row from the top; each of 0 to levels - 1 comes as often.
struct DitherMask
{
    std::uint32_t size = 0;
    std::uint32_t levels = 0;
    std::vector<std::uint32_t> ranks;

    std::size_t pixels() const { return ranks.size(); }

    /// The threshold of a pixel as a number below `values`: that of the middle of its rank.
    std::uint32_t threshold(std::size_t pixel, std::uint32_t values) const
    {
        return static_cast<std::uint32_t>((2 * std::uint64_t{ranks[pixel]} + 1) * values / (2 * std::uint64_t{levels}));
    }
};

using OnPart = std::function<void(double part)>;

/// The tile set of a mask: all tiles have the same points, the middles of pixels, and ranks of their own.
PoissonTileSet dither_tiles(const DitherMaskSettings& settings, std::uint64_t seed, const OnPart& on_part = {});

/// The tiling of such a set that closes after `period` tiles.
DitherMask mask_of_tiles(const PoissonTileSet& tiles, std::uint32_t period, std::uint64_t seed);

/// `tiles` is what dither_tiles() made, by tiles.
DitherMask dither_mask(const DitherMaskSettings& settings, std::uint64_t seed, const OnPart& on_part = {});

/// Thresholds in sixteenths of all: at each of fifteen the pixels below it.
inline constexpr std::uint32_t measured_thresholds = 15;

struct ThresholdMeasures
{
    std::size_t pixels = 0;
    double least_distance = 0; ///< pixels
    double mean_nearest = 0;   ///< over the largest least distance of as many points
    double low_power = 0;      ///< mean power of frequencies below half of the principal one; random pixels have 1
    std::vector<double> power; ///< radial means, from frequency 1 on
};

/// Measures the minority at threshold i / 16: the pixels below it, from the middle on those above.
ThresholdMeasures threshold_measures(const DitherMask& mask, std::uint32_t sixteenths);

std::vector<DistributionNumber> dither_numbers(const std::vector<ThresholdMeasures>& measures);
DistributionTable dither_table(const std::vector<ThresholdMeasures>& measures);

/// Radial power at some of the thresholds.
CurveChart dither_curves(const std::vector<ThresholdMeasures>& measures);

// Masks of thresholds as files.

/// Writes .png (8 bits where there are at most 256 thresholds, else 16) or .npy (uint32, the ranks of pixels). Throws
/// StorageError.
void write_dither_mask(const std::filesystem::path& file, const DitherMask& mask);

/// Pixels below some thresholds as black dots of a corner of the mask, side by side.
void write_threshold_strip(const std::filesystem::path& file, const DitherMask& mask);

}
