// The corrections of a row of the table, by relaxation in all neighbourhoods at once.
#pragma once

#include "tiles/polyominoes/point_pairs.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <vector>

namespace poissonlab {

/// Corrections [class * kept + number]: see relaxed_points(). Published tables were relaxed by Lloyd's method, in
/// patches. `frequencies`: see frequencies_of().
std::vector<Correction> relaxed_row(const KeptTiles& tiles, const std::vector<double>& frequencies);

}
