// Kinds of work, each described once: what its tables and commands take, and what is made of that.
//
// A kind is a plain struct of settings whose members' own values are the defaults, a function that names its keys (see
// host/settings/keys/keys.hpp) and checks what single values cannot show, and a function that makes the result. Tables
// of configs, commands, Python and the documentation follow from these.
#pragma once

#include "host/device/device_memory.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/settings/keys/keys.hpp"
#include "results/pictures/construction_result.hpp"
#include "results/pictures/distribution_files.hpp"
#include "results/pictures/tiling_result.hpp"

#include <any>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace poissonlab {

/// Settings of whatever kind, and what is known of them without it.
struct KindSettings
{
    std::any values;      ///< of the kind's own type
    std::string label;    ///< of a result, where nobody gave another one
    std::string resolved; ///< keys and values, in one line: what decides the result, but for `inputs`
    std::vector<std::filesystem::path> inputs; ///< files that decide it as well

    template <class Settings>
    const Settings& as() const
    {
        return std::any_cast<const Settings&>(values);
    }
};

/// The result of a kind, without name and label; names of files are without folder.
using Exhibited = std::variant<DistributionResult, TilingResult, ConstructionResult>;

/// The names of a kind.
struct KindNames
{
    std::string table;   ///< "distribution": a table [[distribution]] ...
    std::string word;    ///< ... with kind = "stippling"; empty: the only kind of its tables, whose `kind` is a key
    std::string command; ///< "distribute stipple"; empty: none
    std::string title;   ///< "Stippling"
    std::string summary; ///< one line for the help
    bool uses_device = true;
};

struct Kind : KindNames
{
    /// Visits the keys: describes them, or reads and checks a table.
    std::function<KindSettings(Keys& keys)> visit;

    std::function<Exhibited(const KindSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                            DistributionFiles& files)>
        make;

    /// The most that making takes of a device; empty: not known.
    std::function<DeviceMemory(const KindSettings& settings, const DeviceInfo& device)> device_memory = {};

    /// The folder of a result in those of runs; empty: named after the kind.
    std::function<std::string(const KindSettings& settings)> folder = {};

    /// The module that this program lacks and that alone knows the kind, of which names are all that is there; empty:
    /// it is all there.
    std::string absent_module = {};

    std::vector<KeySpec> keys() const;

    /// The word for its results.
    const std::string& name() const { return word.empty() ? table : word; }
};

/// A kind of these functions. `keys` gets the defaults, `label` names a result in reports, and `make` is called with
/// the settings, the seed, the place and the files; without the place where it takes none.
template <class Settings, class Make>
Kind make_kind(KindNames names, void (*keys)(Keys&, Settings&), std::string (*label)(const Settings&), Make make,
               Settings defaults = {})
{
    return {std::move(names),
            [keys, label, defaults](Keys& visited) {
                Settings settings = defaults;
                keys(visited, settings);
                std::string text = label(settings);
                return KindSettings{std::move(settings), std::move(text), visited.resolved(), visited.inputs()};
            },
            [make](const KindSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                   DistributionFiles& files) -> Exhibited {
                if constexpr (std::invocable<Make, const Settings&, std::uint64_t, DistributionFiles&>)
                    return make(settings.as<Settings>(), seed, files);
                else
                    return make(settings.as<Settings>(), seed, place, files);
            }};
}

/// Reads a table of this kind, but for keys in `others`, which have a meaning of their own. `where` and `name` are how
/// messages call it. Throws InputError, with the place of what is wrong.
KindSettings read_kind(const Kind& kind, const ConfigTable& table, const SourceLocation& where, const std::string& name,
                       const std::vector<std::string>& others = {});

}
