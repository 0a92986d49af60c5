// The options of a series' analysis: the keys of [analysis] beyond the size and number of the sets.
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/periodic_box.hpp"
#include "experiment/config/region_options.hpp"
#include "host/settings/config_tree.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

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
