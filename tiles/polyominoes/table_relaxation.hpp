// The corrections of a row of the table, by relaxation in all neighbourhoods at once.
#pragma once

#include "tiles/polyominoes/point_pairs.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <vector>

namespace poissonlab {

/// Corrections [class * kept + number] of least energy, in which points are spread evenly, and then without pairs that
/// are nearer than they have to be. First, an entry of the table moves by the mean force on its points, with the
/// potential (1 - r)^4 (4 r + 1) of Wendland between all pairs, r in 2.5 mean spacings, which keeps low frequencies out
/// as a Gaussian does (Ahmed, Ren and Wonka, Gaussian blue noise, 2022). Then each pair that is too near pushes both
/// apart, and an entry moves by the mean of its pushes, heavier ones for nearer points. Published tables were relaxed
/// by Lloyd's method, in patches. `frequencies`: see frequencies_of().
std::vector<Correction> relaxed_row(const KeptTiles& tiles, const std::vector<double>& frequencies);

}
