// The member "measures" of a series in results.json: what is not there was not defined for its sets.
#pragma once

#include "base/files/stored_object.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct Measures
{
    struct Fit
    {
        double exponent = 0, exponent_error = 0;
        double intercept = 0, intercept_error = 0;
    };
    struct Oscillation
    {
        double value = 0, noise_floor = 0;
        std::optional<double> standard_error;
    };
    /// The ring whose power varies most with direction, of those with enough samples.
    struct PeakAnisotropy
    {
        double db = 0, frequency = 0;
        std::optional<double> standard_error_db;
        std::int64_t samples = 0;
    };
    struct Cells
    {
        double relative_area_variance = 0;
        std::array<double, 5> neighbour_share{}; ///< up to 4, 5, 6, 7, at least 8 neighbours
    };

    struct Peaks
    {
        std::int64_t tiles = 0;
        double max_ratio = 0, mean_ratio = 0;
        std::int64_t peaks = 0;
        std::optional<double> mean_ratio_error; ///< standard error
    };
    struct Integral
    {
        std::string integrand;
        double rms_error = 0, standard_error = 0;
        double relative_variance = 0; ///< 1: Monte Carlo
    };

    std::optional<double> effective_nyquist;
    std::optional<double> effective_nyquist_error; ///< standard error, of several realizations
    std::optional<Oscillation> oscillation;
    std::optional<Fit> low_frequency_power;
    std::optional<Peaks> lattice_peaks;
    std::optional<PeakAnisotropy> peak_anisotropy;
    std::vector<Integral> integration;
    std::optional<double> largest_empty_radius; ///< relative to the largest minimum distance
    std::optional<Cells> voronoi;
};

/// Throws InputError for members of another kind.
Measures read_measures(const StoredObject& series);

}
