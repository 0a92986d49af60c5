// A realization as a unit of work: its points, the time they took, and what the sampler said of them.
#pragma once

#include "experiment/series/experiment.hpp"
#include "experiment/series/series_units.hpp"
#include "experiment/store/unit_store.hpp"
#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace poissonlab {

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
