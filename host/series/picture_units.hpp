// Tile sets, tilings and constructions of an experiment as units of work.
#pragma once

#include "host/scenes/tiling_analysis.hpp"
#include "host/series/code_versions.hpp"
#include "host/series/experiment.hpp"
#include "host/store/unit_store.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The stored results of a tile set or tiling.
struct TilingUnit
{
    std::optional<TilingStatistics> statistics;         ///< of tilings that do not close; without autocorrelations
    std::map<std::string, std::filesystem::path> files; ///< by their names in the output folder
};

/// The stored results of a construction.
struct ConstructionUnit
{
    SceneSummary summary;
    bool on_device = false; ///< whether a device made it
    std::map<std::string, std::filesystem::path> files;
};

/// The tile sets, tilings and constructions of one experiment, each stored when it is done.
class PictureWork
{
public:
    /// The arguments must outlive it.
    PictureWork(const Experiment& experiment, const CodeVersions& versions, UnitStore& store)
        : experiment_(experiment), versions_(versions), store_(store)
    {}

    /// The stored results, or std::nullopt if there are none.
    std::optional<TilingUnit> tiling(const TilingTask& task) const;
    std::optional<ConstructionUnit> construction(const ConstructionTask& task) const;

    bool are_constructions_there() const;

    /// The keys of all units, as text.
    std::string identity() const;

    /// Makes and stores what is not there. Throws StorageError.
    void make_tiling(const TilingTask& task);

    /// All constructions that are not there: those of the same tiles are made together.
    void make_constructions();

private:
    UnitKey key_of(const TilingTask& task) const;
    UnitKey key_of(const ConstructionTask& task) const;

    const Experiment& experiment_;
    const CodeVersions& versions_;
    UnitStore& store_;
};

}
