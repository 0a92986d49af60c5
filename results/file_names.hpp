// The names of the files of an output folder, see docs/output-folder.md.
#pragma once

#include <cstdint>
#include <string>

namespace poissonlab::file_names {

inline constexpr const char* results = "results.json";
inline constexpr const char* collection = "collection.json";

/// These files are in the folder of a series.
inline constexpr const char* spectrum = "spectrum.exr";
inline constexpr const char* spectrum_volume = "spectrum-volume.exr";
inline constexpr const char* radial = "radial.csv";
inline constexpr const char* pair_correlation = "pair-correlation.csv";
inline constexpr const char* number_variance = "number-variance.csv";
inline constexpr const char* region_curves = "region.csv";
inline constexpr const char* region_picture = "region.json";
inline constexpr const char* folded_density = "folded-density.exr";
inline constexpr const char* iterations = "iterations.csv";
inline constexpr const char* zone_plate = "zone-plate.exr";
inline constexpr const char* zone_plate_error = "zone-plate.csv";
inline constexpr const char* tile_set = "tile-set.ptiles";

/// These files are in the folder of a tiling or tile set, and of a construction.
inline constexpr const char* tiles = "tiles.txt";
inline constexpr const char* construction = "construction.json";

/// This file is in the folder of a distribution.
inline constexpr const char* distribution_numbers = "numbers.csv";

/// "realization-007.dat": the points of a realization.
std::string realization(std::uint32_t number);

}
