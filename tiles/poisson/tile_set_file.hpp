// Tile sets as files, and as the bytes of such files: docs/tile-set-file.md describes both formats.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace poissonlab {

/// Reads a tile set, binary or JSON, told apart by content. Throws InputError, one line that starts with the
/// path, for files that cannot be read, are something else, are damaged, or hold a set that cannot be.
/// The stored minimum distance is for certify() to prove.
PoissonTileSet read_tile_set(const std::filesystem::path& path);

/// Writes a tile set whole or not at all: JSON where the extension is ".json", else binary. Throws
/// StorageError when that fails, InputError for sets that read_tile_set() would refuse.
void write_tile_set(const std::filesystem::path& path, const PoissonTileSet& set);

/// The bytes of a binary file. Throws InputError for sets that cannot be.
std::string encode_tile_set(const PoissonTileSet& set);

/// The tile set of the bytes of a file, binary or JSON. `name` is what messages call it.
PoissonTileSet decode_tile_set(std::string_view bytes, const std::string& name);

/// Returns the checksum that the bytes of a binary file, which has a whole header, must have.
std::uint64_t tile_file_checksum(std::string_view file);

/// Checks a stored tile set of any format: check(parameters) passes, the factor is a number even if none is used,
/// and the minimum distance is not above that of the densest packing. Throws InputError, a sentence without the
/// file's name.
void check_stored(const PoissonTileParameters& parameters, std::uint64_t squared_min_distance);

}
