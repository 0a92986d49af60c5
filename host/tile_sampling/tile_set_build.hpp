// The time that building a tile set took, kept beside the set in the cache: times are results of the laboratory, too.
#pragma once

#include "host/sampling/sampler.hpp"

#include <filesystem>
#include <optional>

namespace poissonlab {

/// The record's file of a tile set's file: its name with .json added.
std::filesystem::path build_record_file(const std::filesystem::path& tile_set_file);

/// Writes it. Throws StorageError.
void write_build_record(const std::filesystem::path& tile_set_file, const TileSetBuild& build);

/// Reads it; nothing where it is missing, damaged or of another kind: a set is as good without.
std::optional<TileSetBuild> read_build_record(const std::filesystem::path& tile_set_file);

}
