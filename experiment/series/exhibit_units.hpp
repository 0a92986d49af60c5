// Exhibits of an experiment as units of work.
#pragma once

#include "experiment/series/code_versions.hpp"
#include "experiment/series/experiment.hpp"
#include "experiment/store/unit_store.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace poissonlab {

/// The stored result of an exhibit.
struct ExhibitUnit
{
    Exhibited result;       ///< without name and label, files without folder
    bool on_device = false; ///< whether a device made it
    std::map<std::string, std::filesystem::path> files{};
};

/// The exhibits of one experiment, each stored when it is done.
class ExhibitUnits
{
public:
    /// The arguments must outlive it.
    ExhibitUnits(const Experiment& experiment, const CodeVersions& versions, UnitStore& store)
        : experiment_(experiment), versions_(versions), store_(store)
    {}

    /// The stored result of exhibit `item`, or std::nullopt if there is none.
    std::optional<ExhibitUnit> find(std::size_t item) const;

    /// The keys of all units, as text.
    std::string identity() const;

    /// Makes and stores it, unless it is there. Throws InputError and StorageError.
    void make(std::size_t item);

private:
    UnitKey key_of(const Exhibit& exhibit) const;

    const Experiment& experiment_;
    const CodeVersions& versions_;
    UnitStore& store_;
};

}
