// How cereal stores what the laboratory's units of work hold: binary, exact, for this program's own use.
//
// Only programs built from the same sources read it again, see cmake/code_versions.cmake: there are no versions here.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"
#include "results/records/archive.hpp"
#include "results/series_result.hpp"

namespace poissonlab {

template <class Archive>
void serialize(Archive& archive, SquareImage& image)
{
    archive(image.size, image.pixels);
}

template <class Archive>
void serialize(Archive& archive, ZonePlateResult& result)
{
    archive(result.size, result.rms_error, result.resolved_rms_error);
}

template <class Archive>
void serialize(Archive& archive, Oscillation& oscillation)
{
    archive(oscillation.value, oscillation.noise_floor, oscillation.begin, oscillation.end);
}

template <class Archive>
void serialize(Archive& archive, PeakAnisotropy& peak)
{
    archive(peak.db, peak.frequency, peak.samples, peak.standard_error_db);
}

template <class Archive>
void serialize(Archive& archive, LowFrequencyPower& power)
{
    archive(power.exponent, power.exponent_standard_error, power.intercept, power.intercept_standard_error, power.begin,
            power.end, power.bins);
}

template <class Archive>
void serialize(Archive& archive, LatticePeaks& peaks)
{
    archive(peaks.tiles, peaks.max_ratio, peaks.mean_ratio, peaks.frequency, peaks.peaks);
}

template <class Archive>
void serialize(Archive& archive, IntegrationError& error)
{
    archive(error.integrand, error.integral, error.rms_error, error.standard_error, error.relative_variance);
}

template <class Archive>
void serialize(Archive& archive, LargestEmptyBall& ball)
{
    archive(ball.radius, ball.relative_radius, ball.centre);
}

template <class Archive>
void serialize(Archive& archive, VoronoiStatistics& statistics)
{
    archive(statistics.relative_area_variance, statistics.neighbour_share);
}

template <class Archive>
void serialize(Archive& archive, SeriesMeasures& measures)
{
    archive(measures.effective_nyquist, measures.effective_nyquist_error, measures.oscillation,
            measures.oscillation_error, measures.peak_anisotropy, measures.low_frequency_power, measures.lattice_peaks,
            measures.lattice_peaks_error, measures.integration, measures.packing_fraction, measures.largest_empty,
            measures.voronoi);
}

/// What analysis finds out; the rest of a result belongs to other units.
template <class Archive>
void serialize(Archive& archive, SeriesResult& result)
{
    archive(result.points, result.min_distance, result.relative_radius, result.covered_fraction, result.spectrum_size,
            result.zone_plate, result.measures, result.has_pair_correlation, result.analysis_seconds);
}

}
