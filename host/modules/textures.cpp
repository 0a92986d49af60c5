// Textures of tiles, endless ones of other kinds, and maps of cells.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_textures(Laboratory& laboratory)
{
    for (Kind (*const kind)() : {texture_kind, texture_set_kind, endless_kind, cell_kind})
        laboratory.kinds.push_back(kind());
}

}
