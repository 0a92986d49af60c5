// The units of work of a series and the keys under which they are stored.
#pragma once

#include "experiment/series/code_versions.hpp"
#include "experiment/series/experiment.hpp"
#include "experiment/store/unit_store.hpp"
#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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

// A realization as a unit of work: its points, the time they took, and what the sampler said of them.

/// The stored results of a realization beside its points.
struct SampleRecord
{
    std::size_t points = 0;
    double seconds = 0;     ///< of sampling, without building kernels
    std::string conditions; ///< Workplace::conditions() then
    bool on_device = false; ///< whether a device was open
    SetTraits traits;
    double build_seconds = 0;       ///< spent on building kernels since the realization before
    double preparation_seconds = 0; ///< since the realization before

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(points, seconds, conditions, on_device, traits, build_seconds, preparation_seconds);
    }
};

/// A realization that was just made.
struct Sample
{
    PointSet points;
    SampleRecord record;
    std::string tile_set; ///< of realization 0, where it is a tiling: the bytes of the tile set's file, unless too many
};

/// Larger tile sets, in bytes, are not results: a page could not hold them either.
inline constexpr std::size_t most_tile_set_bytes = std::size_t{8} << 20;

/// The sampler at hand: of one series at a time, as samplers hold large buffers on devices.
class SamplerSlot
{
public:
    /// Makes the first realization of a range of a series, with the sampler at hand if it is that of the same series.
    /// The others of the range will be asked for next.
    Sample make(const SeriesTask& task, const RealizationRange& range, const Workplace& workplace);

    /// Releases the sampler.
    void clear();

private:
    const SeriesTask* task_ = nullptr;
    std::unique_ptr<Sampler> sampler_;
    double build_seconds_ = 0; ///< of the sampler, as far as they are in a record
    double preparation_seconds_ = 0;
};

/// Stores a realization, with or without its points. Throws StorageError.
void store_sample(UnitStore& store, const UnitKey& key, const Sample& sample, bool with_points,
                  const std::string& comment);

/// The file of the tile set of realization 0; nothing where it is not there or without one.
std::optional<std::filesystem::path> stored_tile_set(const UnitStore& store, const UnitKey& key);

/// The record of a stored realization; nothing where it is not there.
std::optional<SampleRecord> stored_sample(const UnitStore& store, const UnitKey& key);

/// The file of its points; nothing where it is not there or without points.
std::optional<std::filesystem::path> stored_points(const UnitStore& store, const UnitKey& key);

}
