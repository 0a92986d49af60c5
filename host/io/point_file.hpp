// Point sets as files: text, PLY and NumPy, told apart by their first bytes, not by their names.
#pragma once

#include "geometry/point_set.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// Reads the point sets of a file, one a realization.
///
/// Text: one point a line, 2 or 3 coordinates separated by blanks or a comma; a line with `#` alone separates
/// realizations (as UTK writes them); `# words` is a comment; blank lines are ignored.
/// PLY: ascii and binary (either byte order), vertex properties x, y and, where not all zero, z.
/// NPY: float32 or float64 (either byte order), shape (N, 2), (N, 3), (K, N, 2) or (K, N, 3), C or Fortran
/// order.
///
/// Throws InputError with file and line (or the byte offset): no points, a coordinate that is not a finite
/// number in [0, 1), lines of unequal length, truncated files.
std::vector<PointSet> read_points(const std::filesystem::path& path);

/// Writes one point set. The format follows the extension: .ply (ascii, double), .npy (float64, N x
/// dimension), anything else text with 17 significant digits, so that reading back gives the same doubles.
/// `comment`, where the format has room for it, is put at the top. Whole or not at all. Throws StorageError.
void write_points(const std::filesystem::path& path, const PointSet& points, const std::string& comment = {});

}
