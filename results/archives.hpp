// Archives by cereal of the laboratory's units of work: binary, exact, for this program's own use.
//
// Only programs built from the same sources read it again, see cmake/code_versions.cmake: there are no versions here.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"
#include "results/records/archive.hpp"
#include "results/series.hpp"

#include <cereal/types/map.hpp>

namespace poissonlab {

template <class Archive>
void serialize(Archive& archive, SquareImage& image)
{
    archive(image.size, image.pixels);
}

template <class Archive>
void serialize(Archive& archive, Statistic& statistic)
{
    archive(statistic.min, statistic.mean, statistic.max, statistic.each);
}

template <class Archive>
void serialize(Archive& archive, ZonePlateResult& result)
{
    archive(result.size, result.file, result.error_file, result.rms_error, result.resolved_rms_error);
}

template <class Archive>
void serialize(Archive& archive, FoldedDensityFile& folded)
{
    archive(folded.size, folded.file);
}

template <class Archive>
void serialize(Archive& archive, Estimate& estimate)
{
    archive(estimate.value, estimate.standard_error);
}

/// The measures as results.json has them: what is stored there is all there is to know of them.
template <class Archive>
void save(Archive& archive, const Measures& measures)
{
    archive(measures_text(measures));
}

template <class Archive>
void load(Archive& archive, Measures& measures)
{
    std::string text;
    archive(text);
    measures = read_measures(text);
}

/// Results of the analysis; the rest of a series belongs to other units.
template <class Archive>
void serialize(Archive& archive, Series& series)
{
    archive(series.points, series.points_each, series.realizations, series.repeated, series.min_distance,
            series.relative_radius, series.covered_fraction, series.measures, series.is_window, series.spectrum_size,
            series.pair_correlation_file, series.number_variance_file, series.folded_density, series.zone_plate,
            series.analysis_seconds);
}

}
