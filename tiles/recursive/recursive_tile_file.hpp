// Files of recursive Wang tiles: what a cache keeps.
//
// Bytes, all numbers with the low byte first: "RECWANG1"; N as 32 bits, seed as 64 bits; for each of the 8 tiles 16
// bytes, the tiles of its cells, and 16 N links of 16 bits, the cell times 4,096 plus the point; XXH64 of all before.
#pragma once

#include "tiles/recursive/recursive_tile_set.hpp"

#include <filesystem>

namespace poissonlab {

/// Throws StorageError.
void write_recursive_tiles(const std::filesystem::path& file, const RecursiveTileSet& tiles);

/// Throws InputError, a line with the file's name, for a file that is damaged or something else.
RecursiveTileSet read_recursive_tiles(const std::filesystem::path& file);

}
