// Tilings by polygons as TOML: those that the program brings, configs/tilings, and those of users, in the same format.
// docs/polygon-tilings.md describes it.
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The words for the tilings that the program brings: by substitution, and periodic ones.
const std::vector<std::string>& substitution_words();
const std::vector<std::string>& periodic_words();

/// A tiling of one of these words. Throws std::out_of_range for any other.
const PolygonTiling& built_in_tiling(const std::string& word);

/// The tiling of a file. Throws InputError with the line of what is wrong.
PolygonTiling read_polygon_tiling(const std::filesystem::path& file);

/// The text of a file of configs/tilings, such as "chair.toml"; empty: there is none.
std::string_view built_in_tiling_text(std::string_view name);

}
