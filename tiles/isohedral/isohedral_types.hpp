// The 93 types of isohedral tilings, IH1 to IH93.
//
// Gruenbaum and Shephard, Tilings and Patterns, 1986, table 6.2.1. The types are found by enumeration of their symbols;
// the numbers come from the incidence symbols of the 81 types that shapes can tell. The other 12 take the numbers that
// are left: which one each has follows from the symmetries of its tile, of which no two of them agree.
#pragma once

#include "tiles/isohedral/isohedral_template.hpp"

#include <string>
#include <vector>

namespace poissonlab {

struct IsohedralType
{
    int number = 0;         ///< 1 to 93
    std::string symbol;     ///< the incidence symbol, "a+b+c+c-b-a-;a-c+b+"
    std::string topology;   ///< of the Laves tiling, "3^6"
    bool is_marked = false; ///< tiles need markings: no shape alone has the type
    IsohedralTemplate shape{};
};

/// All types in the order of their numbers; made when it is first asked for.
const std::vector<IsohedralType>& isohedral_types();

/// The mirror image of the type with this number, whose tiles are those of the type in a mirror. Null where these are
/// tiles of the type itself.
const IsohedralType* mirrored_type(int number);

}
