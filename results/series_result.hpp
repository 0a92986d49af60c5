// What a series came to: the numbers of its realizations, measures and times.
#pragma once

#include "analysis/measures/blue_noise_measures.hpp"
#include "analysis/measures/integration_error.hpp"
#include "analysis/measures/largest_empty_ball.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/measures/low_frequency_power.hpp"
#include "analysis/measures/peak_anisotropy.hpp"
#include "analysis/measures/voronoi_diagram.hpp"
#include "results/records/sample_records.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// What the computation ran on. Empty and zero: not used.
struct Machine
{
    std::string device;
    std::string platform;
    std::string driver;
    std::string device_version;
    unsigned compute_units = 0;
    int threads = 0;
    int processes = 0; ///< that shared the work; 0: one
};

/// What the sampling test came to. Vectors have one value a realization.
struct ZonePlateResult
{
    int size = 0;                           ///< pixels of the first picture along each axis
    std::vector<double> rms_error;          ///< over the whole picture
    std::vector<double> resolved_rms_error; ///< where the plate has up to half a cycle per pixel; NaN: nowhere
};

/// Measures of the field beyond distances and spectra. Nothing: not defined for the sets at hand.
struct SeriesMeasures
{
    std::optional<double> effective_nyquist;       ///< of the mean spectrum, in units of half of N^(1/dimension)
    std::optional<double> effective_nyquist_error; ///< standard errors, here and below: of two realizations and more
    std::optional<Oscillation> oscillation;
    std::optional<double> oscillation_error;
    std::optional<PeakAnisotropy> peak_anisotropy;
    std::optional<LowFrequencyPower> low_frequency_power;
    std::optional<LatticePeaks> lattice_peaks; ///< of sets that are said to be tiled
    std::optional<double> lattice_peaks_error; ///< of mean_ratio
    std::vector<IntegrationError> integration; ///< over all realizations
    std::optional<double> packing_fraction;    ///< these are of the first realization
    std::optional<LargestEmptyBall> largest_empty;
    std::optional<VoronoiStatistics> voronoi; ///< 2D
};

/// What was measured on one series. Vectors have one value a realization.
struct SeriesResult
{
    std::vector<std::size_t> points;
    std::vector<double> min_distance; ///< unit lengths; infinite for a set of one point
    std::vector<double> relative_radius;
    std::vector<double> covered_fraction;
    int spectrum_size = 0; ///< 0: no spectrum
    std::optional<ZonePlateResult> zone_plate;
    std::vector<std::vector<IterationRecord>> iterations; ///< empty for methods without any
    SeriesMeasures measures;
    bool has_pair_correlation = false;     ///< sets of one point have none
    std::vector<std::string> point_files;  ///< relative to the output folder
    std::vector<double> sample_seconds;    ///< of the realizations, then of further runs; under one run's conditions
    std::optional<TileSetRecord> tile_set; ///< of methods that tile
    double build_seconds = 0;
    double preparation_seconds = 0;
    double analysis_seconds = 0;
};

}
