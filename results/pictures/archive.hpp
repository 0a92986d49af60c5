// Archives by cereal of the units of tilings and constructions.
#pragma once

#include "results/pictures/construction_scene.hpp"
#include "results/pictures/tiling_result.hpp"
#include "results/records/archive.hpp"

namespace poissonlab {

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
    archive(statistics.size, statistics.samples, statistics.tiles, statistics.colors);
}

template <class Archive>
void serialize(Archive& archive, SceneSummary& summary)
{
    archive(summary.panels, summary.points);
}

}
