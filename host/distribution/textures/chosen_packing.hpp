// The packing that settings ask for.
#pragma once

#include "host/settings/distributions/texture_config.hpp"
#include "tiles/packing/packing_board.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace poissonlab {

/// Returns the kind of search that the word of a method means; none for methods that do not search.
std::optional<PackingMethod> search_method(const std::string& method);

/// Throws InputError where a search finds that there is none.
TilePacking chosen_packing(const PackingSettings& settings, std::uint64_t seed);

}
