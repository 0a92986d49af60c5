// Textures of tiles, and endless ones of other kinds.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_textures(Laboratory& laboratory)
{
    for (Kind (*const kind)() :
         {texture_kind, texture_set_kind, endless_kind, textured_surface_kind, surface_object_kind})
        laboratory.kinds.push_back(kind());
}

}
