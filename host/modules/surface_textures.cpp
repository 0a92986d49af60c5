// Textures and objects on surfaces.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_surface_textures(Laboratory& laboratory)
{
    for (Kind (*const kind)() : {textured_surface_kind, surface_object_kind}) laboratory.kinds.push_back(kind());
}

}
