// Alphabets of cells as TOML files: docs/cells.md.
#pragma once

#include "tiles/cells/cell_alphabet.hpp"

#include <filesystem>

namespace poissonlab {

/// Throws InputError with the line of what is wrong, and names the corners of a cell that has neither a drawing nor a
/// rule.
CellAlphabet read_cell_alphabet(const std::filesystem::path& file);

}
