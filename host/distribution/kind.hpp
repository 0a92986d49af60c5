// Kinds of work, each described once: what its tables and commands take, and what is made of that.
//
// A kind is a plain struct of settings whose members' own values are the defaults, a function that names its keys (see
// host/config/keys/keys.hpp) and checks what single values cannot show, and a function that makes the result. Tables of
// configs, commands, Python and the documentation follow from these.
#pragma once

#include "host/config/keys/keys.hpp"
#include "host/config/keys/kind_settings.hpp"
#include "host/distribution/distribution_place.hpp"
#include "results/pictures/distribution_files.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

struct Kind
{
    std::string table;   ///< "distribution": a table [[distribution]] ...
    std::string word;    ///< ... with kind = "stippling"
    std::string command; ///< "distribute stipple"
    std::string title;   ///< "Stippling"
    std::string summary; ///< one line for the help

    /// Visits the keys: describes them, or reads and checks a table.
    std::function<KindSettings(Keys& keys)> visit;

    std::function<DistributionResult(const KindSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                     DistributionFiles& files)>
        make;

    std::vector<KeySpec> keys() const;
};

/// The names of a kind.
struct KindNames
{
    std::string table, word, command, title, summary;
};

/// A kind of these functions. `keys` gets the defaults, and `label` names a result in reports.
template <class Settings>
Kind make_kind(KindNames names, void (*keys)(Keys&, Settings&), std::string (*label)(const Settings&),
               DistributionResult (*make)(const Settings&, std::uint64_t, const DistributionPlace&, DistributionFiles&),
               Settings defaults = {})
{
    return {std::move(names.table),
            std::move(names.word),
            std::move(names.command),
            std::move(names.title),
            std::move(names.summary),
            [keys, label, defaults](Keys& visited) {
                Settings settings = defaults;
                keys(visited, settings);
                std::string text = label(settings);
                return KindSettings{std::move(settings), std::move(text), visited.resolved(), visited.inputs()};
            },
            [make](const KindSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                   DistributionFiles& files) { return make(settings.as<Settings>(), seed, place, files); }};
}

/// Reads a table of this kind, but for keys in `others`, which have a meaning of their own. `where` and `name` are how
/// messages call it. Throws InputError, with the place of what is wrong.
KindSettings read_kind(const Kind& kind, const ConfigTable& table, const SourceLocation& where, const std::string& name,
                       const std::vector<std::string>& others = {});

}
