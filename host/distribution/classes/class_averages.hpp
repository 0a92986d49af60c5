// Spectra of points with classes, as means over several sets.
#pragma once

#include "analysis/spectra/cross_spectrum.hpp"
#include "host/distribution/classes/class_points.hpp"

#include <cstdint>
#include <string>

namespace poissonlab {

struct ClassSpectra
{
    std::uint32_t sets = 1;
    CrossSpectra mean;
    CrossSpectra error; ///< standard errors of the means; of one set: nothing
};

/// Means over settings.sets sets in 2D, of which `first` is the first; makes the others, which have the same classes.
/// Throws InputError and DeviceError as throw_classes() does.
ClassSpectra averaged_spectra(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              const ClassSet& first);

/// Columns frequency,all,class_I...,cross_I_J..., and with several sets the same again, in that order, as ..._error.
std::string spectra_csv(const ClassedPoints& points, const ClassSpectra& spectra);

}
