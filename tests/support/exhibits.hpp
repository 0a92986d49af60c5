// The tables of a config, read.
#pragma once

#include "experiment/exhibits/exhibit.hpp"
#include "host/kinds/kinds.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <vector>

namespace poissonlab {

inline std::vector<Exhibit> exhibits_in(const std::string& text, const std::string& file = "c.toml")
{
    return read_exhibits(parse_config(text, file));
}

/// The settings of each exhibit, which are all of one type.
template <class Settings>
std::vector<Settings> settings_in(const std::vector<Exhibit>& exhibits)
{
    std::vector<Settings> all;
    for (const Exhibit& exhibit : exhibits) all.push_back(exhibit.settings.as<Settings>());
    return all;
}

/// Makes what the settings of a kind ask for, in a folder.
template <class Settings>
DistributionResult made_of(const Settings& settings, std::uint64_t seed, const std::filesystem::path& folder,
                           const DistributionPlace& place = {})
{
    DistributionFiles files([&](const std::string& name) { return folder / name; });
    for (const Kind& kind : all_kinds()) {
        Keys described;
        KindSettings own = kind.visit(described);
        if (own.values.type() != typeid(Settings)) continue;
        own.values = settings;
        Exhibit exhibit{&kind, own, "exhibit", {}, seed};
        return std::get<DistributionResult>(make_exhibit(exhibit, place, files));
    }
    throw std::logic_error("no kind has such settings");
}

}
