// The options of a series' analysis: the keys of [analysis] beyond the size and number of the sets.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/periodic_box.hpp"
#include "base/regions/region_reading.hpp"
#include "host/settings/config_tree.hpp"
#include "host/settings/keys/choices.hpp"
#include "host/settings/keys/keys.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

class RegionDensity;
class RegionTapers;

// The keys that are about sets in a region of the plane: region and planar of [analysis], which hold for all methods,
// and of a [[method]]; density, density_from, envelope, tapers of [analysis].

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

/// The region that a table says, as it is read.
struct TypedRegion
{
    std::string text;
    RegionReading reading;
};

/// Reads a region with what is measured in it. Throws InputError at the key that is wrong. A program without regions
/// asks for the module here.
RegionOptions read_region_options(Keys& keys, const TypedRegion& typed, const RegionMeasures& measures,
                                  const DensityChoice& density);

/// Visits the keys of a region in [analysis], and reads `measures`; returns nothing where it names no region. Relative
/// file names start at the config's folder. Throws InputError at the value's line, also for keys that need a region, or
/// that cannot be combined with one. `is_any_in_region` says that methods have regions of their own.
std::optional<RegionOptions> region_keys(Keys& keys, int dimension, RegionMeasures& measures, bool is_any_in_region);

/// Visits the keys of a region in a [[method]]; returns nothing where it names no region. Throws InputError as well.
std::optional<RegionOptions> method_region_keys(Keys& keys, int dimension, const RegionMeasures& measures);

/// The square of sets that are not periodic, as a region.
inline constexpr auto unit_square_region = "rectangle 0 0 1 1";

struct AnalysisOptions
{
    std::optional<PeriodogramMethod> spectrum = PeriodogramMethod::fast; ///< nothing: no spectra
    int spectrum_size = 0;         ///< frequency samples along each axis, even; 0: spectrum_size()
    double bin_width = 1;          ///< of the radial curves' annuli or shells, in frequency samples; at least 1
    bool keep_spectrum = false;    ///< whether large spectra are stored whole; 2D only
    bool volume = false;           ///< whether the whole spectrum is stored; 3D only
    bool zone_plate = false;       ///< whether sets sample the zone plate; 2D only
    int tiles = 0;                 ///< tiles per unit length, for lattice peaks; 0: the sets are not tiled
    std::uint32_t tile_sets = 1;   ///< that realizations take in turn: errors are then between sets
    std::vector<double> box_sides; ///< of the periodic box of the sets, in any unit; empty: the unit square (cube)
    bool window = false;           ///< sets are windows of the plane, not tori: see SeriesAnalysis
    bool is_periodic = false;      ///< sets are known to be periodic, wherever they were made
    bool is_foreign = false;       ///< sets were made elsewhere, and may not be periodic: see BorderResult
    bool progressive = false;      ///< the first points of a set are a set of their own, which is measured
    bool distances_only = false;   ///< no measures that are slow for large sets: see SeriesAnalysis
    std::optional<RegionOptions> region; ///< that sets lie in, where they lie in one: see SeriesAnalysis
    RegionMeasures region_measures;      ///< of sets in this region, or in regions of methods
    bool first_points_only = false;      ///< of all realizations, only the points of the first are stored

    PeriodicBox box() const { return periodic_box(box_sides); }
};

/// Visits these keys. `dimension` of the sets decides what is allowed, and whether methods have regions of their own.
/// Throws InputError with the value's own line.
AnalysisOptions analysis_keys(Keys& keys, int dimension, bool is_any_in_region = false);

/// Throws InputError where the sides of a box differ too much.
void check_box_sides(const std::vector<double>& sides);

/// The options of sets that were not made by a config, from `--set analysis.KEY=VALUE` arguments, and from entries of
/// [analysis] that other options stand for. Throws InputError.
AnalysisOptions overridden_analysis(const std::vector<std::string>& overrides, int dimension,
                                    const ConfigTable& entries = {});

/// The region alone, which says where points are before they are read.
std::optional<RegionOptions> overridden_region(const std::vector<std::string>& overrides, const ConfigTable& entries);

}
