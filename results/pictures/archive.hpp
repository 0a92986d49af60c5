// Archives by cereal of the units of tilings, constructions and distributions.
#pragma once

#include "results/pictures/construction_result.hpp"
#include "results/pictures/distribution_result.hpp"
#include "results/pictures/tiling_result.hpp"
#include "results/records/archive.hpp"

#include <cereal/types/variant.hpp>

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
    archive(autocorrelation.lags, autocorrelation.chance, autocorrelation.largest, autocorrelation.largest_at,
            autocorrelation.agreement, autocorrelation.bound);
}

template <class Archive>
void serialize(Archive& archive, ColorStatistics& colors)
{
    archive(colors.name, colors.counts, colors.frequencies, colors.autocorrelation_file, colors.autocorrelation);
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

template <class Archive>
void serialize(Archive& archive, DistributionNumber& number)
{
    archive(number.key, number.title, number.value, number.meaning, number.standard_error, number.is_in_table,
            number.is_time);
}

template <class Archive>
void serialize(Archive& archive, DistributionParameter& parameter)
{
    archive(parameter.key, parameter.value);
}

template <class Archive>
void serialize(Archive& archive, DistributionPicture& picture)
{
    archive(picture.file, picture.caption);
}

template <class Archive>
void serialize(Archive& archive, DistributionTable& table)
{
    archive(table.title, table.columns, table.rows);
}

template <class Archive>
void serialize(Archive& archive, DistributionResult& distribution)
{
    archive(distribution.facts, distribution.parameters, distribution.numbers, distribution.pictures,
            distribution.files, distribution.tables);
}

template <class Archive>
void serialize(Archive& archive, TilingResult& tiling)
{
    archive(tiling.kind, tiling.colors, tiling.vertical_colors, tiling.tiles, tiling.file, tiling.regions, tiling.set,
            tiling.algorithm, tiling.origin, tiling.size, tiling.hash, tiling.hash_period, tiling.period,
            tiling.statistics);
}

template <class Archive>
void serialize(Archive& archive, ConstructionResult& construction)
{
    archive(construction.kind, construction.show, construction.colors, construction.tiles, construction.points_per_tile,
            construction.relative_radius, construction.filling, construction.lloyd_iterations, construction.repulsion,
            construction.seed, construction.file, construction.scene);
}

}
