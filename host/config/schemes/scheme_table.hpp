// The table [[scheme]] of a config: how tilings and tile sets are made, step by step, and what is known of them.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapters 2, 3 and 8.
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/schemes/scheme_settings.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The words for the key `kind`.
const std::vector<std::string>& scheme_kinds();

struct SchemeChoice
{
    SchemeSettings settings;
    std::string label; ///< unless the table has one
};

/// Reads and checks a table of a kind. Throws InputError with the place of what is wrong.
SchemeChoice read_scheme(const ConfigTable& table, const std::string& kind, std::uint64_t seed);

}
