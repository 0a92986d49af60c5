// The points of a monotile's tilings as a tile set file of kind 3, docs/tile-set-file.md: how it is written, and the
// proof of what it says. Windows of its points are read from its bytes by runtime/monotile_points.h.
#pragma once

#include "tiles/monotiles/monotile_table.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace poissonlab {

/// Ranks the points of a table, and returns the bytes of a file. `levels` are those of monotile_states().
std::string ranked_monotile_file(const MonotileTable& table, std::uint32_t levels);

/// Builds the table of a tiling, "hat" or "spectre", ranks its points, and returns the bytes of a file. See
/// build_monotile_table().
std::string built_monotile_file(const PolygonTiling& tiling, std::uint32_t points, std::uint32_t levels,
                                const std::function<void(const std::string& what)>& on_step = {});

/// Proves the distances of a file from its points alone: its other tables must be those of the tiling, which are made
/// again. Returns the table with the proven distances. Throws InputError, a line that begins with the file's name,
/// where tables differ or where the file promises more than is proven.
MonotileTable proven_monotile_table(const MonotilePointsFile& file, const PolygonTiling& tiling);

}
