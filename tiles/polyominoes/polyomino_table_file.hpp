// The table of corrections as a file, for the cache: only programs built from the same sources read it again.
#pragma once

#include "tiles/polyominoes/polyomino_table.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace poissonlab {

/// Bytes and their checksum. Throws StorageError.
void write_with_checksum(const std::filesystem::path& file, const std::string& bytes);

/// No value where the file is missing or damaged. Throws InputError where it cannot be read.
std::optional<std::string> read_with_checksum(const std::filesystem::path& file);

/// Throws StorageError.
void write_polyomino_table(const std::filesystem::path& file, const PolyominoTable& table);

/// No value where the file is missing, cannot be read, is damaged, or holds something else.
std::optional<PolyominoTable> read_polyomino_table(const std::filesystem::path& file);

}
