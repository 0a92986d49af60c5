// Spectra of points with classes, as means over several sets.
#pragma once

#include "host/distribution/classes/class_means.hpp"
#include "host/distribution/classes/class_points.hpp"

#include <cstdint>
#include <string>

namespace poissonlab {

/// Means over settings.sets sets in 2D, of which `first` is the first; makes the others, by the tiles of the first
/// where it has some. Throws InputError and DeviceError as throw_classes() does.
ClassSpectra averaged_spectra(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              const ClassSet& first);

/// Columns frequency,all,class_I...,cross_I_J..., and with several sets the same again, in that order, as ..._error.
std::string spectra_csv(const ClassSpectra& spectra);

}
