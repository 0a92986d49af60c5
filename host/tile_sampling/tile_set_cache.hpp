// Tile sets that were built before: construction takes seconds, reading a file milliseconds.
#pragma once

#include "host/device/device.hpp"
#include "host/sampling/sampler.hpp"
#include "host/tile_construction/tile_construction.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Constructs a tile set and proves its minimum distance, which the set then states. Throws InputError where
/// construct_tile_set() does.
ConstructedTileSet build_tile_set(const PoissonTileParameters& parameters, Engine engine, const DeviceProvider& device,
                                  const ConstructionOptions& options = {});

/// The memory that this takes on such a device, nearly.
DeviceMemory build_memory(const PoissonTileParameters& parameters, const DeviceInfo& device);

/// The name of a tile set's file in the cache_folder(): all its parameters, the version of the code that builds it, and
/// what it is built on: a device, or with null the reference engine.
std::string tile_cache_name(const PoissonTileParameters& parameters, const DeviceInfo* device);

/// A tile set and where it came from.
struct CachedTileSet
{
    PoissonTileSet set;
    TileSetRecord record;
    double waiting_seconds = 0; ///< for another process that was building it
};

/// The tile set from `folder`, or built and put there, with a record of what that took. A file that cannot be read, is
/// damaged or holds something else is replaced; where nothing can be written, the set is not kept. An empty folder:
/// always built. Of several processes that want the same set, one builds it and the others wait. `on_step` is told of
/// waiting and of the steps of building; what it throws ends that.
CachedTileSet cached_tile_set(const PoissonTileParameters& parameters, Engine engine, const DeviceProvider& device,
                              const std::filesystem::path& folder,
                              const std::function<void(const std::string& what)>& on_step = {});

// The tile sets of a series, which its realizations take in turn.

/// So many sets, with seeds that follow one another.
struct TileSetChoice
{
    PoissonTileParameters first;
    std::uint32_t sets = 1;
    double density = 1; ///< part of the points that is kept
};

/// Returns the number of tile sets of a series: its parameter `sets`.
std::uint32_t sets_of(const Parameters& given);

class SeriesTileSets
{
public:
    /// Takes them from the cache, or builds them. Throws InputError where the relative radius cannot be reached.
    SeriesTileSets(const TileSetChoice& choice, const SampleRequest& request, Engine engine,
                   const DeviceProvider& device);

    const std::vector<PoissonTileSet>& all() const { return sets_; }

    /// Returns what sets of points have of their tile sets; its tile_set_file is to be called while this lives.
    SetTraits traits() const;

private:
    double preparation_seconds_ = 0;
    std::vector<PoissonTileSet> sets_;
    TileSetRecord record_; ///< of the first
};

// The time that building a tile set took, kept beside the set in the cache: times are results of the laboratory, too.

/// The record's file of a tile set's file: its name with .json added.
std::filesystem::path build_record_file(const std::filesystem::path& tile_set_file);

/// Writes it. Throws StorageError.
void write_build_record(const std::filesystem::path& tile_set_file, const TileSetBuild& build);

/// Reads it; nothing where it is missing, damaged or of another kind: a set is as good without.
std::optional<TileSetBuild> read_build_record(const std::filesystem::path& tile_set_file);

}
