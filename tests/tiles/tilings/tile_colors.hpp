// The colours of tiles as the tests read them: by the digits of the index, one by one, not by the code under
// test.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <array>
#include <vector>

namespace poissonlab::test {

/// The digits of a number with these bases, the last base first.
inline std::vector<Color> digits(TileIndex index, std::vector<Color> bases)
{
    std::vector<Color> result(bases.size());
    for (std::size_t i = bases.size(); i-- > 0;) {
        result[i] = index % bases[i];
        index /= bases[i];
    }
    return result;
}

/// The colours that a tile shows to its neighbours on each side: colours from west to east, or from south to north.
struct Sides
{
    std::vector<Color> north, east, south, west;
};

inline Sides wang_sides(TileIndex index, WangColors c)
{
    const auto d = digits(index, {c.horizontal, c.vertical, c.horizontal, c.vertical});
    return {{d[0]}, {d[1]}, {d[2]}, {d[3]}};
}

inline Sides corner_sides(TileIndex index, Color c)
{
    const auto d = digits(index, {c, c, c, c}); // NE, SE, SW, NW
    return {{d[3], d[0]}, {d[1], d[0]}, {d[2], d[1]}, {d[2], d[3]}};
}

}
