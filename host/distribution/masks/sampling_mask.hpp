// Masks of samples on a grid of pixels, such as the phase encodings of magnetic resonance imaging: as many as asked
// for, as dense as asked for, and as far apart as that allows.
//
// Relaxation dart throwing (McCool and Fiume 1992) on pixels, with a distance at each: that of two samples is at least
// the larger one of theirs (Mitchell and others, Variable radii Poisson-disk sampling, 2012: bigger disks). Distances
// of all pixels have one scale: pixels come in an order by chance, and those that fit at this scale become samples;
// then the scale becomes smaller, until there are as many samples as asked for. Squared distances of pixels are whole
// numbers, and all comparisons are exact.
//
// For variable density in magnetic resonance imaging see Lustig, Donoho, Pauly, Sparse MRI, 2007; for densities that
// fall as powers of the distance from the middle Krahmer, Ward, Stable and robust sampling strategies for compressive
// imaging, 2014.
#pragma once

#include "host/settings/distributions/mask_config.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The pixels with what each asks for, row after row from the top.
struct MaskField
{
    std::uint32_t rows = 0, columns = 0;
    std::vector<std::uint64_t> costs;    ///< squared distance over the square of the scale: see SamplingMask::scale
    std::vector<std::uint8_t> allowed;   ///< 1: may be a sample
    std::vector<std::uint32_t> always{}; ///< pixels that are samples, however near: the calibration area
    bool is_graded = false;              ///< the density varies

    std::size_t pixels() const { return costs.size(); }
    std::size_t allowed_pixels() const;
};

/// Costs that pixels may have.
inline constexpr std::uint64_t most_cost = std::uint64_t{1} << 30;

/// Three quarters of a square pixel: two of them are half of the widest step between small squared distances.
inline constexpr std::int64_t most_offset = std::int64_t{3} << 30;

/// Throws InputError for a density that leaves no pixel.
MaskField mask_field(const SamplingMaskSettings& settings);

/// The number of samples that is asked for. Throws InputError where there are fewer pixels, or more in the calibration
/// area.
std::size_t asked_samples(const SamplingMaskSettings& settings, const MaskField& field);

struct SamplingMask
{
    std::uint32_t rows = 0, columns = 0;
    std::vector<std::uint32_t> samples; ///< numbers of pixels, in the order in which they came
    /// Any two samples, but for those that are in the calibration area both, are at a squared distance of no less than
    /// (scale * cost + offsets) * 2^-32, cost being the larger one of theirs, offsets the sum of both.
    std::uint64_t scale = 0;
    std::vector<std::int64_t> offsets; ///< of all pixels, at most most_offset either way; empty: 0

    std::int64_t offset(std::size_t pixel) const { return offsets.empty() ? 0 : offsets[pixel]; }

    std::vector<std::uint8_t> pixels() const; ///< 1: a sample
};

SamplingMask sampling_mask(const MaskField& field, std::size_t samples, std::uint64_t seed);

}
