// Makes what the tables [[scheme]] of a config ask for: pictures, counts and tables of tilings and tile sets.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapters 2, 3 and 8.
#pragma once

#include "host/schemes/scheme_settings.hpp"
#include "results/pictures/distribution_files.hpp"
#include "tiles/prototiles/polygon_tiling.hpp"

#include <cstdint>

namespace poissonlab {

/// The tile that the settings say. Throws InputError for parameters that it cannot have.
IsohedralTile tile_of(const IsohedralSettings& settings, std::uint64_t seed);

/// The tiling that the settings name. Throws InputError for a file that is none.
PolygonTiling tiling_of(const PolygonTilingChoice& choice);

// One function a kind, each in a file of its own, which makes it and writes its files. Each throws InputError where
// that cannot be done, StorageError, and Interrupted.
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
DistributionResult make_substitution(const SubstitutionSettings& settings, DistributionFiles& files);
DistributionResult make_periodic(const PeriodicSettings& settings, DistributionFiles& files);
DistributionResult make_bricks(const BrickSettings& settings, DistributionFiles& files);
DistributionResult make_surface(const SurfaceSettings& settings, std::uint64_t seed, DistributionFiles& files);

}
