// The aperiodic sets of Wang tiles that the laboratory knows, as data.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 8.3, with figures 8.1 to 8.5. The figures are
// pictures of numbers: Kari's and Culik's sets are made by their rules, the others are lists. The sets of figures 8.1
// and 8.2 were printed as pictures only (Gruenbaum and Shephard, Tilings and Patterns, 1986, p. 593): the second one is
// derived anew, and the first one is not here.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// Kari, A small aperiodic set of Wang tiles, 1996: 14 tiles. A tile multiplies the number on its north by q and adds
/// what it carries from the west: q N + W = S + E. The tiles of q = 2 are first (0 to 3), then those of q = 2/3. The
/// horizontal colours are the digits 0, 1, 2; vertical colours 0 and 1 are the carries -1 and 0 of q = 2, and 2 to 5
/// the carries -1/3, 0, 1/3, 2/3 of q = 2/3.
WangList kari_tiles();

/// Culik, An aperiodic set of 13 Wang tiles, 1996: Kari's method with q = 3 (tiles 0 to 5) and q = 1/2. The horizontal
/// colours are the digits 0, 1, 2, and 3 for 0', which only tiles of q = 1/2 take from the north; vertical colours 0 to
/// 2 are the carries 0, 1, 2 of q = 3, and 3 and 4 the carries 0 and 1/2 of q = 1/2.
WangList culik_tiles();

/// Ammann's 16 tiles, as numbered by Stam, Aperiodic texture mapping, 1997 (after Gruenbaum and Shephard, p. 595).
WangList ammann_tiles();

/// Robinson's 24 tiles, 1977, of Ammann's two L-shaped tiles A2: a Wang tile is a tile of A2 in its surroundings.
/// tests/tiles/aperiodic/robinson_tiles.py derives this list from a tiling with A2. All numbers of tables 8.1 to 8.7
/// are those printed of the set 24/24; which of the figure's colours is which is not known.
WangList robinson_tiles();

/// Jeandel and Rao, An aperiodic set of 11 Wang tiles, 2015 (arXiv 1506.06492): no aperiodic set of Wang tiles has
/// fewer tiles or fewer colours. This is their variant with 4 colours, where horizontal colours 0 and 4 of the other
/// are one. Not known when the dissertation was written.
WangList jeandel_rao_tiles();

struct AperiodicSet
{
    std::string name;   ///< what users type; empty: its tiles are not available
    std::string title;  ///< "Kari 14/6"
    std::string source; ///< who found it, and when
    WangList (*tiles)() = nullptr;
    std::string figure{}; ///< of the dissertation
    std::string note{};   ///< why it is not available
};

/// All sets of the dissertation in the order of its tables, and then those found later.
const std::vector<AperiodicSet>& aperiodic_sets();

/// The names of those that are available.
std::vector<std::string> aperiodic_set_names();

/// The set of a name; nullptr if there is none.
const AperiodicSet* find_aperiodic_set(const std::string& name);

}
