// The frequencies of neighbourhoods and pairs of tiles, by the automaton.
#pragma once

#include "tiles/polyominoes/neighbourhoods.hpp"

#include <vector>

namespace poissonlab {

/// Frequencies per tile after a few divisions of tiles that had all classes, and all pairs, equally often: of the
/// classes, then of the pairs. Those that last occur as often as in the long run, within some percent; those that die
/// out are there still.
std::vector<double> frequencies_of(const Neighbourhoods& neighbourhoods);

}
