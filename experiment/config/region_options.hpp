// The keys that are about sets in a region of the plane: region and planar of [analysis], which hold for all methods,
// and of a [[method]]; density, density_from, envelope, tapers of [analysis].
#pragma once

#include "analysis/regions/random_in_region.hpp"
#include "analysis/regions/region_tapers.hpp"
#include "host/settings/keys/keys.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace poissonlab {

/// Spectra of sets in regions are made in memory for all of their frequencies at once.
inline constexpr int largest_region_spectrum = 4096;

/// The settings by which sets are measured in any region.
struct RegionMeasures
{
    std::uint32_t envelope = 39; ///< random sets that curves are held against
    std::uint32_t tapers = 0;    ///< whose spectra are averaged; 0: spectra are those of the points less the region's
};

struct RegionOptions
{
    std::shared_ptr<const FramedRegion> region;
    std::shared_ptr<const RegionDensity> density; ///< null: points follow none
    std::uint32_t envelope = 39;                  ///< random sets that curves are held against
    std::shared_ptr<const RegionTapers> tapers;   ///< null: spectra are those of the points less the region's
    std::uint64_t hash = 0;                       ///< of all corners and weights, for keys of stored work
};

/// Visits those of [analysis], and reads `measures`; nothing where it has no region. Names of files count from the
/// folder of the config. Throws InputError with the value's own line; also for keys that do not go with a region, or
/// not without one: `is_any_in_region` says that methods have regions of their own.
std::optional<RegionOptions> region_keys(Keys& keys, int dimension, RegionMeasures& measures, bool is_any_in_region);

/// Visits those of a [[method]]; nothing where it has no region. Throws InputError as well.
std::optional<RegionOptions> method_region_keys(Keys& keys, int dimension, const RegionMeasures& measures);

}
