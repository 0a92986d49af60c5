// Makes what the tables [[scheme]] of a config ask for: pictures, counts and tables of tilings and tile sets.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapters 2, 3 and 8.
#pragma once

#include "host/config/schemes/scheme_settings.hpp"
#include "results/pictures/distribution_files.hpp"

#include <cstdint>

namespace poissonlab {

/// Makes one scheme and writes its files. The result has no name and no label; names of files are without folder.
/// Throws InputError where it cannot be made, StorageError, and Interrupted.
DistributionResult make_scheme(const SchemeSettings& settings, std::uint64_t seed, DistributionFiles& files);

// One function a kind, each in a file of its own.
DistributionResult make_corner_problem(const CornerProblemSettings& settings, std::uint64_t seed,
                                       DistributionFiles& files);
DistributionResult make_scanline_steps(const ScanlineStepsSettings& settings, std::uint64_t seed,
                                       DistributionFiles& files);
DistributionResult make_direct_scheme(const DirectTilingSettings& settings, DistributionFiles& files);
DistributionResult make_noise(const NoiseSettings& settings, std::uint64_t seed, DistributionFiles& files);
DistributionResult make_tiling_costs(const TilingCostSettings& settings, std::uint64_t seed);
DistributionResult make_construction(const ConstructionSettings& settings, std::uint64_t seed,
                                     DistributionFiles& files);
DistributionResult make_aperiodic_tables(const AperiodicTableSettings& settings, DistributionFiles& files);
DistributionResult make_diffraction(const DiffractionSettings& settings, DistributionFiles& files);
DistributionResult make_isohedral(const IsohedralSettings& settings, std::uint64_t seed, DistributionFiles& files);
DistributionResult make_surface(const SurfaceSettings& settings, std::uint64_t seed, DistributionFiles& files);

}
