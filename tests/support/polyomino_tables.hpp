// Tables of polyominoes that tests of one program share: building one takes a second or two.
#pragma once

#include "tiles/polyominoes/polyomino_table.hpp"

namespace poissonlab::test {

inline const PolyominoTable& p_table()
{
    static const PolyominoTable table = build_polyomino_table(Polyomino::P);
    return table;
}

}
