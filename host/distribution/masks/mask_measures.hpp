// Measures of masks of samples: numbers, distances and densities.
#pragma once

#include "host/distribution/masks/sampling_mask.hpp"
#include "results/pictures/curve_chart.hpp"
#include "results/pictures/distribution_result.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

// Masks of samples as files.

/// Writes .npy (uint8, shape (rows, columns), 1: a sample), .cfl and the .hdr beside it (BART: complex floats,
/// dimensions 1, rows, columns) or .png (samples are white). Throws StorageError.
void write_mask(const std::filesystem::path& file, const SamplingMask& mask);

/// The least distance of two samples that are not in the calibration area both, in pixels, and the least one in parts
/// of what they are to have at least; infinite where there is no such pair near enough to matter, or where no distance
/// is asked for.
struct MaskDistances
{
    double least = 0;
    double least_part = 0;
};

MaskDistances mask_distances(const MaskField& field, const SamplingMask& mask);

std::vector<DistributionNumber> mask_numbers(const MaskField& field, const SamplingMask& mask);

/// The part of pixels that are samples by their distance from the middle, in parts of half the grid.
CurveChart mask_profile(const SamplingMask& mask);

}
