// How cereal stores what the laboratory's units of work hold: binary, exact, for this program's own use.
//
// Only programs built from the same sources read it again, see cmake/code_versions.cmake: there are no versions here.
#pragma once

#include "analysis/reconstruction.hpp"
#include "experiment/construction_run.hpp"
#include "experiment/experiment.hpp"
#include "experiment/tiling_analysis.hpp"
#include "sampling/sampler.hpp"

#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/tuple.hpp>
#include <cereal/types/vector.hpp>

#include <sstream>
#include <string>

namespace poissonlab {

template <class Archive>
void serialize(Archive& archive, SquareImage& image)
{
    archive(image.size, image.pixels);
}

template <class Archive>
void serialize(Archive& archive, IterationRecord& record)
{
    archive(record.relative_radius, record.energy);
}

template <class Archive>
void serialize(Archive& archive, TileSetBuild& build)
{
    archive(build.seconds, build.device, build.threads);
}

template <class Archive>
void serialize(Archive& archive, RegionPoints& points)
{
    archive(points.mean, points.expected);
}

template <class Archive>
void serialize(Archive& archive, TileSetRecord& record)
{
    archive(record.tiles, record.points_per_tile, record.cached, record.build, record.regions);
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
    archive(power.exponent, power.exponent_standard_error, power.intercept, power.intercept_standard_error,
            power.begin, power.end, power.bins);
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
            measures.oscillation_error, measures.peak_anisotropy, measures.low_frequency_power,
            measures.lattice_peaks, measures.lattice_peaks_error, measures.integration, measures.packing_fraction,
            measures.largest_empty, measures.voronoi);
}

/// What analysis finds out; the rest of a result belongs to other units.
template <class Archive>
void serialize(Archive& archive, SeriesResult& result)
{
    archive(result.points, result.min_distance, result.relative_radius, result.covered_fraction,
            result.spectrum_size, result.zone_plate, result.measures, result.has_pair_correlation,
            result.analysis_seconds);
}

template <class Archive>
void serialize(Archive& archive, FrequencyTest& test)
{
    archive(test.chi_square, test.p_value);
}

/// Without the values at all displacements, which an image holds.
template <class Archive>
void serialize(Archive& archive, ColorAutocorrelation& autocorrelation)
{
    archive(autocorrelation.lags, autocorrelation.largest, autocorrelation.largest_at, autocorrelation.bound);
}

template <class Archive>
void serialize(Archive& archive, ColorStatistics& colors)
{
    archive(colors.name, colors.counts, colors.frequencies, colors.autocorrelation);
}

template <class Archive>
void serialize(Archive& archive, TilingStatistics& statistics)
{
    archive(statistics.samples, statistics.tiles, statistics.colors);
}

template <class Archive>
void serialize(Archive& archive, SceneSummary& summary)
{
    archive(summary.panels, summary.points);
}

/// The bytes of a value.
template <class T>
std::string to_bytes(const T& value)
{
    std::ostringstream stream;
    cereal::BinaryOutputArchive archive(stream);
    archive(value);
    return std::move(stream).str();
}

/// Fills a value from what to_bytes() made of one of its type. Throws cereal::Exception where bytes are missing.
template <class T>
void from_bytes(const std::string& bytes, T& value)
{
    std::istringstream stream(bytes);
    cereal::BinaryInputArchive archive(stream);
    archive(value);
}

}
