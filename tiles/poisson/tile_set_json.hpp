// Tile sets as JSON, for people and other programs: docs/tile-set-file.md.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <string>
#include <string_view>

namespace poissonlab {

/// The text of a JSON file, a tile a line.
std::string tile_set_to_json(const PoissonTileSet& set);

/// Throws InputError, a sentence without the file's name, for text that is no such JSON. Values are checked
/// only as far as they have to fit into the set.
PoissonTileSet tile_set_from_json(std::string_view text);

}
