// The table of corrections as a file, for the cache: only programs built from the same sources read it again.
#pragma once

#include "tiles/polyominoes/polyomino_table.hpp"

#include <filesystem>
#include <optional>

namespace poissonlab {

/// Throws StorageError.
void write_polyomino_table(const std::filesystem::path& file, const PolyominoTable& table);

/// No value where the file is missing, cannot be read, is damaged, or holds something else.
std::optional<PolyominoTable> read_polyomino_table(const std::filesystem::path& file);

}
