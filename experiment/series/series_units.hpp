// The units of work of a series and the keys under which they are stored.
#pragma once

#include "experiment/series/code_versions.hpp"
#include "experiment/series/experiment.hpp"
#include "experiment/store/unit_key.hpp"

#include <cstdint>
#include <string>

namespace poissonlab {

/// Realizations that are analysed together. Parts of a series are put together in order, so that results do not depend
/// on who analysed which one. Larger parts cost less to store, smaller ones less when a run is killed.
inline constexpr std::uint32_t realizations_per_part = 32;

/// Consecutive realizations.
struct RealizationRange
{
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// A series is sampled realization by realization, analysed part by part, and then put together.
class SeriesUnits
{
public:
    SeriesUnits(const SeriesTask& task, const AnalysisOptions& options, const CodeVersions& versions);

    std::uint32_t parts() const;
    RealizationRange part(std::uint32_t number) const;

    /// Points and times of one realization. No analysis, and no number of realizations, matters to it.
    UnitKey sample_key(std::uint32_t realization) const;

    /// The key of the analysis of a part's realizations.
    UnitKey part_key(std::uint32_t number) const;

    /// The key of the analysis of the whole series.
    UnitKey analysis_key() const;

    /// Times of realization 0 beyond that of its making, under conditions that times depend on.
    UnitKey times_key(const std::string& conditions) const;

    /// The part of the key that all samples have in common; equal for series of the same point sets.
    const UnitKey& identity() const { return identity_; }

private:
    UnitKey analysis_of(const char* kind, const RealizationRange& range) const;

    std::uint32_t realizations_;
    AnalysisOptions options_;
    std::string analysis_version_;
    UnitKey identity_;
};

}
